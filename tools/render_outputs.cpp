#include "render_outputs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <opencv2/imgcodecs.hpp>

#include "adit/io/errors.hpp"
#include "adit/io/output_file.hpp"
#include "csv_cell.hpp"
#include "version.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;

constexpr double kDegree = 180.0 / std::numbers::pi;
constexpr float kRangeUnit_m = 0.001f;

/// ",12.30;-4.50", in degrees.
template <class Angle>
void add_list(std::string& line, const std::vector<Bearing>& bearings, const Angle& angle_rad) {
  line += ',';
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    char text[24];
    std::snprintf(text, sizeof text, "%s%.2f", i == 0 ? "" : ";", kDegree * angle_rad(bearings[i]));
    line += text;
  }
}

std::string name_of(std::int64_t frame) {
  char digits[24];
  std::snprintf(digits, sizeof digits, "%06lld.png", static_cast<long long>(frame));
  return digits;
}

void write_png(const fs::path& path, const cv::Mat& picture, int compression) {
  std::vector<unsigned char> png;
  if (!cv::imencode(".png", picture, png, {cv::IMWRITE_PNG_COMPRESSION, compression}))
    throw io::OutputError(path.string() + ": OpenCV cannot make a PNG of it");
  io::write_file(path, {reinterpret_cast<const char*>(png.data()), png.size()});
}

cv::Mat range_picture(const sim::Frame& frame) {
  cv::Mat picture(frame.height, frame.width, CV_16UC1);
  for (int v = 0; v < frame.height; ++v)
    for (int u = 0; u < frame.width; ++u) {
      const float range_m = frame.range_m[static_cast<std::size_t>(v) * static_cast<std::size_t>(frame.width) +
                                          static_cast<std::size_t>(u)];
      picture.at<std::uint16_t>(v, u) =
          range_m >= sim::kRangeOfNothing_m
              ? std::uint16_t{0}
              : static_cast<std::uint16_t>(std::clamp(range_m / kRangeUnit_m + 0.5f, 1.0f, 65535.0f));
    }
  return picture;
}

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

/// As ROS's camera_calibration writes it, so that `adit run --camera` takes it.
std::string camera_yaml(const CameraModel& c) {
  std::string text = "# Of the frames of this data set.\nimage_width: " + std::to_string(c.width) +
                     "\nimage_height: " + std::to_string(c.height) + "\ncamera_name: adit_render\n";
  text += "camera_matrix:\n  rows: 3\n  cols: 3\n  data: [" + number(c.focal_length_x_px) + ", 0, " +
          number(c.principal_point_x_px) + ", 0, " + number(c.focal_length_y_px) + ", " +
          number(c.principal_point_y_px) + ", 0, 0, 1]\n";
  const bool plumb_bob = c.distortion_model == DistortionModel::kPlumbBob;
  text += "distortion_model: plumb_bob\ndistortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [";
  for (std::size_t i = 0; i < 5; ++i) text += (i == 0 ? "" : ", ") + number(plumb_bob ? c.distortion[i] : 0.0);
  return text + "]\n";
}

std::string dataset_json(const DatasetNote& note, std::int64_t written) {
  nlohmann::ordered_json json;
  json["adit_version"] = ADIT_VERSION;
  json["world"] = note.world;
  json["rig"] = note.rig;
  json["dust_1_m"] = note.dust_1_m;
  json["seed"] = note.seed;
  json["width"] = note.width;
  json["height"] = note.height;
  json["frames"] = written;
  json["frames_asked"] = note.frames_asked;
  json["complete"] = !note.interrupted;
  json["frame_files"] = "frames/%06d.png";
  json["range_files"] = "range/%06d.png";
  json["range_unit_m"] = 0.001;
  json["range_nothing"] = 0;
  json["truth"] = "truth.csv";
  json["camera"] = "camera.yaml";
  json["settings"] = "settings.yaml";
  return json.dump(2) + "\n";
}

}  // namespace

std::string truth_csv_header() {
  return "frame,image,range_image,stamp_s,x_m,y_m,z_m,roll_deg,pitch_deg,yaw_deg,vx_m_s,vy_m_s,vz_m_s,yaw_rate_rad_s,"
         "height_m,passage_azimuth_deg,passage_elevation_deg,deepest_azimuth_deg,deepest_elevation_deg,"
         "deepest_range_m,branch_azimuths_deg,branch_elevations_deg,opening_in_sight,clearance_m,side_clearance_m,"
         "aside_m,exposure_s,gain,mean_level,world,rig,dust_1_m,seed\n";
}

std::string truth_csv_line(const TruthRow& row, const DatasetNote& note) {
  const sim::VehicleState& v = row.vehicle;
  const sim::Truth& t = row.truth;
  const std::string name = name_of(row.frame);
  std::string line = std::to_string(row.frame);
  line.append(",frames/").append(name).append(",range/").append(name);
  add_cell(line, row.stamp_s, 4);
  for (int k = 0; k < 3; ++k) add_cell(line, v.place[k], 4);
  for (const double rad : {v.roll_rad, v.pitch_rad, v.yaw_rad}) add_cell(line, kDegree * rad, 3);
  for (int k = 0; k < 3; ++k) add_cell(line, v.velocity[k], 4);
  add_cell(line, v.yaw_rate_rad_s, 5);
  add_cell(line, v.height_m, 3);
  for (const double rad :
       {t.passage.azimuth_rad, t.passage.elevation_rad, t.deepest.azimuth_rad, t.deepest.elevation_rad})
    add_cell(line, kDegree * rad, 3);
  add_cell(line, t.deepest_range_m, 3);
  add_list(line, t.branches, [](const Bearing& b) { return b.azimuth_rad; });
  add_list(line, t.branches, [](const Bearing& b) { return b.elevation_rad; });
  line += t.opening_in_sight ? ",1" : ",0";
  for (const double m : {t.clearance_m, t.side_clearance_m, t.aside_m}) add_cell(line, m, 3);
  add_cell(line, static_cast<double>(row.exposure.time_s), 6);
  add_cell(line, static_cast<double>(row.exposure.gain), 4);
  add_cell(line, static_cast<double>(row.mean_level), 2);
  for (const std::string& cell : {note.world, note.rig, number(note.dust_1_m), std::to_string(note.seed)})
    line.append(",").append(cell);
  return line.append("\n");
}

std::string remake_yaml(const io::Settings& settings, const io::Settings& as_rig, const std::string& command) {
  std::string text = "# " + command + "\n";
  for (std::size_t s = 0; s < settings.sections().size(); ++s) {
    const io::SettingSection& section = settings.sections()[s];
    const io::SettingSection& before = as_rig.sections()[s];
    std::string lines;
    for (std::size_t k = 0; k < section.settings.size(); ++k) {
      const std::string value = section.settings[k].value();
      if (section.name == "lamp" && value == before.settings[k].value()) continue;
      lines += "  " + std::string(section.settings[k].note.name) + ": " + value + "\n";
    }
    if (!lines.empty()) text += section.name + ":\n" + lines;
  }
  return text;
}

DatasetOutputs::DatasetOutputs(fs::path folder) : folder_(std::move(folder)) {
  for (const char* name : {"frames", "range"}) {
    io::make_folder(folder_ / name);
    if (!fs::is_empty(folder_ / name))
      throw io::OutputError((folder_ / name).string() +
                            ": there are files already, which would mix with new ones; choose another folder");
  }
}

void DatasetOutputs::write_frame(std::int64_t frame, const sim::Frame& picture) const {
  const cv::Mat pixels(picture.height, picture.width, CV_8UC3, const_cast<std::uint8_t*>(picture.bgr.data()));
  // Noise hardly packs: more than the lowest level costs time and saves some per cent.
  write_png(folder_ / "frames" / name_of(frame), pixels, 1);
  write_png(folder_ / "range" / name_of(frame), range_picture(picture), 3);
}

void DatasetOutputs::commit(const std::vector<std::optional<TruthRow>>& rows, const DatasetNote& note,
                            const CameraModel& camera, const std::string& settings_yaml) const {
  std::string table = truth_csv_header();
  std::int64_t written = 0;
  for (const auto& row : rows)
    if (row) {
      table += truth_csv_line(*row, note);
      ++written;
    }
  io::write_file(folder_ / "camera.yaml", camera_yaml(camera));
  io::write_file(folder_ / "settings.yaml", settings_yaml);
  io::write_file(folder_ / "dataset.json", dataset_json(note, written));
  io::write_file(folder_ / "truth.csv", table);
}

}  // namespace adit::tools
