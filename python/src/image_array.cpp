#include "image_array.hpp"

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

}  // namespace

ImageArray::ImageArray(py::array array, const std::string& order) : array_(std::move(array)) {
  const bool is_16 = py::isinstance<py::array_t<std::uint16_t>>(array_);
  if (!is_16 && !py::isinstance<py::array_t<std::uint8_t>>(array_))
    throw py::type_error("frames are arrays of uint8, or grey ones of uint16, not of " +
                         std::string(py::str(static_cast<py::object>(array_.dtype()))));
  if (array_.ndim() != 2 && array_.ndim() != 3)
    throw py::value_error("frames have the shape (height, width) or (height, width, channels), not " +
                          shape_text(array_));
  const py::ssize_t channels = array_.ndim() == 3 ? array_.shape(2) : 1;
  view_.height = side_of(array_.shape(0), array_);
  view_.width = side_of(array_.shape(1), array_);
  view_.format = format_of(order, channels, array_);
  if (is_16 && channels != 1)
    throw py::value_error("an array of uint16 has to be grey, not of shape " + shape_text(array_));
  if (is_16) view_.format = PixelFormat::kGrey16;
  view_.stride_bytes = array_.strides(0);
  view_.pixel_stride_bytes = array_.strides(1);
  if (channels > 1) view_.channel_stride_bytes = array_.strides(2);
  view_.data = static_cast<const std::uint8_t*>(array_.data());
  if (channels == 3 && view_.channel_stride_bytes == -1) {
    // frame[..., ::-1]: the same bytes from the other end, and the fast loops take them.
    view_.data -= 2;
    view_.channel_stride_bytes = 1;
    view_.format = swapped(view_.format);
  }
}

}  // namespace adit::python
