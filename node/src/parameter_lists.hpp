// Fields of structs as lists of parameters: what settings.cpp and launch_config.cpp share.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "adit/fields.hpp"
#include "adit/node/parameters.hpp"

namespace adit::node {

inline std::string number_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

inline std::string outside(const FieldNote& note, double value) {
  std::string unit = *note.unit != '\0' ? std::string(" ").append(note.unit) : "";
  return std::string(note.name) + ": " + number_text(value) + unit + " is not in [" + number_text(note.minimum) + ", " +
         number_text(note.maximum) + "]" + unit + "; set a value in this range";
}

inline std::string wrong_type(const FieldNote& note, const char* wanted) {
  return std::string(note.name) + ": a value of the wrong type; set " + wanted;
}

/// Numbers alone.
inline std::optional<double> number_of(const ParameterValue& value) {
  if (const auto* d = std::get_if<double>(&value)) return *d;
  if (const auto* i = std::get_if<int>(&value)) return *i;
  return std::nullopt;
}

template <class Enum>
std::vector<std::string> choices_of(const FieldNote& note) {
  std::vector<std::string> names;
  for (int i = 0; i <= static_cast<int>(note.maximum); ++i) names.emplace_back(to_string(static_cast<Enum>(i)));
  return names;
}

template <class Enum>
std::string take_choice(const FieldNote& note, const ParameterValue& value, Enum& member) {
  const auto* name = std::get_if<std::string>(&value);
  if (name != nullptr && parse(*name, member)) return "";
  std::string known;
  for (const std::string& choice : choices_of<Enum>(note)) known += (known.empty() ? "" : ", ") + choice;
  return std::string(note.name) + ": " + (name != nullptr ? "'" + *name + "'" : "this") + " is not known; set one of " +
         known;
}

template <class Member>
std::string take(const FieldNote& note, const ParameterValue& value, Member& member) {
  if constexpr (std::is_same_v<Member, bool>) {
    const auto* flag = std::get_if<bool>(&value);
    if (flag == nullptr) return wrong_type(note, "true or false");
    member = *flag;
    return "";
  } else if constexpr (std::is_same_v<Member, std::string>) {
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) return wrong_type(note, "text");
    member = *text;
    return "";
  } else if constexpr (std::is_enum_v<Member>) {
    return take_choice(note, value, member);
  } else {
    const auto number = number_of(value);
    if (!number) return wrong_type(note, "a number");
    if (!(*number >= note.minimum && *number <= note.maximum)) return outside(note, *number);
    if constexpr (std::is_integral_v<Member>)
      if (*number != std::floor(*number)) return wrong_type(note, "a whole number");
    member = static_cast<Member>(*number);
    return "";
  }
}

template <class Member>
ParameterValue value_of(const Member& member) {
  if constexpr (std::is_enum_v<Member>)
    return std::string(to_string(member));
  else if constexpr (std::is_same_v<Member, std::uint64_t>)
    return static_cast<int>(member);
  else
    return member;
}

template <class Settings>
std::vector<Parameter> listed(const Settings& settings) {
  std::vector<Parameter> parameters;
  visit_sections(settings, [&](const char* section, const auto& object) {
    visit_fields(object, [&](const FieldNote& note, const auto& member) {
      using Member = std::remove_cvref_t<decltype(member)>;
      Parameter parameter{section,      note.name, value_of(member), note.unit,   note.minimum,
                          note.maximum, note.odd,  note.meaning,     note.source, {}};
      if constexpr (std::is_enum_v<Member>) parameter.choices = choices_of<Member>(note);
      parameters.push_back(std::move(parameter));
    });
  });
  return parameters;
}

/// A section is changed as a whole or not at all: what its fault_of() refuses leaves no trace.
template <class Settings>
std::string set_one(Settings& settings, std::string_view name, const ParameterValue& value) {
  std::string why = std::string(name) + ": there is no such parameter";
  visit_sections(settings, [&](const char*, auto& object) {
    auto changed = object;
    bool is_here = false;
    visit_fields(changed, [&](const FieldNote& note, auto& member) {
      if (name != note.name) return;
      is_here = true;
      why = take(note, value, member);
    });
    if (!is_here || !why.empty()) return;
    if constexpr (requires { fault_of(changed); })
      if (const auto fault = fault_of(changed)) why = *fault;
    if (why.empty()) object = changed;
  });
  return why;
}

/// Of the fields alone.
template <class Config>
std::optional<std::string> first_fault(const Config& config) {
  std::optional<std::string> fault;
  visit_fields(config, [&](const FieldNote& note, const auto& member) {
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::is_same_v<Member, double>)
      if (!fault && !(member >= note.minimum && member <= note.maximum)) fault = outside(note, member);
  });
  return fault;
}

}  // namespace adit::node
