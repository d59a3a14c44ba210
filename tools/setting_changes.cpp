#include "setting_changes.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "adit/io/settings.hpp"

namespace adit::tools {
namespace {

io::Settings sections_of(io::Configuration& configuration) {
  io::Settings settings;
  io::visit_sections(configuration, [&](const char* name, auto& section) { settings.add(name, section); });
  return settings;
}

}  // namespace

std::vector<SettingChange> changes_between(io::Configuration before, io::Configuration after, double stamp_s) {
  std::vector<SettingChange> changes;
  const io::Settings old = sections_of(before), now = sections_of(after);
  for (std::size_t s = 0; s < now.sections().size(); ++s) {
    const io::SettingSection& section = now.sections()[s];
    for (std::size_t f = 0; f < section.settings.size(); ++f) {
      const io::Setting& setting = section.settings[f];
      const std::string from = old.sections()[s].settings[f].value(), to = setting.value();
      if (from != to) changes.push_back({stamp_s, section.name + "." + setting.note.name, from, to});
    }
  }
  return changes;
}

std::vector<SettingChange> changes_in(const std::string& summary_json) {
  std::vector<SettingChange> changes;
  try {
    const auto json = nlohmann::json::parse(summary_json);
    for (const auto& change : json.at("settings_changed_in_flight"))
      changes.push_back({change.at("stamp_s").get<double>(), change.at("setting").get<std::string>(),
                         change.at("from").get<std::string>(), change.at("to").get<std::string>()});
  } catch (const nlohmann::json::exception&) {  // of another making: there is nothing to tell
    return {};
  }
  return changes;
}

std::string text_of(const SettingChange& change) { return change.setting + " " + change.from + " → " + change.to; }

std::string note_of(const std::vector<SettingChange>& changes) {
  if (changes.empty()) return "";
  std::string note = "Settings were changed by hand in flight, so its command does not fly it again:";
  for (const SettingChange& change : changes) {
    char stamp[32];
    std::snprintf(stamp, sizeof stamp, "%.2f s", change.stamp_s);
    note.append(&change == &changes.front() ? " from " : "; from ")
        .append(stamp)
        .append(" on ")
        .append(text_of(change));
  }
  return note + ". Those that are listed as its settings are the ones it began with.";
}

}  // namespace adit::tools
