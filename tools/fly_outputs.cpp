#include "fly_outputs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <opencv2/imgcodecs.hpp>

#include "adit/io/draw.hpp"
#include "adit/io/errors.hpp"
#include "adit/io/image_file.hpp"
#include "adit/io/output_file.hpp"
#include "adit/io/table.hpp"
#include "csv_cell.hpp"

namespace adit::tools {
namespace {

constexpr double kDegree = 180.0 / std::numbers::pi;

double angle_deg(double rad) { return rad * kDegree; }

nlohmann::ordered_json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::round(value * 1e6) / 1e6;
}

nlohmann::ordered_json spread(const sim::Spread& s) { return {{"median", number(s.median)}, {"p95", number(s.p95)}}; }

void write_png(const std::filesystem::path& path, const cv::Mat& picture) {
  std::vector<unsigned char> png;
  if (!cv::imencode(".png", picture, png)) throw io::OutputError(path.string() + ": OpenCV cannot make a PNG of it");
  io::write_file(path, {reinterpret_cast<const char*>(png.data()), png.size()});
}

/// Free is white, occupied black: probabilities are clamped to 12 and 97 %.
std::uint8_t level_of(std::uint8_t percent) {
  return static_cast<std::uint8_t>(254.0 * (1.0 - std::clamp((percent - 12.0) / 85.0, 0.0, 1.0)));
}

void write_scan(io::OutputFile& file, const sim::Scan& scan) {
  std::string line = std::to_string(scan.stamp_s);
  add_cell(line, scan.angle_min_rad, 6);
  add_cell(line, scan.angle_step_rad, 8);
  for (const float range_m : scan.ranges_m) add_cell(line, static_cast<double>(range_m), 3);
  file.write(line + "\n");
}

void write_imu(io::OutputFile& file, const std::vector<sim::ImuSample>& samples) {
  for (const sim::ImuSample& sample : samples) {
    std::string line = std::to_string(sample.stamp_s);
    for (int k = 0; k < 3; ++k) add_cell(line, sample.angular_rate_rad_s[k], 6);
    for (int k = 0; k < 3; ++k) add_cell(line, sample.specific_force_m_s2[k], 5);
    file.write(line + "\n");
  }
}

std::filesystem::path made(const std::filesystem::path& folder) {
  io::make_folder(folder);
  return folder;
}

}  // namespace

std::string flight_csv_header() {
  return "frame,stamp_s,x_m,y_m,z_m,roll_deg,pitch_deg,yaw_deg,vx_m_s,vy_m_s,vz_m_s,height_m,delivery,status,"
         "confidence,u_px,v_px,sx,sy,azimuth_deg,elevation_deg,area_fraction,flags,command,yaw_rate_rad_s,speed_scale,"
         "manoeuvre,track,track_azimuth_deg,"
         "passage_azimuth_deg,passage_elevation_deg,deepest_azimuth_deg,deepest_elevation_deg,deepest_range_m,"
         "branch_azimuths_deg,opening_in_sight,clearance_m,side_clearance_m,aside_m,progress_m,to_goal_m\n";
}

std::string flight_csv_line(const sim::FlightRow& row) {
  const sim::VehicleState& v = row.vehicle;
  std::string line = std::to_string(row.frame);
  add_cell(line, row.stamp_s, 4);
  for (int k = 0; k < 3; ++k) add_cell(line, v.place[k], 4);
  for (const double rad : {v.roll_rad, v.pitch_rad, v.yaw_rad}) add_cell(line, angle_deg(rad), 3);
  for (int k = 0; k < 3; ++k) add_cell(line, v.velocity[k], 4);
  add_cell(line, v.height_m, 3);
  const bool judged = row.delivery != sim::Delivery::kDropped;
  const bool found = judged && row.status == Status::kFound;
  const double no = sim::kUnknown;
  line.append(",").append(to_string(row.delivery)).append(",");
  if (judged) line.append(to_string(row.status));
  add_cell(line, judged ? row.confidence : no, 4);
  add_cell(line, found ? row.centroid_px.u_px : no, 2);
  add_cell(line, found ? row.centroid_px.v_px : no, 2);
  add_cell(line, found ? row.point.sx : no, 5);
  add_cell(line, found ? row.point.sy : no, 5);
  add_cell(line, found ? angle_deg(row.bearing.azimuth_rad) : no, 3);
  add_cell(line, found ? angle_deg(row.bearing.elevation_rad) : no, 3);
  add_cell(line, found ? row.area_fraction : no, 5);
  line.append(",");
  if (judged) line.append(io::flags_text(row.flags));
  line.append(",").append(to_string(row.command.state));
  add_cell(line, row.command.yaw_rate_rad_s, 5);
  add_cell(line, row.speed_scale, 3);
  line.append(",");
  if (row.manoeuvre) line.append(to_string(*row.manoeuvre));
  line.append(",");
  if (row.track) line.append(std::to_string(row.track->id));
  add_cell(line, row.track ? angle_deg(row.track->bearing.azimuth_rad) : no, 3);
  const sim::Truth& t = row.truth;
  for (const double rad :
       {t.passage.azimuth_rad, t.passage.elevation_rad, t.deepest.azimuth_rad, t.deepest.elevation_rad})
    add_cell(line, angle_deg(rad), 3);
  add_cell(line, t.deepest_range_m, 3);
  line += ',';
  for (std::size_t i = 0; i < t.branches.size(); ++i) {
    char text[24];
    std::snprintf(text, sizeof text, "%s%.2f", i == 0 ? "" : ";", angle_deg(t.branches[i].azimuth_rad));
    line += text;
  }
  line += t.opening_in_sight ? ",1" : ",0";
  for (const double m : {t.clearance_m, t.side_clearance_m, t.aside_m, t.progress_m, t.to_goal_m}) add_cell(line, m, 3);
  return line + "\n";
}

std::string summary_json(const sim::FlightSummary& s, const SummaryContext& context) {
  nlohmann::ordered_json json;
  json["outcome"] = context.interrupted ? std::string("interrupted") : std::string(to_string(s.outcome));
  json["reason"] = s.reason;
  json["world"] = context.world;
  json["method"] = context.method;
  json["lamp"] = context.lamp;
  json["speed_m_s"] = number(context.speed_m_s);
  json["dust_1_m"] = number(context.dust_1_m);
  json["seed"] = s.seed;
  json["duration_s"] = number(s.duration_s);
  json["distance_m"] = number(s.distance_m);
  json["progress_m"] = number(s.progress_m);
  json["to_goal_m"] = number(s.to_goal_m);
  json["bends"] = s.bends;
  json["frames"] = s.frames;
  json["dropped_frames"] = s.dropped_frames;
  json["repeated_frames"] = s.repeated_frames;
  json["side_clearance_min_m"] = number(s.side_clearance_min_m);
  json["side_clearance_median_m"] = number(s.side_clearance_median_m);
  json["clearance_min_m"] = number(s.clearance_min_m);
  json["heading_error_passage_deg"] = spread(s.heading_error_passage_deg);
  json["heading_error_deepest_deg"] = spread(s.heading_error_deepest_deg);
  json["sx_jitter"] = number(s.sx_jitter);
  json["found_fraction"] = number(s.found_fraction);
  json["false_stops"] = s.false_stops;
  json["missed_stops"] = s.missed_stops;
  json["real_time_factor"] = number(context.real_time_factor);
  if (!context.changes.empty()) json["reproducible"] = false;
  for (const SettingChange& change : context.changes)
    json["settings_changed_in_flight"].push_back(
        {{"stamp_s", number(change.stamp_s)}, {"setting", change.setting}, {"from", change.from}, {"to", change.to}});
  return json.dump(2) + "\n";
}

std::vector<unsigned char> map_png(const sim::OccupancyPicture& picture) {
  std::vector<unsigned char> png;
  if (picture.width == 0) return png;
  cv::Mat grey(picture.height, picture.width, CV_8UC1);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const std::uint8_t percent =
          picture.probability_percent[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                      static_cast<std::size_t>(x)];
      grey.at<std::uint8_t>(picture.height - 1 - y, x) =
          percent == sim::OccupancyPicture::kUnseen ? std::uint8_t{205} : level_of(percent);
    }
  cv::imencode(".png", grey, png);
  return png;
}

FlyOutputs::FlyOutputs(const std::filesystem::path& folder, const sim::Flight& flight, bool film, bool sensors,
                       std::vector<double> stills_s)
    : folder_(made(folder)),
      table_(folder_ / "flight.csv"),
      stills_s_(std::move(stills_s)),
      explainer_(flight.settings().finder, flight.camera()) {
  std::sort(stills_s_.begin(), stills_s_.end());
  table_.write(flight_csv_header());
  if (film) film_.emplace(folder_ / "flight.mp4", flight.settings().flight.camera_rate_hz);
  if (!sensors) return;
  imu_.emplace(folder_ / "imu.csv");
  imu_->write("stamp_s,gyro_x_rad_s,gyro_y_rad_s,gyro_z_rad_s,force_x_m_s2,force_y_m_s2,force_z_m_s2\n");
  scans_.emplace(folder_ / "scans.csv");
  scans_->write("stamp_s,angle_min_rad,angle_step_rad,ranges_m...\n");
}

void FlyOutputs::draw(const sim::Flight& flight) {
  const bool still = !stills_s_.empty() && flight.row().stamp_s >= stills_s_.front();
  if ((!film_ && !still) || flight.frame().data == nullptr) return;
  StageImages stages;
  const OpenSpace seen = explainer_.explain(flight.frame(), stages);
  const cv::Mat picture = io::side_by_side(io::mat_of(flight.frame()), seen, stages, flight.row().command);
  if (film_) film_->write(picture);
  if (!still) return;
  char name[48];
  std::snprintf(name, sizeof name, "still_%06.2f.png", stills_s_.front());
  write_png(folder_ / name, picture);
  stills_s_.erase(stills_s_.begin());
}

void FlyOutputs::add(const sim::Flight& flight) {
  table_.write(flight_csv_line(flight.row()));
  if (imu_) write_imu(*imu_, flight.imu_samples());
  if (scans_ && flight.scan()) write_scan(*scans_, *flight.scan());
  draw(flight);
}

void FlyOutputs::use(const sim::Flight& flight) {
  explainer_ = OpenSpaceFinder(flight.settings().finder, flight.camera());
}

void FlyOutputs::commit(const sim::Flight& flight, const std::string& summary) {
  table_.commit();
  if (imu_) imu_->commit();
  if (scans_) scans_->commit();
  if (film_) film_->commit();
  const sim::OccupancyPicture picture = flight.map().picture();
  const auto png = map_png(picture);
  if (!png.empty()) {
    io::write_file(folder_ / "map.png", {reinterpret_cast<const char*>(png.data()), png.size()});
    char yaml[256];
    std::snprintf(yaml, sizeof yaml,
                  "image: map.png\nresolution: %.4f\norigin: [%.4f, %.4f, 0.0]\nnegate: 0\noccupied_thresh: 0.65\n"
                  "free_thresh: 0.196\n",
                  picture.cell_m, picture.x_min_m - 0.5 * picture.cell_m, picture.y_min_m - 0.5 * picture.cell_m);
    io::write_file(folder_ / "map.yaml", yaml);
  }
  io::write_file(folder_ / "summary.json", summary);
}

}  // namespace adit::tools
