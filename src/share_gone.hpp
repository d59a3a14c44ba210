// Smoothing that does not depend on how often it is done.
#pragma once

#include <cmath>

namespace adit {

/// The share of the way to a new value that a first-order lag goes while `passed` goes by, both in seconds or both in
/// metres; all of it where there is no lag.
inline double share_gone(double passed, double lag) noexcept { return lag > 0.0 ? -std::expm1(-passed / lag) : 1.0; }

}  // namespace adit
