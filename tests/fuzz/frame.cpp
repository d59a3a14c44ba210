// Frames of any geometry: the finder never reads outside the pixels, never writes them, and keeps its promises.
// Input: width, height (int16), extra stride (int16), format (uint8), flags (uint8), byte offset (uint8), pixels.
#include <cmath>
#include <memory>
#include <vector>

#include "adit/finder.hpp"
#include "byte_source.hpp"

namespace {

using adit::fuzz::require;

/// Frames larger than this only cost the fuzzer time.
constexpr std::ptrdiff_t kFrameMax_bytes = 1 << 18;

struct Geometry {
  int width;
  int height;
  std::ptrdiff_t stride_bytes;
  adit::PixelFormat format;
  bool bottom_up;
  bool lloyd;
  bool adit;
  int offset_bytes;
};

Geometry geometry_of(adit::fuzz::ByteSource& source) {
  Geometry geometry{};
  geometry.width = source.take<std::int16_t>();
  geometry.height = source.take<std::int16_t>();
  const int extra_bytes = source.take<std::int16_t>();
  geometry.format = static_cast<adit::PixelFormat>(source.take<std::uint8_t>());
  const int flags = source.take<std::uint8_t>();
  geometry.bottom_up = (flags & 1) != 0;
  geometry.lloyd = (flags & 2) != 0;
  geometry.adit = (flags & 4) != 0;
  geometry.offset_bytes = source.take<std::uint8_t>() % 64;
  geometry.stride_bytes = std::ptrdiff_t{geometry.width} * adit::bytes_per_pixel(geometry.format) + extra_bytes;
  if (geometry.stride_bytes < 0) {  // rows that go upwards, as with the flag
    geometry.stride_bytes = -geometry.stride_bytes;
    geometry.bottom_up = true;
  }
  return geometry;
}

void check_answer(const adit::OpenSpace& answer, const adit::ImageView& view) {
  require((answer.status == adit::Status::kBadFrame) == !fault_of(view).empty(), "bad_frame if and only if fault_of");
  require(answer.confidence >= 0.0 && answer.confidence <= 1.0, "confidence is in [0, 1]");
  require(answer.opening_count >= 0 && answer.opening_count <= adit::kOpeningCountMax, "opening_count is in range");
  if (!answer.found()) {
    require(answer.confidence == 0.0, "confidence is 0 unless found");
    require(answer.opening_count == 0, "no openings unless found");
    return;
  }
  require(answer.opening_count >= 1, "an opening when found");
  require(answer.centroid_px.u_px >= 0.0 && answer.centroid_px.u_px <= view.width - 1.0, "u_px is in the frame");
  require(answer.centroid_px.v_px >= 0.0 && answer.centroid_px.v_px <= view.height - 1.0, "v_px is in the frame");
  require(std::isfinite(answer.point.sx) && std::isfinite(answer.point.sy), "sx and sy are numbers");
  require(answer.area_fraction > 0.0 && answer.area_fraction <= 1.0, "area_fraction is in (0, 1]");
  require(answer.darkest_level <= answer.threshold_level && answer.threshold_level <= answer.brightest_level,
          "the threshold lies between darkest and brightest level");
}

bool same(const adit::OpenSpace& a, const adit::OpenSpace& b) {
  return a.status == b.status && a.confidence == b.confidence && a.centroid_px.u_px == b.centroid_px.u_px &&
         a.centroid_px.v_px == b.centroid_px.v_px && a.threshold_level == b.threshold_level;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  adit::fuzz::ByteSource source(bytes, size);
  const Geometry geometry = geometry_of(source);
  const std::ptrdiff_t row_bytes = std::ptrdiff_t{geometry.width} * adit::bytes_per_pixel(geometry.format);

  // A heap block of exactly the bytes that the frame may touch: a sanitizer sees every step outside. A geometry that
  // is no frame gets one byte, since nothing of it may be read.
  std::ptrdiff_t frame_bytes = 1;
  const bool plausible =
      geometry.width > 0 && geometry.height > 0 && geometry.stride_bytes >= row_bytes && row_bytes > 0;
  if (plausible) frame_bytes = geometry.stride_bytes * (geometry.height - 1) + row_bytes;
  if (frame_bytes > kFrameMax_bytes) return 0;
  const auto block_bytes = static_cast<std::size_t>(frame_bytes + geometry.offset_bytes);
  const std::unique_ptr<std::uint8_t[]> block(new std::uint8_t[block_bytes]);
  for (std::size_t i = 0; i < block_bytes; ++i) {
    // A short input is repeated, with a drift, so that a few bytes already make a picture.
    block[i] = source.rest_size() == 0 ? static_cast<std::uint8_t>(i / 7)
                                       : static_cast<std::uint8_t>(source.rest()[i % source.rest_size()] + i / 1024);
  }

  adit::ImageView view{block.get() + geometry.offset_bytes, geometry.width, geometry.height, geometry.stride_bytes,
                       geometry.format};
  if (plausible && geometry.bottom_up) {
    view.data += geometry.stride_bytes * (geometry.height - 1);
    view.stride_bytes = -view.stride_bytes;
  }

  adit::FinderConfig config = adit::paper_preset();
  if (geometry.lloyd) config.clustering = adit::Clustering::kLloyd;
  if (geometry.adit) config.method = adit::Method::kAdit;
  const std::vector<std::uint8_t> before(block.get(), block.get() + block_bytes);
  adit::OpenSpaceFinder finder(config);
  const adit::OpenSpace first = finder.find(view);
  check_answer(first, view);
  require(same(first, finder.find(view)), "the same frame has the same answer");
  if (fault_of(view).empty()) {
    adit::StageImages images;
    require(same(first, finder.explain(view, images)), "explain answers as find");
    const auto pixel_count = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
    require(images.dark_channel.size() == pixel_count, "a stage image has the frame's size");
  }
  require(std::equal(before.begin(), before.end(), block.get()), "pixels are never written");
  return 0;
}
