#include "adit/frame_watch.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "spread_pixels.hpp"

namespace adit {
namespace {

constexpr int kColumns = 48;          // looked at for a seam
constexpr int kJumpMin = 10;          // levels: above noise and compression
constexpr int kJumpRatio = 3;         // over what the rows about it do in the same column
constexpr double kSeamColumns = 0.7;  // of the columns that have to jump: rock's own edges are never so long and level
constexpr double kSeamNear = 0.03;    // of the height: an edge that was there in the last frame too is the scene's
constexpr int kSignalMin = 4;         // rows with signal that a comparison needs
constexpr std::uint64_t kHashBegin = 0x9e3779b97f4a7c15ull;

/// Goes on with the hash of what stands before; a multiple of eight bytes, but for the last piece of a row.
std::uint64_t hash_of(const std::uint8_t* row, std::size_t bytes, std::uint64_t hash) noexcept {
  // Multiply and fold, eight bytes at a time (as in wyhash and its kin): collisions do not matter here, speed does.
  for (std::size_t at = 0; at + 8 <= bytes; at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, row + at, 8);
    hash = (hash ^ word) * 0xff51afd7ed558ccdull;
    hash ^= hash >> 29;
  }
  return hash;
}

bool is_flat(const std::uint8_t* row, std::size_t bytes, std::size_t pixel) noexcept {
  return std::memcmp(row, row + pixel, bytes - pixel) == 0;
}

constexpr int kPiece_px = 240;  // a multiple of eight bytes in every format

/// A row of pixels that do not lie side by side, piece by piece: as its packed copy would be.
void judge_spread_row(const ImageView& frame, const std::uint8_t* row, std::uint64_t& hash, bool& flat) noexcept {
  std::array<std::uint8_t, kPiece_px * 4> piece;
  std::array<std::uint8_t, 4> first{};
  const auto pixel = static_cast<std::size_t>(bytes_per_pixel(frame.format));
  flat = true;
  for (int u = 0; u < frame.width; u += kPiece_px) {
    const int count = std::min(kPiece_px, frame.width - u);
    gather_pixels(frame, row + u * frame.pixel_step(), piece.data(), count);
    const std::size_t bytes = static_cast<std::size_t>(count) * pixel;
    hash = hash_of(piece.data(), bytes, hash);
    if (u == 0) std::memcpy(first.data(), piece.data(), pixel);
    flat = flat && is_flat(piece.data(), bytes, pixel) && std::memcmp(first.data(), piece.data(), pixel) == 0;
  }
}

/// The byte of a pixel that carries the light: green, the grey itself, or the upper byte of 16 bits.
std::ptrdiff_t byte_of(const ImageView& frame) noexcept {
  if (frame.format == PixelFormat::kGrey8) return 0;
  if (frame.format == PixelFormat::kGrey16)
    return 1;  // the upper byte on the little-endian machines that all targets are
  return frame.channel_step();
}

}  // namespace

FrameWatch::FrameWatch(const FrameWatchConfig& config) : config_(config) {
  if (const auto fault = fault_of(config)) throw std::invalid_argument(*fault);
}

void FrameWatch::reset() noexcept {
  has_last_ = false;
  same_count_ = torn_count_ = 0;
}

FrameWatch::Rows FrameWatch::rows_of(const ImageView& frame) noexcept {
  Rows rows;
  const auto pixel = static_cast<std::size_t>(bytes_per_pixel(frame.format));
  const std::size_t bytes = static_cast<std::size_t>(frame.width) * pixel;
  const bool is_packed = frame.is_packed();
  for (int k = 0; k < kRows; ++k) {
    const std::uint8_t* row = frame.row(static_cast<int>((2LL * k + 1) * frame.height / (2LL * kRows)));
    std::uint64_t& hash = rows.hash[static_cast<std::size_t>(k)] = kHashBegin;
    bool& flat = rows.flat[static_cast<std::size_t>(k)];
    if (is_packed) {
      hash = hash_of(row, bytes, hash);
      flat = is_flat(row, bytes, pixel);
    } else {
      judge_spread_row(frame, row, hash, flat);
    }
  }
  rows.seam = seam_of(frame);
  return rows;
}

int FrameWatch::seam_of(const ImageView& frame) noexcept {
  const std::ptrdiff_t pixel = frame.pixel_step(), at = byte_of(frame);
  const int columns = std::min(kColumns, frame.width);
  std::array<std::ptrdiff_t, kColumns> offset{};
  std::array<int, kColumns> before{}, jump{};
  for (int i = 0; i < columns; ++i)
    offset[static_cast<std::size_t>(i)] = (2 * i + 1) * frame.width / (2 * columns) * pixel + at;
  int best_row = -1, best_count = static_cast<int>(kSeamColumns * columns);
  for (int v = 0; v < frame.height; ++v) {
    const std::uint8_t* row = frame.row(v);
    int count = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(columns); ++i) {
      const int level = row[offset[i]];
      const int step = v == 0 ? 0 : std::abs(level - before[i]);
      count += step >= kJumpMin && step >= kJumpRatio * jump[i] ? 1 : 0;
      jump[i] = step;
      before[i] = level;
    }
    if (v > 1 && count > best_count) {
      best_row = v;
      best_count = count;
    }
  }
  return best_row;
}

bool FrameWatch::is_same(const Rows& rows) const noexcept { return rows.hash == last_.hash; }

bool FrameWatch::is_torn(const Rows& rows, int height) const noexcept {
  int with_signal = 0, above = 0, below = 0, lost = 0;
  bool run = true;
  for (std::size_t k = 0; k < kRows; ++k) {
    if (rows.flat[k]) continue;  // nothing to compare
    ++with_signal;
    run = run && rows.hash[k] == last_.hash[k];
    above += run ? 1 : 0;
  }
  run = true;
  bool dead = true;
  for (std::size_t k = kRows; k-- > 0;) {
    dead = dead && rows.flat[k] && !last_.flat[k];
    lost += dead ? 1 : 0;
    if (rows.flat[k]) continue;
    run = run && rows.hash[k] == last_.hash[k];
    below += run ? 1 : 0;
  }
  const double least = config_.torn_fraction_min * kRows;
  if (with_signal >= kSignalMin && lost >= least) return true;
  if (with_signal >= kSignalMin && above < with_signal && (above >= least || below >= least)) return true;
  return rows.seam >= 0 &&
         (last_.seam < 0 || std::abs(rows.seam - last_.seam) > static_cast<int>(kSeamNear * height) + 1);
}

Status FrameWatch::judge(const ImageView& frame) noexcept {
  if (!fault_of(frame).empty()) return Status::kFound;
  if (frame.width != width_ || frame.height != height_ || frame.format != format_) reset();
  width_ = frame.width;
  height_ = frame.height;
  format_ = frame.format;
  const Rows rows = rows_of(frame);
  if (!has_last_) {
    last_ = rows;
    has_last_ = true;
    return Status::kFound;
  }
  same_count_ = is_same(rows) ? same_count_ + 1 : 0;
  if (same_count_ > 0) return same_count_ + 1 >= config_.frozen_frames ? Status::kFrozenFrame : Status::kFound;
  const bool torn = is_torn(rows, frame.height);
  torn_count_ = torn ? torn_count_ + 1 : 0;
  // What is torn for so long is how this camera's pictures look (a mask, a part of the vehicle in view).
  const bool is_news = torn_count_ <= config_.torn_frames_max;
  if (!torn || !is_news) {
    last_ = rows;
    return Status::kFound;
  }
  // Compared with what comes next are its rows, but its seam is not the scene's.
  const int seam = last_.seam;
  const auto flat = last_.flat;
  last_ = rows;
  last_.seam = seam;
  last_.flat = flat;
  return Status::kTornFrame;
}

}  // namespace adit
