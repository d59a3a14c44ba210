#include "band_pass.hpp"

#include <cstring>

namespace adit {

Order smallest_order() noexcept { return {kernels::pixel_loops().smallest, 255}; }
Order largest_order() noexcept { return {kernels::pixel_loops().largest, 0}; }

BandPass::BandPass(Order order, const BandPlan& plan, int height, std::uint8_t* work) noexcept
    : order_(order), plan_(plan), height_(height) {
  own_source_.memory = {work, plan.pitch};
  windows_.memory = {work + (plan.core_rows - 1 + plan.band) * plan.pitch, plan.pitch};
  main_work_ = windows_.memory.first + plan.band * plan.pitch;
  main_.memory = {main_work_, plan.pitch};
}

// What lies outside the plane is never better. Steps do not touch the source's rows: their ends stay as they are.
void BandPass::start_strip(int begin, int columns) noexcept {
  begin_ = begin;
  width_ = columns;
  first_ = std::max(0, begin - plan_.reach_u);
  last_ = std::min(plan_.plane_width, begin + columns + plan_.reach_u);
  taken_ = done_ = given_ = main_.first = own_source_.first = 0;
  is_placed_ = false;
  const int rows = plan_.core_rows - 1 + plan_.band;
  std::memset(own_source_.memory.first, order_.identity, static_cast<std::size_t>(rows * plan_.pitch));
}

void BandPass::run_over(kernels::ConstRows source, PlaneView out) noexcept {
  begin_ = 0;
  width_ = plan_.plane_width;
  done_ = given_ = main_.first = 0;
  is_placed_ = false;
  source_ = source;
  source_is_own_ = false;
  source_first_ = 0;
  out_ = {out.data, out.stride_bytes};
  out_first_ = 0;
  for (int end = 0; end < height_ + plan_.fold_rows;) {
    end = std::min(end + plan_.band, height_ + plan_.fold_rows);
    make_room_in_main(end);
    advance(end);
  }
}

// Rows up to `end` of the source will come in; those outside the plane are made here.
void BandPass::make_room(int end) noexcept {
  const auto pitch = static_cast<std::size_t>(plan_.pitch);
  std::memmove(own_source_.memory.first, own_source_.at(done_), static_cast<std::size_t>(taken_ - done_) * pitch);
  own_source_.first = done_;
  source_ = {own_source_.memory.first, plan_.pitch};
  source_is_own_ = true;
  source_first_ = done_;
  const int above = plan_.element_height / 2;
  for (int row = taken_; row < end; ++row) {
    if (row < above || row >= height_ + above) std::memset(own_source_.at(row), order_.identity, pitch);
  }
  make_room_in_main(end - (plan_.core_rows - 1));
}

void BandPass::make_room_in_main(int end) noexcept {
  if (is_placed_ && end - main_.first <= plan_.fold_rows + plan_.room) return;
  is_placed_ = true;
  const int first = std::max(0, done_ - plan_.fold_rows);
  // Loads wait for stores whose addresses have the same low bits: the source's next row stands a little ahead of the
  // row that is made of it.
  const auto source = reinterpret_cast<std::uintptr_t>(source_.first + (done_ - source_first_) * source_.pitch);
  const auto unshifted = reinterpret_cast<std::uintptr_t>(main_work_ + (done_ - first) * plan_.pitch);
  const std::uintptr_t shift = (source - BandPlan::kLead - unshifted) % BandPlan::kAliasPeriod;
  std::uint8_t* to = main_work_ + shift / AlignedBytes::kAlignment * AlignedBytes::kAlignment;
  std::memmove(to, main_.at(first), static_cast<std::size_t>((done_ - first) * plan_.pitch));
  main_.memory.first = to;
  main_.first = first;
}

// Where the plane's columns go in a row of the source.
kernels::Rows BandPass::inside(int source_row) const noexcept {
  return {own_source_.at(source_row) + first_ - (begin_ - plan_.reach_u), plan_.pitch};
}

kernels::ConstRows BandPass::at(BandPlan::Operand operand, int row) const noexcept {
  row += operand.dv;
  if (operand.from == BandPlan::From::kSource) {
    return {source_.first + (row - source_first_) * source_.pitch + operand.du, source_.pitch};
  }
  return {(operand.from == BandPlan::From::kMain ? main_ : windows_).at(row) + operand.du, plan_.pitch};
}

// In place: rows below are still as the last step left them, and so are columns to the right.
void BandPass::apply(const BandPlan::Step& step, int row, kernels::Rows to, int width, int rows) noexcept {
  if (looks_ahead_) {
    source_ahead_.next();
    out_ahead_.next();
  }
  if (rows <= 0) return;
  if (step.window > 0) return order_.loops.best_of_window(at(step.operands[0], row), step.window, to, width, rows);
  if (step.is_lozenge) {
    const BandPlan::Operand upper = step.operands[0], side = step.operands[1];
    return order_.loops.best_of_lozenge(at({0, 0}, row), upper.du, side.dv, to, width, rows);
  }
  kernels::ConstRows from[kernels::kOperandsMax];
  for (std::size_t i = 0; i < static_cast<std::size_t>(step.count); ++i) from[i] = at(step.operands[i], row);
  const bool is_far = step.operands[0].from == BandPlan::From::kSource && !source_is_own_;
  (is_far ? order_.loops.best_of_far_rows : order_.loops.best_of_rows)(from, step.count, to, width, rows);
}

// Rows of the source that the next band takes, and of the result that this one writes once its steps are done.
void BandPass::look_ahead(int end) noexcept {
  const int turns = static_cast<int>(plan_.core.size() + plan_.folds.size());
  if (far_source_.data != nullptr) {
    const int v = std::clamp(taken_ - plan_.element_height / 2, 0, height_);
    const int rows = std::min(plan_.band, height_ - v);
    source_ahead_ = {far_source_.data + v * far_source_.stride_bytes + first_, far_source_.stride_bytes, last_ - first_,
                     rows, turns};
  }
  if (is_out_far_) {
    const int rows = std::max(0, end - plan_.fold_rows) - given_;
    out_ahead_ = {out_.first + (given_ - out_first_) * out_.pitch, out_.pitch, width_, rows, turns};
  }
}

// Main rows up to `end` have their source. The last fold goes to the plane.
void BandPass::advance(int end) noexcept {
  static constexpr BandPlan::Step kCopy{.operands = {{{0, 0}}}, .count = 1};
  windows_.first = done_;
  if (looks_ahead_) look_ahead(end);
  for (const BandPlan::Step& step : plan_.core) {
    const Moving& to = step.to == BandPlan::From::kMain ? main_ : windows_;
    apply(step, done_, {to.at(done_), plan_.pitch}, step.width, end - done_);
  }
  int from = done_;
  done_ = end;
  for (const BandPlan::Step& fold : plan_.folds) {
    from = std::max(0, from - fold.dv_max);
    end = std::max(0, end - fold.dv_max);
    if (&fold != &plan_.folds.back()) apply(fold, from, {main_.at(from), plan_.pitch}, fold.width, end - from);
  }
  const kernels::Rows to = {out_.first + (from - out_first_) * out_.pitch, out_.pitch};
  apply(plan_.folds.empty() ? kCopy : plan_.folds.back(), from, to, width_, end - from);
  given_ = end;
}

}  // namespace adit
