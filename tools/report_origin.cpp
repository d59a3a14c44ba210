#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "adit/cpu_target.hpp"
#include "adit/io/output_file.hpp"
#include "report.hpp"
#include "version.hpp"

namespace adit::tools {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The command line as a shell would take it.
std::string command_line() {
  std::string line, word;
  for (const char c : text_of("/proc/self/cmdline")) {
    if (c != '\0') {
      word += c;
      continue;
    }
    if (line.empty()) word = std::filesystem::path(word).filename().string();
    const bool plain = !word.empty() && word.find_first_of(" \t\n\"'$`\\*?[](){}<>|&;#~!") == std::string::npos;
    if (!line.empty()) line += ' ';
    line += plain ? word : "'" + word + "'";
    word.clear();
  }
  return line;
}

/// "section.name: value" of each line with a value; comments are taken off.
std::vector<std::string> settings_in(const std::string& yaml) {
  std::vector<std::string> settings;
  std::istringstream lines(yaml);
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    if (const std::size_t comment = line.find('#'); comment != std::string::npos) line.resize(comment);
    while (!line.empty() && line.back() == ' ') line.pop_back();
    if (line.empty()) continue;
    if (line.front() != ' ') {
      section = line.substr(0, line.find(':'));
    } else {
      settings.push_back(section + "." + line.substr(line.find_first_not_of(' ')));
    }
  }
  return settings;
}

}  // namespace

ReportOrigin origin_now(const std::string& settings, const std::string& defaults) {
  ReportOrigin origin{ADIT_VERSION, command_line(), settings, {}};
  const auto usual = settings_in(defaults);
  const std::set<std::string> known(usual.begin(), usual.end());
  for (const std::string& setting : settings_in(settings))
    if (!known.contains(setting)) origin.changed.push_back(setting);
  return origin;
}

void write_origin(const std::filesystem::path& folder, const ReportOrigin& origin) {
  io::write_file(folder / "settings.yaml", origin.settings);
  const Json json{{"program", "adit"},
                  {"version", origin.version},
                  {"command", origin.command},
                  {"cpu_target", std::string(cpu_target())},
                  {"changed_settings", origin.changed}};
  io::write_file(folder / "made_by.json", json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

ReportOrigin read_origin(const std::filesystem::path& folder) {
  ReportOrigin origin;
  origin.settings = text_of(folder / "settings.yaml");
  const Json json = Json::parse(text_of(folder / "made_by.json"), nullptr, false);
  if (!json.is_object()) return origin;
  const auto text = [&json](const char* key) {
    return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : std::string();
  };
  origin.version = text("version");
  origin.command = text("command");
  if (json.contains("changed_settings") && json["changed_settings"].is_array())
    for (const Json& setting : json["changed_settings"])
      if (setting.is_string()) origin.changed.push_back(setting);
  return origin;
}

}  // namespace adit::tools
