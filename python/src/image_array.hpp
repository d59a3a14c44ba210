// Arrays of numpy as the core's views.
#pragma once

#include <pybind11/numpy.h>

#include <string>
#include <vector>

#include "adit/image.hpp"

namespace adit::python {

/// An array seen as an ImageView. Rows may lie at any stride, the colours of a pixel in either order of memory and
/// beside a fourth channel that is passed over: such arrays are read where they lie. Pixels that do not lie side by
/// side (every second column, a mirrored picture, planes one after the other) are no ImageView; they alone are gathered
/// into `rows`.
class ImageArray {
 public:
  /// @param order  "bgr", "rgb", "bgra" or "rgba", by the array's last axis; "grey"; "" takes bgr, bgra or grey by
  /// shape.
  /// @throws pybind11::type_error for another dtype, pybind11::value_error for another shape or order.
  ImageArray(pybind11::array array, const std::string& order);

  /// What may be done without the interpreter's lock; the array stays alive with this object.
  [[nodiscard]] ImageView view(std::vector<std::uint8_t>& rows) const;
  [[nodiscard]] bool is_copied() const noexcept { return gathered_; }

 private:
  pybind11::array array_;
  const std::uint8_t* data_ = nullptr;  ///< of the first row's first pixel, its lowest address
  int width_ = 0, height_ = 0;
  std::ptrdiff_t row_stride_ = 0, pixel_stride_ = 0, channel_stride_ = 0;
  int channels_ = 1;
  PixelFormat format_ = PixelFormat::kGrey8;
  bool gathered_ = false;
};

}  // namespace adit::python
