// What a tile of pixels sees. Included by shade_kernels.cpp.
#include "sight_aim.inl"
#include "sight_draw.inl"

/// Range and place within the triangle from each ray's own origin (Moeller and Trumbore 1997).
void settle(Tile& t, const TriangleRow* rows, int first) {
  RowLanes lanes;
  take_rows(rows, t.triangle + first, 0, lanes);
  const auto& f = lanes.field;
  const float* const origin = t.origin[first / kTileWidth];
  const float ox = origin[0], oy = origin[1], oz = origin[2];
  ADIT_LANES
  for (int j = 0; j < kTreeWidth; ++j) {
    const int i = first + j;
    const bool hit = t.triangle[i] >= 0;
    const float dx = t.dx[i], dy = t.dy[i], dz = t.dz[i];
    const float sx = ox - f[0][j], sy = oy - f[1][j], sz = oz - f[2][j];
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

/// Along a plane 1 / range runs nearly straight through the image, however steep the view: a place that lies off the
/// plane through the corners of its block tells of an edge. @return blocks without an edge, a bit each.
std::uint32_t even_blocks(const Tile& t) {
  constexpr float kShare = 0.03f;
  constexpr int kLast = kBlock - 1;
  constexpr float kThird = 1.0f / kLast;
  alignas(64) static constexpr float kAcross[kPacketLanes] = {
      0, kThird, kThird * 2, kThird * 3, 0, kThird, kThird * 2, kThird * 3,
      0, kThird, kThird * 2, kThird * 3, 0, kThird, kThird * 2, kThird * 3};
  alignas(64) static constexpr float kDown[kPacketLanes] = {
      0,          0,          0,          0,          kThird,     kThird,     kThird,     kThird,
      kThird * 2, kThird * 2, kThird * 2, kThird * 2, kThird * 3, kThird * 3, kThird * 3, kThird * 3};
  const Floats &across = floats_at(kAcross), &down = floats_at(kDown);
  std::uint32_t even = 0;
  for (int b = 0; b < kBlocks; ++b) {
    const Floats here = 1.0f / block_of(t.range, b);
    const float first = here[0], upper = here[kLast], lower = here[kLast * kBlock], last = here[kPacketLanes - 1];
    const Floats left = first + down * (lower - first), right = upper + down * (last - upper);
    const Floats off = here - (left + across * (right - left));
    const Floats size = off < 0.0f ? -off : off;
    even |= (bits_of(size > kShare * here) == 0 ? 1u : 0u) << b;
  }
  return even;
}

/// Closest hits of all lanes.
void see(Tile& t, const float* axes, const TreeNode* nodes, const TreeLeaf* leaves, const TriangleRow* rows) {
  static thread_local Sight s;
  aim_sight(t, axes, s);
  draw_tree(s, nodes, leaves);
  Ints any{};
  for (int b = 0; b < kBlocks; ++b) {
    const std::int32_t* const seen = s.triangle + b * kPacketLanes;
    std::int32_t* const first = t.triangle + kBlockLanes[static_cast<std::size_t>(b)];
    for (int v = 0; v < kBlock; ++v)
      std::memcpy(first + v * kTileWidth, seen + v * kBlock, kBlock * sizeof(std::int32_t));
    any |= ints_at(s.triangle + b * kPacketLanes) >= 0;
    for (int k = 0; k < kPacketLanes; ++k) send_for(rows + (seen[k] < 0 ? 0 : seen[k]));
  }
  for (int i = 0; i < kTileLanes; i += kTreeWidth) settle(t, rows, i);
  t.any = bits_of(any) != 0;
  t.even_blocks = even_blocks(t);
}
