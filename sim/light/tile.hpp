// A block of pixels on its way through the shading loops, as structure of arrays.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace adit::sim {

inline constexpr int kTileWidth = 32;
inline constexpr int kTileHeight = 8;
inline constexpr int kTileLanes = kTileWidth * kTileHeight;
inline constexpr int kBlock = 4;  ///< px; blocks of 4 x 4 are cast as one packet, and ask for shadows together
inline constexpr int kBlocks = kTileLanes / (kBlock * kBlock);
/// First lane of each block.
inline constexpr std::array<int, kBlocks> kBlockLanes = [] {
  std::array<int, kBlocks> lanes{};
  for (int b = 0; b < kBlocks; ++b)
    lanes[static_cast<std::size_t>(b)] = b * kBlock / kTileWidth * kBlock * kTileWidth + b * kBlock % kTileWidth;
  return lanes;
}();
inline constexpr int kBlurRun_px = 8;
inline constexpr float kNoRange_m = 1e9f;  ///< of rays that meet nothing
inline constexpr int kMaterialsMax = 256;
inline constexpr int kLampsMax = 16;

/// Where camera and lamps are while a row of pixels is exposed (rolling shutter).
struct RowPose {
  float rotation[9];  ///< optical frame to world, row major
  float place[3];     ///< of the lens
  float lamp_place[kLampsMax][3];
  float lamp_axis[kLampsMax][3];
};

/// What the rays of a tile met. triangle < 0: nothing.
struct alignas(64) TileHits {
  using Lane = float[kTileLanes];
  Lane range, bu, bv;
  std::int32_t triangle[kTileLanes];
  std::uint32_t even_blocks;  ///< blocks through which the surface goes on without an edge, a bit each
  bool any;
};

struct Tile : TileHits {
  // View: unit direction in the world.
  Lane dx, dy, dz;
  std::int32_t material[kTileLanes];
  Lane gx, gy, gz;
  // Surface: place, normal with facets, geometric normal turned to the eye (gx, gy, gz), reflectance.
  Lane px, py, pz, nx, ny, nz;
  Lane albedo, red, blue, specular, shininess, emission, slope;
  // Light gathered so far: irradiance (lux) and specular luminance (cd/m^2), by colour of source.
  Lane own, own_specular, foreign, foreign_specular, sky;
  // Indirect light of quads (2 x 2 pixels), row by row: by colour of source, a vector whose product with a normal that
  // faces the light is lux.
  static constexpr int kQuads = kTileLanes / 4;
  float soft[3][3][kQuads];
  // One lamp's share, before its shadows are known.
  Lane share, share_specular;
  float origin[kTileHeight][3];  ///< of the rays of each row; last, so that lanes stay aligned
};

/// Reflectance of the world's materials, an array a field so that lanes can gather.
struct MaterialTable {
  float albedo[kMaterialsMax], sigma[kMaterialsMax], patch_1_m[kMaterialsMax];
  float specular[kMaterialsMax], shininess[kMaterialsMax], emission[kMaterialsMax];
  float facet_slope[kMaterialsMax], facet_1_m[kMaterialsMax];
  float red[kMaterialsMax], blue[kMaterialsMax];
};

/// One triangle of the mesh, in two cache lines.
struct alignas(64) TriangleRow {
  float corner[3];       ///< the first, m
  float side_1[3];       ///< from the first corner to the second
  float side_2[3];       ///< to the third
  float normal[3];       ///< side_1 x side_2, not normalised
  float normals[9];      ///< unit, at each corner
  float reflectance[9];  ///< albedo, specular, facet_slope at each corner
  std::int32_t material;
  float unused;
};
inline constexpr int kRowFloats = sizeof(TriangleRow) / sizeof(float);
static_assert(kRowFloats == 32);

/// What the surface loop needs besides the tile.
struct SurfaceTerms {
  const MaterialTable* materials;
  const TriangleRow* triangles;
  float pixel_angle;  ///< rad
  bool facets;
};

/// One lamp as the lamp loop sees it. Place and axis are given per row of the tile.
struct LampTerms {
  const float* places;  ///< 3 floats a row, row_stride apart
  const float* axes;
  int row_stride;
  const float* lobe;  ///< LampLobe::table()
  float intensity_cd;
  float radius2_m2;  ///< added to the squared distance: a lamp is no point
  float extinction_1_m;
};

/// Light reflected once, as a point that shines with the cosine of its normal.
struct VirtualLight {
  float place[3];
  float normal[3];
  float power;  ///< E = power * cos * cos / d^2: flux * albedo / pi
  int colour;   ///< 0 own, 1 foreign, 2 sky
};

/// Backscatter of the own lamps by (node of a grid over the image, range).
struct BackscatterTable {
  static constexpr int kNodesX = 33, kNodesY = 25, kBins = 48;
  static constexpr float kRangeScale_m = 1.5f;  ///< bins are even in r / (r + scale)
  float luminance[kNodesY][kNodesX][kBins + 1];
};

struct ComposeTerms {
  float own_red, own_blue, foreign_red, foreign_blue, sky_red, sky_blue;
  float extinction_1_m;
  float sky_luminance;
  const BackscatterTable* backscatter;  ///< may be null
  float node_u, node_v;                 ///< nodes a pixel
  int u0, v0;
};

/// The frame as a lamp beside the lens sees it, laid out so that what could stand in the light of a place lies after it
/// in the same line. See lamp_parallax.cpp.
struct ParallaxTable {
  int steps = 0;  ///< along a line, the last nearest to the lamp's side
  int lines = 0;  ///< a whole number of kTreeWidth
  // [line / kTreeWidth][steps - 1 - step][line % kTreeWidth]: in the order in which lines are walked.
  std::vector<std::int32_t> pixel;  ///< which pixel's range counts there; -1: none
  std::vector<float> shift_m;       ///< steps of parallax times range
  std::vector<std::int32_t> block;  ///< 4 * the first block the pixel or a neighbour lies in, + 1 and + 2 where they
                                    ///< reach into the next one to the right and below
  std::vector<float> edge;          ///< [line]: steps less the parallax of what may stand just beyond the image
};

/// The loops, compiled once per kind of CPU. Every kind gives the same bits.
struct ShadeKernels {
  const char* target;
  /// @param directions optical frame, [axis][lane].
  void (*aim)(Tile&, const RowPose* rows, const float* directions);
  /// Fills TileHits. @param axes RowPose::rotation of the tile's middle row.
  void (*see)(Tile&, const float* axes, const struct TreeNode*, const struct TreeLeaf*, const TriangleRow*);
  void (*surface)(Tile&, const SurfaceTerms&);
  void (*lamp)(Tile&, const LampTerms&);
  /// Adds to Tile::soft.
  void (*virtual_lights)(Tile&, const VirtualLight*, int count, float clamp_m2, float extinction_1_m);
  /// Adds Tile::soft to own, foreign and sky, by the normal of each pixel; colours that have none may be left out.
  void (*soft_light)(Tile&, bool own, bool foreign, bool sky);
  void (*blur_row)(const struct BlurRow&);
  void (*compose)(Tile&, const ComposeTerms&, float* const planes[3], int stride);
  /// Marks blocks of the frame, `across` in a row, in which light may be blocked: kTreeWidth lines from first_line on.
  void (*parallax)(const ParallaxTable&, int first_line, const float* range, int across, std::uint8_t* blocks);
  /// Sensor: one row of the mosaic. See sensor_rows.hpp.
  void (*mosaic_row)(const struct MosaicRow&);
  void (*tone_row)(const struct ToneRow&);
};

/// Those chosen, else the widest that this CPU has.
[[nodiscard]] const ShadeKernels& shade_kernels() noexcept;
/// Names of the targets this CPU runs, narrowest first.
[[nodiscard]] std::vector<const char*> shade_targets();
/// For tests: all frames from now on use this target. @return false where there is none of that name.
bool choose_shade_target(std::string_view name);

}  // namespace adit::sim
