// The tree is walked once for all rays of a tile, near boxes first, and triangles are drawn with edge functions.
// Included by sight.inl.

/// How far x lies outside of an interval.
ADIT_LANE Floats outside(float x, const Floats& low, const Floats& high) {
  return greater(greater(low - x, x - high), Floats{});
}

/// Children in the pyramid that nothing nearer hides, and the squared distances of their boxes.
std::uint32_t children_in_sight(const Sight& s, const TreeNode& node, float farthest2_inverse, Floats& distance2) {
  const Way o = s.origin;
  Ints flags = Ints{} - 1;
  for (const Way& n : s.side) {
    const Floats& x = floats_at(n.x >= 0.0f ? node.high[0] : node.low[0]);
    const Floats& y = floats_at(n.y >= 0.0f ? node.high[1] : node.low[1]);
    const Floats& z = floats_at(n.z >= 0.0f ? node.high[2] : node.low[2]);
    flags &= n.x * (x - o.x) + n.y * (y - o.y) + n.z * (z - o.z) >= -kPlaceSlack_m;
  }
  const Floats x = outside(o.x, floats_at(node.low[0]), floats_at(node.high[0]));
  const Floats y = outside(o.y, floats_at(node.low[1]), floats_at(node.high[1]));
  const Floats z = outside(o.z, floats_at(node.low[2]), floats_at(node.high[2]));
  distance2 = x * x + y * y + z * z;
  flags &= distance2 * farthest2_inverse <= 1.001f;
  return bits_of(flags) & ((1u << node.count) - 1u);
}

/// A place in each lane.
struct Ways {
  Floats x, y, z;
};
ADIT_LANE Floats dot(const Way& a, const Ways& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// (a - b) x (a + b) = 2 a x b, and exactly its negative with a and b swapped. Far from the origin it is as sharp as
/// near by, where the plain product loses the small difference of two long vectors.
ADIT_LANE Ways cross(const Ways& a, const Ways& b) {
  const Ways d{a.x - b.x, a.y - b.y, a.z - b.z}, m{a.x + b.x, a.y + b.y, a.z + b.z};
  return {d.y * m.z - d.z * m.y, d.z * m.x - d.x * m.z, d.x * m.y - d.y * m.x};
}

/// The triangles of a leaf seen from the origin: normals of the planes through it and each edge, three dots with which
/// are the barycentric coordinates. Neighbours share edges to the bit, so that no ray slips through between them.
struct EdgePlanes {
  // planes_of reads these ten as rows of floats.
  Ways n[3];       ///< against each corner
  Floats inverse;  ///< (sum of the three dots) * inverse is 1 / range
  Floats nearest;  ///< 1 / range is less than that
  Ints blocks;     ///< that may see it, a bit each
};

/// Pixels of a triangle lie in a rectangle of the grid: most triangles that are smaller than pixels hold no ray.
/// @param corner in the tile's frame, all before the lens.
void find_blocks(const Sight& s, const Ways corner[3], EdgePlanes& e) {
  Floats x_low, x_high, y_low, y_high;
  for (int k = 0; k < 3; ++k) {
    const Floats inverse = 1.0f / corner[k].z;
    const Floats x = corner[k].x * inverse, y = corner[k].y * inverse;
    e.nearest = k == 0 ? inverse : greater(e.nearest, inverse);
    x_low = k == 0 ? x : lesser(x_low, x);
    x_high = k == 0 ? x : greater(x_high, x);
    y_low = k == 0 ? y : lesser(y_low, y);
    y_high = k == 0 ? y : greater(y_high, y);
  }
  // First and last column and row, by rounding down of numbers that are made positive by an offset.
  constexpr float kOffset = 64.0f;
  constexpr int kOff = 64;
  const auto down_from = [](const Floats& x, int last) {
    return truncated(lesser(greater(x + kOffset, all_of(kOffset - 1.0f)), all_of(static_cast<float>(last + kOff))));
  };
  const auto up_from = [](const Floats& x, int end) {
    return kOff - truncated(lesser(greater(kOffset - x, all_of(static_cast<float>(kOff - end))), all_of(kOffset)));
  };
  const Ints u0 = up_from((x_low - (s.x_first + s.x_high + kSlopeSlack)) * s.columns_per_x, kTileWidth);
  const Ints u1 = down_from((x_high - (s.x_first + s.x_low - kSlopeSlack)) * s.columns_per_x, kTileWidth - 1) - kOff;
  const Ints v0 = up_from((y_low - (s.y_first + s.y_high + kSlopeSlack)) * s.rows_per_y, kTileHeight);
  const Ints v1 = down_from((y_high - (s.y_first + s.y_low - kSlopeSlack)) * s.rows_per_y, kTileHeight - 1) - kOff;
  const Ints columns = ((Ints{} + 0xff) << (u0 >> 2)) & (((Ints{} + 2) << (u1 >> 2)) - 1);
  e.blocks = ((columns & (v0 < kBlock)) | ((columns << 8) & (v1 >= kBlock))) & (u0 <= u1) & (v0 <= v1);
}

/// The same for leaves beside the lens, where slopes mean nothing: all blocks, where the tile's pyramid is reached.
void find_blocks_beside(const Sight& s, const Ways corner[3], EdgePlanes& e) {
  e.nearest = all_of(1e30f);
  e.blocks = Ints{} + 0xffff;
  for (const Way& n : s.side)
    e.blocks &= greater(greater(dot(n, corner[0]), dot(n, corner[1])), dot(n, corner[2])) >= -kPlaceSlack_m;
}

void make_planes(const Ways corner[3], EdgePlanes& e) {
  e.n[0] = cross(corner[1], corner[2]);
  e.n[1] = cross(corner[2], corner[0]);
  e.n[2] = cross(corner[0], corner[1]);
  const Floats volume = corner[0].x * e.n[0].x + corner[0].y * e.n[0].y + corner[0].z * e.n[0].z;
  const Floats side = volume < 0.0f ? all_of(-1.0f) : all_of(1.0f);
  const Floats size = volume * side;
  e.inverse = size > 1e-20f ? 1.0f / size : Floats{};  // 0: seen edge on, never hit
  for (Ways& n : e.n) n = {n.x * side, n.y * side, n.z * side};
}

/// One triangle of EdgePlanes, in all lanes.
struct TrianglePlanes {
  Ways n[3];
  Floats inverse;
  Ints triangle;
};

ADIT_LANE TrianglePlanes planes_of(const EdgePlanes& e, int j, std::int32_t triangle) {
  // Plain floats, so that all are read off one address.
  const float* const lane = reinterpret_cast<const float*>(&e) + j;
  const auto all = [lane](int field) { return all_of(lane[field * kTreeWidth]); };
  return {{{all(0), all(1), all(2)}, {all(3), all(4), all(5)}, {all(6), all(7), all(8)}}, all(9), Ints{} + triangle};
}

ADIT_LANE void draw_in_block(Sight& s, const TrianglePlanes& p, int block) {
  constexpr float kNearest_1_m = 1.0f / 0.02f;  // nothing nearer than that is seen
  const int first = block * kPacketLanes;
  const Floats x = floats_at(s.dx + first), y = floats_at(s.dy + first), z = floats_at(s.dz + first);
  Floats& nearest = floats_at(s.nearest + first);
  Ints& owner = ints_at(s.triangle + first);
  const Floats a = x * p.n[0].x + y * p.n[0].y + z * p.n[0].z;
  const Floats b = x * p.n[1].x + y * p.n[1].y + z * p.n[1].z;
  const Floats c = x * p.n[2].x + y * p.n[2].y + z * p.n[2].z;
  const Floats here = (a + b + c) * p.inverse;
  const Ints hit = (a >= 0.0f) & (b >= 0.0f) & (c >= 0.0f) & (here > nearest) & (here < kNearest_1_m);
  nearest = hit ? here : nearest;
  owner = hit ? p.triangle : owner;
}

void draw_leaf(Sight& s, const TreeLeaf& leaf) {
  EdgePlanes e;
  Ways corner[3], own[3];
  Ints ahead = Ints{} - 1;
  for (int k = 0; k < 3; ++k) {
    corner[k] = {floats_at(leaf.corner[k][0]) - s.origin.x, floats_at(leaf.corner[k][1]) - s.origin.y,
                 floats_at(leaf.corner[k][2]) - s.origin.z};
    own[k] = {dot(s.right, corner[k]), dot(s.down, corner[k]), dot(s.forward, corner[k])};
    ahead &= own[k].z > kBeside_m;
  }
  if (bits_of(ahead) == 0xffffu)
    find_blocks(s, own, e);
  else
    find_blocks_beside(s, corner, e);
  std::uint32_t left = bits_of(e.blocks != 0) & ((1u << leaf.count) - 1u);
  if (left == 0) return;
  make_planes(corner, e);
  for (; left != 0; left &= left - 1) {
    const int j = __builtin_ctz(left);
    const float nearest = lane_of(e.nearest, j) * 1.0001f;
    const TrianglePlanes planes = planes_of(e, j, leaf.triangle[j]);
    for (auto blocks = static_cast<std::uint32_t>(lane_of(e.blocks, j)); blocks != 0; blocks &= blocks - 1) {
      const int block = __builtin_ctz(blocks);
      if (nearest < s.farthest[block]) continue;
      draw_in_block(s, planes, block);
      s.drawn |= 1u << block;
    }
  }
}

/// Brings `farthest` of blocks that were drawn to up to date.
void settle_farthest(Sight& s) {
  for (; s.drawn != 0; s.drawn &= s.drawn - 1) {
    const int block = __builtin_ctz(s.drawn);
    std::int32_t least = 0x7f7fffff;
    ADIT_LANES
    for (int i = 0; i < kPacketLanes; ++i) {
      const std::int32_t bits = float_to_bits(s.nearest[block * kPacketLanes + i]);
      least = bits < least ? bits : least;  // not negative: in order as integers, too
    }
    s.farthest[block] = bits_to_float(least);
  }
}

/// 1 / squared range of the farthest pixel; 0 while one has met nothing.
float farthest2_inverse(Sight& s) {
  settle_farthest(s);
  std::int32_t least = 0x7f7fffff;
  for (int b = 0; b < kBlocks; ++b) {
    const std::int32_t bits = float_to_bits(s.farthest[b]);
    least = bits < least ? bits : least;
  }
  const float inverse = bits_to_float(least);
  return inverse * inverse;
}

/// A tree of many megabytes lies far from the core: what is asked soon is sent for.
template <class Thing>
ADIT_LANE void send_for(const Thing* thing) {
  constexpr std::size_t kLine = 64;
  for (std::size_t at = 0; at < sizeof(Thing); at += kLine)
    __builtin_prefetch(reinterpret_cast<const char*>(thing) + at);
}

void draw_tree(Sight& s, const TreeNode* nodes, const TreeLeaf* leaves) {
  struct Entry {
    float distance2;
    std::int32_t child;
  };
  // Sixteen children a level, and levels are few: 16^7 leaves are more than memory holds.
  Entry stack[8 * kTreeWidth];
  int depth = 0;
  stack[depth++] = {0.0f, 0};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    const float hidden = farthest2_inverse(s);
    if (entry.distance2 * hidden > 1.001f) continue;
    if (entry.child < 0) {
      draw_leaf(s, leaves[~entry.child]);
      continue;
    }
    const TreeNode& node = nodes[entry.child];
    Floats distance2;
    const int first = depth;
    for (std::uint32_t left = children_in_sight(s, node, hidden, distance2); left != 0; left &= left - 1) {
      const int j = __builtin_ctz(left);
      const Entry next{distance2[j], node.child[j]};
      if (next.child < 0)
        send_for(leaves + ~next.child);
      else
        send_for(nodes + next.child);
      int at = depth++;  // the nearest ends on top
      for (; at > first && stack[at - 1].distance2 < next.distance2; --at) stack[at] = stack[at - 1];
      stack[at] = next;
    }
  }
}
