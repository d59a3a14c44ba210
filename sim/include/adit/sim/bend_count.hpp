// How many bends of the passage a flight has gone through.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>
#include <utility>

namespace adit::sim {

/// A bend is passed when the flight goes straight again, along the passage, in a course that differs from that of the
/// last straight piece. Both must agree: a vehicle that weaves in a cavern, or that looks around at a junction, passes
/// none; nor does one that turns back.
class BendCount {
 public:
  static constexpr double kStraight_m = 4.0;     ///< so much of the way tells the course: less than a width is swerving
  static constexpr double kStraightness = 0.99;  ///< of it as the crow flies: an arc of radius 8 m has as much
  static constexpr double kAlongPassage_deg =
      15.0;                                   ///< between the course and the passage 5 m ahead. In an arc they
                                              ///< differ by 4.5 m / radius: none below 17 m is taken for straight
  static constexpr double kBend_deg = 60.0;   ///< no right angle counts twice, whatever its radius
  static constexpr double kBack_deg = 135.0;  ///< from here on it has turned back, which is no bend

  /// A moment of the flight. @param place m. @param passage_rad of the passage ahead in the world, counter-clockwise
  /// from x; NaN where none is known.
  void add(const Eigen::Vector3d& place, double passage_rad);

  [[nodiscard]] int bends() const noexcept { return bends_; }

 private:
  std::deque<std::pair<double, Eigen::Vector2d>> way_;  ///< distance flown and place, of the last kStraight_m
  std::optional<double> course_rad_;                    ///< of the last straight piece
  int bends_ = 0;
};

}  // namespace adit::sim
