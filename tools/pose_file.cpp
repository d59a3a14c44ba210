#include "pose_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include "adit/io/errors.hpp"

namespace adit::tools {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr const char* kNeeded[] = {"x_m", "y_m", "z_m", "roll_deg", "pitch_deg", "yaw_deg"};
constexpr const char* kTaken[] = {"vx_m_s", "vy_m_s", "vz_m_s", "height_m", "stamp_s"};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t from = 0;
  for (std::size_t comma = 0; comma != std::string::npos; from = comma + 1) {
    comma = line.find(',', from);
    cells.push_back(line.substr(from, comma == std::string::npos ? comma : comma - from));
    if (!cells.back().empty() && cells.back().back() == '\r') cells.back().pop_back();
  }
  return cells;
}

/// Where a column stands, or -1.
int column_of(const std::vector<std::string>& header, const char* name) {
  const auto found = std::find(header.begin(), header.end(), name);
  return found == header.end() ? -1 : static_cast<int>(found - header.begin());
}

/// Difference of two angles over time, by the short way round.
double rate(double from_rad, double to_rad, double time_s) {
  return std::remainder(to_rad - from_rad, 2.0 * std::numbers::pi) / time_s;
}

void find_rates(std::vector<FiledPose>& poses) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const FiledPose& a = poses[i == 0 ? 0 : i - 1];
    const FiledPose& b = poses[std::min(i + 1, poses.size() - 1)];
    if (!a.stamp_s || !b.stamp_s || *b.stamp_s - *a.stamp_s <= 1e-6) continue;
    const double time_s = *b.stamp_s - *a.stamp_s;
    sim::VehicleState& v = poses[i].vehicle;
    v.roll_rate_rad_s = rate(a.vehicle.roll_rad, b.vehicle.roll_rad, time_s);
    v.pitch_rate_rad_s = rate(a.vehicle.pitch_rad, b.vehicle.pitch_rad, time_s);
    v.yaw_rate_rad_s = rate(a.vehicle.yaw_rad, b.vehicle.yaw_rad, time_s);
  }
}

}  // namespace

std::vector<FiledPose> read_poses(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw io::InputError(path.string() + ": the table of poses cannot be read; is it there?");
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> header = cells_of(line);
  int needed[std::size(kNeeded)], taken[std::size(kTaken)];
  for (std::size_t k = 0; k < std::size(kNeeded); ++k)
    if ((needed[k] = column_of(header, kNeeded[k])) < 0)
      throw io::InputError(path.string() + ":1: there is no column " + kNeeded[k] +
                           "; x_m, y_m, z_m, roll_deg, pitch_deg and yaw_deg are needed, as in flight.csv");
  for (std::size_t k = 0; k < std::size(kTaken); ++k) taken[k] = column_of(header, kTaken[k]);
  std::vector<FiledPose> poses;
  for (int number = 2; std::getline(file, line); ++number) {
    if (line.empty()) continue;
    const std::vector<std::string> cells = cells_of(line);
    const auto value_of = [&](int column, const char* name) {
      const std::string text = column < static_cast<int>(cells.size()) ? cells[static_cast<std::size_t>(column)] : "";
      double value = 0.0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        throw io::InputError(path.string() + ":" + std::to_string(number) + ": " + name + " is '" + text +
                             "', which is no number");
      return value;
    };
    double v[std::size(kNeeded)], t[std::size(kTaken)] = {};
    for (std::size_t k = 0; k < std::size(kNeeded); ++k) v[k] = value_of(needed[k], kNeeded[k]);
    for (std::size_t k = 0; k < std::size(kTaken); ++k)
      if (taken[k] >= 0) t[k] = value_of(taken[k], kTaken[k]);
    FiledPose pose;
    pose.vehicle.place = {v[0], v[1], v[2]};
    pose.vehicle.roll_rad = v[3] * kDegree;
    pose.vehicle.pitch_rad = v[4] * kDegree;
    pose.vehicle.yaw_rad = v[5] * kDegree;
    pose.vehicle.velocity = {t[0], t[1], t[2]};
    pose.vehicle.height_m = t[3];
    if (taken[4] >= 0) pose.stamp_s = t[4];
    poses.push_back(pose);
  }
  if (poses.empty()) throw io::InputError(path.string() + ": the table of poses has no rows");
  find_rates(poses);
  return poses;
}

}  // namespace adit::tools
