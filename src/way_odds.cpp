#include "way_odds.hpp"

#include <algorithm>
#include <cmath>

#include "cell_filters.hpp"

namespace adit {
namespace {

/// Weights of a logistic regression over rendered frames of passages and walls (docs/method.md): rock from coal to
/// white paint, sections from 2 to 10 m, lamps of four patterns on the camera and beside it, dust of five kinds.
struct Weights {
  double even;  ///< logarithm of the odds where all that follows is 0
  double peak;  ///< of a natural logarithm, as are area and air
  double area;
  double air;
  double above;  ///< a stop
  double below;  ///< a stop
  double cusp;   ///< of a natural logarithm
  double rock;   ///< of a natural logarithm
};
constexpr Weights kClear{15.48, 2.15, 1.25, 4.33, 1.81, -0.50, 3.12, 0.0};
/// Through a veil the peak says how thin the veil is rather than how deep the place, unless much rock is seen beside
/// it, and the veil's own lobe hides cusps.
constexpr Weights kVeilOff{23.11, -4.22, 2.09, 5.17, -0.50, -2.57, 0.0, 4.55};

/// A place this strong, in clear air, is as likely a way on as not whatever the rest of the frame is like: of the walls
/// that the weights are from none was above 0.39. And the natural logarithm of strength over which the odds grow by e.
constexpr double kStrongEven = 0.45, kStrongSpread = 0.15;

/// Added before logarithms, so that nothing seen is a small number and not none: a tenth of a stop, 60 of the 19,200
/// cells, a block in two hundred, what texture makes of a cusp, and the lobe's misfit of rock.
constexpr double kPeakFloor = 0.1, kAreaFloor = 0.003, kAirFloor = 0.005, kCuspFloor = 0.02, kRockFloor = 0.03;

}  // namespace

double way_odds(const Candidate& best, int cells, const VeilSight& veil, double cusp, bool veil_off) noexcept {
  const Weights& w = veil_off ? kVeilOff : kClear;
  const double peak_stops = static_cast<double>(best.peak) / kStop;
  const double share = static_cast<double>(best.cells) / cells;
  const double odds = w.even + w.peak * std::log(peak_stops + kPeakFloor) + w.area * std::log(share + kAreaFloor) +
                      w.air * std::log(veil.open_share + kAirFloor) + w.above * veil.above_stops +
                      w.below * veil.below_stops + w.cusp * std::log(cusp + kCuspFloor) +
                      w.rock * std::log(veil.rock_high + kRockFloor);
  if (veil_off || !(best.strength > 0.0)) return odds;
  return std::max(odds, std::log(best.strength / kStrongEven) / kStrongSpread);
}

}  // namespace adit
