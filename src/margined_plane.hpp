// A plane with margins, so that an element may reach beyond its edges. Internal to the morphology.
#pragma once

#include <cstring>

#include "adit/image.hpp"
#include "aligned_bytes.hpp"
#include "kernels/pixel_loops.hpp"

namespace adit {

/// Pixels whose rows begin on a cache line, and around them a value that is never better.
class MarginedPlane {
 public:
  /// Makes room, unless it is as wanted. What writes pixels leaves the margins alone. May throw std::bad_alloc.
  void reserve(int width, int height, int reach_u, int reach_v) {
    if (width == width_ && height == height_ && reach_u == reach_u_ && reach_v == reach_v_) return;
    width_ = 0;  // until all is done
    // The right margin of a row is the left one of the next.
    const std::size_t left = AlignedBytes::rounded_up(static_cast<std::size_t>(reach_u));
    const std::size_t pitch = AlignedBytes::rounded_up(left + static_cast<std::size_t>(width));
    const auto rows = static_cast<std::size_t>(height + 2 * reach_v);
    // Steps read whole vectors, and so beyond the last margin.
    const std::size_t beyond = 2 * pitch + left;
    bytes_.reserve(rows * pitch + beyond);
    std::memset(bytes_.get(), 0, rows * pitch + beyond);
    left_ = static_cast<std::ptrdiff_t>(left);
    pitch_ = static_cast<std::ptrdiff_t>(pitch);
    width_ = width;
    height_ = height;
    reach_u_ = reach_u;
    reach_v_ = reach_v;
    margin_ = 0;
  }

  /// Another value for the margins; the pixels stay.
  void set_margins(std::uint8_t margin) noexcept {
    if (margin == margin_) return;
    margin_ = margin;
    const auto left = static_cast<std::size_t>(left_);
    const auto above = static_cast<std::size_t>(reach_v_ * pitch_);
    // The right margin of a row and the left one of the next lie side by side.
    const auto between = static_cast<std::size_t>(pitch_ - width_);
    std::uint8_t* row = bytes_.get();
    std::memset(row, margin, above + left);
    row += above + left;
    for (int v = 0; v < height_; ++v, row += pitch_) std::memset(row + width_, margin, between);
    std::memset(row, margin, above);
  }

  [[nodiscard]] PlaneView pixels() const noexcept {
    return {bytes_.get() + reach_v_ * pitch_ + left_, width_, height_, pitch_};
  }
  /// From the topmost and leftmost value that the first pixel's element needs.
  [[nodiscard]] kernels::ConstRows with_margins(int reach_u, int reach_v) const noexcept {
    return {bytes_.get() + (reach_v_ - reach_v) * pitch_ + left_ - reach_u, pitch_};
  }

 private:
  AlignedBytes bytes_;
  int width_ = 0;
  int height_ = 0;
  int reach_u_ = 0;
  int reach_v_ = 0;
  std::uint8_t margin_ = 0;
  std::ptrdiff_t left_ = 0;
  std::ptrdiff_t pitch_ = 0;
};

}  // namespace adit
