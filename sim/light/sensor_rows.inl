// The sensor's row loops; included by shade_kernels.cpp.

void mosaic_row(const MosaicRow& row) {
  const MosaicRow m = row;
  const int width = m.width;
  for (int c = 0; c < 2; ++c) {
    float* const s = m.scratch[c];
    ADIT_LANES
    for (int u = 0; u < width; ++u)
      s[u + 1] = m.blur_side * (m.above[c][u] + m.below[c][u]) + m.blur_centre * m.here[c][u];
    s[0] = s[1];
    s[width + 1] = s[width];
  }
  const float* const even = m.scratch[0];
  const float* const odd = m.scratch[1];
  ADIT_LANES
  for (int u = 0; u < width; ++u) {
    const float a = m.blur_side * (even[u] + even[u + 2]) + m.blur_centre * even[u + 1];
    const float b = m.blur_side * (odd[u] + odd[u + 2]) + m.blur_centre * odd[u + 1];
    const float light = (u & 1) ? b * m.response[1] : a * m.response[0];
    const float e = clamped(light * m.sensitivity[u], 0.0f, m.full_well_e);
    // One normal variate for photons and read-out together: the Poisson law differs from it only where the read
    // noise rules anyway.
    const std::uint32_t h = mixed(m.seed + 0x9e3779b9u * static_cast<std::uint32_t>(u));
    const float z = m.gauss[static_cast<std::int32_t>(h >> 20)];
    const float noisy = e + m.noise * (z * std::sqrt(e + m.read_variance_e2) + m.offset_e[u] + m.row_offset_e);
    const float number = clamped(noisy * m.numbers_per_e + 0.5f, 0.0f, m.number_max);
    m.mosaic[u] = static_cast<float>(static_cast<std::int32_t>(number));
  }
}

void tone_row(const ToneRow& row) {
  const ToneRow t = row;
  const int width = t.width;
  std::uint32_t* const packed = t.scratch;
  const std::int32_t* const tone = t.tone;
  const float top = t.number_max;
  const float row_odd = t.odd_row ? 1.0f : 0.0f, row_even = 1.0f - row_odd;
  std::int32_t sum = 0;
  ADIT_LANES
  for (int u = 0; u < width; ++u) {
    const float m = t.here[u];
    const float across = 0.5f * (t.here[u - 1] + t.here[u + 1]);
    const float down = 0.5f * (t.above[u] + t.below[u]);
    const float corners = 0.25f * (t.above[u - 1] + t.above[u + 1] + t.below[u - 1] + t.below[u + 1]);
    const float cross = 0.5f * (across + down);
    // Rows: red green red ..., then green blue green ...
    const float odd = static_cast<float>(u & 1), even = 1.0f - odd;
    const float on_odd = odd * m + even * cross, on_even = even * m + odd * cross;
    const float upper_r = even * m + odd * across, upper_b = even * corners + odd * down;
    const float lower_r = even * down + odd * corners, lower_b = even * across + odd * m;
    const float g = row_odd * on_even + row_even * on_odd;
    const float r = row_odd * lower_r + row_even * upper_r;
    const float b = row_odd * lower_b + row_even * upper_b;
    const float white_r = r * t.white_red, white_b = b * t.white_blue;
    const float grey = 0.25f * white_r + 0.5f * g + 0.25f * white_b;
    const std::int32_t red =
        tone[static_cast<std::int32_t>(clamped(grey + t.colour * (white_r - grey) + 0.5f, 0.0f, top))];
    const std::int32_t green = tone[static_cast<std::int32_t>(clamped(grey + t.colour * (g - grey) + 0.5f, 0.0f, top))];
    const std::int32_t blue =
        tone[static_cast<std::int32_t>(clamped(grey + t.colour * (white_b - grey) + 0.5f, 0.0f, top))];
    packed[u] = static_cast<std::uint32_t>(blue | green << 8 | red << 16);
    sum += blue + green + red;
  }
  // Four bytes at a time, of which the next pixel takes the last.
  static_assert(std::endian::native == std::endian::little);
  for (int u = 0; u < width - 1; ++u) std::memcpy(t.bgr + 3 * u, packed + u, 4);
  std::memcpy(t.bgr + 3 * (width - 1), packed + width - 1, 3);
  *t.level_sum = static_cast<std::uint64_t>(sum);
}
