// Luminance -> electrons -> numbers -> bytes. Noise is drawn by a hash of (seed of the frame, row, column): it does
// not matter in which order rows are done.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "../light/parts.hpp"
#include "../light/sensor_rows.hpp"
#include "hash.hpp"

namespace adit::sim {
namespace {

constexpr std::size_t kMosaicPad = 16;
std::size_t mosaic_stride(const Renderer::Parts& parts) {
  return static_cast<std::size_t>(parts.width) + 2 * kMosaicPad;
}
float* mosaic_row_of(Renderer::Parts& parts, int v) {
  return &parts.mosaic[static_cast<std::size_t>(v + 1) * mosaic_stride(parts) + kMosaicPad];
}
float number_max(const SensorConfig& sensor) { return static_cast<float>((1 << sensor.adc_bits) - 1); }

void expose_row(Renderer::Parts& parts, const Shot& shot, int v) {
  static thread_local std::vector<float> scratch;
  const SensorConfig& s = parts.rig.sensor;
  const int width = parts.width;
  const std::size_t scratch_width = static_cast<std::size_t>(width) + 2;
  scratch.resize(2 * scratch_width);
  // Red green in even rows, green blue in odd rows.
  const int colours[2] = {(v & 1) ? 1 : 0, (v & 1) ? 2 : 1};
  const float response[3] = {s.response_red, 1.0f, s.response_blue};
  const auto plane_row = [&](int colour, int at) {
    return &parts.planes[colour][static_cast<std::size_t>(std::clamp(at, 0, parts.height - 1)) * parts.stride];
  };
  MosaicRow row{};
  for (int c = 0; c < 2; ++c) {
    row.above[c] = plane_row(colours[c], v - 1);
    row.here[c] = plane_row(colours[c], v);
    row.below[c] = plane_row(colours[c], v + 1);
    row.scratch[c] = scratch.data() + static_cast<std::size_t>(c) * scratch_width;
    row.response[c] = response[colours[c]] * shot.exposure.time_s;
  }
  // Three taps have the variance 2 * side.
  row.blur_side = std::min(0.5f * parts.rig.lens.blur_px * parts.rig.lens.blur_px, 0.33f);
  row.blur_centre = 1.0f - 2.0f * row.blur_side;
  row.sensitivity = &parts.sensor.sensitivity[static_cast<std::size_t>(v) * width];
  row.offset_e = &parts.sensor.offset_e[static_cast<std::size_t>(v) * width];
  row.full_well_e = s.full_well_e;
  const float converter_e = s.converter_noise_e / shot.exposure.gain;
  row.read_variance_e2 = s.read_noise_e * s.read_noise_e + converter_e * converter_e;
  row.seed = hashed(shot.seed * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(v) + 1);
  row.gauss = parts.sensor.gauss.data();
  row.row_offset_e = s.row_noise_e * row.gauss[hashed(row.seed + 0x5bd1e995ULL) >> 20];
  row.number_max = number_max(s);
  row.numbers_per_e = row.number_max * shot.exposure.gain / s.full_well_e;
  row.noise = parts.render.sensor_noise ? 1.0f : 0.0f;
  row.mosaic = mosaic_row_of(parts, v);
  row.width = width;
  shade_kernels().mosaic_row(row);
  // Mirrored about the edge pixel, so that colours keep their places.
  row.mosaic[-1] = row.mosaic[1];
  row.mosaic[width] = row.mosaic[width - 2];
}

std::uint64_t develop_row(Renderer::Parts& parts, const Shot& shot, int v, std::uint8_t* bgr) {
  static thread_local std::vector<std::uint32_t> scratch;
  scratch.resize(static_cast<std::size_t>(parts.width));
  const SensorConfig& s = parts.rig.sensor;
  const float fade = shot.exposure.gain / s.colour_fade_gain;
  std::uint64_t sum = 0;
  shade_kernels().tone_row({mosaic_row_of(parts, v - 1), mosaic_row_of(parts, v), mosaic_row_of(parts, v + 1),
                            (v & 1) != 0, s.white_red, s.white_blue, 1.0f / (1.0f + fade * fade), number_max(s),
                            parts.sensor.tone.data(), scratch.data(), bgr, &sum, parts.width});
  return sum;
}

}  // namespace

void sensor_pass(Renderer::Parts& parts, const Shot& shot, Frame& frame) {
  parts.mosaic.resize(mosaic_stride(parts) * (static_cast<std::size_t>(parts.height) + 2));
  parts.each(parts.height, [&](int v) { expose_row(parts, shot, v); });
  const auto copy_row = [&](int to, int from) {
    std::memcpy(mosaic_row_of(parts, to) - 1, mosaic_row_of(parts, from) - 1,
                (static_cast<std::size_t>(parts.width) + 2) * sizeof(float));
  };
  copy_row(-1, 1);
  copy_row(parts.height, parts.height - 2);
  frame.bgr.resize(static_cast<std::size_t>(3) * parts.width * parts.height);
  std::vector<std::uint64_t> sums(static_cast<std::size_t>(parts.height));
  parts.each(parts.height, [&](int v) {
    sums[static_cast<std::size_t>(v)] =
        develop_row(parts, shot, v, &frame.bgr[static_cast<std::size_t>(3) * parts.width * v]);
  });
  std::uint64_t sum = 0;
  for (const std::uint64_t row : sums) sum += row;
  frame.mean_level = static_cast<float>(static_cast<double>(sum) / static_cast<double>(frame.bgr.size()));
}

}  // namespace adit::sim
