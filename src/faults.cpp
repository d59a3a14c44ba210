// Configurations are refused here, field by field, from the same notes that the YAML and the command line are made of.
#include "adit/fields.hpp"
#include "adit/navigator_fields.hpp"
#include "number_text.hpp"

namespace adit {
namespace {

std::optional<std::string> fault_of_number(const FieldNote& note, double value) {
  if (!(value >= note.minimum && value <= note.maximum)) {  // NaN is not in any range
    return range_fault(note.name, value, note.minimum, note.maximum, note.unit);
  }
  const auto whole = static_cast<int>(value);
  if (note.odd && whole != 0 && whole % 2 == 0) {
    return std::string(note.name) + ": " + number_text(value) + " " + note.unit +
           " has no middle pixel; set an odd size, for example " + number_text(value + 1);
  }
  return std::nullopt;
}

template <class Enum>
std::optional<std::string> fault_of_name(const FieldNote& note, Enum value) {
  const auto at = static_cast<int>(value);
  if (at >= 0 && at <= static_cast<int>(note.maximum)) return std::nullopt;
  std::string names;
  for (int i = 0; i <= static_cast<int>(note.maximum); ++i) {
    names += (i > 0 ? ", " : "") + std::string(to_string(static_cast<Enum>(i)));
  }
  return std::string(note.name) + ": " + std::to_string(at) + " is not a known choice; set one of: " + names;
}

template <class Config>
std::optional<std::string> first_fault_of(const Config& config) {
  std::optional<std::string> fault;
  visit_fields(config, [&fault](const FieldNote& note, const auto& value) {
    if (fault) return;
    if constexpr (std::is_enum_v<std::remove_cvref_t<decltype(value)>>) {
      fault = fault_of_name(note, value);
    } else {
      fault = fault_of_number(note, static_cast<double>(value));
    }
  });
  return fault;
}

}  // namespace

std::optional<std::string> fault_of(const FinderConfig& config) { return first_fault_of(config); }
std::optional<std::string> fault_of(const HeadingConfig& config) { return first_fault_of(config); }
std::optional<std::string> fault_of(const ColumnRangeConfig& config) { return first_fault_of(config); }
std::optional<std::string> fault_of(const RangeMemoryConfig& config) { return first_fault_of(config); }
std::optional<std::string> fault_of(const TrackerConfig& config) { return first_fault_of(config); }
std::optional<std::string> fault_of(const FrameWatchConfig& config) { return first_fault_of(config); }
std::optional<std::string> fault_of(const LensWatchConfig& config) { return first_fault_of(config); }
std::optional<std::string> fault_of(const SteeringConfig& config) { return first_fault_of(config); }

}  // namespace adit
