// How many bends of the passage a flight has gone through.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>
#include <utility>

namespace adit::sim {

/// A bend is passed when the flight goes straight again, along the passage, in a course that differs from that of the
/// last straight piece; or when, within an S, it begins to turn the other way. The passage must have turned with the
/// flight: a vehicle that weaves in a cavern, or that looks around at a junction, passes none; nor does one that turns
/// back.
class BendCount {
 public:
  static constexpr double kStraight_m = 4.0;     ///< so much of the way tells the course: less than a width is swerving
  static constexpr double kStraightness = 0.99;  ///< of it as the crow flies: an arc of radius 8 m has as much
  static constexpr double kCourseness = 0.8;     ///< below that it tells no course: an arc of radius 1.8 m has as much
  static constexpr double kAlongPassage_deg =
      15.0;                                  ///< between the course and the passage 5 m ahead. In an arc they
                                             ///< differ by 4.5 m / radius: none below 17 m is taken for straight
  static constexpr double kLead_m = 6.0;     ///< by so much of the way, at the most, the passage 5 m ahead leads the
                                             ///< course; by how much depends on how the corner is cut
  static constexpr double kBend_deg = 60.0;  ///< between straight pieces: no right angle counts twice, whatever its
                                             ///< radius
  static constexpr double kTurn_deg = 40.0;  ///< between two turns the other way, or one and a straight piece; of the
                                             ///< course and of the passage. Right angles that follow each other without
                                             ///< straight way are flown as turns of 55 to 60 degrees
  static constexpr double kOther_deg = 10.0;   ///< so far back it turns the other way. Where that was a swerve, and it
                                               ///< turns on after all, it is the same bend
  static constexpr double kSteady_deg = 10.0;  ///< a bend is over that turned no more than this within kStraight_m
  static constexpr double kBack_deg = 135.0;   ///< from here on it has turned back, which is no bend

  /// A moment of the flight. @param place m. @param passage_rad of the passage ahead in the world, counter-clockwise
  /// from x; NaN where none is known.
  void add(const Eigen::Vector3d& place, double passage_rad);

  [[nodiscard]] int bends() const noexcept { return bends_; }

 private:
  /// All count on beyond a full turn. The passage is the least and the most of kLead_m.
  struct Directions {
    double flown_m = 0.0;
    double course_deg = 0.0;
    double passage_low_deg = 0.0, passage_high_deg = 0.0;
  };

  void see_passage(double flown_m, double passage_rad);
  [[nodiscard]] Directions directions(double flown_m, double course_rad) const;
  [[nodiscard]] bool turned(const Directions& to) const;
  [[nodiscard]] bool turns_on(const Directions& now);
  void judge(const Directions& now, bool is_straight);
  void pass(const Directions& end, const Directions& now, bool is_straight);
  void begin_at(const Directions& place, const Directions& now);

  std::deque<std::pair<double, Eigen::Vector2d>> way_;  ///< distance flown and place, of the last kStraight_m
  std::deque<std::pair<double, double>> passages_;      ///< distance flown and passage in deg, of the last kLead_m
  std::optional<double> last_course_deg_;
  std::optional<Directions> begin_;  ///< of the last straight piece, or of the last turn the other way
  bool begins_straight_ = true;      ///< which of them
  Directions left_, right_;          ///< the furthest since then, of the course
  int sense_ = 0;                    ///< of the last bend while it is not over: 1 left, -1 right; 0: it is over
  Directions steady_;                ///< since here that bend has not turned by kSteady_deg
  int bends_ = 0;
};

}  // namespace adit::sim
