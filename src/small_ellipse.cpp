#include <algorithm>

#include "morphology_passes.hpp"

namespace adit {
namespace {

// Room at both ends of a row for the furthest shift, which is less than half the element's width.
std::size_t margin_of(int element_width) { return AlignedBytes::rounded_up(static_cast<std::size_t>(element_width)); }

std::size_t pitch_of(int width, int element_width) {
  return AlignedBytes::rounded_up(static_cast<std::size_t>(width)) + 2 * margin_of(element_width);
}

}  // namespace

void list_rectangles(const StructuringElement& element, std::vector<Reach>& rectangles) {
  rectangles.clear();
  const int middle = element.height() / 2;
  for (int dv = 0; dv <= middle; ++dv) {
    const int half = element.half_chord(middle + dv);
    if (!rectangles.empty() && rectangles.back().u == half) {
      rectangles.back().v = dv;
    } else {
      rectangles.push_back({half, dv});
    }
  }
}

std::size_t EllipseRows::bytes_needed(int width, const StructuringElement& element) noexcept {
  return pitch_of(width, element.width()) * (kRectanglesMax + 2);
}

EllipseRows::EllipseRows(Order order, int width, const std::vector<Reach>& rectangles, std::uint8_t* work) noexcept
    : order_(order), width_(width) {
  const int element_width = 2 * rectangles.front().u + 1;
  const std::size_t pitch = pitch_of(width, element_width);
  std::uint8_t* first = work + margin_of(element_width);
  count_ = static_cast<int>(rectangles.size());
  std::memset(work, order_.identity, pitch * static_cast<std::size_t>(count_ + 2));
  for (int j = 0; j < count_; ++j) {
    reach_[j] = rectangles[static_cast<std::size_t>(j)].v;
    window_[j] = first + static_cast<std::size_t>(j) * pitch;
  }
  for (int i = 0; i < 2; ++i) widened_[i] = first + static_cast<std::size_t>(count_ + i) * pitch;
  for (int j = 0; j < count_; ++j) {
    const int reach_u = rectangles[static_cast<std::size_t>(j)].u;
    const int inner_u = j + 1 < count_ ? rectangles[static_cast<std::size_t>(j) + 1].u : 0;
    add_widening(reach_u - inner_u, j + 1 < count_ ? window_[j + 1] : nullptr);
  }
}

// Widens by reach_u to both sides. A step of three windows of c columns may shift by (c + 1) / 2 at the most: further
// out, at the row's ends, the outer window would lie outside the row while part of it is inside.
void EllipseRows::add_widening(int reach_u, const std::uint8_t* also) noexcept {
  const int window = 2 * reach_u + 1;
  int columns = 1;
  do {
    const int shift = std::min((columns + 1) / 2, (window - columns) / 2);
    columns += 2 * shift;
    steps_[step_count_++] = {shift, columns == window ? also : nullptr};
  } while (columns < window);
}

void EllipseRows::make_row(const std::uint8_t* const* rows, std::uint8_t* out) const noexcept {
  order_.loops.stack(rows, reach_, count_, window_, width_);
  const std::uint8_t* from = window_[0];
  for (int i = 0; i < step_count_; ++i) {
    std::uint8_t* to = i + 1 == step_count_ ? out : widened_[i & 1];
    order_.loops.spread(from, steps_[i].shift, steps_[i].also, to, width_);
    from = to;
  }
}

}  // namespace adit
