#include "report_folder.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "adit/io/camera_file.hpp"
#include "adit/io/errors.hpp"
#include "adit/io/frame_source.hpp"
#include "adit/io/image_file.hpp"
#include "eval_csv.hpp"
#include "finder_options.hpp"
#include "report_figures.hpp"
#include "report_shots.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// flight.csv, headings.csv, or the only table there.
fs::path table_in(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw io::InputError(folder.string() + ": no such folder; give one of 'adit fly --out' or 'adit run --out'");
  for (const char* name : {"flight.csv", "headings.csv"})
    if (fs::is_regular_file(folder / name, error)) return folder / name;
  std::vector<fs::path> tables;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".csv") tables.push_back(entry.path());
  if (tables.size() == 1) return tables.front();
  throw io::InputError(
      folder.string() +
      (tables.empty() ? ": there is no table (.csv) in it" : ": which of its tables is meant? Name it headings.csv") +
      "; make one with 'adit fly COURSE --out DIR' or 'adit run INPUT --out DIR'");
}

ReportTable read_table(const fs::path& path) {
  const std::string text = text_of(path);
  std::size_t at = 0;
  int line = 1;
  std::vector<std::string> cells;
  next_csv_row(text, at, line, cells);
  const std::size_t width = cells.size();
  ReportTable table(cells, path.string());
  while (next_csv_row(text, at, line, cells)) {
    if (cells.size() == 1 && cells.front().empty()) continue;
    if (cells.size() != width)
      throw io::InputError(path.string() + ":" + std::to_string(line - 1) + ": a row of " +
                           std::to_string(cells.size()) + " cells under a header of " + std::to_string(width));
    table.add(cells);
  }
  if (table.size() == 0) throw io::InputError(path.string() + ": the table has no rows; there is nothing to report");
  return table;
}

/// Pictures of a film of 'adit fly --video': a picture for each row.
void add_film(Report& report, const fs::path& film, const std::function<void(std::int64_t)>& on_frame) {
  report.pictures.overlay_is_drawn = true;
  const auto sources = io::open_sources({film.string()}, {});
  std::int64_t row = 0;
  for (; auto frame = sources.front()->next(); on_frame(++row)) {
    if (!report.pictures.frames.wants(row) || frame->pixels.empty()) continue;
    report.pictures.add(row, {frame->pixels.cols / 2, frame->pixels.rows}, shot_of_film(frame->pixels));
  }
  if (row < static_cast<std::int64_t>(report.table.size()))
    report.notes.push_back("The film ends after " + std::to_string(row) + " of " + std::to_string(report.table.size()) +
                           " frames.");
}

/// Where a source of the table lies now: where it was, or beside the table.
std::string found_source(const std::string& source, const fs::path& folder) {
  std::error_code error;
  if (fs::exists(source, error)) return source;
  const fs::path beside = folder / fs::path(source).filename();
  return fs::exists(beside, error) ? beside.string() : std::string();
}

/// Frames of a run, judged again for their pictures, where they still are.
void add_sources(Report& report, const fs::path& folder, const std::function<void(std::int64_t)>& on_frame) {
  io::Configuration configuration;
  std::error_code error;
  const bool has_settings = fs::exists(folder / "settings.yaml", error);
  if (has_settings) io::read_configuration(folder / "settings.yaml", configuration);
  std::optional<Camera> camera;
  if (fs::exists(folder / "camera.yaml", error)) camera.emplace(io::read_camera(folder / "camera.yaml"));
  OpenSpaceFinder finder = make_finder(configuration.finder, camera);
  const auto& sources = report.table.sources();
  std::int64_t missing = 0;
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const std::size_t end = s + 1 < sources.size() ? sources[s + 1].first : report.table.size();
    const std::string path = found_source(sources[s].second, folder);
    if (path.empty() || path.starts_with("/dev/")) {
      ++missing;
      continue;
    }
    const auto source = io::open_sources({path}, {});
    for (std::size_t row = sources[s].first; row < end; ++row) {
      auto frame = source.front()->next();
      if (!frame) break;
      on_frame(static_cast<std::int64_t>(row));
      if (!report.pictures.frames.wants(static_cast<std::int64_t>(row))) continue;
      io::load_pixels(*frame);
      if (frame->pixels.empty()) continue;
      StageImages stages;
      const OpenSpace seen = finder.explain(io::view_of(frame->pixels), stages);
      report.pictures.add(static_cast<std::int64_t>(row), frame->pixels.size(),
                          shot_of(frame->pixels, seen, stages, configuration.finder));
    }
  }
  if (missing > 0)
    report.notes.push_back(std::to_string(missing) + " of " + std::to_string(sources.size()) +
                           " sources are no longer where they were: their frames have no pictures here.");
  if (!has_settings && !report.pictures.frames.pictures().empty())
    report.notes.push_back("There is no settings.yaml in the folder: the stage images are made with the defaults.");
}

}  // namespace

std::optional<ReportMap> read_map(const fs::path& folder) {
  ReportMap map;
  map.png = text_of(folder / "map.png");
  const std::string yaml = text_of(folder / "map.yaml");
  const auto after = [&yaml](const char* key) {
    const std::size_t at = yaml.find(key);
    return at == std::string::npos ? "" : yaml.c_str() + at + std::string_view(key).size();
  };
  if (map.png.empty() || std::sscanf(after("resolution:"), "%lf", &map.cell_m) != 1 ||
      std::sscanf(after("origin:"), " [%lf , %lf", &map.x_min_m, &map.y_min_m) != 2)
    return std::nullopt;
  return map;
}

Report report_of_folder(const fs::path& folder, const std::function<void(std::int64_t)>& on_frame) {
  Report report;
  report.table = read_table(table_in(folder));
  report.origin = read_origin(folder);
  std::error_code error;
  std::string name = fs::weakly_canonical(fs::absolute(folder), error).filename().string();
  report.title = (report.table.is_flight() ? "Flight " : "Run ") + name;
  if (report.table.is_flight()) {
    report.map = read_map(folder);
    if (read_shots(folder / kShotsFolder, report.pictures)) {
      on_frame(static_cast<std::int64_t>(report.table.size()));
    } else if (fs::exists(folder / "flight.mp4", error)) {
      add_film(report, folder / "flight.mp4", on_frame);
    } else {
      report.notes.push_back("There is no film in the folder: fly with --video, or with --report, to see the frames.");
    }
    const std::string summary = text_of(folder / "summary.json");
    report.figures = flight_figures(summary);
    report.changes = changes_in(summary);
  } else {
    add_sources(report, folder, on_frame);
  }
  add_figures_of_table(report.table, report.figures);
  return report;
}

}  // namespace adit::tools
