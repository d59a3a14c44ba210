// LampModel: the pattern of the vehicle's own lamp and lens, learnt from the frames of a flight.
//
// The lamp is bolted to the camera: its beam stands still in the image while the rock moves through it. What a place of
// the frame shows in its brightest moments is therefore the lamp's pattern; corners that are never bright are outside
// the beam, and no way on.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "adit/api.hpp"
#include "adit/camera.hpp"

namespace ADIT_API adit {

inline constexpr int kLampColumns = 20;
inline constexpr int kLampRows = 15;

/// The light of one frame, coarsely: what a LampModel learns from.
struct LampGlimpse {
  /// Natural logarithm of the mean light of each of kLampColumns x kLampRows cells over the whole frame, 0 at full
  /// scale. Rows one after the other.
  std::array<float, static_cast<std::size_t>(kLampColumns) * kLampRows> log_light{};
  bool usable = false;  ///< false: the frame was not judged, or dust hides the rock
};

/// A lobe of light over the frame.
struct LampPattern {
  /// Natural logarithm of the light is lobe[0] + lobe[1] x + lobe[2] y + lobe[3] x^2 + lobe[4] y^2 + lobe[5] log(1 +
  /// tan^2), with x from -1 to 1 over the width, y likewise times height / width, tan of the angle to the axis.
  /// lobe[3], [4] and [5] are at most 0.
  std::array<double, 6> lobe{};
  /// How many frames it was learnt from; it counts by frames / (frames + 100), so that the first frames of a flight
  /// are judged as if nothing were known.
  double frames = 0.0;
};

/// Why a pattern is refused; empty when it is good.
[[nodiscard]] const char* fault_of(const LampPattern& pattern) noexcept;

class LampModel {
 public:
  explicit LampModel(const Camera& camera);
  /// Goes on from a pattern that was learnt before. @throws std::invalid_argument
  LampModel(const Camera& camera, const LampPattern& known);
  ~LampModel();
  LampModel(LampModel&&) noexcept;
  LampModel& operator=(LampModel&&) noexcept;

  /// Takes a frame's light. A frame that shows nearly the same as the last is left out: a vehicle that hovers learns
  /// nothing about its lamp. Allocates nothing.
  /// @return whether the pattern has changed.
  bool learn(const LampGlimpse& glimpse) noexcept;

  [[nodiscard]] const LampPattern& pattern() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace adit
