// Loops over rows of cells of 16 bits (method `adit`). Plain C++: the compiler makes vector code of it, for each CPU
// target its own. Whole numbers only, so that all targets give the same bits.

inline std::int16_t less(std::int16_t a, std::int16_t b) { return a < b ? a : b; }
inline std::int16_t more(std::int16_t a, std::int16_t b) { return a < b ? b : a; }

void smallest_of_3(const std::int16_t* a, const std::int16_t* b, const std::int16_t* c, std::int16_t* __restrict out,
                   int width) {
  for (int x = 0; x < width; ++x) out[x] = less(less(a[x], b[x]), c[x]);
}

void largest_of_3(const std::int16_t* a, const std::int16_t* b, const std::int16_t* c, std::int16_t* __restrict out,
                  int width) {
  for (int x = 0; x < width; ++x) out[x] = more(more(a[x], b[x]), c[x]);
}

void binomial_of_5(const std::int16_t* const* rows, std::int16_t* __restrict out, int width) {
  const std::int16_t *a = rows[0], *b = rows[1], *c = rows[2], *d = rows[3], *e = rows[4];
  for (int x = 0; x < width; ++x) {
    // 16 times the largest value, 4080, and 8 for rounding fit 16 bits without a sign.
    const auto ends = static_cast<std::uint16_t>(a[x] + e[x] + 2 * c[x] + 8);
    const auto inner = static_cast<std::uint16_t>(b[x] + d[x] + c[x]);
    const auto sum = static_cast<std::uint16_t>(ends + static_cast<std::uint16_t>(inner << 2));
    out[x] = static_cast<std::int16_t>(sum >> 4);
  }
}

void carry_rays(const std::int16_t* light, const std::int16_t* met, int step, std::int16_t* __restrict out, int width) {
  for (int x = 0; x < width; ++x) out[x] = static_cast<std::int16_t>(more(light[x], met[x]) - step);
}

void rate_rises(const std::int16_t* const* met, const std::int16_t* light, std::int16_t* __restrict out, int width) {
  const std::int16_t *m0 = met[0], *m1 = met[1], *m2 = met[2], *m3 = met[3];
  const std::int16_t *m4 = met[4], *m5 = met[5], *m6 = met[6], *m7 = met[7];
  for (int x = 0; x < width; ++x) {
    std::int16_t r[8] = {m0[x], m1[x], m2[x], m3[x], m4[x], m5[x], m6[x], m7[x]};
    for (std::int16_t& rise : r) rise = more(rise, light[x]);
    const auto order = [&r](int a, int b) {
      const std::int16_t low = less(r[a], r[b]), high = more(r[a], r[b]);
      r[a] = low;
      r[b] = high;
    };
    // Batcher's network of 19 comparators.
    order(0, 1), order(2, 3), order(4, 5), order(6, 7);
    order(0, 2), order(1, 3), order(4, 6), order(5, 7);
    order(1, 2), order(5, 6), order(0, 4), order(3, 7);
    order(1, 5), order(2, 6), order(1, 4), order(3, 6);
    order(2, 4), order(3, 5), order(3, 4);
    out[x] = static_cast<std::int16_t>((r[1] + r[2] + 2 * r[3]) / 4 - light[x]);
  }
}

constexpr CellLoops kCellLoops = {smallest_of_3, largest_of_3, binomial_of_5, carry_rays, rate_rises};
