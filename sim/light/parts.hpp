// What a Renderer is made of; shared by its passes.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <memory>
#include <vector>

#include "adit/sim/render.hpp"
#include "mesh_tree.hpp"
#include "tile.hpp"

namespace adit::sim {

/// A lamp that does not sit on the vehicle, or a piece of the bright mouth of the tunnel.
struct ForeignLamp {
  Eigen::Vector3f place, axis;
  LampLobe lobe;
  float intensity_cd;
  float radius_m;
  bool daylight;  ///< a piece of the mouth: no emitter to be seen, colour of the sky
};

/// A lamp of the rig in the optical frame.
struct OwnLamp {
  Eigen::Vector3f place, axis;
  LampLobe lobe;
  float intensity_cd;
  ParallaxTable parallax;  ///< no lines: the lamp does not stand beside the lens
};

/// Where the camera is in the middle of the exposure and how it moves, in its own frame.
struct CameraMotion {
  Eigen::Isometry3f pose;           ///< optical frame to world
  Eigen::Vector3f velocity_m_s;     ///< optical frame
  Eigen::Vector3f turn_rate_rad_s;  ///< optical frame
  float white_luminance;            ///< cd/m^2 that saturates the sensor at this exposure
};

/// Tables of the sensor, made once.
struct SensorTables {
  std::vector<float> sensitivity, offset_e, gauss;
  std::vector<std::int32_t> tone;  ///< bytes
};

struct Renderer::Parts {
  const World* world = nullptr;
  RigConfig rig;
  RenderConfig render;
  std::shared_ptr<const RayScene> scene;
  std::unique_ptr<Camera> camera;
  std::unique_ptr<tbb::task_arena> arena;           ///< null: one thread
  int width = 0, height = 0, stride = 0, rows = 0;  ///< stride and rows are rounded up to whole tiles
  float pixel_angle = 0.0f;
  std::vector<float> directions;      ///< [tile][axis][lane], optical frame, unit: as tiles ask for them
  std::vector<float> run_directions;  ///< [row][axis][run]: of the middle of each kBlurRun_px pixels
  std::vector<TriangleRow> triangles;
  MeshTree tree;
  MaterialTable materials{};
  std::vector<OwnLamp> own_lamps;
  std::vector<ForeignLamp> foreign_lamps;
  std::vector<VirtualLight> foreign_bounces;
  std::vector<Eigen::Vector3f> mouths;
  std::unique_ptr<BackscatterTable> backscatter;
  SensorTables sensor;
  std::vector<float> dirt_passed;  ///< share of the light that passes the glass, of each pixel; empty: clean
  // Of the frame under work.
  bool lamps_on = true;  ///< the rig's
  std::vector<float> planes[3], blurred[3], range, mosaic;
  std::vector<VirtualLight> bounces;
  std::vector<RowPose> row_poses;
  std::vector<TileHits> hits;                          ///< of each tile
  std::vector<std::vector<std::uint8_t>> dark_blocks;  ///< of each own lamp: 1 where a block may have shadow

  /// The ray of a pixel, which may lie beyond the image up to a whole tile: then that of the nearest.
  [[nodiscard]] Eigen::Vector3f ray_of(int u, int v) const {
    const int tile = v / kTileHeight * (stride / kTileWidth) + u / kTileWidth;
    const float* const d =
        &directions[static_cast<std::size_t>(tile) * 3 * kTileLanes + (v % kTileHeight) * kTileWidth + u % kTileWidth];
    return {d[0], d[kTileLanes], d[2 * kTileLanes]};
  }

  [[nodiscard]] int threads() const { return arena ? arena->max_concurrency() : 1; }

  /// body(i) for i in [0, count): on all threads of the arena, in any order.
  template <class Body>
  void each(int count, const Body& body) const {
    if (!arena) {
      for (int i = 0; i < count; ++i) body(i);
      return;
    }
    arena->execute([&] {
      tbb::parallel_for(tbb::blocked_range<int>(0, count), [&](const tbb::blocked_range<int>& r) {
        for (int i = r.begin(); i < r.end(); ++i) body(i);
      });
    });
  }
};

// Made once.
std::vector<TriangleRow> triangle_table_of(const World& world);
MaterialTable material_table_of(const World& world);
std::vector<ForeignLamp> foreign_lamps_of(const World& world, const RayScene& scene);
std::vector<VirtualLight> bounces_of_foreign(const World& world, const RayScene& scene,
                                             const std::vector<ForeignLamp>& lamps, float extinction_1_m);
std::unique_ptr<BackscatterTable> backscatter_of(const std::vector<OwnLamp>& lamps, const DustConfig& dust,
                                                 const Camera& camera, int stride, int rows);
/// @param lamp in the optical frame.
ParallaxTable parallax_of(const Eigen::Vector3f& lamp, const Renderer::Parts& parts);
SensorTables sensor_tables_of(const Renderer::Parts& parts);
std::vector<float> dirt_passed_of(const Renderer::Parts& parts);

/// Where light of one lamp lands first: `count` points of a Fibonacci lattice over the lobe.
/// @param pose lamp's frame (z along the axis) to world.
void add_bounces(std::vector<VirtualLight>& lights, const World& world, const RayScene& scene,
                 const Eigen::Isometry3f& pose, const LampLobe& lobe, float intensity_cd, int count,
                 float extinction_1_m, int colour);

/// Takes the shares of the lamp that was asked last over where nothing stands between; blocks of pixels whose shares
/// all lie below least_lux are dropped. No ray is cast in blocks that are not in `doubtful`, a bit each.
void add_unshadowed(Tile& tile, const Renderer::Parts& parts, const LampTerms& lamp, float least_lux,
                    std::uint32_t doubtful, float* into, float* specular_into);

// The passes, in order.
void light_pass(Renderer::Parts& parts, const CameraMotion& motion, float readout_s);
void lens_pass(Renderer::Parts& parts, const CameraMotion& motion, const Shot& shot);
void grains_pass(Renderer::Parts& parts, const CameraMotion& motion, const Shot& shot);
void dirt_pass(Renderer::Parts& parts);
void sensor_pass(Renderer::Parts& parts, const Shot& shot, Frame& frame);
void jpeg_pass(const Renderer::Parts& parts, Frame& frame);

}  // namespace adit::sim
