// What one flight leaves behind: a row a frame, a summary, the map, a film, stills.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adit/finder.hpp"
#include "adit/io/output_file.hpp"
#include "adit/io/video_file.hpp"
#include "adit/sim/flight.hpp"
#include "adit/sim/flight_summary.hpp"
#include "setting_changes.hpp"

namespace adit::tools {

[[nodiscard]] std::string flight_csv_header();
/// Reals have a fixed number of digits; numbers that do not exist are empty.
[[nodiscard]] std::string flight_csv_line(const sim::FlightRow& row);

/// What summary.json says beside the figures of the flight.
struct SummaryContext {
  std::string world;
  std::string method;
  std::string lamp;
  double speed_m_s = 0.0;
  double dust_1_m = 0.0;
  bool interrupted = false;
  double real_time_factor = 0.0;       ///< flown seconds per second of the clock
  std::vector<SettingChange> changes;  ///< by hand, in flight (`--view`): it cannot be flown again
};

/// One JSON object, with the units in its keys. Numbers that do not exist are null.
[[nodiscard]] std::string summary_json(const sim::FlightSummary& summary, const SummaryContext& context);

/// Free white, rock black, unseen grey; the first row is the largest y. Empty for an empty map.
[[nodiscard]] std::vector<unsigned char> map_png(const sim::OccupancyPicture& picture);

/// The files of one flight, whole or not there.
class FlyOutputs {
 public:
  /// Makes the folder. @throws io::OutputError
  FlyOutputs(const std::filesystem::path& folder, const sim::Flight& flight, bool film, bool sensors,
             std::vector<double> stills_s);

  /// After each Flight::step().
  void add(const sim::Flight& flight);
  /// After Flight::change(): pictures are explained by what judges from now on.
  void use(const sim::Flight& flight);
  /// Everything appears. @throws io::OutputError
  void commit(const sim::Flight& flight, const std::string& summary);

 private:
  void draw(const sim::Flight& flight);

  std::filesystem::path folder_;
  io::OutputFile table_;
  std::optional<io::OutputFile> imu_, scans_;
  std::optional<io::VideoFile> film_;
  std::vector<double> stills_s_;
  OpenSpaceFinder explainer_;  ///< the flight's own finder makes no pictures
};

}  // namespace adit::tools
