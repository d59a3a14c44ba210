#include "config_fields.hpp"

#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <type_traits>

#include "adit/navigator_fields.hpp"

namespace adit::c_interface {
namespace {

/// Calls visit(section name, section).
template <class Config, class Visitor>
void visit_sections(Config& config, Visitor&& visit) {
  visit("finder", config.finder);
  visit("heading", config.heading);
  visit("column_range", config.column_range);
  visit("range_memory", config.range_memory);
  visit("tracker", config.tracker);
  visit("steering", config.steering);
  visit("frame_watch", config.frame_watch);
  visit("lens_watch", config.lens_watch);
}

bool is_named(std::string_view field, std::string_view section, std::string_view name) {
  if (field == name) return true;
  return field.size() == section.size() + 1 + name.size() && field.substr(0, section.size()) == section &&
         field[section.size()] == '.' && field.substr(section.size() + 1) == name;
}

/// Calls visit(section, note, member) for the first field of that name. @throws std::invalid_argument
template <class Config, class Visitor>
void at_field(Config& config, std::string_view field, const Visitor& visit) {
  bool found = false;
  visit_sections(config, [&](const char* name, auto& section) {
    visit_fields(section, [&](const FieldNote& note, auto& member) {
      if (found || !is_named(field, name, note.name)) return;
      found = true;
      visit(section, note, member);
    });
  });
  if (!found)
    throw std::invalid_argument("there is no field '" + std::string(field) + "'; adit_config_field() lists all");
}

/// Takes the value unless the section then has a fault.
template <class Section, class Member>
void take(Section& section, Member& member, Member value) {
  const Member before = member;
  member = value;
  if (const auto fault = fault_of(section)) {
    member = before;
    throw std::invalid_argument(*fault);
  }
}

template <class Section, class Member>
void take_number(Section& section, const FieldNote& note, Member& member, double value) {
  if constexpr (std::is_integral_v<Member>) {
    // Checked before the conversion, which is not defined for what an int cannot hold.
    if (!(value >= note.minimum && value <= note.maximum) || value != std::floor(value)) {
      std::ostringstream text;
      text.imbue(std::locale::classic());
      text << note.name << ": " << value << " is no whole number in [" << note.minimum << ", " << note.maximum << "]";
      throw std::invalid_argument(text.str());
    }
  }
  take(section, member, static_cast<Member>(value));
}

[[noreturn]] void refuse(const FieldNote& note, std::string_view value, const char* why) {
  throw std::invalid_argument(std::string(note.name) + ": '" + std::string(value) + "' " + why);
}

double number_of(const FieldNote& note, std::string_view value) {
  std::istringstream text{std::string(value)};
  text.imbue(std::locale::classic());  // a point in every locale
  double number = 0.0;
  if (!(text >> number) || text.peek() != std::istringstream::traits_type::eof()) refuse(note, value, "is no number");
  return number;
}

/// The fewest digits that give the number again. Not std::to_chars: emscripten's library has none for reals.
std::string shortest_text(double number) {
  constexpr int kDigitsMax = 17;
  for (int digits = 1;; ++digits) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(digits);
    text << number;
    std::istringstream back(text.str());
    back.imbue(std::locale::classic());
    double read = 0.0;
    if (digits == kDigitsMax || (back >> read && read == number)) return text.str();
  }
}

template <class Enum>
std::string choices_of(const FieldNote& note) {
  std::string names = "is none of:";
  for (int i = 0; i <= static_cast<int>(note.maximum); ++i) names.append(" ").append(to_string(static_cast<Enum>(i)));
  return names;
}

}  // namespace

void set_field(NavigatorConfig& config, std::string_view field, std::string_view value) {
  at_field(config, field, [&](auto& section, const FieldNote& note, auto& member) {
    using Member = std::remove_reference_t<decltype(member)>;
    if constexpr (std::is_enum_v<Member>) {
      Member chosen = member;
      if (!parse(value, chosen)) refuse(note, value, choices_of<Member>(note).c_str());
      take(section, member, chosen);
    } else {
      take_number(section, note, member, number_of(note, value));
    }
  });
}

void set_field(NavigatorConfig& config, std::string_view field, double value) {
  at_field(config, field, [&](auto& section, const FieldNote& note, auto& member) {
    using Member = std::remove_reference_t<decltype(member)>;
    if constexpr (std::is_enum_v<Member>) {
      refuse(note, "a number", choices_of<Member>(note).c_str());
    } else {
      take_number(section, note, member, value);
    }
  });
}

std::string field_text(const NavigatorConfig& config, std::string_view field) {
  std::string text;
  at_field(config, field, [&](const auto&, const FieldNote&, const auto& member) {
    if constexpr (std::is_enum_v<std::remove_cvref_t<decltype(member)>>) {
      text = to_string(member);
    } else {
      text = shortest_text(static_cast<double>(member));
    }
  });
  return text;
}

std::vector<std::string> field_names() {
  std::vector<std::string> names;
  const NavigatorConfig config;
  visit_sections(config, [&](const char* name, const auto& section) {
    visit_fields(section,
                 [&](const FieldNote& note, const auto&) { names.push_back(std::string(name) + "." + note.name); });
  });
  return names;
}

}  // namespace adit::c_interface
