// All that a person may set of the nodes, and from where a message's parameters reach it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "adit/navigator.hpp"
#include "adit/navigator_fields.hpp"
#include "adit/node/control_config.hpp"
#include "adit/node/parameters.hpp"

namespace adit::node {

/// Who turns what the camera shows into commands.
enum class Pilot : std::uint8_t {
  kByMethod,   ///< the published controller for the published method, the navigator for every other
  kPublished,  ///< finder and heading controller in a row, as in the paper
  kNavigator,  ///< the core's Navigator
};
[[nodiscard]] std::string_view to_string(Pilot pilot) noexcept;
[[nodiscard]] bool parse(std::string_view name, Pilot& pilot) noexcept;

/// Of the perception node; unit, range and source of each field stand in visit_fields() below.
struct PerceptionConfig {
  Pilot pilot = Pilot::kByMethod;
  double speed_m_s = 0.2;
  double stamp_jump_s = 0.5;
  bool is_steered = true;
};

template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, PerceptionConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"pilot", "", 0, 2, "Who makes the commands: by_method, published or navigator.",
                  "by_method: the published controller for method paper, the navigator for every other"},
        c.pilot);
  visit(FieldNote{"speed_m_s", "m/s", 0, 10, "Forward speed where nothing asks for less.", "paper, 3.2: 0.2 m/s"},
        c.speed_m_s);
  visit(FieldNote{"stamp_jump_s", "s", 0.01, 60, "Stamps further apart than this, either way, are a jump.",
                  "as hold_after_s"},
        c.stamp_jump_s);
  visit(FieldNote{"is_steered", "", 0, 1,
                  "The camera goes where the commands send it; false for recordings, whose camera is taken to stand.",
                  "as adit run takes recordings"},
        c.is_steered);
}

template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, ControlConfig>
void visit_fields(Config& c, Visitor&& visit) {
  visit(FieldNote{"hover_after_s", "s", 0.05, 10, "Without a fresh image, or without an opening, for this long: hover.",
                  "half a metre at 1 m/s"},
        c.hover_after_s);
  visit(FieldNote{"error_after_s", "s", 0.1, 600, "... for this long: the diagnostics say ERROR.",
                  "longer than a driver's restart"},
        c.error_after_s);
  visit(FieldNote{"speed_max_m_s", "m/s", 0, 10, "No command is faster, whatever the perception node asks for.",
                  "five times the paper's speed"},
        c.speed_max_m_s);
  visit(FieldNote{"yaw_rate_limit_rad_s", "rad/s", 0, 20, "No command turns faster.", "as yaw_rate_max_rad_s"},
        c.yaw_rate_limit_rad_s);
  visit(FieldNote{"turn_without_opening", "", 0, 1,
                  "The navigator's turn in place at a dead end is let through: images still have to be fresh.",
                  "false: whoever sees no opening hovers"},
        c.turn_without_opening);
}

/// Why a configuration is refused, naming the field, the value and the range. Empty when it is good.
[[nodiscard]] std::optional<std::string> fault_of(const PerceptionConfig& config);

/// The perception node's, section by section.
struct PerceptionSettings {
  PerceptionConfig node;
  NavigatorConfig navigator;
};

/// Calls visit(section name, section) for each; `Settings` may be const.
template <class Settings, class Visitor>
requires std::is_same_v<std::remove_const_t<Settings>, PerceptionSettings>
void visit_sections(Settings& s, Visitor&& visit) {
  visit("node", s.node);
  visit("finder", s.navigator.finder);
  visit("heading", s.navigator.heading);
  visit("column_range", s.navigator.column_range);
  visit("range_memory", s.navigator.range_memory);
  visit("tracker", s.navigator.tracker);
  visit("steering", s.navigator.steering);
  visit("frame_watch", s.navigator.frame_watch);
  visit("lens_watch", s.navigator.lens_watch);
}
template <class Settings, class Visitor>
requires std::is_same_v<std::remove_const_t<Settings>, ControlConfig>
void visit_sections(Settings& s, Visitor&& visit) { visit("control", s); }

/// All parameters with their present values, in the order of the fields.
[[nodiscard]] std::vector<Parameter> parameters_of(const PerceptionSettings& settings);
[[nodiscard]] std::vector<Parameter> parameters_of(const ControlConfig& settings);

/// Sets one. A whole number is taken for a double, and a double without a fraction for a whole number.
/// @return why it is refused, naming the parameter, the value and the range; "" when it is taken.
[[nodiscard]] std::string set_parameter(PerceptionSettings& settings, std::string_view name,
                                        const ParameterValue& value);
[[nodiscard]] std::string set_parameter(ControlConfig& settings, std::string_view name, const ParameterValue& value);

}  // namespace adit::node
