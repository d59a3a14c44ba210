// The chain of the paper in plain double precision, written from its text: the judge of the fast chain. Every step is
// the shortest loop that says what the equation says; nothing of the library's stages is used.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "adit/finder.hpp"
#include "adit/image.hpp"

namespace adit::reference {

/// A picture of real numbers, rows one after the other.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<double> values;

  Picture(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  [[nodiscard]] double at(int u, int v) const { return values[index(u, v)]; }
  [[nodiscard]] double& at(int u, int v) { return values[index(u, v)]; }
  [[nodiscard]] const double* row(int v) const { return values.data() + index(0, v); }
  [[nodiscard]] double* row(int v) { return values.data() + index(0, v); }

 private:
  [[nodiscard]] std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
  }
};

struct Answer {
  Status status = Status::kBadFrame;
  double atmospheric_light = 0.0;
  double threshold_depth = 0.0;  ///< the largest scattering depth in the darkest cluster
  int threshold_level = 0;       ///< the largest level of the closed dark channel in the darkest cluster
  double u_px = 0.0;
  double v_px = 0.0;
  double area_fraction = 0.0;
};

/// Where the first cluster of the optimal partition into `cluster_count` intervals ends: its largest value.
/// O(K n^2) dynamic programming over the sorted values, each with its number of pixels.
[[nodiscard]] double darkest_cluster_end(const std::map<double, std::uint64_t>& pixels_of_value, int cluster_count);

/// The least cost of any partition into at most `cluster_count` intervals, by the same.
[[nodiscard]] long double least_cost(const std::map<double, std::uint64_t>& pixels_of_value, int cluster_count);

/// @param patch_px, element_px  odd sizes of the patch and of the elliptical element.
[[nodiscard]] Answer judge(const ImageView& frame, const FinderConfig& config, int patch_px, int element_px);

}  // namespace adit::reference
