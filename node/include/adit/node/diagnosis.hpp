// How a node is, for people and for whoever watches the robot (ROS's diagnostic_msgs/DiagnosticStatus).
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace adit::node {

/// In the order, and with the values, of DiagnosticStatus.
enum class Level : std::uint8_t { kOk, kWarn, kError };

struct Diagnosis {
  Level level = Level::kOk;
  std::string message;  ///< one line
  std::vector<std::pair<std::string, std::string>> values;

  /// Takes the worse level with its message; of equal levels the first stays.
  void worsen(Level worse, const std::string& why) {
    if (worse <= level) return;
    level = worse;
    message = why;
  }
  void add(std::string key, std::string value) { values.emplace_back(std::move(key), std::move(value)); }
};

}  // namespace adit::node
