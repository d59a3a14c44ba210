#include "cusp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace adit {
namespace {

constexpr int kBlock = 4;

/// The frame of a common lens, 640 x 480 px, and light drawn on its blocks.
struct Lit {
  explicit Lit(int width = 640, int height = 480)
      : camera(pinhole(width, height, 75.0)), grid(width, height), fit(grid, camera, kBlock, 12.0) {}

  void draw(const std::function<double(const Bearing&)>& log_light) {
    std::vector<double> blocks;
    for (int v = 0; v < grid.height() / kBlock; ++v) {
      for (int u = 0; u < grid.width() / kBlock; ++u) {
        const Pixel middle{grid.u_px((u + 0.5) * kBlock - 0.5), grid.v_px((v + 0.5) * kBlock - 0.5)};
        blocks.push_back(log_light(camera.bearing_of(middle)));
      }
    }
    fit.judge(blocks);
  }

  /// Column of the cell with the largest weight in the row that shows the horizon.
  int heaviest() {
    const std::vector<std::int16_t>& row = fit.weights_of_row(grid.height() / 2);
    return static_cast<int>(std::max_element(row.begin(), row.end()) - row.begin());
  }

  Camera camera;
  CellGrid grid;
  CuspFit fit;
};

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

double cosine_between(const Bearing& a, double azimuth_rad) {
  return std::cos(a.elevation_rad) * std::cos(a.azimuth_rad - azimuth_rad);
}

/// A tube seen along its axis: inverse square, and grazing incidence.
double tube(const Bearing& at, double azimuth_rad) {
  const double cosine = cosine_between(at, azimuth_rad);
  return 1.5 * std::log(1.0 - cosine * cosine + 0.002);
}

/// A plane whose normal has that azimuth, likewise.
double wall(const Bearing& at, double azimuth_rad) { return 3.0 * std::log(cosine_between(at, azimuth_rad)); }

/// A narrow beam with its axis aside.
double beam(const Bearing& at) {
  return -4.0 * (std::pow(at.azimuth_rad - 0.1, 2) + std::pow(at.elevation_rad + 0.05, 2));
}

TEST(Cusp, APassageHasOneWhereItLeads) {
  Lit lit;
  for (const double azimuth_deg : {-25.0, -10.0, 0.0, 15.0, 30.0}) {
    lit.draw([&](const Bearing& at) { return tube(at, radians(azimuth_deg)) + beam(at); });
    EXPECT_GT(lit.fit.most(), 0.8) << azimuth_deg;
    const double found_deg =
        lit.camera.bearing_of({lit.grid.u_px(lit.heaviest()), 239.5}).azimuth_rad * 180.0 / std::numbers::pi;
    EXPECT_NEAR(found_deg, azimuth_deg, 3.75) << "half a patch, and a cell";
  }
}

TEST(Cusp, OfTwoWaysEachHasItsOwn) {
  Lit lit;
  lit.draw([&](const Bearing& at) { return std::min(0.0, std::max(tube(at, 0.4), -8.0)) + 0.7 * tube(at, -0.4); });
  const auto column = [&](double azimuth_rad) {
    return (lit.camera.pixel_of(Bearing{azimuth_rad, 0.0})->u_px - 1.5) / 4.0;
  };
  const double right = lit.fit.share_at(column(0.4), 59.5), left = lit.fit.share_at(column(-0.4), 59.5);
  EXPECT_GT(right, left);
  EXPECT_GT(left, 2.0 * lit.fit.share_at(column(0.0), 59.5));
  EXPECT_LE(right, lit.fit.most() + 1e-6);
}

TEST(Cusp, AWallHasNoneHoweverItIsTurnedAndLit) {
  Lit lit;
  // Drawn rock is never quite smooth: a twentieth of its light, which a quadratic does not hold either.
  const auto rough = [](const Bearing& at) { return 0.05 * std::sin(37.0 * at.azimuth_rad + 53.0 * at.elevation_rad); };
  for (const double azimuth_deg : {-30.0, -10.0, 0.0, 20.0, 30.0}) {
    lit.draw([&](const Bearing& at) { return wall(at, radians(azimuth_deg)) + beam(at) + rough(at); });
    EXPECT_LT(lit.fit.most(), 0.2) << azimuth_deg;
  }
}

TEST(Cusp, ABrightTipIsNoPassage) {
  Lit lit;
  lit.draw([&](const Bearing& at) { return -tube(at, 0.0); });
  EXPECT_LT(lit.fit.most(), 0.3);
}

TEST(Cusp, AnEvenFrameHasNeitherCuspNorChoice) {
  Lit lit;
  lit.draw([](const Bearing&) { return -1.0; });
  EXPECT_LT(lit.fit.most(), 0.05);
  for (const int v : {0, 60, 119}) {
    for (const int weight : lit.fit.weights_of_row(v)) EXPECT_GE(weight, 200);
  }
}

TEST(Cusp, WeightsAreAThirdAtTheLeast) {
  Lit lit;
  lit.draw([](const Bearing& at) { return tube(at, 0.2); });
  for (int v = 0; v < lit.grid.height(); ++v) {
    const std::vector<std::int16_t>& row = lit.fit.weights_of_row(v);
    ASSERT_EQ(static_cast<int>(row.size()), lit.grid.width());
    for (const int weight : row) {
      ASSERT_GE(weight, 95);
      ASSERT_LE(weight, 256);
    }
  }
}

TEST(Cusp, TooFewBlocksSayNothing) {
  for (const auto& [width, height] : {std::pair{16, 16}, {640, 16}, {16, 8192}, {20, 16}}) {
    Lit lit(width, height);
    lit.draw([](const Bearing& at) { return tube(at, 0.0); });
    EXPECT_DOUBLE_EQ(lit.fit.most(), 0.2) << width << " x " << height;
    for (const int weight : lit.fit.weights_of_row(0)) EXPECT_EQ(weight, 256);
  }
}

}  // namespace
}  // namespace adit
