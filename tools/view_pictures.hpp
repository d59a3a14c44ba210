// Pictures of a live view, encoded once for all viewers, on a thread of their own.
#pragma once

#include <array>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "live_view.hpp"

namespace adit::tools {

/// What a viewer may look at.
enum class PictureKind { kOverlay, kDepth };
inline constexpr std::size_t kPictureKinds = 2;

class ViewPictures {
 public:
  explicit ViewPictures(LiveView& live);
  /// After LiveView::end().
  ~ViewPictures();
  ViewPictures(const ViewPictures&) = delete;
  ViewPictures& operator=(const ViewPictures&) = delete;

  /// A viewer of this kind comes or goes: what nobody looks at is not encoded.
  void watch(PictureKind kind, int change);
  /// The newest JPEG if its number is above `number`, which it then sets; waits up to wait_s. Null if there is none.
  [[nodiscard]] std::shared_ptr<const std::string> after(PictureKind kind, std::int64_t& number, double wait_s);

 private:
  struct Newest {
    int viewers = 0;
    std::int64_t number = 0;
    std::shared_ptr<const std::string> jpeg;
  };
  void work();
  [[nodiscard]] bool is_watched(PictureKind kind);
  void put(PictureKind kind, std::int64_t number, const cv::Mat& picture);

  LiveView* live_;
  std::mutex mutex_;
  std::condition_variable made_;
  std::array<Newest, kPictureKinds> newest_;
  std::thread thread_;
};

}  // namespace adit::tools
