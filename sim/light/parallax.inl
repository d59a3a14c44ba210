// Which blocks of pixels a lamp beside the lens may leave dark. Included by shade_kernels.cpp.

/// The block of a pixel and those its neighbours lie in. @param block see ParallaxTable.
ADIT_LANE void mark_blocks(std::int32_t block, int across, std::uint8_t* blocks) {
  std::uint8_t* const at = blocks + (block >> 2);
  const int aside = block & 1, down = block & 2 ? across : 0;
  // Lines of several threads cross a block.
  for (const int step : {0, aside, down, aside + down}) __atomic_store_n(at + step, std::uint8_t{1}, __ATOMIC_RELAXED);
}

/// The horizon of each line, from the lamp's side on: a place is dark where something before it in the line is shifted
/// so much more by the lamp's parallax that it comes to lie over it.
void parallax(const ParallaxTable& table, int first_line, const float* range, int across, std::uint8_t* blocks) {
  constexpr float kLeast = 0.75f;  // px; shadows narrower than that are not seen
  Floats horizon = lanes_from<Floats>(table.edge.data() + first_line);
  std::size_t at = static_cast<std::size_t>(first_line) * table.steps;
  for (int step = table.steps - 1; step >= 0; --step, at += kTreeWidth) {
    const std::int32_t* const pixel = table.pixel.data() + at;
    alignas(64) float met[kTreeWidth];
    ADIT_LANES
    for (int j = 0; j < kTreeWidth; ++j) met[j] = range[pixel[j] < 0 ? 0 : pixel[j]];
    const Ints valid = lanes_from<Ints>(pixel) >= 0;
    const Floats here = lanes_from<Floats>(table.shift_m.data() + at) / floats_at(met) - static_cast<float>(step);
    std::uint32_t dark = bits_of(valid & (here + kLeast < horizon));
    horizon = valid ? greater(horizon, here) : horizon;
    for (; dark != 0; dark &= dark - 1)
      mark_blocks(table.block[at + static_cast<std::size_t>(__builtin_ctz(dark))], across, blocks);
  }
}
