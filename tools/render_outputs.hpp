// A data set on the disk: frames, ranges, truth, camera, and what makes it again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "adit/camera.hpp"
#include "adit/io/settings.hpp"
#include "adit/sim/render.hpp"
#include "adit/sim/truth.hpp"
#include "adit/sim/vehicle.hpp"

namespace adit::tools {

/// What dataset.json says of all frames together.
struct DatasetNote {
  std::string world;
  std::string rig;
  std::uint64_t seed = 0;
  double dust_1_m = 0.0;
  int width = 0;
  int height = 0;
  std::int64_t frames_asked = 0;
  bool interrupted = false;
};

/// One row of truth.csv.
struct TruthRow {
  std::int64_t frame = 0;
  double stamp_s = 0.0;
  sim::VehicleState vehicle;
  sim::Truth truth;
  sim::Exposure exposure;
  float mean_level = 0.0f;
};

[[nodiscard]] std::string truth_csv_header();
/// @param note  its settings stand in every row, so that tables of several data sets can be put together.
[[nodiscard]] std::string truth_csv_line(const TruthRow& row, const DatasetNote& note);

/// The sections as YAML for --config. `lamp` is left out where it is as the rig has it: it would make all lamps alike.
/// @param as_rig  the same sections before anything was set.
[[nodiscard]] std::string remake_yaml(const io::Settings& settings, const io::Settings& as_rig,
                                      const std::string& command);

/// frames/000000.png, range/000000.png; then, with commit(), truth.csv, dataset.json, camera.yaml, settings.yaml.
/// write_frame() may be called from several threads at once for different frames.
class DatasetOutputs {
 public:
  /// Makes the folders. @throws io::OutputError, also when there are frames already: old ones would mix with new.
  explicit DatasetOutputs(std::filesystem::path folder);

  /// Range images are 16-bit PNG in mm along each pixel's ray: 65535 for 65.535 m and more, 0 where nothing is met.
  void write_frame(std::int64_t frame, const sim::Frame& picture) const;
  /// @param rows  of the frames that were written; others are passed over.
  void commit(const std::vector<std::optional<TruthRow>>& rows, const DatasetNote& note, const CameraModel& camera,
              const std::string& settings_yaml) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace adit::tools
