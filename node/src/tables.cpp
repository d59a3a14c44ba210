#include "adit/node/tables.hpp"

#include "adit/node/launch_config.hpp"
#include "adit/node/settings.hpp"
#include "parameter_lists.hpp"

namespace adit::node {
namespace {

constexpr TopicNote kTopics[] = {
    {"open_space", "in", "image", "sensor_msgs/Image", "image_transport: raw", "frames, by image_transport"},
    {"open_space", "in", "image/compressed", "sensor_msgs/CompressedImage", "image_transport: compressed", "frames"},
    {"open_space", "in", "camera_info", "sensor_msgs/CameraInfo", "always",
     "calibration; without it the lens is assumed"},
    {"open_space", "in", "imu", "sensor_msgs/Imu", "always",
     "optional: yaw rate of a gyroscope whose z axis points up"},
    {"open_space", "out", "open_space", "adit_ros1/OpenSpace", "always",
     "where the open space is, or why there is none"},
    {"open_space", "out", "heading", "geometry_msgs/TwistStamped", "always",
     "body frame (REP 103): forward speed, yaw rate positive to the left; stamp of the image"},
    {"open_space", "out", "direction", "geometry_msgs/PoseStamped", "always",
     "an arrow in the optical frame; sent while somebody listens"},
    {"open_space", "out", "scattering_depth", "sensor_msgs/Image", "always",
     "mono8, 0 is far; not metric, not called depth (REP 118); made while somebody listens"},
    {"open_space", "out", "overlay", "sensor_msgs/Image", "always",
     "bgr8, the frame with its opening; made while somebody listens"},
    {"open_space", "out", "/diagnostics", "diagnostic_msgs/DiagnosticArray", "always",
     "rate, latency percentiles, age, status, dropped, and what was wrong with stamps, sizes, encodings"},
    {"open_space", "out", "~parameter_descriptions", "dynamic_reconfigure/ConfigDescription", "always",
     "each parameter's range and meaning; latched"},
    {"open_space", "out", "~parameter_updates", "dynamic_reconfigure/Config", "always",
     "the values in force, after each change; latched"},
    {"open_space", "service", "~set_parameters", "dynamic_reconfigure/Reconfigure", "always",
     "changes parameters live"},
    {"controller", "in", "open_space", "adit_ros1/OpenSpace", "always", "signs of life"},
    {"controller", "in", "heading", "geometry_msgs/TwistStamped", "always", "what to do; passed on once, if fresh"},
    {"controller", "out", "cmd_vel", "geometry_msgs/Twist", "always", "body frame; zero while nothing fresh is known"},
    {"controller", "out", "setpoint_velocity/cmd_vel", "geometry_msgs/TwistStamped", "always",
     "the same, stamped, for MAVROS with `mav_frame: BODY_NED`"},
    {"controller", "out", "setpoint_raw/local", "mavros_msgs/PositionTarget", "built with mavros_msgs",
     "the same for MAVROS: FRAME_BODY_NED, velocity and yaw rate"},
    {"controller", "out", "latency", "std_msgs/Float64", "always", "s, from the image's stamp to the command"},
    {"controller", "out", "controller_state", "std_msgs/String", "always", "`following`, or why it hovers; latched"},
    {"controller", "out", "/diagnostics", "diagnostic_msgs/DiagnosticArray", "always",
     "ERROR after error_after_s of hovering"},
    {"controller", "out", "~parameter_descriptions", "dynamic_reconfigure/ConfigDescription", "always",
     "each parameter's range and meaning; latched"},
    {"controller", "out", "~parameter_updates", "dynamic_reconfigure/Config", "always",
     "the values in force, after each change; latched"},
    {"controller", "service", "~set_parameters", "dynamic_reconfigure/Reconfigure", "always",
     "changes parameters live"},
    {"camera", "out", "camera/image_raw", "sensor_msgs/Image", "always",
     "of a device, a video or a folder of images; and below it what transports are installed"},
    {"camera", "out", "camera/camera_info", "sensor_msgs/CameraInfo", "always",
     "of `camera_info_url`, or of an ideal lens"},
    {"camera", "service", "set_camera_info", "sensor_msgs/SetCameraInfo", "always",
     "keeps a calibration, as camera_info_manager does"},
    {"sim", "in", "cmd_vel", "geometry_msgs/Twist", "always", "body frame"},
    {"sim", "out", "/clock", "rosgraph_msgs/Clock", "always", "simulated time, from 1 s on"},
    {"sim", "out", "camera/image_raw", "sensor_msgs/Image", "always", "rendered, bgr8"},
    {"sim", "out", "camera/camera_info", "sensor_msgs/CameraInfo", "always", "of the simulated lens"},
    {"sim", "out", "odom", "nav_msgs/Odometry", "always", "truth: odom to base_link; twist in the body frame"},
    {"sim", "out", "/tf", "tf2_msgs/TFMessage", "always", "odom to base_link"},
    {"sim", "out", "/tf_static", "tf2_msgs/TFMessage", "always", "base_link to camera_optical; latched"},
    {"sim", "out", "scan", "sensor_msgs/LaserScan", "always", "in the body's plane"},
    {"sim", "out", "imu", "sensor_msgs/Imu", "always", "gyroscope and accelerometer of the body"},
    {"sim", "out", "outcome", "std_msgs/String", "always", "goal, collided or timeout, with figures; latched"},
};

std::string text_of(const ParameterValue& value) {
  if (const auto* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
  if (const auto* i = std::get_if<int>(&value)) return std::to_string(*i);
  if (const auto* d = std::get_if<double>(&value)) return number_text(*d);
  return std::get<std::string>(value);
}

std::string range_of(const Parameter& p) {
  std::string text;
  for (const std::string& choice : p.choices) text += (text.empty() ? "" : ", ") + choice;
  if (!p.choices.empty()) return text;
  if (std::holds_alternative<bool>(p.value)) return "true, false";
  if (std::holds_alternative<std::string>(p.value)) return "text";
  return number_text(p.minimum) + " to " + number_text(p.maximum) + (p.is_odd ? ", odd" : "");
}

std::string table_of(const char* node, const char* when, const std::vector<Parameter>& parameters) {
  std::string text =
      "### Node `" + std::string(node) + "`" + when +
      "\n\n| section | parameter | default | unit | range | meaning | why |\n|---|---|---|---|---|---|---|\n";
  for (const Parameter& p : parameters)
    text += "| " + p.section + " | `" + p.name + "` | " + text_of(p.value) + " | " + p.unit + " | " + range_of(p) +
            " | " + p.meaning + " | " + p.source + " |\n";
  return text + "\n";
}

}  // namespace

std::string topic_tables() {
  std::string text, node;
  for (const TopicNote& t : kTopics) {
    if (node != t.node) {
      node = t.node;
      if (!text.empty()) text += "\n";
      text.append("### Node `")
          .append(node)
          .append("`\n\n| | name | type | there | meaning |\n|---|---|---|---|---|\n");
    }
    text.append("| ").append(t.way).append(" | `").append(t.name).append("` | ").append(t.type);
    text.append(" | ").append(t.where).append(" | ").append(t.meaning).append(" |\n");
  }
  return text + "\n";
}

std::string parameter_tables() {
  return table_of("open_space", "", parameters_of(PerceptionSettings{})) +
         table_of("open_space", ", at its start alone", parameters_of(PerceptionLaunch{})) +
         table_of("controller", "", parameters_of(ControlConfig{})) +
         table_of("controller", ", at its start alone", parameters_of(ControlLaunch{})) +
         table_of("camera", ", at its start alone", parameters_of(CameraLaunch{})) +
         table_of("sim", ", at its start alone", parameters_of(SimLaunch{}));
}

}  // namespace adit::node
