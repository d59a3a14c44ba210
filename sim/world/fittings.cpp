#include "fittings.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "fitting_shapes.hpp"
#include "rock.hpp"

namespace adit::sim {
namespace {

/// Fittings are laid from stations this far apart on the axis.
constexpr int kStation_points = 2;  ///< of AxisPoints, about 1 m
/// Where the wall is further away than half the width by this much, something opens there: no fittings.
constexpr float kOpening_m = 0.9f;
constexpr float kPipeRadius_m = 0.055f, kPipeHeight_m = 1.75f, kPipeApart_m = 0.21f;
constexpr float kCableRadius_m = 0.022f, kCableHeight_m = 2.0f, kCableApart_m = 0.11f, kCableSag_m = 0.12f;
constexpr int kHook_stations = 3;
/// The duct hangs this far to the left, as a share of the width.
constexpr float kDuctAside = 0.27f;
constexpr float kPostRadius_m = 0.10f;
/// Headroom below which no beam goes across.
constexpr float kBeamHeight_m = 2.9f;
constexpr float kStoneMax_m = 0.3f;

/// Fits one passage out.
class Outfitter {
 public:
  Outfitter(const PassageField& field, const CourseConfig& config, const Passage& passage, std::uint32_t seed)
      : field_(&field), config_(config), passage_(passage), rock_(field, config), row_(seed) {}

  Mesh fitted() {
    const float low = lowest_height();
    for (int i = 0; i < static_cast<int>(config_.pipe_count); ++i)
      lay_line(1.0f, kPipeHeight_m - kPipeApart_m * static_cast<float>(i), kPipeRadius_m, RockMaterial::kPipe, low);
    for (int i = 0; i < static_cast<int>(config_.cable_count); ++i)
      lay_line(-1.0f, kCableHeight_m + kCableApart_m * static_cast<float>(i), kCableRadius_m, RockMaterial::kCable,
               low);
    if (config_.duct_diameter_m > 0.0) lay_duct();
    if (config_.prop_spacing_m > 0.0) set_props();
    strew_stones();
    return std::move(mesh_);
  }

 private:
  struct Station {
    Eigen::Vector3f place, aside;  ///< aside: unit, to the left
    float width_m, height_m;
  };

  Station station_at(std::size_t i) const {
    const auto& axis = passage_.axis;
    const Eigen::Vector3f way = axis[std::min(i + 1, axis.size() - 1)].place - axis[i > 0 ? i - 1 : 0].place;
    const Eigen::Vector3f aside = Eigen::Vector3f(-way.y(), way.x(), 0.0f).normalized();
    return {axis[i].place, aside, axis[i].width_m, axis[i].height_m};
  }

  float lowest_height() const {
    float low = 1e9f;
    for (const AxisPoint& point : passage_.axis) low = std::min(low, point.height_m);
    return low;
  }

  /// Metres from a place in the open to the rock, at most `reach_m`.
  float range_to_rock(const Eigen::Vector3f& from, const Eigen::Vector3f& way, float reach_m) {
    constexpr float kStride_m = 0.1f;
    const Eigen::Vector3f to = from + reach_m * way;
    PassageField::Candidates candidates = near_;
    const Eigen::Vector3f edge = Eigen::Vector3f::Constant(0.05f);
    rock_.prepare(from.cwiseMin(to) - edge, from.cwiseMax(to) + edge, std::move(candidates));
    float before = rock_.at(from);
    if (before >= 0.0f) return 0.0f;
    for (float range = kStride_m; range < reach_m; range += kStride_m) {
      const float now = rock_.at(from + range * way);
      if (now >= 0.0f) return range - kStride_m * now / (now - before);
      before = now;
    }
    return reach_m;
  }

  void look_near(const Station& station) {
    near_ = field_->all();
    field_->cull(station.place + Eigen::Vector3f(0.0f, 0.0f, 0.5f * station.height_m), 0.5f * station.width_m + 2.0f,
                 near_);
  }

  /// A pipe or cable along one wall, a hand's breadth off its bosses; it ends where the wall opens.
  void lay_line(float side, float height_m, float radius_m, RockMaterial material, float passage_low_m) {
    if (height_m > passage_low_m - 0.35f) return;
    std::vector<Station> stations;
    std::vector<float> walls;
    for (std::size_t i = 0; i < passage_.axis.size(); i += kStation_points) {
      stations.push_back(station_at(i));
      const Station& s = stations.back();
      look_near(s);
      const float limit = 0.5f * s.width_m + kOpening_m;
      const float wall = range_to_rock(s.place + Eigen::Vector3f(0, 0, height_m), side * s.aside, limit);
      walls.push_back(wall < limit && wall > 0.25f * s.width_m ? wall : -1.0f);
    }
    std::vector<Eigen::Vector3f> line;
    for (std::size_t i = 0; i < stations.size(); ++i) {
      float nearest = walls[i];
      for (std::size_t k = i > 0 ? i - 1 : 0; k < std::min(i + 2, walls.size()); ++k)
        nearest = std::min(nearest, walls[k]);
      if (nearest <= 0.0f) {
        flush(line, radius_m, material);
        continue;
      }
      Eigen::Vector3f place = stations[i].place + side * (nearest - radius_m - 0.03f) * stations[i].aside;
      place.z() += height_m;
      if (material == RockMaterial::kCable && i % kHook_stations != 0) place.z() -= kCableSag_m;
      line.push_back(place);
    }
    flush(line, radius_m, material);
  }

  void flush(std::vector<Eigen::Vector3f>& line, float radius_m, RockMaterial material) {
    if (line.size() > 3) add_tube(line, radius_m, radius_m > 0.2f ? 14 : radius_m > 0.04f ? 8 : 5, material, mesh_);
    line.clear();
  }

  void lay_duct() {
    const auto radius = static_cast<float>(0.5 * config_.duct_diameter_m);
    std::vector<Eigen::Vector3f> line;
    for (std::size_t i = 0; i < passage_.axis.size(); i += kStation_points) {
      const Station s = station_at(i);
      look_near(s);
      const Eigen::Vector3f foot = s.place + kDuctAside * s.width_m * s.aside + Eigen::Vector3f(0, 0, 1.0f);
      float roof = 1e9f;
      for (const float off : {-radius, 0.0f, radius})
        roof = std::min(roof, range_to_rock(foot + off * s.aside, Eigen::Vector3f::UnitZ(), s.height_m + 1.0f));
      const float height = 1.0f + roof - radius - 0.08f;
      if (roof > s.height_m || height - radius < 1.9f) {
        flush(line, radius, RockMaterial::kDuct);
        continue;
      }
      line.push_back(s.place + kDuctAside * s.width_m * s.aside + Eigen::Vector3f(0, 0, height));
    }
    flush(line, radius, RockMaterial::kDuct);
  }

  void set_props() {
    const double per_point = 0.5 / config_.prop_spacing_m;
    std::size_t last = 0;
    for (std::size_t i = 6; i + 6 < passage_.axis.size(); ++i) {
      if (!row_.chance(per_point * 1.3) || i < last + 6) continue;
      last = i;
      set_prop_pair(station_at(i), row_.chance(0.6) ? RockMaterial::kTimber : RockMaterial::kSteel);
    }
  }

  void set_prop_pair(const Station& s, RockMaterial material) {
    look_near(s);
    float top[2];
    Eigen::Vector3f head[2];
    for (const int k : {0, 1}) {
      const Eigen::Vector3f side = (k == 0 ? 1.0f : -1.0f) * s.aside;
      float wall = 1e9f;
      for (const float height : {0.6f, 1.2f, 1.8f})
        wall =
            std::min(wall, range_to_rock(s.place + Eigen::Vector3f(0, 0, height), side, 0.5f * s.width_m + kOpening_m));
      if (wall > 0.5f * s.width_m + 0.6f || wall < 0.32f * s.width_m) return;
      // In front of the pipes.
      head[k] = s.place + (wall - kPostRadius_m - 0.16f) * side + Eigen::Vector3f(0, 0, 1.0f);
      top[k] = 1.0f + range_to_rock(head[k], Eigen::Vector3f::UnitZ(), s.height_m + 1.0f);
      if (top[k] > s.height_m + 0.8f) return;
    }
    const int sides = material == RockMaterial::kTimber ? 8 : 4;
    const bool has_beam = std::min(top[0], top[1]) > kBeamHeight_m;
    const float beam = std::min(top[0], top[1]) - 0.12f;
    for (const int k : {0, 1}) {
      Eigen::Vector3f foot = head[k];
      foot.z() = s.place.z() - 0.2f;
      head[k].z() = s.place.z() + (has_beam ? beam - 0.05f : top[k] + 0.1f);
      add_tube({foot, head[k]}, kPostRadius_m, sides, material, mesh_);
    }
    if (!has_beam) return;
    const Eigen::Vector3f out = 0.25f * (head[0] - head[1]).normalized();
    const Eigen::Vector3f up(0.0f, 0.0f, 0.08f);
    add_tube({head[0] + out + up, head[1] - out + up}, kPostRadius_m, sides, material, mesh_);
  }

  void strew_stones() {
    for (std::size_t i = 0; i + 1 < passage_.axis.size(); ++i) {
      const Station s = station_at(i);
      const double expected = config_.stones_per_m2 * s.width_m * 0.5;
      const int count = static_cast<int>(expected) + (row_.chance(expected - std::floor(expected)) ? 1 : 0);
      if (count > 0) look_near(s);
      for (int k = 0; k < count; ++k) strew_stone(s);
    }
  }

  void strew_stone(const Station& s) {
    // More of them along the walls, where wheels do not push them aside.
    float across = row_.uniform(-1.0f, 1.0f);
    across = (across < 0.0f ? -1.0f : 1.0f) * std::pow(std::abs(across), 0.6f) * 0.46f * s.width_m;
    const Eigen::Vector3f ahead(s.aside.y(), -s.aside.x(), 0.0f);
    const Eigen::Vector3f above =
        s.place + across * s.aside + row_.uniform(-0.25f, 0.25f) * ahead + Eigen::Vector3f(0, 0, 0.7f);
    // Log-normal: the sum of three uniform numbers is near enough to a normal one.
    const float normal = row_.uniform(-1.0f, 1.0f) + row_.uniform(-1.0f, 1.0f) + row_.uniform(-1.0f, 1.0f);
    const float size = std::min(static_cast<float>(config_.stone_size_m) * std::exp(0.5f * normal), kStoneMax_m);
    const float floor = range_to_rock(above, -Eigen::Vector3f::UnitZ(), 1.4f);
    if (floor <= 0.0f || floor >= 1.4f) return;
    add_stone(above + Eigen::Vector3f(0, 0, 0.15f * size - floor), size, row_, mesh_);
  }

  const PassageField* field_;
  const CourseConfig& config_;
  const Passage& passage_;
  Rock rock_;
  SeededRow row_;
  PassageField::Candidates near_;
  Mesh mesh_;
};

}  // namespace

void add_fittings(const PassageField& field, const CourseConfig& config, const Layout& layout, Mesh& mesh) {
  std::vector<Mesh> fitted(layout.passages.size());
  tbb::parallel_for(std::size_t{0}, fitted.size(), [&](std::size_t i) {
    const std::uint32_t seed = hash_of(config.seed, static_cast<int>(i), 0, 0xf177u);
    fitted[i] = Outfitter(field, config, layout.passages[i], seed).fitted();
  });
  for (const Mesh& part : fitted) {
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& triangle : part.triangles) mesh.triangles.emplace_back(triangle.array() + base);
    mesh.materials.insert(mesh.materials.end(), part.materials.begin(), part.materials.end());
  }
}

}  // namespace adit::sim
