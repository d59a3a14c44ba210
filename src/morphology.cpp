#include "adit/morphology.hpp"

#include <algorithm>
#include <bit>

#include "morphology_passes.hpp"

namespace adit {

MorphologyScratch::MorphologyScratch() : buffers_(std::make_unique<Buffers>()) {}
MorphologyScratch::~MorphologyScratch() = default;
MorphologyScratch::MorphologyScratch(MorphologyScratch&&) noexcept = default;
MorphologyScratch& MorphologyScratch::operator=(MorphologyScratch&&) noexcept = default;

namespace {

bool is_small(const StructuringElement& element) { return element.height() <= EllipseRows::kHeightMax_px; }

std::size_t plane_pitch(int width) { return AlignedBytes::rounded_up(static_cast<std::size_t>(width)); }

// Dilated rows that are kept: those under the element for a batch of rows, and what a batch may run ahead. A power of
// two: rows are looked up so often that a division would be felt.
int ring_rows(const StructuringElement& element) {
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(element.height() + 2 * EllipseRows::kBatch)));
}

PlaneView scratch_plane(ConstPlaneView like, MorphologyScratch::Buffers& buffers) {
  return {buffers.plane.get(), like.width, like.height, static_cast<std::ptrdiff_t>(plane_pitch(like.width))};
}

void apply_rectangle(Order order, ConstPlaneView in, const StructuringElement& element, PlaneView out,
                     MorphologyScratch::Buffers& buffers) {
  RectanglePass pass(order, in.width, in.height, element, buffers.work.get());
  for (int v = 0; v < in.height; ++v) {
    std::memcpy(pass.next_row(), in.row(v), static_cast<std::size_t>(in.width));
    pass.advance(out);
  }
  pass.finish(out);
}

/// The rows under the elements at v and v + 1, in the order that EllipseRows wants them.
class RowsAround {
 public:
  template <class RowOf>
  const std::uint8_t* const* at(int v, int height, int reach_v, RowOf row_of) noexcept {
    rows_[0] = row_of(v);
    rows_[1] = v + 1 < height ? row_of(v + 1) : rows_[0];
    for (int dv = 1; dv <= reach_v; ++dv) {
      rows_[2 * dv] = v - dv >= 0 ? row_of(v - dv) : rows_[0];
      rows_[2 * dv + 1] = v + 1 + dv < height ? row_of(v + 1 + dv) : rows_[1];
    }
    return rows_;
  }

 private:
  const std::uint8_t* rows_[EllipseRows::kHeightMax_px + 1];
};

/// Makes the rows from `begin` to `end`, at most a batch.
template <class RowOf, class OutRow>
void make_rows(const EllipseRows& ellipse, int begin, int end, int height, RowOf row_of, OutRow out_row) {
  RowsAround around;
  std::uint8_t* out[EllipseRows::kBatch];
  for (int v = begin; v < end; v += 2) ellipse.stack(v - begin, around.at(v, height, ellipse.reach_v(), row_of));
  for (int v = begin; v < end; ++v) out[v - begin] = out_row(v);
  ellipse.widen(out, end - begin);
}

void apply_small(Order order, ConstPlaneView in, PlaneView out, MorphologyScratch::Buffers& buffers) {
  const EllipseRows ellipse(order, in.width, buffers.rectangles, buffers.work.get());
  const auto in_row = [&](int v) { return in.row(v); };
  const auto out_row = [&](int v) { return out.row(v); };
  for (int v = 0; v < in.height; v += EllipseRows::kBatch) {
    make_rows(ellipse, v, std::min(v + EllipseRows::kBatch, in.height), in.height, in_row, out_row);
  }
}

// Dilation and erosion in one go down the plane: between them only the rows under one element are kept, so they never
// leave the cache. A row is written when no later one needs it: `out` may be `in`.
void close_small(ConstPlaneView in, const StructuringElement& element, PlaneView out,
                 MorphologyScratch::Buffers& buffers) {
  std::uint8_t* second = buffers.work.get() + EllipseRows::bytes_needed(in.width, element);
  const EllipseRows dilation(largest_order(), in.width, buffers.rectangles, buffers.work.get());
  const EllipseRows erosion(smallest_order(), in.width, buffers.rectangles, second);
  const auto in_row = [&](int v) { return in.row(v); };
  const auto out_row = [&](int v) { return out.row(v); };
  const int mask = ring_rows(element) - 1;
  const std::size_t pitch = plane_pitch(in.width);
  const auto dilated_row = [&](int v) { return buffers.plane.get() + static_cast<std::size_t>(v & mask) * pitch; };
  int dilated = 0;
  for (int v = 0; v < in.height; v += EllipseRows::kBatch) {
    const int end = std::min(v + EllipseRows::kBatch, in.height);
    while (dilated < std::min(end + dilation.reach_v(), in.height)) {
      const int batch_end = std::min(dilated + EllipseRows::kBatch, in.height);
      make_rows(dilation, dilated, batch_end, in.height, in_row, dilated_row);
      dilated = batch_end;
    }
    make_rows(erosion, v, end, in.height, dilated_row, out_row);
  }
}

void apply(Order order, ConstPlaneView in, const StructuringElement& element, PlaneView out,
           MorphologyScratch::Buffers& buffers) {
  if (element.is_rectangle()) return apply_rectangle(order, in, element, out, buffers);
  if (in.data == out.data) {
    const PlaneView copy = scratch_plane(in, buffers);
    for (int v = 0; v < in.height; ++v) std::memcpy(copy.row(v), in.row(v), static_cast<std::size_t>(in.width));
    in = copy;
  }
  list_rectangles(element, buffers.rectangles);
  if (is_small(element)) return apply_small(order, in, out, buffers);
  LargeEllipse(order, in.width, in.height, element, buffers.work.get()).apply(in, out);
}

}  // namespace

void MorphologyScratch::reserve(int width, int height, const StructuringElement& element) {
  Buffers& buffers = *buffers_;
  buffers.rectangles.reserve(static_cast<std::size_t>(element.height() / 2 + 1));
  if (element.is_rectangle()) {
    buffers.work.reserve(RectanglePass::bytes_needed(width, height, element));
    return;
  }
  buffers.work.reserve(is_small(element) ? 2 * EllipseRows::bytes_needed(width, element)
                                         : LargeEllipse::bytes_needed(width, height, element));
  buffers.plane.reserve(plane_pitch(width) * static_cast<std::size_t>(std::max(height, ring_rows(element))));
}

void erode(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept {
  apply(smallest_order(), in, element, out, scratch.buffers());
}

void dilate(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept {
  apply(largest_order(), in, element, out, scratch.buffers());
}

void close(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept {
  MorphologyScratch::Buffers& buffers = scratch.buffers();
  if (element.is_rectangle()) {
    apply_rectangle(largest_order(), in, element, out, buffers);
    apply_rectangle(smallest_order(), out, element, out, buffers);
    return;
  }
  if (is_small(element)) {
    list_rectangles(element, buffers.rectangles);
    close_small(in, element, out, buffers);
    return;
  }
  const PlaneView dilated = scratch_plane(in, buffers);
  LargeEllipse(largest_order(), in.width, in.height, element, buffers.work.get()).apply(in, dilated);
  LargeEllipse(smallest_order(), in.width, in.height, element, buffers.work.get()).apply(dilated, out);
}

}  // namespace adit
