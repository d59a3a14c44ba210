// What the method `adit` makes of lamps: the pattern of its own, and pairs of frames with and without it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "adit_chain.hpp"

namespace adit {
namespace {

/// The lamp's pattern is not taken out beyond this: what lies three stops outside the beam holds more noise than rock.
constexpr double kBeamMax_stops = 3.0;
/// A pattern of so many frames counts by half: three to five seconds of flight.
constexpr double kFramesHalf = 100.0;

}  // namespace

void AditChain::set_lamp(const LampPattern& pattern) noexcept {
  lamp_known_ = pattern.frames > 0.0;
  if (!lamp_known_) return;
  const std::vector<float>& lobe =
      lobe_on_cells_.draw(pattern.lobe, static_cast<double>(frame_height_px_) / frame_width_px_);
  const double most = *std::max_element(lobe.begin(), lobe.end());
  const double trust = pattern.frames / (pattern.frames + kFramesHalf);
  for (std::size_t i = 0; i < lobe.size(); ++i) {
    const double stops = std::min(kBeamMax_stops, (most - static_cast<double>(lobe[i])) / std::numbers::ln2);
    lamp_.values[i] = static_cast<std::int16_t>(std::lround(kStop * trust * stops));
  }
}

void AditChain::brighten_outside_beam() noexcept {
  for (std::size_t i = 0; i < light_.values.size(); ++i) {
    light_.values[i] = static_cast<std::int16_t>(light_.values[i] + lamp_.values[i]);
  }
}

LampGlimpse AditChain::lamp_glimpse() const noexcept {
  LampGlimpse out;
  out.usable = light_usable_ && grid_.width() >= kLampColumns && grid_.height() >= kLampRows;
  if (!out.usable) return out;
  const double stop = std::numbers::ln2 / kStop;
  for (int row = 0; row < kLampRows; ++row) {
    for (int column = 0; column < kLampColumns; ++column) {
      const int left = column * grid_.width() / kLampColumns, right = (column + 1) * grid_.width() / kLampColumns;
      const int top = row * grid_.height() / kLampRows, bottom = (row + 1) * grid_.height() / kLampRows;
      std::int64_t sum = 0;
      for (int v = top; v < bottom; ++v) {
        for (int u = left; u < right; ++u) sum += table_[static_cast<std::size_t>(cleaned_.row(v)[u])];
      }
      const double mean = static_cast<double>(sum) / ((right - left) * (bottom - top));
      out.log_light[static_cast<std::size_t>(row * kLampColumns + column)] = static_cast<float>(mean * stop);
    }
  }
  return out;
}

void AditChain::take_pair(const ImageView& one, const ImageView& other, const FinderConfig& config) noexcept {
  reduce(one, config.grey16_depth_bits, grid_, rows_, level_);
  reduce(other, config.grey16_depth_bits, grid_, rows_, other_level_);
  std::int64_t more = 0;
  for (std::size_t i = 0; i < level_.values.size(); ++i) more += level_.values[i] - other_level_.values[i];
  if (more < 0) level_.values.swap(other_level_.values);
  // Light adds up, grey levels do not: the difference is taken of light and goes back through the tone curve.
  const auto power = static_cast<float>(config.light_gamma), root = 1.0F / power;
  const auto light = [power](std::int16_t part) {
    return std::pow((static_cast<float>(part) / kLevelParts + 1.0F) / 256.0F, power);
  };
  for (std::size_t i = 0; i < level_.values.size(); ++i) {
    const float own = std::max(0.0F, light(level_.values[i]) - light(other_level_.values[i]));
    const float level = std::pow(own, root) * 256.0F - 1.0F;
    level_.values[i] = static_cast<std::int16_t>(std::lround(std::max(0.0F, level) * kLevelParts));
  }
}

}  // namespace adit
