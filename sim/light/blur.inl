// Motion blur in the image, along the flow of the rock: a mean over up to kBlurTapsMax shifts by whole pixels, the same
// for a run of pixels, so that the loops run over neighbours. Included by shade_kernels.cpp.

/// Shifts of `taps` taps are these shares of the flow; lanes beyond the last are not used.
struct TapShares {
  alignas(64) float of[kBlurTapsMax + 1][kBlurTapsMax];
};
inline constexpr TapShares kTapShares = [] {
  TapShares shares{};
  for (int taps = 1; taps <= kBlurTapsMax; ++taps)
    for (int k = 0; k < kBlurTapsMax; ++k)
      shares.of[taps][k] = (static_cast<float>(k) + 0.5f) / static_cast<float>(taps) - 0.5f;
  return shares;
}();

/// What some runs of a row move by within the exposure, px.
struct alignas(64) RunFlows {
  static constexpr int kRuns = 32;
  float u[kRuns], v[kRuns];
  std::int32_t taps[kRuns];
};

void find_flows(const BlurRow& row, int first_run, int runs, RunFlows& flows) {
  const BlurRow b = row;
  ADIT_LANES
  for (int i = 0; i < runs; ++i) {
    const int run = first_run + i, u = run * kBlurRun_px + kBlurRun_px / 2;
    const int middle = u < b.width ? u : b.width - 1;
    const float x = b.run_directions[0][run], y = b.run_directions[1][run], z = b.run_directions[2][run];
    const float range = b.range[middle] < 0.05f ? 0.05f : b.range[middle];
    const float* const w = b.turn_rate_rad_s;
    const float flow_x = -(w[1] * z - w[2] * y) - b.velocity_m_s[0] / range;
    const float flow_y = -(w[2] * x - w[0] * z) - b.velocity_m_s[1] / range;
    const float flow_z = -(w[0] * y - w[1] * x) - b.velocity_m_s[2] / range;
    const float ahead = z < 0.05f ? 0.05f : z;
    const float flow_u = b.focal_x_px * (flow_x - x / ahead * flow_z) / ahead * b.time_s;
    const float flow_v = b.focal_y_px * (flow_y - y / ahead * flow_z) / ahead * b.time_s;
    const float size_u = flow_u < 0.0f ? -flow_u : flow_u, size_v = flow_v < 0.0f ? -flow_v : flow_v;
    const float taps = clamped((size_u < size_v ? size_v : size_u) + 1.5f, 1.0f, kBlurTapsMax);
    flows.u[i] = flow_u;
    flows.v[i] = flow_v;
    flows.taps[i] = static_cast<std::int32_t>(taps);
  }
}

/// Whole pixels, halves away from zero.
ADIT_LANE Ints shifts_of(const Floats& shares, float flow_px) {
  const Floats x = lesser(greater(shares * flow_px, all_of(-9999.0f)), all_of(9999.0f));
  return truncated(x + (x < 0.0f ? all_of(-0.5f) : all_of(0.5f)));
}

using Run = float __attribute__((vector_size(4 * kBlurRun_px), may_alias));

void blur_run(const BlurRow& b, int u0, const float* shares, int taps, float flow_u, float flow_v) {
  const Ints across = shifts_of(floats_at(shares), flow_u) + u0;
  Ints down = shifts_of(floats_at(shares), flow_v) + b.row;
  down = down < 0 ? Ints{} : down;
  down = down > b.height - 1 ? Ints{} + (b.height - 1) : down;
  alignas(64) std::int32_t at[kBlurTapsMax];
  ints_at(at) = down * b.stride + across;
  const float share = 1.0f / static_cast<float>(taps);
  // The first and the last shift are the farthest.
  const int left = across[0] < across[taps - 1] ? across[0] : across[taps - 1];
  const int right = across[0] < across[taps - 1] ? across[taps - 1] : across[0];
  if (left >= 0 && right + kBlurRun_px <= b.width) {
    Run sum[3] = {};
    for (int k = 0; k < taps; ++k)
      for (int c = 0; c < 3; ++c) sum[c] += lanes_from<Run>(b.planes[c] + at[k]);
    for (int c = 0; c < 3; ++c) {
      sum[c] *= share;
      std::memcpy(b.blurred[c] + u0, &sum[c], sizeof(Run));
    }
    return;
  }
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < kBlurRun_px && u0 + i < b.width; ++i) {
      float sum = 0.0f;
      for (int k = 0; k < taps; ++k) {
        const std::int32_t u = across[k] + i;
        const std::int32_t inside = u < 0 ? 0 : (u < b.width ? u : b.width - 1);
        sum += b.planes[c][at[k] - across[k] + inside];
      }
      b.blurred[c][u0 + i] = sum * share;
    }
}

void blur_row(const BlurRow& b) {
  const int runs = (b.width + kBlurRun_px - 1) / kBlurRun_px;
  RunFlows flows;
  for (int first = 0; first < runs; first += RunFlows::kRuns) {
    const int count = runs - first < RunFlows::kRuns ? runs - first : RunFlows::kRuns;
    find_flows(b, first, count, flows);
    for (int i = 0; i < count; ++i)
      blur_run(b, (first + i) * kBlurRun_px, kTapShares.of[flows.taps[i]], flows.taps[i], flows.u[i], flows.v[i]);
  }
}
