#include "surface_nets.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace adit::sim {
namespace {

constexpr int kSide = 8;  ///< cells along the edge of a block
constexpr int kCorners = kSide + 1;
constexpr std::uint16_t kNone = 0xffff;

using Key = Eigen::Vector3i;
using Triangle = Eigen::Matrix<std::uint32_t, 3, 1>;

struct KeyHash {
  std::size_t operator()(const Key& k) const noexcept { return hash_of(k.x(), k.y(), k.z(), 0u); }
};

/// A cube of cells. Its vertices are those of its own cells.
struct Block {
  Key key;
  PassageField::Candidates candidates;
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::uint16_t> vertex_of_cell;  ///< kSide^3, kNone where the surface does not pass; empty: no vertices
  std::vector<std::uint8_t> inside;           ///< kCorners^3: 1 in the rock
  std::uint32_t first_vertex = 0;
  std::vector<Triangle> triangles;
};

constexpr int corner_index(int x, int y, int z) { return (z * kCorners + y) * kCorners + x; }
constexpr int cell_index(int x, int y, int z) { return (z * kSide + y) * kSide + x; }

/// The blocks that may hold surface, in the order of their keys, each with the stretches near it.
class BlockGrid {
 public:
  BlockGrid(const PassageField& field, float block_m, float margin_m) : block_m_(block_m) {
    for (std::uint32_t i = 0; i < field.stretches().size(); ++i) {
      Eigen::Vector3f low, high;
      field.box_of(field.stretches()[i], margin_m, low, high);
      add_box(low, high, static_cast<int>(i));
    }
    for (const Mouth& mouth : field.mouths())
      if (mouth.has_apron) add_apron(mouth, field.apron_m());
    std::sort(blocks.begin(), blocks.end(), [](const Block& a, const Block& b) {
      return std::tie(a.key.z(), a.key.y(), a.key.x()) < std::tie(b.key.z(), b.key.y(), b.key.x());
    });
    reindex();
  }

  /// Throws empty blocks away.
  void compact() {
    std::erase_if(blocks, [](const Block& block) { return block.vertices.empty(); });
    reindex();
  }

  [[nodiscard]] const Block* find(const Key& key) const {
    const auto found = index_.find(key);
    return found == index_.end() ? nullptr : &blocks[found->second];
  }

  std::vector<Block> blocks;

 private:
  void reindex() {
    index_.clear();
    for (std::size_t i = 0; i < blocks.size(); ++i) index_[blocks[i].key] = i;
  }

  void add_box(const Eigen::Vector3f& low, const Eigen::Vector3f& high, int stretch) {
    const Key first = (low / block_m_).array().floor().cast<int>();
    const Key last = (high / block_m_).array().floor().cast<int>();
    for (int z = first.z(); z <= last.z(); ++z)
      for (int y = first.y(); y <= last.y(); ++y)
        for (int x = first.x(); x <= last.x(); ++x) {
          const auto [found, is_new] = index_.try_emplace(Key(x, y, z), blocks.size());
          if (is_new) blocks.emplace_back().key = Key(x, y, z);
          if (stretch >= 0) blocks[found->second].candidates.push_back(static_cast<std::uint32_t>(stretch));
        }
  }

  void add_apron(const Mouth& mouth, float apron_m) {
    const Eigen::Vector3f out(mouth.outward.x(), mouth.outward.y(), 0.0f);
    const Eigen::Vector3f aside(-out.y(), out.x(), 0.0f);
    const float up = std::max(mouth.height_m + 3.0f, 0.6f * apron_m);
    Eigen::Vector3f low = mouth.place, high = mouth.place;
    for (const float along : {-0.25f * up - 1.0f, apron_m})
      for (const float across : {-apron_m, apron_m}) {
        const Eigen::Vector3f corner = mouth.place + along * out + across * aside;
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
      }
    low.z() -= 1.0f;
    high.z() += up;
    add_box(low, high, -1);
  }

  float block_m_;
  std::unordered_map<Key, std::size_t, KeyHash> index_;
};

/// Samples the corners of a block and puts a vertex into each cell that the surface passes through.
class BlockSampler {
 public:
  BlockSampler(const PassageField& field, const CourseConfig& config)
      : field_(&field), rock_(field, config), cell_m_(static_cast<float>(config.cell_m)) {}

  void sample(Block& block) {
    const Eigen::Vector3f low = block.key.cast<float>() * (cell_m_ * kSide);
    const float half = 0.5f * cell_m_ * kSide;
    const Eigen::Vector3f centre = low + Eigen::Vector3f::Constant(half);
    const float radius = std::sqrt(3.0f) * half;
    field_->cull(centre, radius, block.candidates);
    const float distance = field_->at(centre, block.candidates).distance;
    if (std::abs(distance) > 1.3f * radius + rock_.reach_m() + cell_m_) return;
    const Eigen::Vector3f edge = Eigen::Vector3f::Constant(0.01f);
    rock_.prepare(low - edge, low + Eigen::Vector3f::Constant(2.0f * half) + edge, block.candidates);
    if (!sample_corners(block)) return;
    place_vertices(block);
  }

 private:
  [[nodiscard]] Eigen::Vector3f corner_place(const Block& block, int x, int y, int z) const {
    // From integers, so that two blocks give a corner they share the same bits.
    return (block.key * kSide + Eigen::Vector3i(x, y, z)).cast<float>() * cell_m_;
  }

  bool sample_corners(Block& block) {
    block.inside.resize(kCorners * kCorners * kCorners);
    bool any_rock = false;
    bool any_open = false;
    for (int z = 0; z < kCorners; ++z)
      for (int y = 0; y < kCorners; ++y)
        for (int x = 0; x < kCorners; ++x) {
          const auto i = static_cast<std::size_t>(corner_index(x, y, z));
          values_[i] = rock_.at(corner_place(block, x, y, z));
          block.inside[i] = values_[i] >= 0.0f ? 1 : 0;
          (block.inside[i] ? any_rock : any_open) = true;
        }
    return any_rock && any_open;
  }

  void place_vertices(Block& block) {
    block.vertex_of_cell.assign(kSide * kSide * kSide, kNone);
    for (int z = 0; z < kSide; ++z)
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
          Eigen::Vector3f within;
          if (!vertex_within(x, y, z, within)) continue;
          block.vertex_of_cell[static_cast<std::size_t>(cell_index(x, y, z))] =
              static_cast<std::uint16_t>(block.vertices.size());
          block.vertices.push_back(corner_place(block, x, y, z) + within * cell_m_);
        }
  }

  /// The mean of the places where the surface crosses the cell's edges, in cells.
  bool vertex_within(int x, int y, int z, Eigen::Vector3f& within) const {
    static constexpr std::array<std::array<int, 2>, 12> kEdges{
        {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
    std::array<float, 8> value;
    for (int c = 0; c < 8; ++c)
      value[static_cast<std::size_t>(c)] =
          values_[static_cast<std::size_t>(corner_index(x + (c & 1), y + ((c >> 1) & 1), z + (c >> 2)))];
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    int crossings = 0;
    for (const auto& edge : kEdges) {
      const auto a = static_cast<std::size_t>(edge[0]);
      const auto b = static_cast<std::size_t>(edge[1]);
      if ((value[a] >= 0.0f) == (value[b] >= 0.0f)) continue;
      const float t = value[a] / (value[a] - value[b]);
      const Eigen::Vector3f from(static_cast<float>(a & 1), static_cast<float>((a >> 1) & 1),
                                 static_cast<float>(a >> 2));
      const Eigen::Vector3f to(static_cast<float>(b & 1), static_cast<float>((b >> 1) & 1), static_cast<float>(b >> 2));
      sum += from + t * (to - from);
      ++crossings;
    }
    if (crossings == 0) return false;
    within = sum / static_cast<float>(crossings);
    return true;
  }

  const PassageField* field_;
  Rock rock_;
  float cell_m_;
  std::array<float, kCorners * kCorners * kCorners> values_{};
};

/// Joins the vertices round each edge that the surface crosses to two triangles.
class BlockStitcher {
 public:
  BlockStitcher(const BlockGrid& grid, const std::vector<Eigen::Vector3f>& vertices)
      : grid_(&grid), vertices_(&vertices) {}

  void stitch(Block& block) {
    for (int dz = 0; dz < 2; ++dz)
      for (int dy = 0; dy < 2; ++dy)
        for (int dx = 0; dx < 2; ++dx)
          near_[static_cast<std::size_t>(dz * 4 + dy * 2 + dx)] = grid_->find(block.key - Key(dx, dy, dz));
    for (int z = 0; z < kSide; ++z)
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
          for (int axis = 0; axis < 3; ++axis) stitch_edge(block, Key(x, y, z), axis);
  }

 private:
  /// The vertex of a cell whose coordinates may be -1 (a neighbour's), or false.
  bool vertex_of(const Key& cell, std::uint32_t& vertex) const {
    const Key over = (cell.array() < 0).cast<int>();
    const Block* block = near_[static_cast<std::size_t>(over.z() * 4 + over.y() * 2 + over.x())];
    if (block == nullptr || block->vertex_of_cell.empty()) return false;
    const Key own = cell + kSide * over;
    const std::uint16_t local = block->vertex_of_cell[static_cast<std::size_t>(cell_index(own.x(), own.y(), own.z()))];
    if (local == kNone) return false;
    vertex = block->first_vertex + local;
    return true;
  }

  void stitch_edge(Block& block, const Key& corner, int axis) {
    Key along = Key::Zero();
    along[axis] = 1;
    const Key far = corner + along;
    const bool from_rock =
        block.inside[static_cast<std::size_t>(corner_index(corner.x(), corner.y(), corner.z()))] != 0;
    const bool to_rock = block.inside[static_cast<std::size_t>(corner_index(far.x(), far.y(), far.z()))] != 0;
    if (from_rock == to_rock) return;
    Key u = Key::Zero();
    Key v = Key::Zero();
    u[(axis + 1) % 3] = 1;
    v[(axis + 2) % 3] = 1;
    std::array<std::uint32_t, 4> ring;
    // Counter-clockwise seen from the far end of the edge.
    if (!vertex_of(corner, ring[0]) || !vertex_of(corner - u, ring[1]) || !vertex_of(corner - u - v, ring[2]) ||
        !vertex_of(corner - v, ring[3]))
      return;
    if (!from_rock) std::swap(ring[1], ring[3]);  // open at the near end: seen from there
    add_quad(block, ring);
  }

  void add_quad(Block& block, const std::array<std::uint32_t, 4>& r) const {
    const auto& v = *vertices_;
    // The shorter diagonal follows creases better.
    if ((v[r[0]] - v[r[2]]).squaredNorm() <= (v[r[1]] - v[r[3]]).squaredNorm()) {
      block.triangles.emplace_back(r[0], r[1], r[2]);
      block.triangles.emplace_back(r[0], r[2], r[3]);
    } else {
      block.triangles.emplace_back(r[1], r[2], r[3]);
      block.triangles.emplace_back(r[1], r[3], r[0]);
    }
  }

  const BlockGrid* grid_;
  const std::vector<Eigen::Vector3f>* vertices_;
  std::array<const Block*, 8> near_{};
};

template <class Worker, class Action>
void for_blocks(std::vector<Block>& blocks, const Worker& worker, Action&& action) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks.size(), 16), [&](const auto& range) {
    Worker own = worker;
    for (std::size_t i = range.begin(); i != range.end(); ++i) action(own, blocks[i]);
  });
}

/// What each triangle of a block is made of; triangles beyond a mouth are dropped.
void finish(Block& block, const PassageField& field, const CourseConfig& config, const Mesh& mesh,
            std::vector<std::uint8_t>& materials) {
  std::size_t kept = 0;
  for (const Triangle& triangle : block.triangles) {
    const Eigen::Vector3f& a = mesh.vertices[triangle[0]];
    const Eigen::Vector3f& b = mesh.vertices[triangle[1]];
    const Eigen::Vector3f& c = mesh.vertices[triangle[2]];
    const Eigen::Vector3f middle = (a + b + c) / 3.0f;
    if (field.is_outside(middle)) continue;
    const Eigen::Vector3f normal = (b - a).cross(c - a).normalized();
    const float above_floor = field.at(middle, block.candidates).above_floor;
    materials.push_back(
        static_cast<std::uint8_t>(material_at(middle, above_floor, normal.z(), static_cast<float>(config.wet_fraction),
                                              mixed(static_cast<std::uint32_t>(config.seed)))));
    block.triangles[kept++] = triangle;
  }
  block.triangles.resize(kept);
}

/// Leaves out vertices that no triangle uses.
void drop_unused(Mesh& mesh) {
  std::vector<std::uint32_t> place(mesh.vertices.size(), 0);
  for (const Triangle& triangle : mesh.triangles)
    for (int i = 0; i < 3; ++i) place[triangle[i]] = 1;
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (place[i] == 0) continue;
    mesh.vertices[kept] = mesh.vertices[i];
    place[i] = kept++;
  }
  mesh.vertices.resize(kept);
  for (Triangle& triangle : mesh.triangles)
    for (int i = 0; i < 3; ++i) triangle[i] = place[triangle[i]];
}

}  // namespace

Mesh mesh_of(const PassageField& field, const CourseConfig& config) {
  const auto cell_m = static_cast<float>(config.cell_m);
  const BlockSampler sampler(field, config);
  const float margin = Rock(field, config).reach_m() + static_cast<float>(config.blend_m) + 3.0f * cell_m;
  BlockGrid grid(field, cell_m * kSide, margin);
  for_blocks(grid.blocks, sampler, [](BlockSampler& own, Block& block) { own.sample(block); });
  grid.compact();

  Mesh mesh;
  for (Block& block : grid.blocks) {
    block.first_vertex = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), block.vertices.begin(), block.vertices.end());
  }
  const BlockStitcher stitcher(grid, mesh.vertices);
  for_blocks(grid.blocks, stitcher, [](BlockStitcher& own, Block& block) { own.stitch(block); });
  std::vector<std::vector<std::uint8_t>> materials(grid.blocks.size());
  tbb::parallel_for(std::size_t{0}, grid.blocks.size(),
                    [&](std::size_t i) { finish(grid.blocks[i], field, config, mesh, materials[i]); });
  for (std::size_t i = 0; i < grid.blocks.size(); ++i) {
    const Block& block = grid.blocks[i];
    mesh.triangles.insert(mesh.triangles.end(), block.triangles.begin(), block.triangles.end());
    mesh.materials.insert(mesh.materials.end(), materials[i].begin(), materials[i].end());
  }
  drop_unused(mesh);
  return mesh;
}

}  // namespace adit::sim
