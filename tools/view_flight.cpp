#include "view_flight.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <thread>

#include "adit/io/image_file.hpp"
#include "fly_outputs.hpp"
#include "interrupt.hpp"
#include "progress.hpp"

namespace adit::tools {
namespace {

io::Configuration configuration_of(const sim::FlightSettings& s) {
  return {s.finder, s.heading, s.column_range, s.range_memory, s.tracker, s.steering, s.frame_watch, s.lens_watch};
}

/// Steep patches of less than half a square metre are stones on the floor and knobs of the roof.
void clear_stones(cv::Mat& picture, double cell_m) {
  constexpr double kStone_m2 = 0.5;
  cv::Mat steep, labels, figures, middles;
  cv::extractChannel(picture, steep, 3);
  const int count = cv::connectedComponentsWithStats(steep, labels, figures, middles);
  std::vector<bool> is_stone(static_cast<std::size_t>(count));
  for (int i = 1; i < count; ++i)
    is_stone[static_cast<std::size_t>(i)] = figures.at<int>(i, cv::CC_STAT_AREA) * cell_m * cell_m < kStone_m2;
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x)
      if (is_stone[static_cast<std::size_t>(labels.at<int>(y, x))]) picture.at<cv::Vec4b>(y, x) = {};
}

}  // namespace

LivePlan plan_of(const sim::World& world) {
  constexpr double kMargin_m = 2.0, kCell_m = 0.1, kPixelsMax = 4000.0;
  constexpr float kSteep = 0.2f;  // normals within 12 deg of level are walls; stones on the floor are few of them
  const sim::Mesh& mesh = world.mesh;
  if (mesh.vertices.empty()) return {};
  Eigen::Vector3f low = mesh.vertices.front(), high = low;
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  const double width_m = static_cast<double>(high.x() - low.x()) + 2.0 * kMargin_m;
  const double height_m = static_cast<double>(high.y() - low.y()) + 2.0 * kMargin_m;
  LivePlan plan{"", static_cast<double>(low.x()) - kMargin_m, static_cast<double>(low.y()) - kMargin_m,
                std::max(kCell_m, std::max(width_m, height_m) / kPixelsMax)};
  cv::Mat picture(static_cast<int>(height_m / plan.cell_m) + 1, static_cast<int>(width_m / plan.cell_m) + 1, CV_8UC4,
                  cv::Scalar(0, 0, 0, 0));
  const auto pixel = [&](const Eigen::Vector3f& p) {
    return cv::Point(static_cast<int>((static_cast<double>(p.x()) - plan.x_min_m) / plan.cell_m),
                     picture.rows - 1 - static_cast<int>((static_cast<double>(p.y()) - plan.y_min_m) / plan.cell_m));
  };
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Eigen::Vector3f normal = (b - a).cross(c - a);
    if (std::abs(normal.z()) > kSteep * normal.norm()) continue;
    const cv::Point corners[] = {pixel(a), pixel(b), pixel(c)};
    cv::fillConvexPoly(picture, corners, 3, cv::Scalar(140, 125, 110, 255));
    cv::line(picture, corners[0], corners[1], cv::Scalar(140, 125, 110, 255));
  }
  clear_stones(picture, plan.cell_m);
  std::vector<unsigned char> png;
  cv::imencode(".png", picture, png);
  plan.png.assign(png.begin(), png.end());
  return plan;
}

FlightView::FlightView(const std::string& name, const FlySettings& settings, const sim::World& world,
                       const ViewAddress& address)
    : flown_(configuration_of(settings.flight)),
      live_("flight of " + name, flown_, true, plan_of(world)),
      server_(live_, address) {
  std::printf("%s\n", server_.address().c_str());
  std::fflush(stdout);
  print_line("open the address in a browser, end with Ctrl-C");
  live_.say("flying");
}

void FlightView::add(const sim::Flight& flight) {
  if (flight.frame().data == nullptr) return;
  const sim::FlightRow& row = flight.row();
  live_.show({io::mat_of(flight.frame()).clone(), cv::Mat(), row.stamp_s, flight.open_space(), row.command,
              LivePose{row.vehicle.place.x(), row.vehicle.place.y(), row.vehicle.yaw_rad}, row.speed_scale});
}

std::vector<SettingChange> FlightView::take_changes(sim::Flight& flight) {
  const auto wanted = live_.new_settings();
  if (!wanted) return {};
  std::vector<SettingChange> changes = changes_between(flown_, *wanted, flight.time_s());
  if (changes.empty()) return {};  // changed there and back
  flight.change(io::navigator_config_of(*wanted));
  flown_ = *wanted;
  changes_.insert(changes_.end(), changes.begin(), changes.end());
  live_.say("flying. " + note_of(changes_));
  return changes;
}

void FlightView::stay(const std::string& line) {
  live_.hold_settings();
  const std::string note = note_of(changes_);
  live_.say(note.empty() ? line : line + ". " + note);
  while (!is_interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

}  // namespace adit::tools
