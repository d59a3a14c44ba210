// Messages of a robot's middleware, of any fields: a view that stays within the pixels and a camera that can be built,
// or one line that says why not. Input: the numbers of an image (encoding by number) and of a camera_info, then pixels.
#include <algorithm>
#include <memory>
#include <string>
#include <string_view>

#include "adit/node/camera_info.hpp"
#include "adit/node/image_message.hpp"
#include "byte_source.hpp"

namespace {

using adit::fuzz::ByteSource;
using adit::fuzz::require;

constexpr std::string_view kEncodings[] = {"mono8", "8UC1",   "bgr8",  "8UC3",  "rgb8",        "bgra8", "8UC4",
                                           "rgba8", "mono16", "16UC1", "32FC1", "bayer_rggb8", "",      "mono8\n"};
constexpr std::string_view kModels[] = {"plumb_bob", "rational_polynomial", "equidistant", "", "fisheye\n"};

template <std::size_t kCount>
std::string_view one_of(const std::string_view (&names)[kCount], ByteSource& source) {
  return names[source.take<std::uint8_t>() % kCount];
}

/// Small numbers are the likely ones; the large ones have to be survived.
std::uint32_t size_of(ByteSource& source) {
  const auto number = source.take<std::uint32_t>();
  return (number & 1U) != 0U ? number : (number >> 1U) % 512U;
}

void check_fault(const std::string& fault) {
  require(!fault.empty(), "a reason where there is no reading");
  adit::fuzz::require_message(fault, "");
}

void try_camera_info(ByteSource& source) {
  adit::node::CameraInfoMessage m;
  m.width = size_of(source);
  m.height = size_of(source);
  m.distortion_model = one_of(kModels, source);
  m.distortion.resize(source.take<std::uint8_t>() % 16);
  for (double& figure : m.distortion) figure = source.take<float>();
  for (double& figure : m.matrix) figure = source.take<float>();
  for (std::uint32_t* field :
       {&m.binning_x, &m.binning_y, &m.roi_x_offset, &m.roi_y_offset, &m.roi_width, &m.roi_height})
    *field = size_of(source);
  const adit::node::CameraReading reading = adit::node::camera_of(m);
  if (reading.model) {
    require(!fault_of(*reading.model), "an accepted calibration is a camera");
    const adit::Camera camera(*reading.model);
    (void)camera.normalised_of({0.0, 0.0});
  } else if (!reading.fault.empty()) {
    check_fault(reading.fault);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  ByteSource source(bytes, size);
  adit::node::ImageMessage m;
  m.width = size_of(source);
  m.height = size_of(source);
  m.step = size_of(source);
  m.encoding = one_of(kEncodings, source);
  m.is_bigendian = (source.take<std::uint8_t>() & 1U) != 0U;
  const bool has_all = (source.take<std::uint8_t>() & 1U) != 0U;
  try_camera_info(source);
  // Of the exact size and on the heap, so that a sanitizer sees a read past the end.
  constexpr std::size_t kMost_bytes = 1 << 20;
  m.size = has_all ? std::min(std::size_t{m.step} * m.height, kMost_bytes) : source.rest_size();
  const std::unique_ptr<std::uint8_t[]> pixels(new std::uint8_t[m.size + 1]);
  m.data = pixels.get();
  const adit::node::ImageReading reading = adit::node::view_of(m);
  if (reading.view.data == nullptr) {
    check_fault(reading.fault);
    return 0;
  }
  const adit::ImageView& view = reading.view;
  require(fault_of(view).empty(), "a view that can be judged");
  const auto row = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(bytes_per_pixel(view.format));
  const auto last = static_cast<std::size_t>(view.stride_bytes) * static_cast<std::size_t>(view.height - 1);
  require(view.data == m.data && last + row <= m.size, "a view within the pixels");
  return 0;
}
