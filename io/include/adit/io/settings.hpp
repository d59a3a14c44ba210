// Everything a person may set of any structs that list their fields (adit/fields.hpp), section by section: from YAML,
// from `--set`, and back as YAML. configuration.hpp is this for the finder and the controller; the simulator has more.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "adit/fields.hpp"

namespace adit::io {

/// One field of one struct, whatever its type.
struct Setting {
  FieldNote note{};
  std::vector<std::string> choices;                   ///< of an enumeration; empty for numbers
  std::function<std::string(std::string_view)> take;  ///< text in; why it is refused, "" when it is taken
  std::function<std::string()> value;                 ///< as text that take() takes
};

/// One struct.
struct SettingSection {
  std::string name;
  std::vector<Setting> settings;
  std::function<std::string()> fault;  ///< why the struct as a whole is refused, "" when it is good
};

// The texts of numbers; see Setting::take and Setting::value.
[[nodiscard]] std::string take_number(const FieldNote& note, std::string_view text, double& value);
[[nodiscard]] std::string take_number(const FieldNote& note, std::string_view text, int& value);
[[nodiscard]] std::string take_number(const FieldNote& note, std::string_view text, float& value);
[[nodiscard]] std::string take_number(const FieldNote& note, std::string_view text, bool& value);
[[nodiscard]] std::string refused_choice(const FieldNote& note, std::string_view text,
                                         const std::vector<std::string>& choices);
[[nodiscard]] std::string number_text(double value);
[[nodiscard]] std::string number_text(float value);
[[nodiscard]] std::string number_text(int value);

/// The sections that may be set. Holds references to the structs: they must outlive it.
class Settings {
 public:
  /// Adds a struct with visit_fields() and fault_of(). Members that are neither numbers nor enumerations with parse()
  /// and to_string() are passed over.
  template <class Struct>
  void add(const std::string& name, Struct& object);
  void add(SettingSection section) { sections_.push_back(std::move(section)); }

  /// Reads a YAML text over the structs: fields it does not name keep their value.
  /// @param name  the file's name, for messages.
  /// @throws ConfigError "NAME:LINE: ..." for broken YAML, an unknown section or key (with the nearest known one), a
  ///         key given twice, a value of the wrong type or out of range.
  void read_yaml(std::string_view text, std::string_view name);
  /// The same for a file. @throws ConfigError also when the file is missing, empty or unreadable.
  void read_file(const std::filesystem::path& path);
  /// Takes one `--set` assignment, "omega=0.9" or "finder.omega=0.9". @throws ConfigError "--set omega=9: ...".
  void set(std::string_view assignment);
  /// All fields as YAML, each with its meaning, unit, range and source in a comment.
  [[nodiscard]] std::string to_yaml() const;

  [[nodiscard]] const std::vector<SettingSection>& sections() const noexcept { return sections_; }

 private:
  std::vector<SettingSection> sections_;
};

template <class Member>
Setting setting_of(const FieldNote& note, Member& member) {
  Setting setting{note, {}, {}, {}};
  if constexpr (std::is_enum_v<Member>) {
    for (int i = 0; i <= static_cast<int>(note.maximum); ++i)
      setting.choices.emplace_back(to_string(static_cast<Member>(i)));
    setting.take = [note, &member, choices = setting.choices](std::string_view text) {
      return parse(text, member) ? std::string() : refused_choice(note, text, choices);
    };
    setting.value = [&member] { return std::string(to_string(member)); };
  } else {
    setting.take = [note, &member](std::string_view text) { return take_number(note, text, member); };
    setting.value = [&member] { return number_text(member); };
  }
  return setting;
}

template <class Struct>
void Settings::add(const std::string& name, Struct& object) {
  SettingSection section{name, {}, {}};
  visit_fields(object, [&section](const FieldNote& note, auto& member) {
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::is_arithmetic_v<Member> || requires(Member m) { parse(std::string_view(), m); })
      section.settings.push_back(setting_of(note, member));
  });
  section.fault = [&object]() -> std::string {
    if constexpr (requires { fault_of(object); }) {
      if (const auto fault = fault_of(object)) return *fault;
    }
    return "";
  };
  sections_.push_back(std::move(section));
}

}  // namespace adit::io
