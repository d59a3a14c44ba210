// What a tile of pixels sees: the tree is walked once for all its rays, near boxes first, and triangles are drawn with
// edge functions. Included by shade_kernels.cpp.

struct Way {
  float x, y, z;
};
ADIT_LANE float dot(const Way& a, const Way& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// A tile's pyramid of rays, and what they have met.
struct alignas(64) Sight {
  // Rays and what they have met, block by block: 1 / range of the nearest so far, 0 for nothing.
  float dx[kTileLanes], dy[kTileLanes], dz[kTileLanes], nearest[kTileLanes];
  std::int32_t triangle[kTileLanes];
  float farthest[kBlocks];  ///< least of `nearest` in each block
  std::uint32_t drawn;      ///< blocks whose `farthest` waits to be brought up to date, a bit each
  Way origin;
  // The optical frame of the tile's middle row. All zero where the rays do not make a grid: then nothing is culled.
  Way right, down, forward;
  Way side[4];  ///< planes through the origin, the pyramid inside: p * n >= 0
  // In this frame a ray runs through (x, y, 1), and that of pixel (u, v) lies within (x_low, x_high) of x_first +
  // u * step; so that from an interval of x follows which columns it may hold.
  float x_first, x_low, x_high, columns_per_x;
  float y_first, y_low, y_high, rows_per_y;
};

/// Rounding: of places, m, up to a kilometre away, and of slopes x / z.
constexpr float kPlaceSlack_m = 2e-4f;
constexpr float kSlopeSlack = 1e-5f;
constexpr float kBeside_m = 0.01f;  ///< nearer to the lens's plane slopes are not used

ADIT_LANE Way scaled(const Way& a, float by) { return {a.x * by, a.y * by, a.z * by}; }
ADIT_LANE Way sum(const Way& a, const Way& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

/// Where a tile's rays run in its own frame: extremes over each column of pixels.
struct alignas(64) Slopes {
  float x[kTileLanes], y[kTileLanes];
  float x_low[kTileWidth], x_high[kTileWidth], y_low[kTileWidth], y_high[kTileWidth];
};

ADIT_LANE float lesser(float a, float b) { return a < b ? a : b; }
ADIT_LANE float greater(float a, float b) { return a > b ? a : b; }

/// @return whether all rays go forward.
bool slopes_of(const Tile& t, const Sight& s, Slopes& slopes) {
  const Way right = s.right, down = s.down, forward = s.forward;
  std::int32_t aside = 0;
  ADIT_LANES
  for (int i = 0; i < kTileLanes; ++i) {
    const float z = t.dx[i] * forward.x + t.dy[i] * forward.y + t.dz[i] * forward.z;
    aside |= z > 0.05f ? 0 : 1;
    slopes.x[i] = (t.dx[i] * right.x + t.dy[i] * right.y + t.dz[i] * right.z) / z;
    slopes.y[i] = (t.dx[i] * down.x + t.dy[i] * down.y + t.dz[i] * down.z) / z;
  }
  return aside == 0;
}

/// The columns and rows of the grid, and how far its rays lie off them.
void fit_grid(Sight& s, Slopes& g) {
  constexpr int kMiddle = kTileHeight / 2 * kTileWidth + kTileWidth / 2;
  // The first step, not the mean: lanes beyond the image's edge repeat its last pixel.
  const float x_step = g.x[kMiddle - kTileWidth / 2 + 1] - g.x[kMiddle - kTileWidth / 2];
  const float y_step = g.y[kTileWidth + kTileWidth / 2] - g.y[kTileWidth / 2];
  s.x_first = g.x[kMiddle - kTileWidth / 2];
  s.y_first = g.y[kTileWidth / 2];
  for (int u = 0; u < kTileWidth; ++u) {
    g.x_low[u] = g.y_low[u] = 1e9f;
    g.x_high[u] = g.y_high[u] = -1e9f;
  }
  float x_least = 1e9f, x_most = -1e9f, y_least = 1e9f, y_most = -1e9f;
  for (int v = 0; v < kTileHeight; ++v) {
    const float y = s.y_first + static_cast<float>(v) * y_step;
    ADIT_LANES
    for (int u = 0; u < kTileWidth; ++u) {
      const int i = v * kTileWidth + u;
      const float x_off = g.x[i] - (s.x_first + static_cast<float>(u) * x_step), y_off = g.y[i] - y;
      g.x_low[u] = lesser(g.x_low[u], x_off);
      g.x_high[u] = greater(g.x_high[u], x_off);
      g.y_low[u] = lesser(g.y_low[u], y_off);
      g.y_high[u] = greater(g.y_high[u], y_off);
    }
  }
  s.x_low = s.y_low = 1e9f;
  s.x_high = s.y_high = -1e9f;
  for (int u = 0; u < kTileWidth; ++u) {
    const float x = s.x_first + static_cast<float>(u) * x_step;
    x_least = lesser(x_least, x + g.x_low[u]);
    x_most = greater(x_most, x + g.x_high[u]);
    s.x_low = lesser(s.x_low, g.x_low[u]);
    s.x_high = greater(s.x_high, g.x_high[u]);
    s.y_low = lesser(s.y_low, g.y_low[u]);
    s.y_high = greater(s.y_high, g.y_high[u]);
  }
  y_least = s.y_first + s.y_low;
  y_most = s.y_first + (kTileHeight - 1) * y_step + s.y_high;
  if (!(x_step > 1e-7f) || !(y_step > 1e-7f)) {
    s.right = s.down = s.forward = Way{0.0f, 0.0f, 0.0f};
    return;
  }
  s.columns_per_x = 1.0f / x_step;
  s.rows_per_y = 1.0f / y_step;
  s.side[0] = sum(s.right, scaled(s.forward, -(x_least - kSlopeSlack)));
  s.side[1] = sum(scaled(s.right, -1.0f), scaled(s.forward, x_most + kSlopeSlack));
  s.side[2] = sum(s.down, scaled(s.forward, -(y_least - kSlopeSlack)));
  s.side[3] = sum(scaled(s.down, -1.0f), scaled(s.forward, y_most + kSlopeSlack));
}

/// @param axes rotation from the optical frame to the world, row major: in this frame the rays of a lens that does not
/// bend lines make an even grid.
void aim_sight(const Tile& t, const float* axes, Sight& s) {
  for (int b = 0; b < kBlocks; ++b)
    for (int k = 0; k < kPacketLanes; ++k) {
      const int i = kBlockLanes[static_cast<std::size_t>(b)] + k / kBlock * kTileWidth + k % kBlock;
      const int j = b * kPacketLanes + k;
      s.dx[j] = t.dx[i];
      s.dy[j] = t.dy[i];
      s.dz[j] = t.dz[i];
      s.nearest[j] = 0.0f;
      s.triangle[j] = -1;
    }
  for (int b = 0; b < kBlocks; ++b) s.farthest[b] = 0.0f;
  s.drawn = 0;
  constexpr int kMiddle = kTileHeight / 2 * kTileWidth;
  s.origin = {t.ox[kMiddle], t.oy[kMiddle], t.oz[kMiddle]};
  s.right = {axes[0], axes[3], axes[6]};
  s.down = {axes[1], axes[4], axes[7]};
  s.forward = {axes[2], axes[5], axes[8]};
  for (Way& n : s.side) n = {0.0f, 0.0f, 0.0f};
  static thread_local Slopes slopes;
  if (slopes_of(t, s, slopes))
    fit_grid(s, slopes);
  else
    s.right = s.down = s.forward = Way{0.0f, 0.0f, 0.0f};
}

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

void draw_in_block(Sight& s, const EdgePlanes& e, int j, std::int32_t triangle, int block) {
  constexpr float kNearest_1_m = 1.0f / 0.02f;  // nothing nearer than that is seen
  const int first = block * kPacketLanes;
  const Ways ray{floats_at(s.dx + first), floats_at(s.dy + first), floats_at(s.dz + first)};
  Floats& nearest = floats_at(s.nearest + first);
  Ints& owner = ints_at(s.triangle + first);
  const Floats a = ray.x * e.n[0].x[j] + ray.y * e.n[0].y[j] + ray.z * e.n[0].z[j];
  const Floats b = ray.x * e.n[1].x[j] + ray.y * e.n[1].y[j] + ray.z * e.n[1].z[j];
  const Floats c = ray.x * e.n[2].x[j] + ray.y * e.n[2].y[j] + ray.z * e.n[2].z[j];
  const Floats here = (a + b + c) * e.inverse[j];
  const Ints hit = (a >= 0.0f) & (b >= 0.0f) & (c >= 0.0f) & (here > nearest) & (here < kNearest_1_m);
  nearest = hit ? here : nearest;
  owner = hit ? Ints{} + triangle : owner;
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
    for (auto blocks = static_cast<std::uint32_t>(e.blocks[j]); blocks != 0; blocks &= blocks - 1) {
      const int block = __builtin_ctz(blocks);
      if (e.nearest[j] * 1.0001f < s.farthest[block]) continue;
      draw_in_block(s, e, j, leaf.triangle[j], block);
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

/// Range and place within the triangle from each ray's own origin (Moeller and Trumbore 1997).
void settle(Tile& t, const TriangleRow* rows, int first) {
  RowLanes lanes;
  take_rows(rows, t.triangle + first, 0, lanes);
  const auto& f = lanes.field;
  ADIT_LANES
  for (int j = 0; j < kTreeWidth; ++j) {
    const int i = first + j;
    const bool hit = t.triangle[i] >= 0;
    const float dx = t.dx[i], dy = t.dy[i], dz = t.dz[i];
    const float sx = t.ox[i] - f[0][j], sy = t.oy[i] - f[1][j], sz = t.oz[i] - f[2][j];
    const float ax = f[3][j], ay = f[4][j], az = f[5][j];
    const float bx = f[6][j], by = f[7][j], bz = f[8][j];
    const float px = dy * bz - dz * by, py = dz * bx - dx * bz, pz = dx * by - dy * bx;
    const float qx = sy * az - sz * ay, qy = sz * ax - sx * az, qz = sx * ay - sy * ax;
    const float across = ax * px + ay * py + az * pz;
    const float inverse = 1.0f / (hit && across != 0.0f ? across : 1.0f);
    t.bu[i] = hit ? clamped((sx * px + sy * py + sz * pz) * inverse, 0.0f, 1.0f) : 0.0f;
    t.bv[i] = hit ? clamped((dx * qx + dy * qy + dz * qz) * inverse, 0.0f, 1.0f) : 0.0f;
    t.range[i] = hit ? (bx * qx + by * qy + bz * qz) * inverse : kNoRange_m;
  }
}

/// Closest hits of all lanes. @return whether anything was hit.
bool see(Tile& t, const float* axes, const TreeNode* nodes, const TreeLeaf* leaves, const TriangleRow* rows) {
  static thread_local Sight s;
  aim_sight(t, axes, s);
  draw_tree(s, nodes, leaves);
  std::int32_t any = 0;
  for (int b = 0; b < kBlocks; ++b)
    for (int k = 0; k < kPacketLanes; ++k) {
      const std::int32_t triangle = s.triangle[b * kPacketLanes + k];
      t.triangle[kBlockLanes[static_cast<std::size_t>(b)] + k / kBlock * kTileWidth + k % kBlock] = triangle;
      any |= triangle + 1;
      send_for(rows + (triangle < 0 ? 0 : triangle));
    }
  for (int i = 0; i < kTileLanes; i += kTreeWidth) settle(t, rows, i);
  return any != 0;
}
