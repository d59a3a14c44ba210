// The open space of a layout as a signed distance, before relief: negative in the open, positive in the rock.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "layout.hpp"

namespace adit::sim {

/// A short straight stretch of a passage (or a room, when its length is 0).
struct Stretch {
  Eigen::Vector2f from;
  Eigen::Vector2f direction;   ///< unit
  float length = 0.0f;         ///< horizontal
  float floor = 0.0f;          ///< z at `from`
  float grade = 0.0f;          ///< rise per metre
  float half_width = 0.0f;     ///< at `from`
  float half_widening = 0.0f;  ///< per metre
  float height = 0.0f;
  float heightening = 0.0f;
  bool flat_start = false;  ///< the passage ends there with a face
  bool flat_end = false;
  int passage = 0;
};

/// The distance at a point and the height over the floor of the stretch it is nearest to.
struct OpenDistance {
  float distance = 0.0f;  ///< m, negative in the open
  float above_floor = 0.0f;
};

/// Signed distance to the union of all stretches; passages run into each other smoothly.
class PassageField {
 public:
  PassageField(const Layout& layout, float crown_fraction, float blend_m, float apron_m);

  using Candidates = std::vector<std::uint32_t>;

  [[nodiscard]] const std::vector<Stretch>& stretches() const noexcept { return stretches_; }
  [[nodiscard]] const std::vector<Mouth>& mouths() const noexcept { return mouths_; }
  [[nodiscard]] float apron_m() const noexcept { return apron_m_; }

  /// Distance at p, looking only at these stretches (in rising order).
  [[nodiscard]] OpenDistance at(const Eigen::Vector3f& p, const Candidates& candidates) const noexcept;
  /// Leaves only the candidates that can matter within `radius` of p.
  void cull(const Eigen::Vector3f& p, float radius, Candidates& candidates) const;
  /// All stretches that can matter near p: slow, for a few points.
  [[nodiscard]] Candidates all() const;

  /// Corners of the box in which a stretch can matter, `margin` beyond its walls.
  void box_of(const Stretch& stretch, float margin, Eigen::Vector3f& low, Eigen::Vector3f& high) const;
  /// True beyond a mouth, where there is to be no rock.
  [[nodiscard]] bool is_outside(const Eigen::Vector3f& p) const noexcept;

 private:
  void add_passage(const Passage& passage, int index, const std::vector<Node>& nodes);
  [[nodiscard]] float distance_to(const Stretch& stretch, const Eigen::Vector3f& p, float& above_floor) const noexcept;
  [[nodiscard]] float blend_over(float above_floor) const noexcept;
  [[nodiscard]] float distance_to_open_air(const Mouth& mouth, const Eigen::Vector3f& p) const noexcept;

  std::vector<Stretch> stretches_;
  std::vector<Mouth> mouths_;
  float crown_fraction_;
  float blend_m_;
  float apron_m_;
};

}  // namespace adit::sim
