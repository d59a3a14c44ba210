#include "mesh_tree.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "adit/sim/world.hpp"

namespace adit::sim {
namespace {

using Eigen::Vector3f;
using Part = std::span<std::uint32_t>;

struct Box {
  Vector3f low = Vector3f::Constant(1e30f), high = Vector3f::Constant(-1e30f);
  void add(const Vector3f& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
};

class TreeMaker {
 public:
  explicit TreeMaker(const Mesh& mesh) : mesh_(mesh), middles_(mesh.triangles.size()), order_(mesh.triangles.size()) {
    for (std::size_t i = 0; i < middles_.size(); ++i)
      middles_[i] = mesh.vertices[mesh.triangles[i][0]] + mesh.vertices[mesh.triangles[i][1]] +
                    mesh.vertices[mesh.triangles[i][2]];
    std::iota(order_.begin(), order_.end(), 0u);
  }

  MeshTree made() {
    add_node(order_);
    return std::move(tree_);
  }

 private:
  [[nodiscard]] Box box_of(Part part) const {
    Box box;
    for (const std::uint32_t t : part)
      for (int k = 0; k < 3; ++k) box.add(mesh_.vertices[mesh_.triangles[t][k]]);
    return box;
  }

  static std::size_t leaves_in(Part part) { return (part.size() + kTreeWidth - 1) / kTreeWidth; }

  /// In two along the longest side, at a whole number of `unit` leaves.
  std::pair<Part, Part> halves_of(Part part, std::size_t unit) {
    Box box;
    for (const std::uint32_t t : part) box.add(middles_[t]);
    int axis = 0;
    (box.high - box.low).maxCoeff(&axis);
    const std::size_t units = (leaves_in(part) + unit - 1) / unit;
    const std::size_t half = (units + 1) / 2 * unit * kTreeWidth;
    std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                       const float x = middles_[a][axis], y = middles_[b][axis];
                       return x < y || (x == y && a < b);
                     });
    return {part.first(half), part.subspan(half)};
  }

  std::int32_t add_leaf(Part part) {
    TreeLeaf leaf{};
    leaf.count = static_cast<std::int32_t>(part.size());
    for (std::size_t j = 0; j < kTreeWidth; ++j) {
      const std::uint32_t t = part[j < part.size() ? j : 0];
      leaf.triangle[j] = static_cast<std::int32_t>(t);
      for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 3; ++axis) leaf.corner[k][axis][j] = mesh_.vertices[mesh_.triangles[t][k]][axis];
    }
    tree_.leaves.push_back(leaf);
    return ~static_cast<std::int32_t>(tree_.leaves.size() - 1);
  }

  std::int32_t add_node(Part part) {
    // Children are whole trees of one level less, so that the last level, which most walks come to, is full.
    std::size_t unit = 1;
    while (unit * kTreeWidth < leaves_in(part)) unit *= kTreeWidth;
    std::vector<Part> parts = {part};
    for (int level = 1; level < kTreeWidth; level *= 2) {
      std::vector<Part> next;
      for (const Part p : parts) {
        if (leaves_in(p) <= unit) {
          next.push_back(p);
          continue;
        }
        const auto [left, right] = halves_of(p, unit);
        next.push_back(left);
        next.push_back(right);
      }
      parts = std::move(next);
    }
    const std::size_t place = tree_.nodes.size();
    tree_.nodes.emplace_back();
    TreeNode node{};
    node.count = static_cast<std::int32_t>(parts.size());
    for (std::size_t j = 0; j < kTreeWidth; ++j) {
      const Box box = box_of(parts[j < parts.size() ? j : 0]);
      for (int axis = 0; axis < 3; ++axis) {
        node.low[axis][j] = box.low[axis];
        node.high[axis][j] = box.high[axis];
      }
      if (j < parts.size()) node.child[j] = parts[j].size() <= kTreeWidth ? add_leaf(parts[j]) : add_node(parts[j]);
    }
    tree_.nodes[place] = node;
    return static_cast<std::int32_t>(place);
  }

  const Mesh& mesh_;
  std::vector<Vector3f> middles_;  ///< three times the middle of each triangle
  std::vector<std::uint32_t> order_;
  MeshTree tree_;
};

}  // namespace

MeshTree mesh_tree_of(const Mesh& mesh) { return TreeMaker(mesh).made(); }

}  // namespace adit::sim
