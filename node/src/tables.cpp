#include "adit/node/tables.hpp"

#include <charconv>

#include "adit/node/settings.hpp"

namespace adit::node {
namespace {

constexpr bool kIn = false, kOut = true;

constexpr TopicNote kTopics[] = {
    {"open_space", kIn, "image", "sensor_msgs/Image", "frames; with `image_transport: compressed`, `image/compressed`"},
    {"open_space", kIn, "camera_info", "sensor_msgs/CameraInfo", "calibration; without it the lens is assumed"},
    {"open_space", kIn, "imu", "sensor_msgs/Imu", "optional: yaw rate of a gyroscope whose z axis points up"},
    {"open_space", kOut, "open_space", "adit_ros1/OpenSpace", "where the open space is, or why there is none"},
    {"open_space", kOut, "heading", "geometry_msgs/TwistStamped",
     "body frame (REP 103): forward speed, yaw rate positive to the left; stamp of the image"},
    {"open_space", kOut, "direction", "geometry_msgs/PoseStamped", "an arrow in the optical frame, when listened to"},
    {"open_space", kOut, "scattering_depth", "sensor_msgs/Image",
     "mono8, 0 is far; not metric, not called depth (REP 118); when listened to"},
    {"open_space", kOut, "overlay", "sensor_msgs/Image", "bgr8, the frame with its opening; when listened to"},
    {"open_space", kOut, "/diagnostics", "diagnostic_msgs/DiagnosticArray",
     "rate, latency percentiles, age, status, dropped, and what was wrong with stamps, sizes, encodings"},
    {"controller", kIn, "open_space", "adit_ros1/OpenSpace", "signs of life"},
    {"controller", kIn, "heading", "geometry_msgs/TwistStamped", "what to do; passed on once, if fresh"},
    {"controller", kOut, "cmd_vel", "geometry_msgs/Twist", "body frame; zero while nothing fresh is known"},
    {"controller", kOut, "setpoint_velocity/cmd_vel", "geometry_msgs/TwistStamped",
     "the same, stamped, for MAVROS with `mav_frame: BODY_NED`"},
    {"controller", kOut, "latency", "std_msgs/Float64", "s, from the image's stamp to the command"},
    {"controller", kOut, "controller_state", "std_msgs/String", "`following`, or why it hovers; latched"},
    {"controller", kOut, "/diagnostics", "diagnostic_msgs/DiagnosticArray", "ERROR after error_after_s of hovering"},
    {"camera", kOut, "camera/image_raw", "sensor_msgs/Image", "of a device, a video or a folder of images"},
    {"camera", kOut, "camera/camera_info", "sensor_msgs/CameraInfo", "of `camera_info_url`, or of an ideal lens"},
    {"sim", kIn, "cmd_vel", "geometry_msgs/Twist", "body frame"},
    {"sim", kOut, "/clock", "rosgraph_msgs/Clock", "simulated time, from 1 s on"},
    {"sim", kOut, "camera/image_raw", "sensor_msgs/Image", "rendered, bgr8"},
    {"sim", kOut, "camera/camera_info", "sensor_msgs/CameraInfo", "of the simulated lens"},
    {"sim", kOut, "odom", "nav_msgs/Odometry", "truth: odom to base_link; twist in the body frame"},
    {"sim", kOut, "/tf", "tf2_msgs/TFMessage", "odom to base_link; base_link to camera_optical is static"},
    {"sim", kOut, "scan", "sensor_msgs/LaserScan", "in the body's plane"},
    {"sim", kOut, "imu", "sensor_msgs/Imu", "gyroscope and accelerometer of the body"},
    {"sim", kOut, "outcome", "std_msgs/String", "goal, collided or timeout, with figures; latched"},
};

std::string text_of(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string text_of(const ParameterValue& value) {
  if (const auto* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
  if (const auto* i = std::get_if<int>(&value)) return std::to_string(*i);
  if (const auto* d = std::get_if<double>(&value)) return text_of(*d);
  return std::get<std::string>(value);
}

std::string range_of(const Parameter& p) {
  std::string text;
  for (const std::string& choice : p.choices) text += (text.empty() ? "" : ", ") + choice;
  if (!p.choices.empty()) return text;
  if (std::holds_alternative<bool>(p.value)) return "true, false";
  return text_of(p.minimum) + " to " + text_of(p.maximum) + (p.is_odd ? ", odd" : "");
}

std::string table_of(const char* node, const std::vector<Parameter>& parameters) {
  std::string text =
      "### Node `" + std::string(node) +
      "`\n\n| section | parameter | default | unit | range | meaning | why |\n|---|---|---|---|---|---|---|\n";
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
      text.append("### Node `").append(node).append("`\n\n| | topic | type | meaning |\n|---|---|---|---|\n");
    }
    text.append(t.is_output ? "| out | `" : "| in | `").append(t.name).append("` | ").append(t.type);
    text.append(" | ").append(t.meaning).append(" |\n");
  }
  return text + "\n";
}

std::string parameter_tables() {
  return table_of("open_space", parameters_of(PerceptionSettings{})) +
         table_of("controller", parameters_of(ControlConfig{}));
}

}  // namespace adit::node
