#include "adit/morphology.hpp"

#include "rectangle_pass.hpp"

namespace adit {

MorphologyScratch::MorphologyScratch() : buffers_(std::make_unique<Buffers>()) {}
MorphologyScratch::~MorphologyScratch() = default;
MorphologyScratch::MorphologyScratch(MorphologyScratch&&) noexcept = default;
MorphologyScratch& MorphologyScratch::operator=(MorphologyScratch&&) noexcept = default;

const MorphologyScratch::Buffers::Plans& MorphologyScratch::Buffers::plans_for(
    int width, const StructuringElement& element) const noexcept {
  std::size_t i = 0;
  while (!plans[i].alone.is_for(width, element)) ++i;
  return plans[i];
}

namespace {

std::size_t plane_pitch(int width) { return AlignedBytes::rounded_up(static_cast<std::size_t>(width)); }

PlaneView scratch_plane(ConstPlaneView like, MorphologyScratch::Buffers& buffers) {
  return {buffers.plane.get(), like.width, like.height, static_cast<std::ptrdiff_t>(plane_pitch(like.width))};
}

auto rows_of(ConstPlaneView plane) {
  return [plane](int v, int rows, int first, int count, kernels::Rows to) {
    const kernels::ConstRows from = {plane.row(v) + first, plane.stride_bytes};
    kernels::pixel_loops().smallest.best_of_rows(&from, 1, to, count, rows);
  };
}

// A strip's neighbours need what it has overwritten.
ConstPlaneView copy_of(ConstPlaneView in, MorphologyScratch::Buffers& buffers) {
  const PlaneView copy = scratch_plane(in, buffers);
  rows_of(in)(0, in.height, 0, in.width, {copy.data, copy.stride_bytes});
  return copy;
}

void apply(Order order, ConstPlaneView in, const StructuringElement& element, PlaneView out,
           MorphologyScratch::Buffers& buffers) {
  if (RectanglePass::takes(element)) {
    RectanglePass pass(order, in.width, in.height, element, buffers.work.get());
    for (int v = 0; v < in.height; ++v) {
      std::memcpy(pass.next_row(), in.row(v), static_cast<std::size_t>(in.width));
      pass.advance(out);
    }
    return pass.finish(out);
  }
  const BandPlan& plan = buffers.plans_for(in.width, element).alone;
  if (in.data == out.data && plan.strip_columns < in.width) in = copy_of(in, buffers);
  BandPass(order, plan, in.height, buffers.work.get()).run(rows_of(in), out);
}

// What lies between dilation and erosion is needed for a few rows of a strip alone.
void close_in_strips(ConstPlaneView in, const MorphologyScratch::Buffers::Plans& plans, PlaneView out,
                     MorphologyScratch::Buffers& buffers) {
  if (in.data == out.data) in = copy_of(in, buffers);
  BandPass dilation(largest_order(), *plans.before, in.height, buffers.before_work.get());
  BandPass erosion(smallest_order(), plans.alone, in.height, buffers.work.get());
  dilation.read_ahead(in);
  erosion.write_ahead();
  const auto dilated = [&](int v, int rows, int, int, kernels::Rows to) { dilation.bring(rows_of(in), v + rows, to); };
  for (int begin = 0; begin < in.width; begin += plans.alone.strip_columns) {
    erosion.start_strip(begin, std::min(plans.alone.strip_columns, in.width - begin));
    dilation.start_strip(erosion.source_begin(), erosion.source_columns());
    erosion.bring(dilated, in.height, {out.row(0) + begin, out.stride_bytes});
  }
}

}  // namespace

void MorphologyScratch::reserve(int width, int height, const StructuringElement& element) {
  Buffers& buffers = *buffers_;
  buffers.plane.reserve(plane_pitch(width) * static_cast<std::size_t>(height));
  if (RectanglePass::takes(element)) {
    return buffers.work.reserve(RectanglePass::bytes_needed(width, height, element));
  }
  const auto is_for = [&](const Buffers::Plans& plans) { return plans.alone.is_for(width, element); };
  if (std::none_of(buffers.plans.begin(), buffers.plans.end(), is_for)) {
    Buffers::Plans& plans = buffers.plans.emplace_back(Buffers::Plans{BandPlan(width, element), {}});
    const int strip = plans.alone.strip_columns;
    if (strip < width) plans.before.emplace(width, element, std::min(width, strip + 2 * plans.alone.reach_u));
  }
  const Buffers::Plans& plans = buffers.plans_for(width, element);
  buffers.work.reserve(plans.alone.bytes_needed());
  if (plans.before) return buffers.before_work.reserve(plans.before->bytes_needed());
  buffers.margined.reserve(width, height, plans.alone.reach_u, element.height() / 2);
}

void erode(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept {
  apply(smallest_order(), in, element, out, scratch.buffers());
}

void dilate(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept {
  apply(largest_order(), in, element, out, scratch.buffers());
}

bool closes_in_strips(int width, const StructuringElement& element, MorphologyScratch& scratch) noexcept {
  return scratch.buffers().plans_for(width, element).before.has_value();
}

PlaneView close_margined(MarginedPlane& in, const StructuringElement& element, MarginedPlane& out,
                         MorphologyScratch& scratch) noexcept {
  MorphologyScratch::Buffers& buffers = scratch.buffers();
  const PlaneView pixels = in.pixels();
  const auto& plans = buffers.plans_for(pixels.width, element);
  if (plans.before) {
    close_in_strips(pixels, plans, out.pixels(), buffers);
    return out.pixels();
  }
  for (const Order order : {largest_order(), smallest_order()}) {
    BandPass pass(order, plans.alone, pixels.height, buffers.work.get());
    in.set_margins(order.identity);
    // Over the plane itself, as long as no row is written before it was read.
    if (plans.alone.fold_rows >= plans.alone.core_rows - 1) {
      pass.run_over(in.with_margins(plans.alone.reach_u, element.height() / 2), pixels);
    } else {
      pass.run(rows_of(pixels), pixels);
    }
  }
  return pixels;
}

void close(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept {
  MorphologyScratch::Buffers& buffers = scratch.buffers();
  if (RectanglePass::takes(element)) {
    const PlaneView dilated = scratch_plane(in, buffers);
    apply(largest_order(), in, element, dilated, buffers);
    return apply(smallest_order(), dilated, element, out, buffers);
  }
  if (const auto& plans = buffers.plans_for(in.width, element); plans.before) {
    return close_in_strips(in, plans, out, buffers);
  }
  // Another size or element may have been there since.
  const int reach_u = buffers.plans_for(in.width, element).alone.reach_u;
  buffers.margined.reserve(in.width, in.height, reach_u, element.height() / 2);
  const PlaneView margined = buffers.margined.pixels();
  rows_of(in)(0, in.height, 0, in.width, {margined.data, margined.stride_bytes});
  const PlaneView closed = close_margined(buffers.margined, element, buffers.margined, scratch);
  rows_of(closed)(0, in.height, 0, in.width, {out.data, out.stride_bytes});
}

}  // namespace adit
