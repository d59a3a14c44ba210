// A report as one HTML file: columns as packed arrays, pictures as JPEG, all in base64.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "adit/io/output_file.hpp"
#include "base64.hpp"
#include "pages.hpp"
#include "report.hpp"

namespace adit::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kEventsMax = 2000;  ///< more make the page slow, and nobody reads them
constexpr double kStampStep_s = 1e-4;     ///< of stamps in flight.csv

template <class Value>
std::string packed(const std::vector<Value>& values) {
  return base64_of(values.data(), values.size() * sizeof(Value));
}

/// Where each picture begins in one long text; each is padded on its own, so that it can be cut out and shown.
Json pictures_json(const ThinnedPictures& thinned) {
  Json rows = Json::array(), offsets = Json::array();
  std::string text;
  for (const ThinnedPictures::Picture& picture : thinned.pictures()) {
    rows.push_back(picture.row);
    offsets.push_back(text.size());
    text += base64_of(picture.jpeg.data(), picture.jpeg.size());
  }
  offsets.push_back(text.size());
  return {{"rows", rows}, {"offsets", offsets}, {"jpeg", text}};
}

/// Each at the first row that was judged with it.
void add_changes(const Report& report, std::vector<ReportEvent>& events) {
  const std::vector<double>& time_s = report.table.time_s();
  for (const SettingChange& change : report.changes) {
    const auto row = static_cast<std::size_t>(
        std::lower_bound(time_s.begin(), time_s.end(), change.stamp_s - kStampStep_s) - time_s.begin());
    if (row < time_s.size()) events.push_back({row, row, "setting", text_of(change)});
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const ReportEvent& a, const ReportEvent& b) { return a.first < b.first; });
}

Json events_json(const Report& report, std::size_t& left_out) {
  std::vector<ReportEvent> events = events_of(report.table);
  add_changes(report, events);
  left_out = events.size() > kEventsMax ? events.size() - kEventsMax : 0;
  Json json = Json::array();
  for (std::size_t i = 0; i < events.size() - left_out; ++i)
    json.push_back({events[i].first, events[i].last, events[i].kind, events[i].text});
  return json;
}

Json json_of(const Report& report) {
  const ReportTable& table = report.table;
  Json json{{"title", report.title},
            {"flight", table.is_flight()},
            {"rows", table.size()},
            {"time_s", packed(table.time_s())}};
  for (const ReportColumn& column : table.columns()) json["columns"][column.name] = packed(column.values);
  for (const ReportWords& words : table.words())
    json["words"][words.name] = {{"known", words.known}, {"codes", packed(words.codes)}};
  json["sources"] = Json::array();
  for (const auto& [row, source] : table.sources()) json["sources"].push_back({row, source});
  const ReportPictures& pictures = report.pictures;
  json["frames"] = pictures_json(pictures.frames);
  json["stages"] = pictures_json(pictures.stages);
  json["tiles"] = {{"names", pictures.tile_names}, {"columns", pictures.overlay_is_drawn ? 1 : kTileColumns}};
  json["frame_size_px"] = {pictures.width_px, pictures.height_px};
  json["overlay_is_drawn"] = pictures.overlay_is_drawn;
  if (report.map)
    json["map"] = {{"png", base64_of(report.map->png.data(), report.map->png.size())},
                   {"x_min_m", report.map->x_min_m},
                   {"y_min_m", report.map->y_min_m},
                   {"cell_m", report.map->cell_m}};
  std::size_t left_out = 0;
  json["events"] = events_json(report, left_out);
  json["events_left_out"] = left_out;
  json["figures"] = Json::array();
  for (const auto& [name, value] : report.figures) json["figures"].push_back({name, value});
  json["notes"] = report.notes;
  if (const std::string note = note_of(report.changes); !note.empty()) json["notes"].push_back(note);
  json["origin"] = {{"version", report.origin.version},
                    {"command", report.origin.command},
                    {"changed", report.origin.changed},
                    {"settings", report.origin.settings}};
  return json;
}

}  // namespace

void write_report(const std::filesystem::path& path, const Report& report) {
  std::string json = json_of(report).dump(-1, ' ', false, Json::error_handler_t::replace);
  // Nothing in it may look like the end of the script it stands in.
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; at += 6) json.replace(at, 1, "\\u003c");
  io::write_file(path, filled_page(report_page(), {{"@TITLE@", html_of(report.title)},
                                                   {"@UPLOT_CSS@", std::string(uplot_css())},
                                                   {"@UPLOT_JS@", std::string(uplot_js())},
                                                   {"@CSS@", std::string(look_css())},
                                                   {"@JS@", joined({report_js(), report_charts_js(), report_status_js(),
                                                                    report_map_js(), report_scrubber_js()})},
                                                   {"@REPORT@", json}}));
}

}  // namespace adit::tools
