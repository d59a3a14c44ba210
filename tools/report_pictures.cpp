#include "report_pictures.hpp"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "adit/io/draw.hpp"
#include "adit/io/stage_tiles.hpp"

namespace adit::tools {
namespace {

constexpr int kFrameQuality = 70;  ///< of JPEG: 6 to 10 kB for a dark frame of 400 px
constexpr int kTileQuality = 70;

std::vector<unsigned char> jpeg_of(const cv::Mat& picture, int quality) {
  std::vector<unsigned char> jpeg;
  cv::imencode(".jpg", picture, jpeg, {cv::IMWRITE_JPEG_QUALITY, quality});
  return jpeg;
}

cv::Mat fitted(const cv::Mat& picture, int width_px) {
  if (picture.cols <= width_px) return picture;
  cv::Mat small;
  const int height_px = std::max(1, picture.rows * width_px / picture.cols);
  cv::resize(picture, small, {width_px, height_px}, 0, 0, cv::INTER_AREA);
  return small;
}

/// Every so many-th pixel of a stage: enough for a tile, and far cheaper than drawing it whole.
template <class Value>
std::vector<Value> reduced(const std::vector<Value>& pixels, const StageImages& stages, const cv::Size& size) {
  if (pixels.empty()) return {};
  std::vector<Value> small;
  small.reserve(static_cast<std::size_t>(size.area()));
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const int v = (2 * y + 1) * stages.height / (2 * size.height), u = (2 * x + 1) * stages.width / (2 * size.width);
      small.push_back(
          pixels[static_cast<std::size_t>(v) * static_cast<std::size_t>(stages.width) + static_cast<std::size_t>(u)]);
    }
  return small;
}

StageImages reduced(const StageImages& stages, const cv::Size& size) {
  StageImages small;
  small.width = size.width;
  small.height = size.height;
  small.dark_channel = reduced(stages.dark_channel, stages, size);
  small.transmission = reduced(stages.transmission, stages, size);
  small.scattering_depth = reduced(stages.scattering_depth, stages, size);
  small.closing = reduced(stages.closing, stages, size);
  small.closing_level = reduced(stages.closing_level, stages, size);
  small.cluster = reduced(stages.cluster, stages, size);
  small.binary = reduced(stages.binary, stages, size);
  small.light = reduced(stages.light, stages, size);
  small.enclosure = reduced(stages.enclosure, stages, size);
  small.openings = reduced(stages.openings, stages, size);
  return small;
}

}  // namespace

void ThinnedPictures::add(std::int64_t row, std::vector<unsigned char> jpeg) {
  if (!wants(row)) return;
  bytes_ += static_cast<std::int64_t>(jpeg.size());
  pictures_.push_back({row, std::move(jpeg)});
  while (bytes_ > bytes_max_ && pictures_.size() > 1) {
    stride_ *= 2;
    std::erase_if(pictures_, [this](const Picture& picture) {
      if (wants(picture.row)) return false;
      bytes_ -= static_cast<std::int64_t>(picture.jpeg.size());
      return true;
    });
  }
}

ReportShot shot_of(const cv::Mat& frame, const OpenSpace& open_space, const StageImages& stages,
                   const FinderConfig& config) {
  ReportShot shot;
  const cv::Mat bgr = fitted(io::bgr_of(frame, config.grey16_depth_bits), kFrameWidth_px);
  shot.frame = jpeg_of(bgr, kFrameQuality);
  const cv::Size size(kTileWidth_px, std::max(1, kTileWidth_px * frame.rows / frame.cols));
  cv::Mat small;
  cv::resize(bgr, small, size, 0, 0, cv::INTER_AREA);
  OpenSpace seen = open_space;
  seen.centroid_px = {seen.centroid_px.u_px * size.width / frame.cols,
                      seen.centroid_px.v_px * size.height / frame.rows};
  // The first tile is the frame itself.
  const std::vector<io::StageTile> all = io::stage_tiles({"", small, seen, reduced(stages, size), config, false});
  const int count = static_cast<int>(all.size()) - 1;
  const int rows = (count + kTileColumns - 1) / kTileColumns;
  cv::Mat sheet = cv::Mat::zeros(rows * size.height, kTileColumns * size.width, CV_8UC3);
  for (int i = 0; i < count; ++i) {
    const io::StageTile& tile = all[static_cast<std::size_t>(i) + 1];
    shot.tile_names.push_back(tile.name + " — " + tile.equation);
    if (tile.picture.empty()) continue;
    tile.picture.copyTo(
        sheet(cv::Rect(cv::Point(i % kTileColumns * size.width, i / kTileColumns * size.height), size)));
  }
  shot.stages = jpeg_of(sheet, kTileQuality);
  return shot;
}

ReportShot shot_of_film(const cv::Mat& side_by_side) {
  const int half = side_by_side.cols / 2;
  const cv::Mat frame = side_by_side(cv::Rect(0, 0, half, side_by_side.rows));
  const cv::Mat depth = side_by_side(cv::Rect(half, 0, half, side_by_side.rows));
  return {jpeg_of(fitted(frame, kFrameWidth_px), kFrameQuality),
          jpeg_of(fitted(depth, kFrameWidth_px), kTileQuality),
          {"closed scattering depth — eq. (2), (4), (5)"}};
}

void ReportPictures::add(std::int64_t row, const cv::Size& size, ReportShot shot) {
  if (frames.pictures().empty()) {
    width_px = size.width;
    height_px = size.height;
  }
  if (tile_names.empty()) tile_names = std::move(shot.tile_names);
  frames.add(row, std::move(shot.frame));
  if (!shot.stages.empty()) stages.add(row, std::move(shot.stages));
}

}  // namespace adit::tools
