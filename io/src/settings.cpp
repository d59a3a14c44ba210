#include "adit/io/settings.hpp"

#include <cstdio>
#include <map>

#include "text_file.hpp"
#include "yaml.hpp"

namespace adit::io {
namespace {

std::string range_of(const FieldNote& note) {
  std::string range = shortest(note.minimum) + " to " + shortest(note.maximum);
  if (note.unit[0] != '\0') range.append(" ").append(note.unit);
  return range;
}

template <class Number>
std::string take_as(const FieldNote& note, std::string_view text, Number& value) {
  if (!parse_number(text, value)) {
    return std::string(note.name) + ": " + in_quotes(text) +
           (std::is_integral_v<Number> ? " is not a whole number" : " is not a number") + "; it takes " +
           range_of(note);
  }
  if (!(value >= note.minimum && value <= note.maximum)) {
    return std::string(note.name) + ": " + shortest(value) + " is out of range; it takes " + range_of(note);
  }
  return "";
}

std::vector<std::string> keys_of(const SettingSection& section) {
  std::vector<std::string> keys;
  for (const Setting& setting : section.settings) keys.emplace_back(setting.note.name);
  return keys;
}

std::vector<std::string> names_of(const std::vector<SettingSection>& sections) {
  std::vector<std::string> names;
  for (const SettingSection& section : sections) names.push_back(section.name);
  return names;
}

const Setting* setting_named(const SettingSection& section, std::string_view key) {
  for (const Setting& setting : section.settings) {
    if (key == setting.note.name) return &setting;
  }
  return nullptr;
}

/// Takes a value for a key. Returns why it is refused, "" when it is taken.
std::string take_key(const SettingSection& section, std::string_view key, std::string_view text) {
  const Setting* setting = setting_named(section, key);
  return setting ? setting->take(text) : "unknown key " + in_quotes(key) + hint_for(key, keys_of(section));
}

[[noreturn]] void refuse(std::string_view file, const YAML::Mark& mark, const std::string& why) {
  throw ConfigError(place_of(file, mark) + ": " + why);
}

void read_section(const YAML::Node& node, std::string_view file, const SettingSection& section) {
  if (node.IsNull()) return;
  if (!node.IsMap()) refuse(file, node.Mark(), section.name + ": not a list of keys and values (key: value)");
  // Where each key was, to name the line when the section as a whole is refused.
  std::map<std::string, YAML::Mark, std::less<>> places;
  for (const auto& entry : node) {
    if (!entry.first.IsScalar()) refuse(file, entry.first.Mark(), section.name + ": a key is not a word");
    const std::string& key = entry.first.Scalar();
    if (!places.emplace(key, entry.first.Mark()).second) refuse(file, entry.first.Mark(), key + ": given twice");
    const bool plain = entry.second.IsScalar();
    const std::string why = take_key(section, key, plain ? std::string_view(entry.second.Scalar()) : "");
    if (why.empty()) continue;
    refuse(file, entry.first.Mark(), plain || why.starts_with("unknown") ? why : key + ": one value is wanted here");
  }
  if (const std::string why = section.fault(); !why.empty()) {
    const auto place = places.find(std::string_view(why).substr(0, why.find(':')));
    refuse(file, place != places.end() ? place->second : YAML::Mark::null_mark(), why);
  }
}

}  // namespace

std::string take_number(const FieldNote& note, std::string_view text, double& value) {
  double taken{};
  std::string why = take_as(note, text, taken);
  if (why.empty()) value = taken;
  return why;
}

std::string take_number(const FieldNote& note, std::string_view text, int& value) {
  int taken{};
  std::string why = take_as(note, text, taken);
  if (why.empty()) value = taken;
  return why;
}

std::string take_number(const FieldNote& note, std::string_view text, float& value) {
  double taken{};
  std::string why = take_as(note, text, taken);
  if (why.empty()) value = static_cast<float>(taken);
  return why;
}

std::string take_number(const FieldNote& note, std::string_view text, bool& value) {
  int taken = text == "true" ? 1 : 0;
  std::string why = text == "true" || text == "false" ? "" : take_as(note, text, taken);
  if (why.empty()) value = taken != 0;
  return why;
}

std::string refused_choice(const FieldNote& note, std::string_view text, const std::vector<std::string>& choices) {
  return std::string(note.name) + ": " + in_quotes(text) + " is none of its values" + hint_for(text, choices);
}

std::string number_text(double value) { return shortest(value); }
std::string number_text(int value) { return std::to_string(value); }

std::string number_text(float value) {
  // Its own shortest digits, not those of the double beside it: 0.1, not 0.10000000149.
  for (int digits = 1; digits < 9; ++digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, static_cast<double>(value));
    double back = 0.0;
    if (parse_number(std::string_view(text), back) && static_cast<float>(back) == value) return shortest(back);
  }
  return shortest(static_cast<double>(value));
}

void Settings::read_yaml(std::string_view text, std::string_view name) {
  const YAML::Node root = load_yaml(text, name);
  std::map<std::string, bool> seen;
  for (const auto& entry : root) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    const YAML::Mark mark = entry.first.Mark();
    if (!seen.emplace(key, true).second) refuse(name, mark, key + ": given twice");
    bool known = false;
    std::string hint = hint_for(key, names_of(sections_));
    for (const SettingSection& section : sections_) {
      if (setting_named(section, key)) hint = "; it belongs into the section '" + section.name + ":'";
      if (key != section.name) continue;
      known = true;
      read_section(entry.second, name, section);
    }
    if (!known) refuse(name, mark, "unknown section " + in_quotes(key) + hint);
  }
}

void Settings::read_file(const std::filesystem::path& path) { read_yaml(read_settings_text(path), path.string()); }

void Settings::set(std::string_view assignment) {
  const auto refuse_it = [assignment](const std::string& why) {
    throw ConfigError("--set " + on_one_line(assignment) + ": " + why);
  };
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) refuse_it("not of the form key=value");
  std::string_view key = assignment.substr(0, equals);
  const std::string_view text = assignment.substr(equals + 1);
  std::string_view wanted_section;
  if (const std::size_t dot = key.find('.'); dot != std::string_view::npos) {
    wanted_section = key.substr(0, dot);
    key.remove_prefix(dot + 1);
  }
  const SettingSection* found = nullptr;
  std::vector<std::string> all_keys;
  for (const SettingSection& section : sections_) {
    if (!wanted_section.empty() && wanted_section != section.name) continue;
    for (const std::string& field : keys_of(section)) all_keys.push_back(field);
    if (!setting_named(section, key)) continue;
    if (found) {
      refuse_it("there are '" + found->name + "." + std::string(key) + "' and '" + section.name + "." +
                std::string(key) + "': name the section");
    }
    found = &section;
  }
  if (all_keys.empty()) {
    refuse_it("unknown section " + in_quotes(wanted_section) + hint_for(wanted_section, names_of(sections_)));
  }
  if (!found) refuse_it("unknown key " + in_quotes(key) + hint_for(key, all_keys));
  const std::string before = setting_named(*found, key)->value();
  if (const std::string why = take_key(*found, key, text); !why.empty()) refuse_it(why);
  if (const std::string why = found->fault(); !why.empty()) {
    static_cast<void>(take_key(*found, key, before));
    refuse_it(why);
  }
}

std::string Settings::to_yaml() const {
  std::string yaml;
  for (const SettingSection& section : sections_) {
    yaml += (yaml.empty() ? "" : "\n") + section.name + ":\n";
    for (const Setting& setting : section.settings) {
      std::string range;
      for (const std::string& choice : setting.choices) range += (range.empty() ? "" : " | ") + choice;
      if (range.empty()) range = range_of(setting.note);
      yaml += "  # " + std::string(setting.note.meaning) + "\n  # [" + range + "]";
      if (setting.note.source[0] != '\0') yaml += " Source: " + std::string(setting.note.source) + ".";
      yaml += "\n  " + std::string(setting.note.name) + ": " + setting.value() + "\n";
    }
  }
  return yaml;
}

}  // namespace adit::io
