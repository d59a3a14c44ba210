// Pictures of a run, thinned to what a page can hold.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <utility>
#include <vector>

#include "adit/finder.hpp"

namespace adit::tools {

/// Pictures of every n-th row; n doubles whenever they have outgrown their budget.
class ThinnedPictures {
 public:
  struct Picture {
    std::int64_t row = 0;
    std::vector<unsigned char> jpeg;
  };

  explicit ThinnedPictures(std::int64_t bytes_max) : bytes_max_(bytes_max) {}

  [[nodiscard]] bool wants(std::int64_t row) const noexcept { return row % stride_ == 0; }
  /// Rows come in growing order; one that is no longer wanted is passed over.
  void add(std::int64_t row, std::vector<unsigned char> jpeg);

  [[nodiscard]] const std::vector<Picture>& pictures() const noexcept { return pictures_; }
  [[nodiscard]] std::int64_t bytes() const noexcept { return bytes_; }

 private:
  std::int64_t bytes_max_;
  std::int64_t bytes_ = 0;
  std::int64_t stride_ = 1;
  std::vector<Picture> pictures_;
};

/// What a report keeps of one frame.
struct ReportShot {
  std::vector<unsigned char> frame;   ///< JPEG, at most kFrameWidth_px wide, without overlay
  std::vector<unsigned char> stages;  ///< JPEG, tiles side by side in rows of kTileColumns; empty if there are none
  std::vector<std::string> tile_names;
};
inline constexpr int kFrameWidth_px = 400;
inline constexpr int kTileColumns = 3;
inline constexpr int kTileWidth_px = 200;

/// @param frame  any frame that io::bgr_of() takes. @param stages  of OpenSpaceFinder::explain of the same frame.
[[nodiscard]] ReportShot shot_of(const cv::Mat& frame, const OpenSpace& open_space, const StageImages& stages,
                                 const FinderConfig& config);
/// Half of a film's picture as a frame, the other half as its only tile: see io::side_by_side().
[[nodiscard]] ReportShot shot_of_film(const cv::Mat& side_by_side);

/// All that is kept. Budgets are bytes of JPEG; in the page they are a third longer.
struct ReportPictures {
  static constexpr std::int64_t kFrameBytes =
      16'000'000;  ///< 1000 to 2000 frames; the page is 30 MB at most, and its table
  static constexpr std::int64_t kStageBytes = 6'000'000;
  ThinnedPictures frames{kFrameBytes};
  ThinnedPictures stages{kStageBytes};
  std::vector<std::string> tile_names;
  bool overlay_is_drawn = false;    ///< the pictures have the answer drawn in
  int width_px = 0, height_px = 0;  ///< of a frame as it was judged

  void add(std::int64_t row, const cv::Size& size, ReportShot shot);
};

}  // namespace adit::tools
