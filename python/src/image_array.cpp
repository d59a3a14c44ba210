#include "image_array.hpp"

#include <cstring>

namespace py = pybind11;

namespace adit::python {
namespace {

std::string shape_text(const py::array& array) { return py::str(array.attr("shape")); }

int side_of(py::ssize_t length, const py::array& array) {
  // Sides out of range are the core's to refuse (bad_frame), as long as an int holds them.
  if (length > (1 << 30)) throw py::value_error("an array of shape " + shape_text(array) + " is no frame");
  return static_cast<int>(length);
}

PixelFormat format_of(const std::string& order, py::ssize_t channels, const py::array& array) {
  const std::string chosen = !order.empty() ? order : channels == 4 ? "bgra" : channels == 3 ? "bgr" : "grey";
  if (chosen == "grey" && channels == 1) return PixelFormat::kGrey8;
  if (chosen == "bgr" && channels == 3) return PixelFormat::kBgr8;
  if (chosen == "rgb" && channels == 3) return PixelFormat::kRgb8;
  if (chosen == "bgra" && channels == 4) return PixelFormat::kBgra8;
  if (chosen == "rgba" && channels == 4) return PixelFormat::kRgba8;
  for (const char* known : {"grey", "bgr", "rgb", "bgra", "rgba"})
    if (chosen == known)
      throw py::value_error("an array of shape " + shape_text(array) + " has not the channels of order '" + chosen +
                            "'");
  throw py::value_error("order: '" + chosen + "' is none of grey, bgr, rgb, bgra, rgba");
}

PixelFormat swapped(PixelFormat format) {
  return format == PixelFormat::kBgr8 ? PixelFormat::kRgb8 : PixelFormat::kBgr8;
}

PixelFormat with_fourth(PixelFormat format) {
  return format == PixelFormat::kBgr8 ? PixelFormat::kBgra8 : PixelFormat::kRgba8;
}

/// One past the last byte that is known to belong to the array's memory: that of the array it is a view of.
const std::uint8_t* end_of_memory(const py::array& array) {
  py::array owner = array;
  for (py::object base = owner.base(); base && py::isinstance<py::array>(base); base = owner.base())
    owner = py::reinterpret_borrow<py::array>(base);
  const auto* end = static_cast<const std::uint8_t*>(owner.data());
  for (py::ssize_t axis = 0; axis < owner.ndim(); ++axis)
    if (owner.strides(axis) > 0) end += (owner.shape(axis) - 1) * owner.strides(axis);
  return end + owner.itemsize();
}

}  // namespace

ImageArray::ImageArray(py::array array, const std::string& order) : array_(std::move(array)) {
  const bool is_16 = py::isinstance<py::array_t<std::uint16_t>>(array_);
  if (!is_16 && !py::isinstance<py::array_t<std::uint8_t>>(array_))
    throw py::type_error("frames are arrays of uint8, or grey ones of uint16, not of " +
                         std::string(py::str(static_cast<py::object>(array_.dtype()))));
  if (array_.ndim() != 2 && array_.ndim() != 3)
    throw py::value_error("frames have the shape (height, width) or (height, width, channels), not " +
                          shape_text(array_));
  height_ = side_of(array_.shape(0), array_);
  width_ = side_of(array_.shape(1), array_);
  row_stride_ = array_.strides(0);
  pixel_stride_ = array_.strides(1);
  const py::ssize_t channels = array_.ndim() == 3 ? array_.shape(2) : 1;
  format_ = format_of(order, channels, array_);
  if (is_16 && channels != 1)
    throw py::value_error("an array of uint16 has to be grey, not of shape " + shape_text(array_));
  if (is_16) format_ = PixelFormat::kGrey16;
  channels_ = static_cast<int>(channels);
  channel_stride_ = channels_ > 1 ? array_.strides(2) : 1;
  data_ = static_cast<const std::uint8_t*>(array_.data());
  if (channels_ == 3 && channel_stride_ == -1 && (pixel_stride_ == 3 || pixel_stride_ == 4)) {
    // frame[..., ::-1]: the same bytes from the other end.
    data_ -= 2;
    channel_stride_ = 1;
    format_ = swapped(format_);
  }
  if (channels_ == 3 && channel_stride_ == 1 && pixel_stride_ == 4 && height_ > 0) {
    // frame[..., :3] of four channels. The fourth is passed over, but it has to be there to be read.
    const std::uint8_t* last_row = data_ + (row_stride_ > 0 ? (height_ - 1) * row_stride_ : 0);
    if (last_row + std::ptrdiff_t{4} * width_ <= end_of_memory(array_)) format_ = with_fourth(format_);
  }
  const int bytes = bytes_per_pixel(format_);
  const bool odd = is_16 && (reinterpret_cast<std::uintptr_t>(data_) % 2 != 0 || row_stride_ % 2 != 0);
  const std::ptrdiff_t reach = row_stride_ < 0 ? -row_stride_ : row_stride_;
  gathered_ = pixel_stride_ != bytes || channel_stride_ != 1 || odd ||
              reach < static_cast<std::ptrdiff_t>(bytes) * width_;  // a broadcast row, stride 0
}

ImageView ImageArray::view(std::vector<std::uint8_t>& rows) const {
  if (!gathered_) return {data_, width_, height_, row_stride_, format_};
  const auto bytes = static_cast<std::size_t>(bytes_per_pixel(format_));
  const auto row_bytes = bytes * static_cast<std::size_t>(width_);
  rows.resize(row_bytes * static_cast<std::size_t>(height_));
  const std::size_t step = format_ == PixelFormat::kGrey16 ? 2 : 1;
  std::uint8_t* to = rows.data();
  for (int v = 0; v < height_; ++v)
    for (int u = 0; u < width_; ++u)
      for (int c = 0; c < channels_; ++c, to += step)
        std::memcpy(to, data_ + v * row_stride_ + u * pixel_stride_ + c * channel_stride_, step);
  return {rows.data(), width_, height_, static_cast<std::ptrdiff_t>(row_bytes), format_};
}

}  // namespace adit::python
