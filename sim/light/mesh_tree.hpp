// The mesh as a whole tile of pixels asks it: which triangles lie in this thin pyramid, the near ones first?
#pragma once

#include <cstdint>
#include <vector>

namespace adit::sim {

struct Mesh;  // no header with code here: this one is compiled for several CPUs

/// Sixteen children wide, as vector units are.
inline constexpr int kTreeWidth = 16;

struct alignas(64) TreeNode {
  float low[3][kTreeWidth], high[3][kTreeWidth];  ///< boxes of the children
  std::int32_t child[kTreeWidth];                 ///< node, or ~leaf
  std::int32_t count;
};

/// Triangles that lie together. Unused lanes repeat the first.
struct alignas(64) TreeLeaf {
  float corner[3][3][kTreeWidth];  ///< [corner][axis]
  std::int32_t triangle[kTreeWidth];
  std::int32_t count;
};

/// Embree answers rays; it cannot be asked for a pyramid of them at once. Where triangles are as small as pixels, to
/// draw the few that a tile sees costs a fifth of its 256 rays. The same mesh makes the same tree.
struct MeshTree {
  std::vector<TreeNode> nodes;  ///< the first is the root
  std::vector<TreeLeaf> leaves;
};

/// @param mesh with a triangle at least.
MeshTree mesh_tree_of(const Mesh& mesh);

}  // namespace adit::sim
