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

std::size_t plane_pitch(int width) { return AlignedBytes::rounded_up(static_cast<std::size_t>(width)); }

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

void apply_small(Order order, ConstPlaneView in, const StructuringElement& element, PlaneView out,
                 MorphologyScratch::Buffers& buffers) {
  const int ring = SweepPass::ring_rows(in.width, element);
  RowTails tails_in(buffers.tails[0], ring, in.width);
  RowTails tails_out(buffers.tails[1], ring, in.width);
  tails_in.fill(order.identity);
  SweepPass& pass = buffers.passes[0];
  pass.start(order, in.width, in.height, element, rows_of(in, buffers.tails[0], ring),
             rows_of(out, buffers.tails[1], ring));
  for (int v = 0; v < in.height; v += 2) {
    tails_in.take(in, v + 2 + element.height() / 2);
    pass.take(v);
    tails_out.give(out, pass.rows_done());
  }
  pass.finish();
  tails_out.give(out, in.height);
}

// Dilation and erosion in one go down the plane: between them only the rows under one element are kept, so they never
// leave the cache. A row is written when no later one needs it: `out` may be `in`.
void close_small(ConstPlaneView in, const StructuringElement& element, PlaneView out,
                 MorphologyScratch::Buffers& buffers) {
  const int ring = SweepPass::ring_rows(in.width, element);
  const int reach = element.height() / 2;
  const int tail = in.width % kernels::pixel_loops().lanes;
  const auto pitch = static_cast<std::ptrdiff_t>(plane_pitch(in.width));
  const Order erosion_order = smallest_order();
  std::uint8_t* dilated = buffers.plane.get();
  const Rows<std::uint8_t> between{dilated, pitch, ring - 1, dilated + in.width - tail, pitch, ring - 1};

  RowTails tails_in(buffers.tails[0], ring, in.width);
  RowTails tails_out(buffers.tails[1], ring, in.width);
  tails_in.fill(largest_order().identity);
  SweepPass& dilation = buffers.passes[0];
  SweepPass& erosion = buffers.passes[1];
  dilation.start(largest_order(), in.width, in.height, element, rows_of(in, buffers.tails[0], ring), between);
  erosion.start(erosion_order, in.width, in.height, element,
                {between.first, pitch, ring - 1, between.tails, pitch, ring - 1}, rows_of(out, buffers.tails[1], ring));
  int taken = 0;
  int dilated_rows = 0;
  for (int v = 0; v < in.height;) {
    for (int i = 0; i < SweepPass::kBatch && taken < in.height; ++i, taken += 2) {
      tails_in.take(in, taken + 2 + reach);
      dilation.take(taken);
    }
    if (taken < in.height) {
      dilation.run();
    } else {
      dilation.finish();
    }
    for (; tail > 0 && dilated_rows < dilation.rows_done(); ++dilated_rows) {
      std::memset(between.tail(dilated_rows) + tail, erosion_order.identity,
                  static_cast<std::size_t>(kernels::pixel_loops().lanes - tail));
    }
    for (; v < in.height && std::min(v + 2 + reach, in.height) <= dilation.rows_done(); v += 2) erosion.take(v);
    erosion.run();
    tails_out.give(out, erosion.rows_done());
  }
  erosion.finish();
  tails_out.give(out, in.height);
}

void apply(Order order, ConstPlaneView in, const StructuringElement& element, PlaneView out,
           MorphologyScratch::Buffers& buffers) {
  if (element.is_rectangle()) return apply_rectangle(order, in, element, out, buffers);
  if (in.data == out.data) {
    const PlaneView copy = scratch_plane(in, buffers);
    for (int v = 0; v < in.height; ++v) std::memcpy(copy.row(v), in.row(v), static_cast<std::size_t>(in.width));
    in = copy;
  }
  if (SweepPass::takes(order, element)) return apply_small(order, in, element, out, buffers);
  LargeEllipse(order, in.height, element, buffers.work.get()).apply(in, out);
}

}  // namespace

// For whichever target will be in use: not all of them sweep.
void MorphologyScratch::reserve(int width, int height, const StructuringElement& element) {
  Buffers& buffers = *buffers_;
  std::size_t rows = static_cast<std::size_t>(height);
  if (SweepPass::fits(element)) {
    const auto ring = static_cast<std::size_t>(SweepPass::ring_rows(width, element));
    for (SweepPass& pass : buffers.passes) pass.reserve(width, element);
    for (AlignedBytes& tails : buffers.tails) tails.reserve(ring * AlignedBytes::kAlignment);
    rows = std::max(rows, ring);
  }
  buffers.work.reserve(element.is_rectangle() ? RectanglePass::bytes_needed(width, height, element)
                                              : LargeEllipse::bytes_needed(height, element));
  buffers.plane.reserve(plane_pitch(width) * rows);
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
  if (SweepPass::takes(smallest_order(), element)) return close_small(in, element, out, buffers);
  const PlaneView dilated = scratch_plane(in, buffers);
  LargeEllipse(largest_order(), in.height, element, buffers.work.get()).apply(in, dilated);
  LargeEllipse(smallest_order(), in.height, element, buffers.work.get()).apply(dilated, out);
}

}  // namespace adit
