// A run or a flight as one page for people.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report_pictures.hpp"
#include "report_table.hpp"
#include "setting_changes.hpp"

namespace adit::tools {

/// A picture of the ground, north up: as map.png and map.yaml have it.
struct ReportMap {
  std::string png;
  double x_min_m = 0.0, y_min_m = 0.0;  ///< of the lower left corner of the lower left cell
  double cell_m = 0.0;
};

/// By what a run was made.
struct ReportOrigin {
  std::string version;
  std::string command;               ///< line; "" where it is not known
  std::string settings;              ///< as YAML; "" where they are not known
  std::vector<std::string> changed;  ///< those of them that are not the defaults, "section.name: value"
};

struct Report {
  std::string title;
  ReportTable table;
  ReportPictures pictures;
  std::optional<ReportMap> map;
  std::vector<std::pair<std::string, std::string>> figures;  ///< name and value, of the whole run
  std::vector<std::string> notes;                            ///< what is missing, and why
  std::vector<SettingChange> changes;                        ///< by hand, in flight
  ReportOrigin origin;
};

/// map.png and map.yaml of a folder; nothing where they are not there.
[[nodiscard]] std::optional<ReportMap> read_map(const std::filesystem::path& folder);

/// Writes the page; it needs nothing but itself. @throws io::OutputError
void write_report(const std::filesystem::path& path, const Report& report);

/// The program that runs now, as it was called. @param settings  YAML in use. @param defaults  YAML of the defaults.
[[nodiscard]] ReportOrigin origin_now(const std::string& settings, const std::string& defaults);
/// settings.yaml and made_by.json. @throws io::OutputError
void write_origin(const std::filesystem::path& folder, const ReportOrigin& origin);
/// The same back; what is not there stays empty.
[[nodiscard]] ReportOrigin read_origin(const std::filesystem::path& folder);

}  // namespace adit::tools
