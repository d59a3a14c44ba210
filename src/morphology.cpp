#include "adit/morphology.hpp"

#include "rectangle_pass.hpp"

namespace adit {

MorphologyScratch::MorphologyScratch() : buffers_(std::make_unique<Buffers>()) {}
MorphologyScratch::~MorphologyScratch() = default;
MorphologyScratch::MorphologyScratch(MorphologyScratch&&) noexcept = default;
MorphologyScratch& MorphologyScratch::operator=(MorphologyScratch&&) noexcept = default;

const BandPlan& MorphologyScratch::Buffers::plan_for(int width, const StructuringElement& element) const noexcept {
  std::size_t i = 0;
  while (!plans[i].is_for(width, element)) ++i;
  return plans[i];
}

namespace {

std::size_t plane_pitch(int width) { return AlignedBytes::rounded_up(static_cast<std::size_t>(width)); }

PlaneView scratch_plane(ConstPlaneView like, MorphologyScratch::Buffers& buffers) {
  return {buffers.plane.get(), like.width, like.height, static_cast<std::ptrdiff_t>(plane_pitch(like.width))};
}

auto rows_of(ConstPlaneView plane) {
  return [plane](int v, int first, int count, std::uint8_t* to) {
    std::memcpy(to, plane.row(v) + first, static_cast<std::size_t>(count));
  };
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
  const BandPlan& plan = buffers.plan_for(in.width, element);
  if (in.data == out.data && plan.strip_columns < in.width) {  // a strip's neighbours need what it has overwritten
    const PlaneView copy = scratch_plane(in, buffers);
    for (int v = 0; v < in.height; ++v) std::memcpy(copy.row(v), in.row(v), static_cast<std::size_t>(in.width));
    in = copy;
  }
  BandPass(order, plan, in.height, buffers.work.get()).run(rows_of(in), out);
}

// Between its two passes the closing has a plane of its own, which can have the margins that the second one wants.
void close_in_one_strip(ConstPlaneView in, const BandPlan& plan, PlaneView out, MorphologyScratch::Buffers& buffers) {
  const Order erosion = smallest_order();
  const int reach_v = plan.element_height / 2;
  std::uint8_t* margined = buffers.plane.get();
  std::memset(margined, erosion.identity, static_cast<std::size_t>(reach_v * plan.pitch));
  std::memset(margined + (in.height + reach_v) * plan.pitch, erosion.identity,
              static_cast<std::size_t>(reach_v * plan.pitch));
  for (int v = 0; v < in.height; ++v) {
    set_margins(margined + (v + reach_v) * plan.pitch, plan.reach_u, plan.reach_u + in.width, plan.pitch,
                erosion.identity);
  }
  const PlaneView dilated{margined + reach_v * plan.pitch + plan.reach_u, in.width, in.height, plan.pitch};
  BandPass(largest_order(), plan, in.height, buffers.work.get()).run(rows_of(in), dilated);
  BandPass(erosion, plan, in.height, buffers.work.get()).run_over(margined, out);
}

}  // namespace

void MorphologyScratch::reserve(int width, int height, const StructuringElement& element) {
  Buffers& buffers = *buffers_;
  buffers.plane.reserve(plane_pitch(width) * static_cast<std::size_t>(height));
  if (RectanglePass::takes(element)) {
    return buffers.work.reserve(RectanglePass::bytes_needed(width, height, element));
  }
  const auto is_for = [&](const BandPlan& plan) { return plan.is_for(width, element); };
  if (std::none_of(buffers.plans.begin(), buffers.plans.end(), is_for)) buffers.plans.emplace_back(width, element);
  const BandPlan& plan = buffers.plan_for(width, element);
  buffers.work.reserve(plan.bytes_needed());
  // The last row's steps may read beyond its end.
  buffers.plane.reserve(static_cast<std::size_t>(plan.pitch) * static_cast<std::size_t>(height + element.height() + 1));
}

void erode(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept {
  apply(smallest_order(), in, element, out, scratch.buffers());
}

void dilate(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept {
  apply(largest_order(), in, element, out, scratch.buffers());
}

void close(ConstPlaneView in, const StructuringElement& element, PlaneView out, MorphologyScratch& scratch) noexcept {
  MorphologyScratch::Buffers& buffers = scratch.buffers();
  if (!RectanglePass::takes(element)) {
    const BandPlan& plan = buffers.plan_for(in.width, element);
    if (plan.strip_columns >= in.width && !plan.core.empty()) return close_in_one_strip(in, plan, out, buffers);
  }
  const PlaneView dilated = scratch_plane(in, buffers);
  apply(largest_order(), in, element, dilated, buffers);
  apply(smallest_order(), dilated, element, out, buffers);
}

}  // namespace adit
