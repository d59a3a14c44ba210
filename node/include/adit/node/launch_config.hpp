// What is set when a node starts, and not later: names, files and whatever its topics are made of. C++17, see
// parameters.hpp. Unit, range and reason of each field stand in launch_config.cpp.
#pragma once

#include <string>
#include <vector>

#include "adit/node/parameters.hpp"
#include "adit/node/simulated_robot.hpp"

namespace adit::node {

struct PerceptionLaunch {
  std::string image_transport = "raw";
  std::string body_frame = "base_link";
};

struct ControlLaunch {
  std::string body_frame = "base_link";
};

struct CameraLaunch {
  std::string input;
  std::string camera_info_url;
  std::string frame_id = "camera_optical";
  double rate_hz = 30.0;
  double hfov_deg = 75.0;
  bool loop = true;
  bool preload = false;
  int freeze_after = 0;  ///< frames
};

struct SimLaunch {
  SimulatedRobotConfig robot;
  bool lockstep = false;
  double wait_s = 1.0;
  double real_time_factor = 1.0;
  double pilot_s = 10.0;
  int camera_delay_frames = 1;
  int stop_camera_after = 0;  ///< frames
};

/// As of Perception: all parameters with their present values, and one of them set by name.
[[nodiscard]] std::vector<Parameter> parameters_of(const PerceptionLaunch& launch);
[[nodiscard]] std::vector<Parameter> parameters_of(const ControlLaunch& launch);
[[nodiscard]] std::vector<Parameter> parameters_of(const CameraLaunch& launch);
[[nodiscard]] std::vector<Parameter> parameters_of(const SimLaunch& launch);
/// @return why it is refused, naming the parameter, the value and the range; "" when it is taken.
[[nodiscard]] std::string set_parameter(PerceptionLaunch& launch, const std::string& name, const ParameterValue& value);
[[nodiscard]] std::string set_parameter(ControlLaunch& launch, const std::string& name, const ParameterValue& value);
[[nodiscard]] std::string set_parameter(CameraLaunch& launch, const std::string& name, const ParameterValue& value);
[[nodiscard]] std::string set_parameter(SimLaunch& launch, const std::string& name, const ParameterValue& value);

}  // namespace adit::node
