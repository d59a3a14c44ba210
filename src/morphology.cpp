#include "adit/morphology.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace adit {

struct MorphologyScratch::Buffers {
  std::vector<std::uint8_t> padded;
};

MorphologyScratch::MorphologyScratch() : buffers_(std::make_unique<Buffers>()) {}
MorphologyScratch::~MorphologyScratch() = default;
MorphologyScratch::MorphologyScratch(MorphologyScratch&&) noexcept = default;
MorphologyScratch& MorphologyScratch::operator=(MorphologyScratch&&) noexcept = default;

void MorphologyScratch::reserve(int width, int height, const StructuringElement& element) {
  const std::size_t need =
      static_cast<std::size_t>(width + element.width()) * static_cast<std::size_t>(height + element.height());
  if (buffers_->padded.size() < need) buffers_->padded.resize(need);
}

namespace {

template <bool kMax>
void apply(ConstPlaneView in, const StructuringElement& element, PlaneView out, std::uint8_t* padded) {
  const int a = element.width() / 2;
  const int b = element.height() / 2;
  const int stride = in.width + 2 * a;
  std::memset(padded, kMax ? 0 : 255, static_cast<std::size_t>(stride) * static_cast<std::size_t>(in.height + 2 * b));
  const auto padded_row = [&](int v) { return padded + static_cast<std::ptrdiff_t>(v + b) * stride + a; };
  for (int v = 0; v < in.height; ++v) std::memcpy(padded_row(v), in.row(v), static_cast<std::size_t>(in.width));
  for (int v = 0; v < in.height; ++v) {
    std::uint8_t* to = out.row(v);
    std::memset(to, kMax ? 0 : 255, static_cast<std::size_t>(in.width));
    for (int dv = -b; dv <= b; ++dv) {
      const int half = element.half_chord(dv + b);
      for (int du = -half; du <= half; ++du) {
        const std::uint8_t* from = padded_row(v + dv) + du;
        for (int u = 0; u < in.width; ++u) to[u] = kMax ? std::max(to[u], from[u]) : std::min(to[u], from[u]);
      }
    }
  }
}

}  // namespace

void erode(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept {
  apply<false>(in, element, out, scratch.buffers().padded.data());
}

void dilate(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept {
  apply<true>(in, element, out, scratch.buffers().padded.data());
}

void close(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept {
  dilate(in, element, out, scratch);
  erode(out, element, out, scratch);
}

}  // namespace adit
