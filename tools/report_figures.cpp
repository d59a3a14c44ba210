#include "report_figures.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace adit::tools {
namespace {

using Json = nlohmann::ordered_json;

/// Units as the keys end, the longest first.
constexpr std::pair<const char*, const char*> kUnits[] = {
    {"_m_s", " m/s"}, {"_1_m", " 1/m"}, {"_deg", "°"}, {"_m", " m"}, {"_s", " s"}};

std::pair<std::string, std::string> named(std::string key) {
  for (const auto& [ending, unit] : kUnits)
    if (key.ends_with(ending)) {
      key.resize(key.size() - std::string_view(ending).size());
      for (char& c : key) c = c == '_' ? ' ' : c;
      return {key, unit};
    }
  for (char& c : key) c = c == '_' ? ' ' : c;
  return {key, ""};
}

std::string value_text(const Json& value, const std::string& unit) {
  if (value.is_null()) return "–";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return std::to_string(value.get<std::int64_t>()) + unit;
  if (!value.is_number()) return value.dump();
  char text[48];
  std::snprintf(text, sizeof text, "%.4g", value.get<double>());
  return text + unit;
}

}  // namespace

NamedFigures flight_figures(const std::string& summary_json) {
  NamedFigures figures;
  const Json json = Json::parse(summary_json, nullptr, false);
  if (!json.is_object()) return figures;
  for (const auto& [key, value] : json.items()) {
    if (value.is_array()) continue;  // told as events
    const auto [name, unit] = named(key);
    if (value.is_object()) {
      for (const auto& [inner, number] : value.items())
        figures.emplace_back(name + ", " + inner, value_text(number, unit));
    } else if (!(value.is_string() && value.get<std::string>().empty())) {
      figures.emplace_back(name, value_text(value, unit));
    }
  }
  return figures;
}

void add_figures_of_table(const ReportTable& table, NamedFigures& figures) {
  char text[64];
  std::snprintf(text, sizeof text, "%zu over %.1f s", table.size(), table.size() > 0 ? table.time_s().back() : 0.0);
  figures.emplace_back("rows", text);
  for (const ReportWords& words : table.words()) {
    if (words.name != "status") continue;
    std::vector<std::size_t> counts(words.known.size());
    for (const std::uint8_t code : words.codes) ++counts[code];
    for (std::size_t i = 0; i < counts.size(); ++i)
      if (counts[i] > 0)
        figures.emplace_back(words.known[i].empty() ? "no frame" : words.known[i], std::to_string(counts[i]));
  }
}

}  // namespace adit::tools
