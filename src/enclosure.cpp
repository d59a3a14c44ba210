#include "enclosure.hpp"

#include <algorithm>

#include "kernels/pixel_loops.hpp"

namespace adit {
namespace {

/// Taken off for each cell of the way: 0.02 stops along rows and columns, in proportion along diagonals. Over a quarter
/// of the frame, 40 cells, it comes to 0.8 stops: rock that far away still encloses, rock nearby does so better.
constexpr int kStep = 5;
constexpr int kDiagonalStep = 7;
/// Brighter than nothing: what a ray meets outside the frame.
constexpr std::int16_t kNothing = -30000;
/// Share of each side of the frame, at both its ends, that no ray meets: 4 degrees of a common lens. Whole frames of
/// a camera in a cave have the lens's glowing edge and the vehicle's arms there, and beside them all that the lamp's
/// beam leaves out would look enclosed.
constexpr double kRim = 0.05;

std::int16_t brighter(int a, int b) noexcept { return static_cast<std::int16_t>(a > b ? a : b); }

/// What the rays of a row meet, from what those of the neighbouring row met: straight, and from the two sides.
/// `light` and `met` are of the neighbouring row; the results are of this one.
void carry(const kernels::CellLoops& loops, const std::int16_t* light, const std::int16_t* straight,
           const std::int16_t* left, const std::int16_t* right, std::int16_t* out_straight, std::int16_t* out_left,
           std::int16_t* out_right, int width) noexcept {
  loops.carry_rays(light, straight, kStep, out_straight, width);
  out_left[0] = kNothing;
  loops.carry_rays(light, left, kDiagonalStep, out_left + 1, width - 1);
  loops.carry_rays(light + 1, right + 1, kDiagonalStep, out_right, width - 1);
  out_right[width - 1] = kNothing;
}

void nothing_met(std::int16_t* a, std::int16_t* b, std::int16_t* c, int width) noexcept {
  std::fill_n(a, width, kNothing);
  std::fill_n(b, width, kNothing);
  std::fill_n(c, width, kNothing);
}

/// Both ways in one loop: each is a chain of steps that wait for one another.
void along_row(const std::int16_t* __restrict light, std::int16_t* __restrict from_left,
               std::int16_t* __restrict from_right, int width) noexcept {
  std::int16_t left = kNothing, right = kNothing;
  from_left[0] = from_right[width - 1] = kNothing;
  for (int x = 1, y = width - 2; x < width; ++x, --y) {
    from_left[x] = left = static_cast<std::int16_t>(brighter(light[x - 1], left) - kStep);
    from_right[y] = right = static_cast<std::int16_t>(brighter(light[y + 1], right) - kStep);
  }
}

/// Of a plane that is dark at its rim.
void take_inner(const CellPlane& light, CellPlane& rock) noexcept {
  const int rim_u = rim_of(light.width), rim_v = rim_of(light.height);
  for (int v = 0; v < light.height; ++v) {
    std::int16_t* const row = rock.row(v);
    std::fill_n(row, light.width, kNothing);
    if (v < rim_v || v >= light.height - rim_v) continue;
    std::copy_n(light.row(v) + rim_u, light.width - 2 * rim_u, row + rim_u);
  }
}

}  // namespace

EnclosureScratch::EnclosureScratch(int width, int height) : rock(width, height) {
  for (CellPlane& plane : from_below) plane = CellPlane(width, height);
  for (auto* rows : {&from_above, &above_before}) {
    for (auto& row : *rows) row.resize(static_cast<std::size_t>(width));
  }
  for (auto& row : along) row.resize(static_cast<std::size_t>(width));
}

int rim_of(int cells) noexcept { return static_cast<int>(kRim * cells + 0.5); }

void enclosure_of(const CellPlane& light, bool rim_is_rock, EnclosureScratch& scratch, CellPlane& out) noexcept {
  const kernels::CellLoops& loops = kernels::pixel_loops().cells;
  const int width = light.width, last = light.height - 1;
  if (!rim_is_rock) take_inner(light, scratch.rock);
  const CellPlane& rock = rim_is_rock ? light : scratch.rock;
  auto& below = scratch.from_below;
  nothing_met(below[0].row(last), below[1].row(last), below[2].row(last), width);
  for (int v = last - 1; v >= 0; --v) {
    carry(loops, rock.row(v + 1), below[0].row(v + 1), below[1].row(v + 1), below[2].row(v + 1), below[0].row(v),
          below[1].row(v), below[2].row(v), width);
  }
  auto& before = scratch.above_before;
  auto& above = scratch.from_above;
  nothing_met(above[0].data(), above[1].data(), above[2].data(), width);
  for (int v = 0; v <= last; ++v) {
    if (v > 0) {
      before.swap(above);
      carry(loops, rock.row(v - 1), before[0].data(), before[1].data(), before[2].data(), above[0].data(),
            above[1].data(), above[2].data(), width);
    }
    along_row(rock.row(v), scratch.along[0].data(), scratch.along[1].data(), width);
    const std::int16_t* const met[] = {below[0].row(v),         below[1].row(v),        below[2].row(v),
                                       above[0].data(),         above[1].data(),        above[2].data(),
                                       scratch.along[0].data(), scratch.along[1].data()};
    loops.rate_rises(met, light.row(v), out.row(v), width);
  }
}

}  // namespace adit
