#include "adit/node/settings.hpp"

#include "parameter_lists.hpp"

namespace adit::node {
namespace {

constexpr std::string_view kPilotNames[] = {"by_method", "published", "navigator"};

}  // namespace

std::string_view to_string(Pilot pilot) noexcept { return kPilotNames[static_cast<std::size_t>(pilot)]; }

bool parse(std::string_view name, Pilot& pilot) noexcept {
  for (std::size_t i = 0; i < std::size(kPilotNames); ++i) {
    if (name != kPilotNames[i]) continue;
    pilot = static_cast<Pilot>(i);
    return true;
  }
  return false;
}

std::optional<std::string> fault_of(const PerceptionConfig& config) { return first_fault(config); }

std::optional<std::string> fault_of(const ControlConfig& config) {
  if (auto fault = first_fault(config)) return fault;
  if (config.error_after_s < config.hover_after_s)
    return "error_after_s: " + number_text(config.error_after_s) + " s is shorter than hover_after_s (" +
           number_text(config.hover_after_s) + " s); set it longer";
  return std::nullopt;
}

std::vector<Parameter> parameters_of(const PerceptionSettings& settings) { return listed(settings); }
std::vector<Parameter> parameters_of(const ControlConfig& settings) { return listed(settings); }

std::string set_parameter(PerceptionSettings& settings, std::string_view name, const ParameterValue& value) {
  return set_one(settings, name, value);
}
std::string set_parameter(ControlConfig& settings, std::string_view name, const ParameterValue& value) {
  return set_one(settings, name, value);
}

}  // namespace adit::node
