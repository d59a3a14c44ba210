// Rock: the passages with relief at several scales, and what each place of its surface is made of.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "adit/sim/course.hpp"
#include "noise.hpp"
#include "passage_field.hpp"

namespace adit::sim {

/// Indices into World::materials of a course.
enum class RockMaterial : std::uint8_t {
  kRock,
  kWetRock,
  kGravel,
  kWetGravel,
  kStone,
  kPipe,
  kCable,
  kTimber,
  kSteel,
  kDuct,
  kLampGlass
};
[[nodiscard]] std::vector<Material> materials_of(const CourseConfig& config);

/// The field that is meshed. Made for a box at a time (facets and candidates are prepared for it); the value at a
/// point does not depend on the box.
class Rock {
 public:
  Rock(const PassageField& field, const CourseConfig& config);

  /// Prepares for points in [low, high]; `candidates` are the stretches near it, in rising order.
  void prepare(const Eigen::Vector3f& low, const Eigen::Vector3f& high, PassageField::Candidates candidates);
  /// Distance in the smooth field; good where the surface is not near.
  [[nodiscard]] OpenDistance smooth_at(const Eigen::Vector3f& p) const noexcept { return field_->at(p, candidates_); }
  /// Signed distance with relief, negative in the open. Beyond reach_m() of the surface relief is left out.
  [[nodiscard]] float at(const Eigen::Vector3f& p) const noexcept;
  /// Largest displacement that relief can make.
  [[nodiscard]] float reach_m() const noexcept { return reach_m_; }

 private:
  [[nodiscard]] float wall_relief(const Eigen::Vector3f& p) const noexcept;
  [[nodiscard]] float floor_relief(const Eigen::Vector3f& p) const noexcept;

  const PassageField* field_;
  float undulation_m_, undulation_size_m_, grain_depth_m_, grain_size_m_, floor_roughness_m_;
  float reach_m_;
  std::uint32_t seed_;
  Facets facets_;
  Facets chips_;
  PassageField::Candidates candidates_;
};

/// Of a triangle of the surface. @param above_floor metres, @param upward z of the unit normal into the open.
[[nodiscard]] RockMaterial material_at(const Eigen::Vector3f& p, float above_floor, float upward, float wet_fraction,
                                       std::uint32_t seed) noexcept;

}  // namespace adit::sim
