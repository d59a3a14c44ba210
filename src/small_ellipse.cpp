#include <algorithm>

#include "morphology_passes.hpp"

namespace adit {
namespace {

// A buffer holds the rows of a batch, which are widened as one. Between two rows there is room for what both reach out
// to, so that they never meet; before the first row, for where its widened row begins and for what that is made of.
struct RowLayout {
  std::size_t pitch;   ///< from row to row
  std::size_t lead;    ///< columns that are widened before the first row's first column
  std::size_t front;   ///< from the buffer's begin to the first row's first column
  std::size_t buffer;  ///< size

  RowLayout(int width, int element_width) noexcept {
    const auto reach = static_cast<std::size_t>(element_width / 2);
    pitch = AlignedBytes::rounded_up(static_cast<std::size_t>(width)) + AlignedBytes::rounded_up(2 * reach + 1);
    lead = AlignedBytes::rounded_up(reach);
    front = 2 * lead;
    buffer = front + EllipseRows::kBatch * pitch + lead;
  }
};

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
  return RowLayout(width, element.width()).buffer * (kRectanglesMax + 2);
}

EllipseRows::EllipseRows(Order order, int width, const std::vector<Reach>& rectangles, std::uint8_t* work) noexcept
    : order_(order), width_(width) {
  const int element_width = 2 * rectangles.front().u + 1;
  const RowLayout layout(width, element_width);
  pitch_ = layout.pitch;
  lead_ = layout.lead;
  const std::size_t buffer = layout.buffer;
  std::uint8_t* first = work + layout.front;
  count_ = static_cast<int>(rectangles.size());
  std::memset(work, order_.identity, buffer * static_cast<std::size_t>(count_ + 2));
  for (int j = 0; j < count_; ++j) {
    reach_[j] = rectangles[static_cast<std::size_t>(j)].v;
    window_[j] = first + static_cast<std::size_t>(j) * buffer;
  }
  for (int i = 0; i < 2; ++i) widened_[i] = first + static_cast<std::size_t>(count_ + i) * buffer;
  for (int j = 0; j < count_; ++j) {
    const int reach_u = rectangles[static_cast<std::size_t>(j)].u;
    const int inner_u = j + 1 < count_ ? rectangles[static_cast<std::size_t>(j) + 1].u : 0;
    add_widening(reach_u - inner_u, j + 1 < count_ ? window_[j + 1] : nullptr);
  }
}

// Widens by reach_u to both sides: three windows of c columns side by side make one of up to 3 c.
void EllipseRows::add_widening(int reach_u, const std::uint8_t* also) noexcept {
  const int window = 2 * reach_u + 1;
  int columns = 1;
  do {
    const int shift = std::min(columns, (window - columns) / 2);
    columns += 2 * shift;
    steps_[step_count_++] = {shift, columns == window ? also : nullptr};
  } while (columns < window);
}

void EllipseRows::stack(int slot, const std::uint8_t* const* rows) const noexcept {
  std::uint8_t* upper[kRectanglesMax];
  std::uint8_t* lower[kRectanglesMax];
  for (int j = 0; j < count_; ++j) {
    upper[j] = window_[j] + static_cast<std::size_t>(slot) * pitch_;
    lower[j] = upper[j] + pitch_;
  }
  order_.loops.stack(rows, reach_, count_, upper, lower, width_);
}

void EllipseRows::widen(std::uint8_t* const* out, int count) const noexcept {
  const std::uint8_t* from = window_[0];
  const int last = step_count_ - 1;
  for (int i = 0; i < last; ++i) {
    const std::uint8_t* also = steps_[i].also == nullptr ? nullptr : steps_[i].also - lead_;
    order_.loops.spread(from - lead_, steps_[i].shift, also, widened_[i & 1] - lead_,
                        static_cast<int>(lead_ + pitch_ * static_cast<std::size_t>(count)));
    from = widened_[i & 1];
  }
  for (int slot = 0; slot < count; ++slot) {
    const std::size_t offset = static_cast<std::size_t>(slot) * pitch_;
    const std::uint8_t* also = steps_[last].also == nullptr ? nullptr : steps_[last].also + offset;
    order_.loops.spread(from + offset, steps_[last].shift, also, out[slot], width_);
  }
}

}  // namespace adit
