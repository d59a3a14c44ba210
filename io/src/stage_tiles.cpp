// The pictures of Figure 1.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "adit/io/draw.hpp"
#include "marks.hpp"
#include "panel_parts.hpp"

namespace adit::io {
namespace {

std::string size_note(const char* what, int set_px, int vga_px, int width_px) {
  const int size = set_px > 0 ? set_px : scaled_size_px(vga_px, width_px);
  return std::string(what) + " " + std::to_string(size) + " x " + std::to_string(size) + " px";
}

template <class Value>
cv::Mat plane_of(const std::vector<Value>& pixels, const StageImages& stages, int type) {
  const std::size_t wanted = static_cast<std::size_t>(stages.width) * static_cast<std::size_t>(stages.height);
  if (pixels.empty() || pixels.size() != wanted) return {};
  return cv::Mat(stages.height, stages.width, type, const_cast<Value*>(pixels.data()));  // only read
}

cv::Mat grey_picture(const cv::Mat& grey) {
  if (grey.empty()) return {};
  cv::Mat bgr;
  cv::cvtColor(grey, bgr, cv::COLOR_GRAY2BGR);
  return bgr;
}

cv::Mat transmission_picture(const cv::Mat& transmission) {
  if (transmission.empty()) return {};
  cv::Mat grey;
  transmission.convertTo(grey, CV_8U, 255.0);
  return grey_picture(grey);
}

/// Depth before the closing, in the colours of the depth map.
cv::Mat depth_picture(const StageImages& stages) {
  if (plane_of(stages.scattering_depth, stages, CV_32F).empty()) return {};
  StageImages shown;
  shown.width = stages.width;
  shown.height = stages.height;
  shown.closing = stages.scattering_depth;
  return depth_map(shown);
}

cv::Mat cluster_picture(const cv::Mat& clusters, int count) {
  if (clusters.empty() || count < 1) return {};
  cv::Mat colours = cv::Mat::zeros(1, 256, CV_8UC3);
  for (int i = 0; i < count; ++i) {  // a colour costs a whole colour map
    const cv::Scalar colour = colour_of_cluster(i, count);
    colours.at<cv::Vec3b>(0, i) =
        cv::Vec3b(cv::saturate_cast<std::uint8_t>(colour[0]), cv::saturate_cast<std::uint8_t>(colour[1]),
                  cv::saturate_cast<std::uint8_t>(colour[2]));
  }
  cv::Mat bgr;
  cv::LUT(grey_picture(clusters), colours, bgr);
  return bgr;
}

cv::Mat binary_picture(const cv::Mat& binary, const OpenSpace& seen) {
  if (binary.empty()) return {};
  cv::Mat bgr = grey_picture(binary);
  Scale scale = scale_of(bgr.size());
  scale.radius_px *= 2;  // the tile is small
  scale.line_px *= 2;
  if (seen.found()) draw_circle(bgr, seen.centroid_px, kCircle, scale);
  return bgr;
}

std::string text_of(const char* format, double number) {
  char text[64];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

/// Numbers in [low, high] in the colours from violet to yellow.
cv::Mat scale_picture(const cv::Mat& numbers, double low, double high) {
  if (numbers.empty()) return {};
  cv::Mat grey, bgr;
  numbers.convertTo(grey, CV_8U, 255.0 / (high - low), -255.0 * low / (high - low));
  cv::applyColorMap(grey, bgr, cv::COLORMAP_VIRIDIS);
  return bgr;
}

/// The best opening red, the others paler, on the frame.
cv::Mat openings_picture(const PanelSubject& subject, const cv::Mat& openings) {
  if (openings.empty()) return {};
  cv::Mat bgr = bgr_of(subject.frame, subject.config.grey16_depth_bits) * 0.5;
  for (int i = 0; i < subject.open_space.opening_count; ++i) {
    bgr.setTo(i == 0 ? cv::Scalar(50, 50, 235) : cv::Scalar(120, 120, 160), openings == i + 1);
  }
  Scale scale = scale_of(bgr.size());
  scale.radius_px *= 2;  // the tile is small
  scale.line_px *= 2;
  if (subject.open_space.found()) draw_circle(bgr, subject.open_space.centroid_px, cv::Scalar(255, 255, 255), scale);
  return bgr;
}

/// The stages of the method `adit`, after two of the published ones for comparison.
void add_adit_tiles(const PanelSubject& subject, std::vector<StageTile>& tiles) {
  const StageImages& stages = subject.stages;
  const OpenSpace& seen = subject.open_space;
  const cv::Mat light = plane_of(stages.light, stages, CV_32F);
  double darkest = 0.0, brightest = 0.0;
  if (!light.empty()) cv::minMaxLoc(light, &darkest, &brightest);
  tiles.push_back({scale_picture(light, darkest, std::max(brightest, darkest + 1.0)), "light", "stops, coarse grid",
                   text_of("%.1f", brightest - darkest) + " stops in the frame"});
  tiles.push_back({scale_picture(plane_of(stages.enclosure, stages, CV_32F), 0.0, 4.0), "enclosure",
                   "rise of rock about it", "0 to 4 stops"});
  tiles.push_back({openings_picture(subject, plane_of(stages.openings, stages, CV_8U)), "openings",
                   "rule: " + std::string(to_string(seen.rule)),
                   std::to_string(seen.opening_count) + text_of(", veil %.2f", seen.veil_fraction)});
}

}  // namespace

std::vector<StageTile> stage_tiles(const PanelSubject& subject) {
  const StageImages& stages = subject.stages;
  const FinderConfig& config = subject.config;
  const OpenSpace& seen = subject.open_space;
  const int width = subject.frame.cols;
  const cv::Mat dark = plane_of(stages.dark_channel, stages, CV_8U);
  const bool has_depth = !plane_of(stages.closing, stages, CV_32F).empty();
  const std::string k = std::to_string(seen.clusters.count);
  std::vector<StageTile> tiles;
  tiles.push_back({bgr_of(subject.frame, config.grey16_depth_bits), "frame", "I, eq. (1)",
                   "a = " + text_of("%.1f", seen.atmospheric_light) + " of 255"});
  tiles.push_back({grey_picture(dark), "dark channel", "min of colours, patch; (3)",
                   size_note("patch", config.patch_size_px, config.patch_size_vga_px, width)});
  tiles.push_back({transmission_picture(plane_of(stages.transmission, stages, CV_32F)), "transmission",
                   "1 - omega dark / a; (3)", "omega = " + text_of("%.2f", config.omega)});
  tiles.push_back({depth_picture(stages), "scattering depth", "d = -ln(t) / beta; (2)",
                   "beta = " + text_of("%g", config.scattering_coefficient)});
  tiles.push_back(
      {has_depth ? depth_map(stages) : cv::Mat(), "closing", "dilate, erode; (4), (5)",
       size_note("ellipse", config.structuring_element_size_px, config.structuring_element_size_vga_px, width)});
  if (config.method == Method::kAdit) {
    add_adit_tiles(subject, tiles);
    tiles.erase(tiles.begin() + 2);  // the transmission: as many tiles as the published chain has
    return tiles;
  }
  tiles.push_back({cluster_picture(plane_of(stages.cluster, stages, CV_8U), seen.clusters.count), "clusters",
                   "k-means; (6), (7)", k + " clusters, " + std::string(to_string(config.clustering))});
  tiles.push_back({binary_picture(plane_of(stages.binary, stages, CV_8U), seen), "darkest, centroid",
                   "moments; (8), (9)", text_of("%.1f %% of the frame", 100.0 * seen.area_fraction)});
  return tiles;
}

cv::Scalar colour_of_cluster(int cluster, int cluster_count) {
  if (cluster <= 0) return {50, 50, 235};
  const double share = cluster_count > 2 ? (cluster - 1.0) / (cluster_count - 2.0) : 1.0;
  const cv::Mat level(1, 1, CV_8UC1, cv::Scalar(std::round(40.0 + 215.0 * std::min(share, 1.0))));
  cv::Mat colour;
  cv::applyColorMap(level, colour, cv::COLORMAP_VIRIDIS);
  const auto bgr = colour.at<cv::Vec3b>(0, 0);
  return {static_cast<double>(bgr[0]), static_cast<double>(bgr[1]), static_cast<double>(bgr[2])};
}

}  // namespace adit::io
