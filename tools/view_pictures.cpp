#include "view_pictures.hpp"

#include <algorithm>
#include <chrono>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "adit/io/draw.hpp"
#include "adit/io/image_file.hpp"

namespace adit::tools {
namespace {

constexpr int kQuality = 80;
constexpr int kWidthMax_px = 960;        ///< wider frames are made smaller: it goes over a radio link, perhaps
constexpr double kFrame_s = 1.0 / 30.0;  ///< nobody sees more
constexpr double kIdle_s = 0.05;         ///< how soon a first viewer is noticed

cv::Mat fitted(cv::Mat picture) {
  if (picture.cols <= kWidthMax_px) return picture;
  cv::Mat small;
  cv::resize(picture, small, {kWidthMax_px, std::max(1, picture.rows * kWidthMax_px / picture.cols)}, 0, 0,
             cv::INTER_AREA);
  return small;
}

/// Frame and depth map, as in films. The finder is another than perception's: its time is not perception's.
cv::Mat depth_picture(const LiveFrame& frame, const io::Configuration& configuration) {
  OpenSpaceFinder finder(configuration.finder);
  StageImages stages;
  (void)finder.explain(io::view_of(frame.pixels), stages);
  return io::side_by_side(frame.pixels, frame.open_space, stages, frame.command);
}

}  // namespace

ViewPictures::ViewPictures(LiveView& live) : live_(&live), thread_([this] { work(); }) {}

ViewPictures::~ViewPictures() { thread_.join(); }

void ViewPictures::watch(PictureKind kind, int change) {
  const std::scoped_lock lock(mutex_);
  newest_[static_cast<std::size_t>(kind)].viewers += change;
}

bool ViewPictures::is_watched(PictureKind kind) {
  const std::scoped_lock lock(mutex_);
  return newest_[static_cast<std::size_t>(kind)].viewers > 0;
}

std::shared_ptr<const std::string> ViewPictures::after(PictureKind kind, std::int64_t& number, double wait_s) {
  std::unique_lock lock(mutex_);
  const Newest& newest = newest_[static_cast<std::size_t>(kind)];
  made_.wait_for(lock, std::chrono::duration<double>(wait_s), [&] { return newest.number > number; });
  if (newest.number <= number) return nullptr;
  number = newest.number;
  return newest.jpeg;
}

void ViewPictures::put(PictureKind kind, std::int64_t number, const cv::Mat& picture) {
  std::vector<unsigned char> jpeg;
  cv::imencode(".jpg", fitted(picture), jpeg, {cv::IMWRITE_JPEG_QUALITY, kQuality});
  {
    const std::scoped_lock lock(mutex_);
    Newest& newest = newest_[static_cast<std::size_t>(kind)];
    newest.number = number;
    newest.jpeg = std::make_shared<const std::string>(jpeg.begin(), jpeg.end());
  }
  made_.notify_all();
}

void ViewPictures::work() {
  std::array<std::int64_t, kPictureKinds> drawn{};
  while (!live_->has_ended()) {
    const auto begin = std::chrono::steady_clock::now();
    for (const PictureKind kind : {PictureKind::kOverlay, PictureKind::kDepth}) {
      if (!is_watched(kind)) continue;
      std::int64_t& last = drawn[static_cast<std::size_t>(kind)];
      const auto frame = live_->frame_after(last, 0.0, last);
      if (!frame || (frame->pixels.empty() && frame->panel.empty())) continue;
      const io::Configuration configuration = live_->configuration();
      if (!frame->panel.empty()) {
        const cv::Rect left(0, 0, frame->panel.cols / 2, frame->panel.rows);
        put(kind, last, kind == PictureKind::kDepth ? frame->panel : frame->panel(left));
      } else if (kind == PictureKind::kDepth) {
        put(kind, last, depth_picture(*frame, configuration));
      } else {
        cv::Mat picture = io::bgr_of(frame->pixels, configuration.finder.grey16_depth_bits);
        io::draw_overlay(picture, frame->open_space, frame->command);
        put(kind, last, picture);
      }
    }
    const bool any = is_watched(PictureKind::kOverlay) || is_watched(PictureKind::kDepth);
    std::this_thread::sleep_until(begin + std::chrono::duration<double>(any ? kFrame_s : kIdle_s));
  }
}

}  // namespace adit::tools
