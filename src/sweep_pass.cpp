#include <algorithm>
#include <bit>

#include "morphology_passes.hpp"

namespace adit {
namespace {

using kernels::SweepPair;
using kernels::SweepPlace;

struct Recipes {
  kernels::SweepRecipe of_half[kernels::kSweepHalfMax_px];
};

template <int... kHalf>
constexpr Recipes round_recipes(std::integer_sequence<int, kHalf...>) {
  return {{kernels::round_recipe(kHalf + 1)...}};
}
template <int... kHalf>
constexpr Recipes square_recipes(std::integer_sequence<int, kHalf...>) {
  return {{kernels::square_recipe(kHalf + 1)...}};
}
using Halves = std::make_integer_sequence<int, kernels::kSweepHalfMax_px>;
constexpr Recipes kRoundRecipes = round_recipes(Halves{});
constexpr Recipes kSquareRecipes = square_recipes(Halves{});

const kernels::SweepRecipe& recipe_of(const StructuringElement& element) {
  const Recipes& recipes = element.is_rectangle() ? kSquareRecipes : kRoundRecipes;
  return recipes.of_half[element.height() / 2 - 1];
}

/// Lanes of the widest target and of the narrowest: buffers serve all targets.
constexpr int kLanesMax = static_cast<int>(AlignedBytes::kAlignment);
constexpr int kLanesMin = 16;

/// Places of a pair of rows: its vectors, the tail, and the gap to the next pair.
int places_of_pair(int width, int lanes) { return (width + lanes - 1) / lanes + 1; }

/// Pairs that may be on their way while others are taken: the fewer places a pair has, the more.
int pairs_on_their_way(int width, const StructuringElement& element) {
  const int places = places_of_pair(width, kLanesMax);
  return (recipe_of(element).step_count + places - 1) / places + 1;
}

/// Slots for pairs: whole batches, so that a batch never runs over the end.
int slots_of(int width, const StructuringElement& element) {
  const int batches = (pairs_on_their_way(width, element) + SweepPass::kBatch - 1) / SweepPass::kBatch;
  return (batches + 1) * SweepPass::kBatch;
}

}  // namespace

bool SweepPass::fits(const StructuringElement& element) noexcept {
  const int half = element.height() / 2;
  return element.width() == element.height() && half >= 1 && half <= kernels::kSweepHalfMax_px;
}

bool SweepPass::takes(const Order& order, const StructuringElement& element) noexcept {
  if (!fits(element)) return false;
  const kernels::SweepLoops& loops = element.is_rectangle() ? order.loops.square : order.loops.round;
  return loops.of_half[element.height() / 2 - 1] != nullptr;
}

int SweepPass::ring_rows(int width, const StructuringElement& element) noexcept {
  const int late = 2 * pairs_on_their_way(width, element);
  // A power of two: rows are looked up so often that a division would be felt.
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(element.height() + 1 + 2 * kBatch + 2 * late)));
}

// For several elements in turn: room is for the largest of each.
void SweepPass::reserve(int width, const StructuringElement& element) {
  const auto lag = static_cast<std::size_t>(recipe_of(element).step_count);
  const auto slots = static_cast<std::size_t>(slots_of(width, element));
  state_.reserve(kernels::kSweepStateBytes);
  gap_.reserve(AlignedBytes::kAlignment);
  nowhere_.reserve(AlignedBytes::rounded_up(static_cast<std::size_t>(width)));
  places_.resize(
      std::max(places_.size(), 3 * lag + slots * static_cast<std::size_t>(places_of_pair(width, kLanesMin))));
  pairs_.resize(std::max(pairs_.size(), 2 * slots));
  gap_rows_.resize(std::max(gap_rows_.size(), static_cast<std::size_t>(element.height()) + 1));
  row_lists_.resize(pairs_.size() * gap_rows_.size());
}

void SweepPass::start(Order order, int width, int height, const StructuringElement& element,
                      Rows<const std::uint8_t> in, Rows<std::uint8_t> out) noexcept {
  const kernels::SweepLoops& loops = element.is_rectangle() ? order.loops.square : order.loops.round;
  loop_ = loops.of_half[element.height() / 2 - 1];
  lanes_ = kernels::pixel_loops().lanes;
  tail_ = width % lanes_;
  body_ = width - tail_;
  height_ = height;
  reach_ = element.height() / 2;
  lag_ = recipe_of(element).step_count;
  pair_places_ = places_of_pair(width, lanes_);
  slots_ = slots_of(width, element);
  in_ = in;
  out_ = out;
  std::memset(state_.get(), order.identity, kernels::kSweepStateBytes);
  std::memset(gap_.get(), order.identity, AlignedBytes::kAlignment);
  std::fill(gap_rows_.begin(), gap_rows_.end(), gap_.get());
  first_slot_ = 0;
  next_slot_ = 0;
  places_done_ = 0;
  rows_done_ = 0;
  lay_out_places();
}

// The places of all slots in a row; from then on only what the pairs point to changes. Before the first slot come gaps,
// and once the slots have been used in turn, the places of the last one.
void SweepPass::lay_out_places() noexcept {
  gap_pair_ = {gap_rows_.data(), nowhere_.get(), nowhere_.get()};
  SweepPlace* place = places_.data() + lag_;
  for (int slot = 0; slot < slots_; ++slot) {
    SweepPair* pair = pairs_.data() + 2 * slot;
    for (int x = 0; x < body_; x += lanes_) *place++ = {pair, x};
    if (tail_ > 0) *place++ = {pair + 1, 0};
    *place++ = {&gap_pair_, 0};
  }
  std::fill_n(places_.data(), lag_, SweepPlace{&gap_pair_, 0});
}

// Where the plane has no such row, the nearer middle stands in: it is under both elements anyway.
void SweepPass::list_rows(int v, const std::uint8_t** rows, bool tails) const noexcept {
  const auto row = [&](int at) { return tails ? in_.tail(at) : in_.row(at); };
  rows[0] = row(v);
  rows[1] = v + 1 < height_ ? row(v + 1) : rows[0];
  if (v >= reach_ && v + 1 + reach_ < height_) {
    for (int dv = 1; dv <= reach_; ++dv) {
      rows[2 * dv] = row(v - dv);
      rows[2 * dv + 1] = row(v + 1 + dv);
    }
    return;
  }
  for (int dv = 1; dv <= reach_; ++dv) {
    rows[2 * dv] = v - dv >= 0 ? row(v - dv) : rows[0];
    rows[2 * dv + 1] = v + 1 + dv < height_ ? row(v + 1 + dv) : rows[1];
  }
}

void SweepPass::take(int v) noexcept {
  if (next_slot_ - first_slot_ == kBatch || next_slot_ == slots_) run();
  const bool has_lower = v + 1 < height_;
  const std::size_t slot = 2 * static_cast<std::size_t>(next_slot_++);
  const std::uint8_t** rows = row_lists_.data() + slot * gap_rows_.size();
  if (body_ > 0) {
    list_rows(v, rows, false);
    pairs_[slot] = {rows, out_.row(v), has_lower ? out_.row(v + 1) : nowhere_.get()};
  }
  if (tail_ > 0) {
    rows += gap_rows_.size();
    list_rows(v, rows, true);
    pairs_[slot + 1] = {rows, out_.tail(v), has_lower ? out_.tail(v + 1) : nowhere_.get()};
  }
}

void SweepPass::run() noexcept {
  sweep(places_.data() + lag_ + first_slot_ * pair_places_, (next_slot_ - first_slot_) * pair_places_);
  if (next_slot_ == slots_) {
    next_slot_ = 0;
    std::copy_n(places_.data() + slots_ * pair_places_, lag_, places_.data());
  }
  first_slot_ = next_slot_;
}

void SweepPass::finish() noexcept {
  run();
  SweepPlace* end = places_.data() + lag_ + slots_ * pair_places_;
  std::copy_n(places_.data() + first_slot_ * pair_places_, lag_, end);
  std::fill_n(end + lag_, lag_, SweepPlace{&gap_pair_, 0});
  sweep(end + lag_, lag_);
}

void SweepPass::sweep(const SweepPlace* places, int count) noexcept {
  loop_(state_.get(), places, count);
  places_done_ += count;
  const std::int64_t pairs = std::max<std::int64_t>(0, places_done_ - lag_) / pair_places_;
  rows_done_ = static_cast<int>(std::min<std::int64_t>(height_, 2 * pairs));
}

}  // namespace adit
