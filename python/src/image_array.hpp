// Arrays of numpy as the core's views.
#pragma once

#include <pybind11/numpy.h>

#include <string>

#include "adit/image.hpp"

namespace adit::python {

/// An array seen as an ImageView. Nothing is copied: rows, columns and channels may lie at any stride.
class ImageArray {
 public:
  /// @param order  "bgr", "rgb", "bgra" or "rgba", by the array's last axis; "grey"; "" takes bgr, bgra or grey by
  /// shape.
  /// @throws pybind11::type_error for another dtype, pybind11::value_error for another shape or order.
  ImageArray(pybind11::array array, const std::string& order);

  /// May be used without the interpreter's lock; the array stays alive with this object.
  [[nodiscard]] const ImageView& view() const noexcept { return view_; }

 private:
  pybind11::array array_;
  ImageView view_;
};

}  // namespace adit::python
