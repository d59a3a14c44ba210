#include "band_pass.hpp"

namespace adit {

Order smallest_order() noexcept { return {kernels::pixel_loops().smallest, 255}; }
Order largest_order() noexcept { return {kernels::pixel_loops().largest, 0}; }

void set_margins(std::uint8_t* row, std::ptrdiff_t begin, std::ptrdiff_t end, std::ptrdiff_t pitch,
                 std::uint8_t value) noexcept {
  constexpr std::ptrdiff_t kBlock = AlignedBytes::kAlignment;
  for (std::ptrdiff_t x = 0; x < begin; x += kBlock) std::memset(row + x, value, kBlock);
  for (std::ptrdiff_t x = end / kBlock * kBlock; x < pitch; x += kBlock) std::memset(row + x, value, kBlock);
}

// Where the core is a pixel, the source goes into the main rows as it is.
BandPass::BandPass(Order order, const BandPlan& plan, int height, std::uint8_t* work) noexcept
    : order_(order), plan_(plan), height_(height), core_is_pixel_(plan.core.empty()) {
  main_ = {work, plan.fold_rows + plan.room};
  source_ = {work + main_.count * plan.pitch, core_is_pixel_ ? 0 : plan.core_rows - 1 + plan.room};
  windows_ = {source_.memory + source_.count * plan.pitch, plan.band};
}

void BandPass::start_strip(int begin) noexcept {
  begin_ = begin;
  width_ = std::min(plan_.strip_columns, plan_.plane_width - begin);
  first_ = std::max(0, begin - plan_.reach_u);
  last_ = std::min(plan_.plane_width, begin + width_ + plan_.reach_u);
  done_ = main_.first = source_.first = 0;
}

// What lies outside the plane is never better. Steps do not touch the source's rows: their ends stay as they are.
void BandPass::clear_source() noexcept {
  if (core_is_pixel_) return;
  std::memset(source_.memory, order_.identity, static_cast<std::size_t>(source_.count * plan_.pitch));
}

// Rows up to `end` of the source will come in.
void BandPass::make_room(int end) noexcept {
  keep(main_, std::max(0, done_ - plan_.fold_rows), core_is_pixel_ ? end : end - (plan_.core_rows - 1));
  if (!core_is_pixel_) keep(source_, done_, end);
}

void BandPass::keep(Rows& rows, int first, int end) noexcept {
  if (end - rows.first <= rows.count) return;
  const int used = &rows == &main_ ? done_ : done_ + plan_.core_rows - 1;
  std::memmove(rows.memory, at(rows, first), static_cast<std::size_t>(std::max(0, used - first) * plan_.pitch));
  rows.first = first;
}

// Returns where the plane's columns go.
std::uint8_t* BandPass::prepare_row(int source_row) noexcept {
  std::uint8_t* to = at(core_is_pixel_ ? main_ : source_, source_row);
  const int before = first_ - (begin_ - plan_.reach_u);
  const int v = source_row - plan_.element_height / 2;
  if (v < 0 || v >= height_) {
    std::memset(to, order_.identity, static_cast<std::size_t>(plan_.pitch));
  } else if (core_is_pixel_) {
    set_margins(to, before, before + last_ - first_, plan_.pitch, order_.identity);
  }
  return to + before;
}

void BandPass::advance(int end, PlaneView out) noexcept {
  for (const BandPlan::Step& step : plan_.core) {
    windows_.first = done_;
    apply(step, done_, end - done_);
  }
  int from = done_;
  done_ = end;
  for (const BandPlan::Step& fold : plan_.folds) {
    from = std::max(0, from - fold.dv_max);
    end = std::max(0, end - fold.dv_max);
    if (&fold == &plan_.folds.back()) break;
    apply(fold, from, end - from);
  }
  give(from, end, out);
}

// In place: rows below are still as the last step left them, and so are columns to the right.
void BandPass::apply(const BandPlan::Step& step, int row, int rows) noexcept {
  if (rows <= 0) return;
  const std::uint8_t* from[kernels::kOperandsMax];
  for (std::size_t i = 0; i < static_cast<std::size_t>(step.count); ++i) {
    const BandPlan::Operand& operand = step.operands[i];
    from[i] = at(operand.from, row + operand.dv) + operand.du;
  }
  order_.loops.best_of_rows(from, step.count, at(step.to, row), plan_.pitch, step.width, rows);
}

// The last fold goes to the plane.
void BandPass::give(int from, int end, PlaneView out) noexcept {
  static constexpr BandPlan::Step kCopy{.operands = {{{0, 0}}}, .count = 1};
  const BandPlan::Step& step = plan_.folds.empty() ? kCopy : plan_.folds.back();
  for (int v = from; v < end; ++v) {
    const std::uint8_t* rows[kernels::kOperandsMax];
    for (std::size_t i = 0; i < static_cast<std::size_t>(step.count); ++i) {
      const BandPlan::Operand& operand = step.operands[i];
      rows[i] = at(main_, v + operand.dv) + operand.du;
    }
    order_.loops.best_of(rows, step.count, out.row(v) + begin_, width_);
  }
}

}  // namespace adit
