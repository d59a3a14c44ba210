// The numbers of the panel: histogram and table.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "panel_parts.hpp"

namespace adit::io {
namespace {

struct Figure {
  const char* name;
  std::string value;
};

std::string text_of(const char* format, double number) {
  char text[64];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

int cluster_of_level(const Clusters& clusters, int level) {
  int cluster = 0;
  while (cluster + 1 < clusters.count && level > clusters.last_level[static_cast<std::size_t>(cluster)]) ++cluster;
  return cluster;
}

std::vector<Figure> left_column(const PanelSubject& subject) {
  const OpenSpace& seen = subject.open_space;
  const bool judged = seen.clusters.count > 0;
  const auto when = [](bool known, const std::string& value) { return known ? value : std::string("-"); };
  return {{"status", std::string(to_string(seen.status))},
          {"confidence", text_of("%.3f", seen.confidence)},
          {"atmospheric light a", when(judged, text_of("%.1f", seen.atmospheric_light))},
          {"darkest level", when(judged, std::to_string(seen.darkest_level))},
          {"threshold level", when(judged, std::to_string(seen.threshold_level))},
          {"brightest level", when(judged, std::to_string(seen.brightest_level))},
          {"clusters",
           when(judged, std::to_string(seen.clusters.count) + " of " + std::to_string(subject.config.cluster_count))},
          {"area of the frame", when(judged, text_of("%.1f %%", 100.0 * seen.area_fraction))},
          {"moment M00", when(judged, std::to_string(seen.moments.m00) + " px")}};
}

std::vector<Figure> right_column(const PanelSubject& subject) {
  const OpenSpace& seen = subject.open_space;
  const bool found = seen.found();
  const auto when = [&](const std::string& value) { return found ? value : std::string("-"); };
  const std::string pinhole = text_of("pinhole, %.0f deg", subject.config.assumed_hfov_deg);
  return {{"centroid u", when(text_of("%.1f px", seen.centroid_px.u_px))},
          {"centroid v", when(text_of("%.1f px", seen.centroid_px.v_px))},
          {"sx (right)", when(text_of("%+.4f", seen.point.sx))},
          {"sy (down)", when(text_of("%+.4f", seen.point.sy))},
          {"azimuth (right)", when(text_of("%+.2f deg", degrees(seen.bearing.azimuth_rad)))},
          {"elevation (up)", when(text_of("%+.2f deg", degrees(seen.bearing.elevation_rad)))},
          {"camera", subject.has_camera ? "calibrated" : pinhole},
          {"method", std::string(to_string(subject.config.method))}};
}

void draw_column(cv::Mat& panel, cv::Rect box, const std::vector<Figure>& figures) {
  const int step = box.height / 9;
  int top = box.y + 2;
  for (const Figure& figure : figures) {
    const Lettering name{13, kFaint, false, Align::kLeft}, value{14, kInk, false, Align::kRight};
    write_text(panel, figure.name, {box.x, top}, name);
    const int room = box.width - size_of_text(figure.name, name).width - 12;
    write_text(panel, fitted(figure.value, value, room), {box.x + box.width, top}, value);
    cv::line(panel, {box.x, top + step - 8}, {box.x + box.width, top + step - 8}, kEmpty, 1);
    top += step;
  }
}

void draw_bars(cv::Mat& panel, cv::Rect box, const Histogram& histogram, const Clusters& clusters) {
  const double most = *std::max_element(histogram.begin(), histogram.end());
  for (int level = 0; level < 256; ++level) {
    const int left = box.x + box.width * level / 256, right = box.x + box.width * (level + 1) / 256;
    const double share = std::sqrt(histogram[static_cast<std::size_t>(level)] / std::max(most, 1.0));
    const int height = static_cast<int>(std::ceil(share * box.height));
    if (height == 0) continue;
    cv::rectangle(panel, cv::Rect(left, box.y + box.height - height, std::max(1, right - left - 1), height),
                  clusters.count > 0 ? colour_of_cluster(cluster_of_level(clusters, level), clusters.count) : kFaint,
                  cv::FILLED);
  }
}

/// A line at the last level of each cluster but the brightest; the darkest one's, the threshold, is named.
void draw_limits(cv::Mat& panel, cv::Rect box, const Clusters& clusters) {
  for (int i = 0; i + 1 < clusters.count; ++i) {
    const int at = box.x + box.width * (clusters.last_level[static_cast<std::size_t>(i)] + 1) / 256;
    cv::line(panel, {at, box.y}, {at, box.y + box.height}, i == 0 ? kInk : kFaint * 0.6, i == 0 ? 2 : 1);
  }
  if (clusters.count < 2) return;
  const int at = box.x + box.width * (clusters.last_level[0] + 1) / 256;
  const std::string words = "threshold: level " + std::to_string(clusters.last_level[0]);
  const Lettering lettering{13, kInk, false, Align::kLeft};
  const int width = size_of_text(words, lettering).width;
  const int left = std::min(at + 10, box.x + box.width - width - 8);
  tint(panel, {left - 6, box.y + 2, width + 12, 24}, kSheet, 0.85);
  write_text(panel, words, {left, box.y + 7}, lettering);
}

}  // namespace

void draw_histogram(cv::Mat& panel, cv::Rect box, const PanelSubject& subject) {
  cv::rectangle(panel, box, kSheet, cv::FILLED);
  const auto& levels = subject.stages.closing_level;
  const cv::Rect plot(box.x + 16, box.y + 14, box.width - 32, box.height - 14 - 34);
  if (levels.empty()) {
    write_text(panel, "no grey levels: the frame was not judged", {box.x + box.width / 2, box.y + box.height / 2 - 8},
               {16, kFaint, false, Align::kCentre});
    return;
  }
  Histogram histogram{};
  for (const std::uint8_t level : levels) ++histogram[level];
  draw_bars(panel, plot, histogram, subject.open_space.clusters);
  draw_limits(panel, plot, subject.open_space.clusters);
  const int foot = plot.y + plot.height;
  cv::line(panel, {plot.x, foot}, {plot.x + plot.width, foot}, kFaint, 1);
  for (const int level : {0, 64, 128, 192, 255}) {
    const int at = plot.x + plot.width * level / 256;
    const Align align = level == 0 ? Align::kLeft : level == 255 ? Align::kRight : Align::kCentre;
    cv::line(panel, {at, foot}, {at, foot + 5}, kFaint, 1);
    write_text(panel, std::to_string(level), {level == 255 ? plot.x + plot.width : at, foot + 11},
               {12, kFaint, false, align});
  }
}

void draw_figures(cv::Mat& panel, cv::Rect box, const PanelSubject& subject) {
  const int gap = 36;
  const int width = (box.width - gap) / 2;
  draw_column(panel, {box.x, box.y, width, box.height}, left_column(subject));
  draw_column(panel, {box.x + width + gap, box.y, width, box.height}, right_column(subject));
}

}  // namespace adit::io
