// truth.csv, as `adit render` writes it.
#include <charconv>
#include <cmath>
#include <numbers>

#include "adit/io/camera_file.hpp"
#include "adit/io/errors.hpp"
#include "adit/io/image_file.hpp"
#include "eval_csv.hpp"
#include "eval_sets_parts.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr float kRangeUnit_m = 0.001f;
constexpr float kRangeMax_m = 65.535f;  ///< what the range image can hold; stands for open air too
/// Frames taken nearer to each other than this see much of the same rock: a cell of a grid of this width is a place.
constexpr double kPlaceCell_m = 10.0;

/// "12.3;-4.5"
std::vector<double> list_of(const std::string& cell, const std::string& where) {
  std::vector<double> values;
  for (std::size_t from = 0; from < cell.size();) {
    const std::size_t end = std::min(cell.find(';', from), cell.size());
    double value = 0.0;
    const auto [stop, error] = std::from_chars(cell.data() + from, cell.data() + end, value);
    if (error != std::errc() || stop != cell.data() + end)
      throw io::InputError(where + ": '" + cell + "' is no list of angles, as 12.3;-4.5");
    values.push_back(value * kDegree);
    from = end + 1;
  }
  return values;
}

std::optional<Bearing> bearing_of(const CsvTable& table, std::size_t row, const std::string& name) {
  const double azimuth_deg = table.number(row, table.column(name + "_azimuth_deg"));
  const double elevation_deg = table.number(row, table.column(name + "_elevation_deg"));
  if (std::isnan(azimuth_deg) || std::isnan(elevation_deg)) return std::nullopt;
  return Bearing{azimuth_deg * kDegree, elevation_deg * kDegree};
}

std::vector<Bearing> branches_of(const CsvTable& table, std::size_t row) {
  const auto azimuths = list_of(table.text(row, table.needed("branch_azimuths_deg")), table.place(row));
  const auto elevations = list_of(table.text(row, table.needed("branch_elevations_deg")), table.place(row));
  if (azimuths.size() != elevations.size())
    throw io::InputError(table.place(row) + ": branch_azimuths_deg and branch_elevations_deg are not of one length");
  std::vector<Bearing> branches;
  for (std::size_t i = 0; i < azimuths.size(); ++i) branches.push_back({azimuths[i], elevations[i]});
  return branches;
}

/// World, seed and cell: the same place in clear air and in dust is one place.
std::string place_of(const CsvTable& table, std::size_t row, const std::string& set_name) {
  const auto world = table.column("world"), seed = table.column("seed");
  std::string place = world ? table.text(row, *world) : set_name;
  if (seed) place.append("/").append(table.text(row, *seed));
  for (const char* name : {"x_m", "y_m"}) {
    const double m = table.number(row, table.column(name));
    if (!std::isnan(m)) place.append("/").append(std::to_string(static_cast<long>(std::floor(m / kPlaceCell_m))));
  }
  return place;
}

bool is_in_frame(const Camera& camera, Bearing bearing, Pixel& place) {
  const auto pixel = camera.pixel_of(bearing);
  if (!pixel) return false;
  place = *pixel;
  return place.u_px >= -0.5 && place.v_px >= -0.5 && place.u_px < camera.model().width - 0.5 &&
         place.v_px < camera.model().height - 0.5;
}

eval::RangeImage read_ranges(const fs::path& path, const CameraModel& camera) {
  const cv::Mat picture = io::read_image(path);
  if (picture.type() != CV_16UC1 || picture.cols != camera.width || picture.rows != camera.height)
    throw io::InputError(path.string() + ": a range image has 16 bits and the size of its frame");
  eval::RangeImage ranges{picture.cols, picture.rows, {}};
  ranges.range_m.reserve(picture.total());
  for (int v = 0; v < picture.rows; ++v)
    for (int u = 0; u < picture.cols; ++u) {
      const auto mm = picture.at<std::uint16_t>(v, u);
      ranges.range_m.push_back(mm == 0 ? kRangeMax_m : kRangeUnit_m * static_cast<float>(mm));
    }
  return ranges;
}

}  // namespace

void read_rendered(const fs::path& truth, const std::string& prefix, EvalSet& set) {
  const CsvTable table(truth);
  const CameraModel camera = io::read_camera(truth.parent_path() / "camera.yaml");
  const std::size_t image = table.needed("image"), range = table.needed("range_image");
  const std::size_t deepest_m = table.needed("deepest_range_m");
  for (std::size_t row = 0; row < table.size(); ++row) {
    EvalFrame frame;
    frame.name = prefix + table.text(row, image);
    frame.image = truth.parent_path() / table.text(row, image);
    frame.camera = camera;
    frame.ranges = truth.parent_path() / table.text(row, range);
    frame.place = place_of(table, row, set.name);
    const double yaw_deg = table.number(row, table.column("yaw_deg"));
    frame.yaw_rad = std::isnan(yaw_deg) ? 0.0 : yaw_deg * kDegree;
    frame.truth.passage = bearing_of(table, row, "passage");
    frame.truth.deepest = bearing_of(table, row, "deepest");
    frame.truth.branches = branches_of(table, row);
    frame.deepest_m = table.number(row, deepest_m);
    std::error_code error;
    for (const fs::path& path : {frame.image, frame.ranges})
      if (!fs::is_regular_file(path, error))
        throw io::InputError(table.place(row) + ": " + path.string() + " is not there");
    set.frames.push_back(std::move(frame));
  }
}

void complete_truth(EvalFrame& frame, const Camera& camera, const eval::ScoreConfig& config) {
  if (frame.ranges.empty()) return;
  eval::FrameTruth& truth = frame.truth;
  truth.ranges = read_ranges(frame.ranges, camera.model());
  truth.far_m = eval::far_range_m(truth.ranges);
  // A branch is in sight when it lies in the frame and there is no near rock before it.
  const auto hidden = [&](const Bearing& branch) {
    Pixel place;
    return !is_in_frame(camera, branch, place) || !(truth.ranges.at(place) >= config.opening_range_min_m);
  };
  std::erase_if(truth.branches, hidden);
  if (truth.passage && hidden(*truth.passage)) truth.passage.reset();
  truth.scene = eval::scene_of(frame.deepest_m, truth.passage || !truth.branches.empty(), config);
}

}  // namespace adit::tools
