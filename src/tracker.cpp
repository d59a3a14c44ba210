#include "adit/tracker.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "share_gone.hpp"

namespace adit {
namespace {

constexpr double kScoreLost = 0.03;  // a track that has fallen to this is forgotten
constexpr double kScoreNew = 0.2;    // share of its score that an opening brings at first sight

/// `paper` fills in no score.
double worth_of(const Opening& opening) noexcept {
  return std::clamp(std::max(opening.score, opening.confidence), 0.0, 1.0);
}

}  // namespace

OpeningTracker::OpeningTracker(const TrackerConfig& config) : config_(config) {
  if (const auto fault = fault_of(config)) throw std::invalid_argument(*fault);
}

void OpeningTracker::reset() noexcept {
  count_ = 0;
  last_id_ = chosen_id_ = rival_id_ = 0;
  rival_s_ = 0.0;
}

void OpeningTracker::update(const OpenSpace& open_space, double time_s, double yaw_rad) noexcept {
  time_s = std::isfinite(time_s) ? std::max(time_s, 0.0) : 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    tracks_[i].bearing.azimuth_rad += yaw_rad;  // a turn to the left takes what is seen to the right
    tracks_[i].age_s += time_s;
    tracks_[i].unseen_s += time_s;
  }
  std::array<bool, kTracksMax> taken{};
  const int openings = open_space.found() ? std::clamp(open_space.opening_count, 0, kOpeningCountMax) : 0;
  for (int i = 0; i < openings; ++i) {
    const Opening& opening = open_space.openings[static_cast<std::size_t>(i)];
    if (!std::isfinite(opening.bearing.azimuth_rad) || !std::isfinite(opening.bearing.elevation_rad)) continue;
    Track* track = nearest(opening.bearing.azimuth_rad, taken);
    if (track == nullptr) {
      start(opening);
      if (count_ > 0) taken[count_ - 1] = true;
      continue;
    }
    taken[static_cast<std::size_t>(track - tracks_.data())] = true;
    see(*track, opening, time_s);
  }
  for (std::size_t i = 0; i < count_; ++i)
    if (!taken[i]) tracks_[i].score *= 1.0 - share_gone(time_s, config_.forget_s);
  forget();
  choose(time_s);
}

Track* OpeningTracker::nearest(double azimuth_rad, const std::array<bool, kTracksMax>& taken) noexcept {
  Track* best = nullptr;
  double best_rad = config_.gate_rad;
  for (std::size_t i = 0; i < count_; ++i) {
    const double off_rad = std::abs(tracks_[i].bearing.azimuth_rad - azimuth_rad);
    if (taken[i] || !(off_rad <= best_rad)) continue;
    best = &tracks_[i];
    best_rad = off_rad;
  }
  return best;
}

void OpeningTracker::see(Track& track, const Opening& opening, double time_s) noexcept {
  const double share = share_gone(time_s, config_.bearing_smoothing_s);
  track.bearing.azimuth_rad += share * (opening.bearing.azimuth_rad - track.bearing.azimuth_rad);
  track.bearing.elevation_rad += share * (opening.bearing.elevation_rad - track.bearing.elevation_rad);
  track.half_width_rad += share * (opening.half_width_rad - track.half_width_rad);
  track.score += share_gone(time_s, config_.trust_s) * (worth_of(opening) - track.score);
  track.unseen_s = 0.0;
}

void OpeningTracker::start(const Opening& opening) noexcept {
  if (count_ == kTracksMax) return;
  tracks_[count_++] = {++last_id_, opening.bearing, opening.half_width_rad, kScoreNew * worth_of(opening), 0.0, 0.0};
}

void OpeningTracker::forget() noexcept {
  const auto lost = [](const Track& t) { return t.score < kScoreLost && t.unseen_s > 0.0; };
  const auto end = std::remove_if(tracks_.begin(), tracks_.begin() + static_cast<std::ptrdiff_t>(count_), lost);
  count_ = static_cast<std::size_t>(end - tracks_.begin());
}

void OpeningTracker::choose(double time_s) noexcept {
  const Track* best = nullptr;
  for (const Track& track : tracks())
    if (best == nullptr || track.score > best->score) best = &track;
  const Track* chosen = find(chosen_id_);
  if (best == nullptr || chosen == nullptr) {
    chosen_id_ = best == nullptr ? 0 : best->id;
    rival_s_ = 0.0;
    return;
  }
  if (best->id == chosen_id_ || best->score < config_.switch_ratio * chosen->score) {
    rival_s_ = 0.0;
    return;
  }
  rival_s_ = best->id == rival_id_ ? rival_s_ + time_s : 0.0;
  rival_id_ = best->id;
  if (rival_s_ < config_.switch_after_s) return;
  chosen_id_ = best->id;
  rival_s_ = 0.0;
}

const Track* OpeningTracker::find(std::uint32_t id) const noexcept {
  for (const Track& track : tracks())
    if (track.id == id && id != 0) return &track;
  return nullptr;
}

}  // namespace adit
