// Henyey-Greenstein, and the backscatter of the lamps on the vehicle: since they are fixed to the camera, what they
// send back from the air depends on pixel and range alone.
#include "adit/sim/dust.hpp"

#include <cmath>
#include <numbers>

#include "parts.hpp"

namespace adit::sim {

float henyey_greenstein(float cosine, float g) noexcept {
  const float d = 1.0f + g * g - 2.0f * g * cosine;
  return (1.0f - g * g) / (4.0f * std::numbers::pi_v<float> * d * std::sqrt(d));
}

namespace {

/// In-scattered luminance per metre at a place in front of the lens.
/// @param view unit direction, range_m along it.
float source_at(const std::vector<OwnLamp>& lamps, const DustConfig& dust, const Eigen::Vector3f& view, float range_m) {
  const Eigen::Vector3f place = view * range_m;
  float sum = 0.0f;
  for (const OwnLamp& lamp : lamps) {
    const Eigen::Vector3f way = place - lamp.place;
    const float d = std::max(way.norm(), 1e-3f);
    const Eigen::Vector3f to = way / d;
    const float lux = lamp.intensity_cd * lamp.lobe.at(to.dot(lamp.axis)) / (d * d);
    sum += lux * henyey_greenstein(-to.dot(view), dust.asymmetry) * std::exp(-dust.extinction_1_m * (d + range_m));
  }
  return sum * dust.extinction_1_m * dust.scattering_albedo;
}

}  // namespace

std::unique_ptr<BackscatterTable> backscatter_of(const std::vector<OwnLamp>& lamps, const DustConfig& dust,
                                                 const Camera& camera, int stride, int rows) {
  if (dust.extinction_1_m <= 0.0f) return nullptr;
  using Table = BackscatterTable;
  constexpr int kSubsteps = 4;
  auto table = std::make_unique<Table>();
  const auto range_at = [](double x) { return Table::kRangeScale_m * x / (1.0 - x); };
  for (int j = 0; j < Table::kNodesY; ++j)
    for (int i = 0; i < Table::kNodesX; ++i) {
      const Pixel pixel{static_cast<double>(i) / (Table::kNodesX - 1) * stride,
                        static_cast<double>(j) / (Table::kNodesY - 1) * rows};
      const NormalisedPoint n = camera.normalised_of(pixel);
      const Eigen::Vector3f view =
          Eigen::Vector3f(static_cast<float>(n.sx), static_cast<float>(n.sy), 1.0f).normalized();
      float* const bins = table->luminance[j][i];
      double sum = 0.0;
      bins[0] = 0.0f;
      for (int k = 1; k <= Table::kBins; ++k) {
        for (int s = 0; s < kSubsteps; ++s) {
          const double from = (k - 1 + static_cast<double>(s) / kSubsteps) / Table::kBins;
          const double to = std::min((k - 1 + static_cast<double>(s + 1) / kSubsteps) / Table::kBins, 0.9999);
          const double a = range_at(from), b = range_at(to), m = range_at(0.5 * (from + to));
          // Simpson's rule in x, where dr = scale / (1 - x)^2 dx.
          const auto f = [&](double x, double r) {
            return static_cast<double>(source_at(lamps, dust, view, static_cast<float>(r))) * Table::kRangeScale_m /
                   ((1.0 - x) * (1.0 - x));
          };
          sum += (to - from) / 6.0 * (f(from, a) + 4.0 * f(0.5 * (from + to), m) + f(to, b));
        }
        bins[k] = static_cast<float>(sum);
      }
    }
  return table;
}

}  // namespace adit::sim
