// FrameWatch: what is wrong with a stream of frames that no single frame shows.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "adit/api.hpp"
#include "adit/finder.hpp"
#include "adit/image.hpp"

namespace ADIT_API adit {

/// Every constant of the watch; unit, range and source of each field stand in visit_fields() (navigator_fields.hpp).
struct FrameWatchConfig {
  int frozen_frames = 3;
  double torn_fraction_min = 0.1;
  int torn_frames_max = 30;
};

/// Why a configuration is refused, naming the field, the value and the range. Empty when it is good.
[[nodiscard]] std::optional<std::string> fault_of(const FrameWatchConfig& config);

/// Compares each frame with the one before, on some of its rows. Allocates nothing.
///
/// Frozen: a camera's noise never repeats, so frames that are the same to the last bit are one frame, whatever their
/// stamps say. Torn: the lower rows are those of the frame before while the upper are new (or the other way round), the
/// lower rows lost their signal, or the picture jumps along one row from edge to edge where it did not before.
class FrameWatch {
 public:
  /// @throws std::invalid_argument naming the field, the value and the range.
  explicit FrameWatch(const FrameWatchConfig& config = {});

  /// kFrozenFrame, kTornFrame, or kFound when there is nothing to say. A frame that is no frame is passed over.
  [[nodiscard]] Status judge(const ImageView& frame) noexcept;
  void reset() noexcept;

 private:
  static constexpr int kRows = 64;
  struct Rows {
    std::array<std::uint64_t, kRows> hash{};  ///< of all bytes of the row
    std::array<bool, kRows> flat{};           ///< all of one value
    int seam = -1;                            ///< row of a jump from edge to edge, px; -1: none
  };
  static Rows rows_of(const ImageView& frame) noexcept;
  static int seam_of(const ImageView& frame) noexcept;
  [[nodiscard]] bool is_torn(const Rows& rows, int height) const noexcept;
  [[nodiscard]] bool is_same(const Rows& rows) const noexcept;

  FrameWatchConfig config_;
  int width_ = 0, height_ = 0;
  PixelFormat format_ = PixelFormat::kGrey8;
  Rows last_;
  bool has_last_ = false;
  int same_count_ = 0;  ///< frames in a row that were the one before
  int torn_count_ = 0;  ///< frames in a row that were torn
};

}  // namespace adit
