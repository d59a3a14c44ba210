#include "adit/node/launch_config.hpp"

#include "parameter_lists.hpp"

namespace adit::node {

constexpr double kIntMax = 2147483647;
constexpr const char* kBodyFrame = "Name of the body's frame in the messages: x forward, y left, z up.";

template <class Launch, class Visitor>
requires std::is_same_v<std::remove_const_t<Launch>, PerceptionLaunch>
void visit_fields(Launch& c, Visitor&& visit) {
  visit(
      FieldNote{"image_transport", "", 0, 0, "Which of the camera's transports: raw, compressed, or another's plugin.",
                "raw: no loss, and no copy in one manager"},
      c.image_transport);
  visit(FieldNote{"body_frame", "", 0, 0, kBodyFrame, "REP 105"}, c.body_frame);
}

template <class Launch, class Visitor>
requires std::is_same_v<std::remove_const_t<Launch>, ControlLaunch>
void visit_fields(Launch& c, Visitor&& visit) {
  visit(FieldNote{"body_frame", "", 0, 0, kBodyFrame, "REP 105"}, c.body_frame);
}

template <class Launch, class Visitor>
requires std::is_same_v<std::remove_const_t<Launch>, CameraLaunch>
void visit_fields(Launch& c, Visitor&& visit) {
  visit(FieldNote{"input", "", 0, 0, "A device, a video, or a folder of images; has to be set.", "as adit run's"},
        c.input);
  visit(FieldNote{"camera_info_url", "", 0, 0, "The calibration, as camera_info_manager reads it (file://...).",
                  "empty: an ideal lens of hfov_deg"},
        c.camera_info_url);
  visit(FieldNote{"frame_id", "", 0, 0, "Name of the optical frame: x right, y down, z forward.", "REP 103"},
        c.frame_id);
  visit(FieldNote{"rate_hz", "Hz", 0.1, 1000, "Images a second.", "paper, 3.2: 30"}, c.rate_hz);
  visit(FieldNote{"hfov_deg", "deg", 1, 179, "Horizontal field of view where no calibration is given.",
                  "as assumed_hfov_deg"},
        c.hfov_deg);
  visit(FieldNote{"loop", "", 0, 1, "From the beginning again at the end.", "recordings are short"}, c.loop);
  visit(
      FieldNote{"preload", "", 0, 1, "Reads all frames before the first is sent.", "true: no decoding in the latency"},
      c.preload);
  visit(FieldNote{"freeze_after", "", 0, kIntMax,
                  "For tests: after so many frames the same is sent again and again; 0: never.",
                  "how a driver looks whose camera hangs"},
        c.freeze_after);
}

template <class Launch, class Visitor>
requires std::is_same_v<std::remove_const_t<Launch>, SimulatedRobotConfig>
void visit_fields(Launch& c, Visitor&& visit) {
  visit(FieldNote{"course_file", "", 0, 0, "The course, courses/NAME.yaml; has to be set.", "as adit fly's"},
        c.course_file);
  visit(FieldNote{"lamp", "", 0, 0, "Preset of lamps and lens (adit fly --help names them).", "paper, 3.2: 460 lux"},
        c.lamp);
  visit(FieldNote{"dust_1_m", "1/m", 0, 0.5, "Extinction of the air.", "clear air"}, c.dust_1_m);
  visit(FieldNote{"width", "px", 16, 4096, "Of the images.", "paper, 3.2"}, c.width);
  visit(FieldNote{"height", "px", 16, 4096, "Of the images.", "paper, 3.2"}, c.height);
  visit(FieldNote{"seed", "", 0, kIntMax, "Of gusts and noise.", "same seed and commands, same flight"}, c.seed);
  visit(FieldNote{"camera_rate_hz", "Hz", 1, 120, "Images a second, of simulated time.", "paper, 3.2: 30"},
        c.camera_rate_hz);
  visit(FieldNote{"time_max_s", "s", 0.1, 86400, "The flight ends then, if nothing else has ended it.",
                  "an S-bend takes a third of it at 1 m/s"},
        c.time_max_s);
  visit(FieldNote{"threads", "", 0, 256, "Of the renderer; 0: all of the machine.", "pictures do not depend on it"},
        c.threads);
}

template <class Launch, class Visitor>
requires std::is_same_v<std::remove_const_t<Launch>, SimLaunch>
void visit_fields(Launch& c, Visitor&& visit) {
  visit(
      FieldNote{"lockstep", "", 0, 1, "The world waits for the command to each frame: the same flight on any machine.",
                "false: a robot does not wait"},
      c.lockstep);
  visit(FieldNote{"wait_s", "s", 0, 60, "With lockstep: for a command, at the most, wall time.",
                  "longer than any frame takes"},
        c.wait_s);
  visit(FieldNote{"real_time_factor", "", 0.01, 100,
                  "Without lockstep: simulated seconds in a second, if they can be kept.", "1: real time"},
        c.real_time_factor);
  visit(FieldNote{"pilot_s", "s", 0, 600,
                  "The flight begins when somebody takes the images and commands, or after this, wall time.",
                  "nodes take seconds to start"},
        c.pilot_s);
  visit(FieldNote{"camera_delay_frames", "", 0, 30, "Frames that an image is on its way.", "exposure and transfer"},
        c.camera_delay_frames);
  visit(FieldNote{"stop_camera_after", "", 0, kIntMax, "For tests: after so many frames no image comes; 0: never.",
                  "a camera that dies in flight"},
        c.stop_camera_after);
}

template <class Launch, class Visitor>
requires std::is_same_v<std::remove_const_t<Launch>, PerceptionLaunch> ||
    std::is_same_v<std::remove_const_t<Launch>, ControlLaunch> ||
    std::is_same_v<std::remove_const_t<Launch>, CameraLaunch>
void visit_sections(Launch& c, Visitor&& visit) { visit("launch", c); }

template <class Launch, class Visitor>
requires std::is_same_v<std::remove_const_t<Launch>, SimLaunch>
void visit_sections(Launch& c, Visitor&& visit) {
  visit("robot", c.robot);
  visit("launch", c);
}

std::vector<Parameter> parameters_of(const PerceptionLaunch& launch) { return listed(launch); }
std::vector<Parameter> parameters_of(const ControlLaunch& launch) { return listed(launch); }
std::vector<Parameter> parameters_of(const CameraLaunch& launch) { return listed(launch); }
std::vector<Parameter> parameters_of(const SimLaunch& launch) { return listed(launch); }

std::string set_parameter(PerceptionLaunch& launch, const std::string& name, const ParameterValue& value) {
  return set_one(launch, name, value);
}
std::string set_parameter(ControlLaunch& launch, const std::string& name, const ParameterValue& value) {
  return set_one(launch, name, value);
}
std::string set_parameter(CameraLaunch& launch, const std::string& name, const ParameterValue& value) {
  return set_one(launch, name, value);
}
std::string set_parameter(SimLaunch& launch, const std::string& name, const ParameterValue& value) {
  return set_one(launch, name, value);
}

}  // namespace adit::node
