#include <algorithm>
#include <bit>

#include "morphology_passes.hpp"

namespace adit {
namespace {

using kernels::kCellColumns;

/// Columns of a strip: with its margins, the tables of an element of 101 rows stay in a level-2 cache.
constexpr int kStripColumns = 512;
/// Columns for which the rows that matter are listed together.
constexpr int kBlockColumns = 128;
constexpr int kBlocksMax = kStripColumns / kBlockColumns;

int margin_of(int element_width) {
  return static_cast<int>(AlignedBytes::rounded_up(static_cast<std::size_t>(element_width / 2 + 1)));
}

/// A power of two: rows are looked up so often that a division would be felt.
int ring_of(const StructuringElement& element) {
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(element.height())));
}

int levels_of(int element_width) { return std::bit_width(static_cast<unsigned>(element_width)); }

}  // namespace

/// Where each buffer begins in the work memory.
struct LargeEllipse::Layout {
  std::size_t pitch;
  std::size_t words;
  std::size_t chords;
  std::size_t marks;
  std::size_t cells;
  std::size_t pointers;
  std::size_t slots;
  std::size_t end;

  Layout(int height, const StructuringElement& element) noexcept {
    const auto rounded = [](std::size_t size) { return AlignedBytes::rounded_up(size); };
    const auto rows = static_cast<std::size_t>(ring_of(element));
    pitch = static_cast<std::size_t>(kStripColumns + 2 * margin_of(element.width()));
    words = static_cast<std::size_t>(height) / 64 + 1;
    chords = 0;
    marks = chords + rounded(sizeof(Chord) * (rows / 2 + 1));
    cells = marks + rounded(2 * kBlocksMax * words * sizeof(std::uint64_t));
    pointers = cells + 2 * rounded(pitch / kCellColumns);
    slots = pointers + 2 * rounded(rows * sizeof(const std::uint8_t*));
    end = slots + rows * static_cast<std::size_t>(levels_of(element.width())) * pitch;
  }
};

std::size_t LargeEllipse::bytes_needed(int height, const StructuringElement& element) noexcept {
  return Layout(height, element).end;
}

LargeEllipse::LargeEllipse(Order order, int height, const StructuringElement& element, std::uint8_t* work) noexcept
    : order_(order),
      element_(element),
      reach_v_(element.height() / 2),
      ring_(ring_of(element)),
      margin_(margin_of(element.width())),
      levels_(levels_of(element.width())) {
  const Layout layout(height, element);
  pitch_ = layout.pitch;
  words_ = layout.words;
  chords_ = reinterpret_cast<Chord*>(work + layout.chords);
  falling_ = reinterpret_cast<std::uint64_t*>(work + layout.marks);
  rising_ = falling_ + kBlocksMax * words_;
  cells_[0] = work + layout.cells;
  cells_[1] = cells_[0] + AlignedBytes::rounded_up(pitch_ / kCellColumns);
  left_ = reinterpret_cast<const std::uint8_t**>(work + layout.pointers);
  right_ = left_ + AlignedBytes::rounded_up(static_cast<std::size_t>(ring_) * sizeof(*left_)) / sizeof(*left_);
  slots_ = work + layout.slots;
  for (int dv = 0; dv <= reach_v_; ++dv) {
    const int half = element_.half_chord(reach_v_ + dv);
    const int level = std::bit_width(static_cast<unsigned>(2 * half + 1)) - 1;
    const auto table = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(level) * pitch_) + margin_;
    chords_[dv] = {table - half, table + half + 1 - (1 << level)};
  }
}

std::uint8_t* LargeEllipse::slot(int v) const noexcept {
  return slots_ + static_cast<std::size_t>(v & (ring_ - 1)) * static_cast<std::size_t>(levels_) * pitch_;
}

void LargeEllipse::apply(ConstPlaneView in, PlaneView out) noexcept {
  for (int begin = 0; begin < in.width; begin += kStripColumns) {
    strip(in, out, begin, std::min(kStripColumns, in.width - begin));
  }
}

void LargeEllipse::strip(ConstPlaneView in, PlaneView out, int begin, int width) noexcept {
  std::memset(falling_, 0, 2 * kBlocksMax * words_ * sizeof(std::uint64_t));
  for (int v = 0; v < in.height + reach_v_; ++v) {
    if (v < in.height) take_row(in, v, begin, width);
    if (v >= reach_v_) make_row(v - reach_v_, in.height, width, out.row(v - reach_v_) + begin);
  }
}

// Copies a row with its margins and builds its tables: window w(l) at x spans the 2^l columns from x on.
void LargeEllipse::take_row(ConstPlaneView in, int v, int begin, int width) noexcept {
  std::uint8_t* row = slot(v);
  const int first = std::max(0, begin - margin_);
  const int last = std::min(in.width, begin + width + margin_);
  std::memset(row, order_.identity, pitch_);
  std::memcpy(row + margin_ - (begin - first), in.row(v) + first, static_cast<std::size_t>(last - first));
  int length = static_cast<int>(pitch_);
  for (int level = 1; level < levels_; ++level) {
    const int half = 1 << (level - 1);
    length -= half;
    order_.loops.join(row, row + half, row + pitch_, length);
    row += pitch_;
  }
  if (v > 0) mark_rows(v, static_cast<int>(pitch_) / kCellColumns);
}

// Notes for each block of columns, with as many columns around it as the element reaches, whether this row goes beyond
// the last one anywhere, and the last one beyond this.
void LargeEllipse::mark_rows(int v, int cells) noexcept {
  order_.loops.compare_cells(slot(v), slot(v - 1), cells, cells_[0], cells_[1]);
  constexpr int kCellsOfBlock = kBlockColumns / kCellColumns;
  const int around = margin_ / kCellColumns;
  for (int block = 0; block < kBlocksMax; ++block) {
    unsigned falls = 0;
    unsigned rises = 0;
    const int end = (block + 1) * kCellsOfBlock + 2 * around;
    for (int cell = block * kCellsOfBlock; cell < end; ++cell) {
      falls |= cells_[0][cell];
      rises |= cells_[1][cell];
    }
    const std::size_t offset = static_cast<std::size_t>(block) * words_;
    const auto here = static_cast<std::size_t>(v);
    if (falls != 0) falling_[offset + here / 64] |= std::uint64_t{1} << (here % 64);
    if (rises != 0) rising_[offset + (here - 1) / 64] |= std::uint64_t{1} << ((here - 1) % 64);
  }
}

void LargeEllipse::make_row(int v, int height, int width, std::uint8_t* out) noexcept {
  const int first = std::max(0, v - reach_v_);
  const int last = std::min(height - 1, v + reach_v_);
  for (int x = 0; x < width; x += kBlockColumns) {
    const std::size_t offset = static_cast<std::size_t>(x / kBlockColumns) * words_;
    const std::uint8_t* middle = slot(v) + x;
    left_[0] = middle + chords_[0].left;
    right_[0] = middle + chords_[0].right;
    chord_count_ = 1;
    add_marked(rising_ + offset, first, v - 1, v, x);
    add_marked(falling_ + offset, v + 1, last, v, x);
    order_.loops.gather(left_, right_, chord_count_, out + x, std::min(kBlockColumns, width - x));
  }
}

// Lists the chords of the marked rows from `first` to `last`.
void LargeEllipse::add_marked(const std::uint64_t* marks, int first, int last, int v, int x) noexcept {
  if (first > last) return;
  for (int word = first / 64; word <= last / 64; ++word) {
    std::uint64_t bits = marks[word];
    if (word == first / 64) bits &= ~std::uint64_t{0} << (first % 64);
    if (word == last / 64) bits &= ~std::uint64_t{0} >> (63 - last % 64);
    for (; bits != 0; bits &= bits - 1) {
      const int row = word * 64 + std::countr_zero(bits);
      const Chord chord = chords_[row < v ? v - row : row - v];
      const std::uint8_t* from = slot(row) + x;
      left_[chord_count_] = from + chord.left;
      right_[chord_count_] = from + chord.right;
      ++chord_count_;
    }
  }
}

}  // namespace adit
