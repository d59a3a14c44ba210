#include "cell_filters.hpp"

#include <algorithm>
#include <cmath>

namespace adit {
namespace {

struct Smaller {
  std::int16_t operator()(std::int16_t a, std::int16_t b) const noexcept { return a < b ? a : b; }
};
struct Larger {
  std::int16_t operator()(std::int16_t a, std::int16_t b) const noexcept { return a > b ? a : b; }
};

/// out[x] = best of the three neighbours in a row; at the ends of two.
template <class Best>
void best_of_3_across(const std::int16_t* in, std::int16_t* out, int width, Best best) noexcept {
  out[0] = best(in[0], in[std::min(1, width - 1)]);
  for (int x = 1; x + 1 < width; ++x) out[x] = best(best(in[x - 1], in[x]), in[x + 1]);
  out[width - 1] = best(in[std::max(0, width - 2)], in[width - 1]);
}

template <class Best>
void filter_3(CellPlane& plane, FilterScratch& scratch, Best best) noexcept {
  const int width = plane.width;
  for (int v = 0; v < plane.height; ++v) best_of_3_across(plane.row(v), scratch.plane.row(v), width, best);
  for (int v = 0; v < plane.height; ++v) {
    const std::int16_t* above = scratch.plane.row(std::max(0, v - 1));
    const std::int16_t* middle = scratch.plane.row(v);
    const std::int16_t* below = scratch.plane.row(std::min(plane.height - 1, v + 1));
    std::int16_t* out = plane.row(v);
    for (int x = 0; x < width; ++x) out[x] = best(best(above[x], middle[x]), below[x]);
  }
}

std::int16_t binomial(int a, int b, int c, int d, int e) noexcept {
  return static_cast<std::int16_t>((a + e + 4 * (b + d) + 6 * c + 8) >> 4);
}

void blur_across(const std::int16_t* in, std::int16_t* out, int width, std::int16_t* line) noexcept {
  std::copy_n(in, width, line + 2);
  line[0] = line[1] = in[0];
  line[width + 2] = line[width + 3] = in[width - 1];
  for (int x = 0; x < width; ++x) out[x] = binomial(line[x], line[x + 1], line[x + 2], line[x + 3], line[x + 4]);
}

}  // namespace

void erode_3(CellPlane& plane, FilterScratch& scratch) noexcept { filter_3(plane, scratch, Smaller()); }
void dilate_3(CellPlane& plane, FilterScratch& scratch) noexcept { filter_3(plane, scratch, Larger()); }

void erode_5(CellPlane& plane, FilterScratch& scratch) noexcept {
  erode_3(plane, scratch);
  erode_3(plane, scratch);
}

void dilate_5(CellPlane& plane, FilterScratch& scratch) noexcept {
  dilate_3(plane, scratch);
  dilate_3(plane, scratch);
}

void blur(CellPlane& plane, FilterScratch& scratch) noexcept {
  const int last = plane.height - 1;
  for (int v = 0; v <= last; ++v) blur_across(plane.row(v), scratch.plane.row(v), plane.width, scratch.line.data());
  for (int v = 0; v <= last; ++v) {
    const auto line = [&](int at) { return scratch.plane.row(std::clamp(at, 0, last)); };
    const std::int16_t *a = line(v - 2), *b = line(v - 1), *c = line(v), *d = line(v + 1), *e = line(v + 2);
    std::int16_t* out = plane.row(v);
    for (int x = 0; x < plane.width; ++x) out[x] = binomial(a[x], b[x], c[x], d[x], e[x]);
  }
}

void make_light_table(double gamma, double noise_level, LightTable& table) {
  const double floor = std::pow((noise_level + 1.0) / 256.0, gamma);
  for (int part = 0; part <= kLevelPartsMax; ++part) {
    const double level = static_cast<double>(part) / kLevelParts;
    const double light = std::pow((level + 1.0) / 256.0, gamma) + floor;
    table[static_cast<std::size_t>(part)] = static_cast<std::int16_t>(std::lround(kStop * std::log2(light)));
  }
}

void look_up(const CellPlane& levels, const LightTable& table, CellPlane& light) noexcept {
  for (std::size_t i = 0; i < levels.values.size(); ++i) {
    light.values[i] = table[static_cast<std::size_t>(levels.values[i])];
  }
}

}  // namespace adit
