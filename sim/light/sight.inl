// What a tile of pixels sees: the tree is walked once for all its rays, near boxes first, and triangles are drawn with
// edge functions. Included by shade_kernels.cpp.

/// One bit a lane of sixteen flags that are 0 or -1.
ADIT_LANE std::uint32_t bits_of(const std::int32_t* flags) {
#if defined(__AVX512DQ__)
  return _mm512_movepi32_mask(_mm512_load_si512(flags));
#elif defined(__AVX2__)
  const auto low = _mm256_load_ps(reinterpret_cast<const float*>(flags));
  const auto high = _mm256_load_ps(reinterpret_cast<const float*>(flags) + 8);
  return static_cast<std::uint32_t>(_mm256_movemask_ps(low)) | static_cast<std::uint32_t>(_mm256_movemask_ps(high))
                                                                   << 8;
#else
  std::uint32_t bits = 0;
  for (int j = 0; j < kTreeWidth; ++j) bits |= (static_cast<std::uint32_t>(flags[j]) >> 31) << j;
  return bits;
#endif
}

struct Way {
  float x, y, z;
};
ADIT_LANE float dot(const Way& a, const Way& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The pyramids of a tile and of its blocks; rays start within `slack` of one origin.
struct alignas(64) Sight {
  // Rays and what they have met, block by block: 1 / range of the nearest so far, 0 for nothing.
  float dx[kTileLanes], dy[kTileLanes], dz[kTileLanes], nearest[kTileLanes];
  std::int32_t triangle[kTileLanes];
  float farthest[kBlocks];  ///< least of `nearest` in each block
  // Planes through the origin; inside is where p * n >= -slack. Left of the eight columns of blocks, then right.
  float column_x[kTreeWidth], column_y[kTreeWidth], column_z[kTreeWidth];
  float row_x[4], row_y[4], row_z[4];  ///< above the two rows of blocks, then below
  Way side[4];                         ///< of the whole tile
  Way origin;
  float slack;
};

/// A plane through the directions of lanes a and b, turned towards lane `inner` and tilted until none of the lanes
/// from a to b (by step) lies outside: lenses bend lines and the shutter rolls.
Way plane_through(const Tile& t, int a, int b, int step, int inner) {
  const auto way = [&t](int i) { return Way{t.dx[i], t.dy[i], t.dz[i]}; };
  const Way p = way(a), q = way(b), in = way(inner);
  Way n{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
  const float turn = (dot(n, in) < 0.0f ? -1.0f : 1.0f) / std::sqrt(dot(n, n) + 1e-30f);
  n = {n.x * turn, n.y * turn, n.z * turn};
  float out = 1e-6f;
  for (int i = a; i <= b; i += step) {
    const float beyond = -dot(n, way(i));
    out = beyond > out ? beyond : out;
  }
  const Way m = way(inner);
  out *= 1.1f;  // lanes of a tile lie close enough together that their cosine is above 1 / 1.1
  return {n.x + out * m.x, n.y + out * m.y, n.z + out * m.z};
}

void aim_sight(const Tile& t, Sight& s) {
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
  constexpr int kMiddle = kTileHeight / 2 * kTileWidth;
  constexpr int kColumns = kTileWidth / kBlock, kBottom = (kTileHeight - 1) * kTileWidth;
  for (int c = 0; c < kColumns; ++c) {
    const int left = c * kBlock, right = left + kBlock - 1;
    const Way planes[2] = {plane_through(t, left, left + kBottom, kTileWidth, kMiddle + right),
                           plane_through(t, right, right + kBottom, kTileWidth, kMiddle + left)};
    for (int k = 0; k < 2; ++k) {
      s.column_x[c + k * kColumns] = planes[k].x;
      s.column_y[c + k * kColumns] = planes[k].y;
      s.column_z[c + k * kColumns] = planes[k].z;
    }
  }
  for (int r = 0; r < 2; ++r) {
    const int upper = r * kBlock * kTileWidth, lower = upper + (kBlock - 1) * kTileWidth;
    const Way planes[2] = {plane_through(t, upper, upper + kTileWidth - 1, 1, lower + kTileWidth / 2),
                           plane_through(t, lower, lower + kTileWidth - 1, 1, upper + kTileWidth / 2)};
    for (int k = 0; k < 2; ++k) {
      s.row_x[r + 2 * k] = planes[k].x;
      s.row_y[r + 2 * k] = planes[k].y;
      s.row_z[r + 2 * k] = planes[k].z;
    }
  }
  const auto column = [&s](int c) { return Way{s.column_x[c], s.column_y[c], s.column_z[c]}; };
  const auto row = [&s](int r) { return Way{s.row_x[r], s.row_y[r], s.row_z[r]}; };
  const Way sides[4] = {column(0), column(2 * kColumns - 1), row(0), row(3)};
  for (int k = 0; k < 4; ++k) s.side[k] = sides[k];
  s.origin = {t.ox[kMiddle], t.oy[kMiddle], t.oz[kMiddle]};
  s.slack = 1e-5f;
  for (int v = 0; v < kTileHeight; ++v) {
    const int i = v * kTileWidth;
    const Way d{t.ox[i] - s.origin.x, t.oy[i] - s.origin.y, t.oz[i] - s.origin.z};
    const float off = std::sqrt(dot(d, d)) + 1e-5f;
    s.slack = off > s.slack ? off : s.slack;
  }
}

/// How far x lies outside of an interval.
ADIT_LANE float outside(float x, float low, float high) {
  const float below = low - x, above = x - high;
  const float d = below > above ? below : above;
  return d > 0.0f ? d : 0.0f;
}

/// Children in the pyramid that nothing nearer hides, and the squared distances of their boxes.
std::uint32_t children_in_sight(const Sight& s, const TreeNode& node, float farthest2_inverse, float* distance2) {
  alignas(64) std::int32_t flags[kTreeWidth];
  ADIT_LANES
  for (int j = 0; j < kTreeWidth; ++j) flags[j] = -1;
  for (const Way& n : s.side) {
    const float* const x = n.x >= 0.0f ? node.high[0] : node.low[0];
    const float* const y = n.y >= 0.0f ? node.high[1] : node.low[1];
    const float* const z = n.z >= 0.0f ? node.high[2] : node.low[2];
    ADIT_LANES
    for (int j = 0; j < kTreeWidth; ++j) {
      const float d = n.x * (x[j] - s.origin.x) + n.y * (y[j] - s.origin.y) + n.z * (z[j] - s.origin.z);
      flags[j] &= d >= -s.slack ? -1 : 0;
    }
  }
  ADIT_LANES
  for (int j = 0; j < kTreeWidth; ++j) {
    const float x = outside(s.origin.x, node.low[0][j], node.high[0][j]);
    const float y = outside(s.origin.y, node.low[1][j], node.high[1][j]);
    const float z = outside(s.origin.z, node.low[2][j], node.high[2][j]);
    const float sum = x * x + y * y + z * z;
    distance2[j] = sum;
    flags[j] &= sum * farthest2_inverse <= 1.001f ? -1 : 0;
  }
  return bits_of(flags) & ((1u << node.count) - 1u);
}

/// The triangles of a leaf seen from the origin: normals of the planes through it and each edge, three dots with which
/// are the barycentric coordinates. Neighbours share edges to the bit, so that no ray slips through between them.
struct alignas(64) EdgePlanes {
  float n[3][3][kTreeWidth];  ///< [against corner][axis]
  float inverse[kTreeWidth];  ///< (sum of the three dots) * inverse is 1 / range
  float p[3][3][kTreeWidth];  ///< corners from the origin
  std::int32_t seen[kTreeWidth];
};

void cross(const float (*a)[kTreeWidth], const float (*b)[kTreeWidth], float (*n)[kTreeWidth]) {
  const float *const ax = a[0], *const ay = a[1], *const az = a[2];
  const float *const bx = b[0], *const by = b[1], *const bz = b[2];
  float *const nx = n[0], *const ny = n[1], *const nz = n[2];
  ADIT_LANES
  for (int j = 0; j < kTreeWidth; ++j) {
    nx[j] = ay[j] * bz[j] - az[j] * by[j];
    ny[j] = az[j] * bx[j] - ax[j] * bz[j];
    nz[j] = ax[j] * by[j] - ay[j] * bx[j];
  }
}

std::uint32_t edges_of(const Sight& s, const TreeLeaf& leaf, EdgePlanes& e) {
  const float o[3] = {s.origin.x, s.origin.y, s.origin.z};
  for (int k = 0; k < 3; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      ADIT_LANES
      for (int j = 0; j < kTreeWidth; ++j) e.p[k][axis][j] = leaf.corner[k][axis][j] - o[axis];
    }
  ADIT_LANES
  for (int j = 0; j < kTreeWidth; ++j) e.seen[j] = -1;
  for (const Way& n : s.side) {
    ADIT_LANES
    for (int j = 0; j < kTreeWidth; ++j) {
      const float a = n.x * e.p[0][0][j] + n.y * e.p[0][1][j] + n.z * e.p[0][2][j];
      const float b = n.x * e.p[1][0][j] + n.y * e.p[1][1][j] + n.z * e.p[1][2][j];
      const float c = n.x * e.p[2][0][j] + n.y * e.p[2][1][j] + n.z * e.p[2][2][j];
      const float ab = a > b ? a : b;
      e.seen[j] &= (ab > c ? ab : c) >= -s.slack ? -1 : 0;
    }
  }
  cross(e.p[1], e.p[2], e.n[0]);
  cross(e.p[2], e.p[0], e.n[1]);
  cross(e.p[0], e.p[1], e.n[2]);
  const float *const x = e.p[0][0], *const y = e.p[0][1], *const z = e.p[0][2];
  const float *const nx = e.n[0][0], *const ny = e.n[0][1], *const nz = e.n[0][2];
  alignas(64) float sides[kTreeWidth];
  float* const inverse = e.inverse;
  ADIT_LANES
  for (int j = 0; j < kTreeWidth; ++j) {
    const float volume = x[j] * nx[j] + y[j] * ny[j] + z[j] * nz[j];
    const float size = volume < 0.0f ? -volume : volume;
    sides[j] = volume < 0.0f ? -1.0f : 1.0f;
    inverse[j] = size > 1e-20f ? 1.0f / size : 0.0f;  // 0: seen edge on, never hit
  }
  float* const normals = &e.n[0][0][0];
  for (int k = 0; k < 9; ++k) {
    ADIT_LANES
    for (int j = 0; j < kTreeWidth; ++j) normals[k * kTreeWidth + j] *= sides[j];
  }
  return bits_of(e.seen) & ((1u << leaf.count) - 1u);
}

/// Whether any of three corners lies inside of each plane: flags of 0 or -1.
ADIT_LANE void reaches(const float* x, const float* y, const float* z, int count, const Way* p, float slack,
                       std::int32_t* flags) {
  const Way p0 = p[0], p1 = p[1], p2 = p[2];
  ADIT_LANES
  for (int c = 0; c < count; ++c) {
    const float d0 = x[c] * p0.x + y[c] * p0.y + z[c] * p0.z;
    const float d1 = x[c] * p1.x + y[c] * p1.y + z[c] * p1.z;
    const float d2 = x[c] * p2.x + y[c] * p2.y + z[c] * p2.z;
    const float d01 = d0 > d1 ? d0 : d1;
    flags[c] = (d01 > d2 ? d01 : d2) >= -slack ? -1 : 0;
  }
}

/// Blocks whose pyramids triangle j reaches into, a bit each.
std::uint32_t blocks_of(const Sight& s, const EdgePlanes& e, int j) {
  Way p[3];
  for (int k = 0; k < 3; ++k) p[k] = {e.p[k][0][j], e.p[k][1][j], e.p[k][2][j]};
  alignas(64) std::int32_t flags[kTreeWidth];
  reaches(s.column_x, s.column_y, s.column_z, kTreeWidth, p, s.slack, flags);
  const std::uint32_t inside = bits_of(flags);
  const std::uint32_t columns = inside & inside >> 8 & 0xffu;
  reaches(s.row_x, s.row_y, s.row_z, 4, p, s.slack, flags);
  const auto upper = static_cast<std::uint32_t>(flags[0] & flags[2]),
             lower = static_cast<std::uint32_t>(flags[1] & flags[3]);
  return (columns & upper) | (columns << 8 & lower);
}

void draw_in_block(Sight& s, const EdgePlanes& e, int j, std::int32_t triangle, int block) {
  constexpr float kNearest_1_m = 1.0f / 0.02f;  // nothing nearer than that is seen
  float n[3][3];
  for (int k = 0; k < 3; ++k)
    for (int axis = 0; axis < 3; ++axis) n[k][axis] = e.n[k][axis][j];
  const float inverse = e.inverse[j];
  const int first = block * kPacketLanes;
  float* const nearest = s.nearest + first;
  std::int32_t* const owner = s.triangle + first;
  const float *const dx = s.dx + first, *const dy = s.dy + first, *const dz = s.dz + first;
  std::int32_t least = 0x7f7fffff;
  ADIT_LANES
  for (int i = 0; i < kPacketLanes; ++i) {
    const float a = dx[i] * n[0][0] + dy[i] * n[0][1] + dz[i] * n[0][2];
    const float b = dx[i] * n[1][0] + dy[i] * n[1][1] + dz[i] * n[1][2];
    const float c = dx[i] * n[2][0] + dy[i] * n[2][1] + dz[i] * n[2][2];
    const float here = (a + b + c) * inverse;
    const bool hit = (a >= 0.0f) & (b >= 0.0f) & (c >= 0.0f) & (here > nearest[i]) & (here < kNearest_1_m);
    const float now = hit ? here : nearest[i];
    nearest[i] = now;
    owner[i] = hit ? triangle : owner[i];
    const std::int32_t bits = float_to_bits(now);  // not negative: in order as integers, too
    least = bits < least ? bits : least;
  }
  s.farthest[block] = bits_to_float(least);
}

void draw_leaf(Sight& s, const TreeLeaf& leaf) {
  EdgePlanes e;
  for (std::uint32_t left = edges_of(s, leaf, e); left != 0; left &= left - 1) {
    const int j = __builtin_ctz(left);
    for (std::uint32_t blocks = blocks_of(s, e, j); blocks != 0; blocks &= blocks - 1)
      draw_in_block(s, e, j, leaf.triangle[j], __builtin_ctz(blocks));
  }
}

/// 1 / squared range of the farthest pixel; 0 while one has met nothing.
float farthest2_inverse(const Sight& s) {
  std::int32_t least = 0x7f7fffff;
  for (int b = 0; b < kBlocks; ++b) {
    const std::int32_t bits = float_to_bits(s.farthest[b]);
    least = bits < least ? bits : least;
  }
  const float inverse = bits_to_float(least);
  return inverse * inverse;
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
    alignas(64) float distance2[kTreeWidth];
    const int first = depth;
    for (std::uint32_t left = children_in_sight(s, node, hidden, distance2); left != 0; left &= left - 1) {
      const int j = __builtin_ctz(left);
      const Entry next{distance2[j], node.child[j]};
      int at = depth++;  // the nearest ends on top
      for (; at > first && stack[at - 1].distance2 < next.distance2; --at) stack[at] = stack[at - 1];
      stack[at] = next;
    }
  }
}

/// Range and place within the triangle from each ray's own origin (Moeller and Trumbore 1997).
void settle(Tile& t, const TriangleRow* rows) {
  const float* const table = rows->corner;
  ADIT_LANES
  for (int i = 0; i < kTileLanes; ++i) {
    const bool hit = t.triangle[i] >= 0;
    const std::int32_t at = (hit ? t.triangle[i] : 0) * kRowFloats;
    const float dx = t.dx[i], dy = t.dy[i], dz = t.dz[i];
    const float sx = t.ox[i] - table[at], sy = t.oy[i] - table[at + 1], sz = t.oz[i] - table[at + 2];
    const float ax = table[at + 3], ay = table[at + 4], az = table[at + 5];
    const float bx = table[at + 6], by = table[at + 7], bz = table[at + 8];
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
bool see(Tile& t, const TreeNode* nodes, const TreeLeaf* leaves, const TriangleRow* rows) {
  static thread_local Sight s;
  aim_sight(t, s);
  draw_tree(s, nodes, leaves);
  std::int32_t any = 0;
  for (int b = 0; b < kBlocks; ++b)
    for (int k = 0; k < kPacketLanes; ++k) {
      const std::int32_t triangle = s.triangle[b * kPacketLanes + k];
      t.triangle[kBlockLanes[static_cast<std::size_t>(b)] + k / kBlock * kTileWidth + k % kBlock] = triangle;
      any |= triangle + 1;
    }
  settle(t, rows);
  return any != 0;
}
