#include "adit/io/configuration.hpp"

#include <map>
#include <type_traits>
#include <vector>

#include "adit/fields.hpp"
#include "text_file.hpp"
#include "yaml.hpp"

namespace adit::io {
namespace {

/// The names of an enumeration's values, in order: FieldNote::maximum says how many there are.
template <class Enum>
std::vector<std::string> names_of(const FieldNote& note) {
  std::vector<std::string> names;
  for (int i = 0; i <= static_cast<int>(note.maximum); ++i) names.emplace_back(to_string(static_cast<Enum>(i)));
  return names;
}

std::string range_of(const FieldNote& note) {
  return shortest(note.minimum) + " to " + shortest(note.maximum) +
         (note.unit[0] == '\0' ? "" : " " + std::string(note.unit));
}

/// Takes the text of a value. Returns why it is refused, "" when it is taken.
template <class Value>
std::string take(const FieldNote& note, std::string_view text, Value& member) {
  const std::string field = std::string(note.name) + ": " + in_quotes(text);
  if constexpr (std::is_enum_v<Value>) {
    return parse(text, member) ? "" : field + " is none of its values" + hint_for(text, names_of<Value>(note));
  } else {
    Value value{};
    if (!parse_number(text, value)) {
      return field + (std::is_integral_v<Value> ? " is not a whole number" : " is not a number") + "; it takes " +
             range_of(note);
    }
    if (!(value >= note.minimum && value <= note.maximum)) {
      return std::string(note.name) + ": " + shortest(value) + " is out of range; it takes " + range_of(note);
    }
    member = value;
    return "";
  }
}

template <class Section>
std::vector<std::string> keys_of(const Section& section) {
  std::vector<std::string> keys;
  visit_fields(section, [&keys](const FieldNote& note, const auto&) { keys.emplace_back(note.name); });
  return keys;
}

std::vector<std::string> section_names() {
  std::vector<std::string> names;
  Configuration defaults;
  visit_sections(defaults, [&names](const char* name, const auto&) { names.emplace_back(name); });
  return names;
}

/// Takes a value for a key. Returns why it is refused, "" when it is taken.
template <class Section>
std::string take_key(Section& section, std::string_view key, std::string_view text) {
  bool known = false;
  std::string fault;
  visit_fields(section, [&](const FieldNote& note, auto& member) {
    if (key != note.name) return;
    known = true;
    fault = take(note, text, member);
  });
  if (!known) return "unknown key " + in_quotes(key) + hint_for(key, keys_of(section));
  return fault;
}

/// Where each key of a section was, to name the line when the section as a whole is refused.
using Places = std::map<std::string, YAML::Mark, std::less<>>;

template <class Section>
void read_section(const YAML::Node& node, std::string_view file, const char* name, Section& section) {
  const auto refuse = [file](const YAML::Mark& mark, const std::string& why) {
    throw ConfigError(place_of(file, mark) + ": " + why);
  };
  if (node.IsNull()) return;
  if (!node.IsMap()) refuse(node.Mark(), std::string(name) + ": not a list of keys and values (key: value)");
  Places places;
  for (const auto& entry : node) {
    if (!entry.first.IsScalar()) refuse(entry.first.Mark(), std::string(name) + ": a key is not a word");
    const std::string& key = entry.first.Scalar();
    if (!places.emplace(key, entry.first.Mark()).second) refuse(entry.first.Mark(), key + ": given twice");
    const bool plain = entry.second.IsScalar();
    const std::string why = take_key(section, key, plain ? std::string_view(entry.second.Scalar()) : "");
    if (why.empty()) continue;
    refuse(entry.first.Mark(), plain || why.starts_with("unknown") ? why : key + ": one value is wanted here");
  }
  if (const auto why = fault_of(section)) {
    const auto place = places.find(std::string_view(*why).substr(0, why->find(':')));
    refuse(place != places.end() ? place->second : YAML::Mark::null_mark(), *why);
  }
}

}  // namespace

void read_yaml(std::string_view text, std::string_view name, Configuration& configuration) {
  const YAML::Node root = load_yaml(text, name);
  std::map<std::string, bool> seen;
  for (const auto& entry : root) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    const std::string place = place_of(name, entry.first.Mark());
    if (!seen.emplace(key, true).second) throw ConfigError(place + ": " + key + ": given twice");
    bool known = false;
    visit_sections(configuration, [&](const char* section_name, auto& section) {
      if (key != section_name) return;
      known = true;
      read_section(entry.second, name, section_name, section);
    });
    if (known) continue;
    std::string hint = hint_for(key, section_names());
    visit_sections(configuration, [&](const char* section_name, const auto& section) {
      for (const std::string& field : keys_of(section)) {
        if (field == key) hint = "; it belongs into the section '" + std::string(section_name) + ":'";
      }
    });
    throw ConfigError(place + ": unknown section " + in_quotes(key) + hint);
  }
}

void read_configuration(const std::filesystem::path& path, Configuration& configuration) {
  read_yaml(read_settings_text(path), path.string(), configuration);
}

void set_field(std::string_view assignment, Configuration& configuration) {
  const auto refuse = [assignment](const std::string& why) {
    throw ConfigError("--set " + std::string(assignment) + ": " + why);
  };
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) refuse("not of the form key=value");
  std::string_view key = assignment.substr(0, equals);
  const std::string_view text = assignment.substr(equals + 1);
  std::string_view wanted_section;
  if (const std::size_t dot = key.find('.'); dot != std::string_view::npos) {
    wanted_section = key.substr(0, dot);
    key.remove_prefix(dot + 1);
  }
  bool known = false;
  std::vector<std::string> all_keys;
  visit_sections(configuration, [&](const char* section_name, auto& section) {
    if (!wanted_section.empty() && wanted_section != section_name) return;
    for (const std::string& field : keys_of(section)) {
      all_keys.push_back(field);
      if (field != key) continue;
      known = true;
      auto changed = section;
      if (const std::string why = take_key(changed, key, text); !why.empty()) refuse(why);
      if (const auto why = fault_of(changed)) refuse(*why);
      section = changed;
    }
  });
  if (all_keys.empty()) refuse("unknown section " + in_quotes(wanted_section) + hint_for(wanted_section, section_names()));
  if (!known) refuse("unknown key " + in_quotes(key) + hint_for(key, all_keys));
}

std::string to_yaml(const Configuration& configuration) {
  std::string yaml;
  visit_sections(configuration, [&yaml](const char* section_name, const auto& section) {
    yaml += (yaml.empty() ? "" : "\n") + std::string(section_name) + ":\n";
    visit_fields(section, [&yaml](const FieldNote& note, const auto& member) {
      using Value = std::remove_cvref_t<decltype(member)>;
      std::string value;
      std::string range;
      if constexpr (std::is_enum_v<Value>) {
        value = to_string(member);
        for (const std::string& name : names_of<Value>(note)) range += (range.empty() ? "" : " | ") + name;
      } else {
        value = shortest(member);
        range = range_of(note);
      }
      yaml += "  # " + std::string(note.meaning) + "\n  # [" + range + "] Source: " + note.source + ".\n  " +
              note.name + ": " + value + "\n";
    });
  });
  return yaml;
}

}  // namespace adit::io
