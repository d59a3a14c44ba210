#include "chain_reference.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace adit::reference {
namespace {

struct Colour {
  double smallest;
  double mean;
};

Colour colour_at(const ImageView& frame, int grey16_depth_bits, int u, int v) {
  const std::uint8_t* pixel = frame.row(v) + static_cast<std::ptrdiff_t>(u) * bytes_per_pixel(frame.format);
  if (frame.format == PixelFormat::kGrey8) return {double(pixel[0]), double(pixel[0])};
  if (frame.format == PixelFormat::kGrey16) {
    std::uint16_t value = 0;
    std::memcpy(&value, pixel, sizeof value);
    const double level = std::min(std::floor(value / std::pow(2.0, grey16_depth_bits - 8)), 255.0);
    return {level, level};
  }
  const double b = pixel[0], g = pixel[1], r = pixel[2];
  return {std::min({b, g, r}), (b + g + r) / 3.0};
}

/// Pixels (u, v) from the anchor that belong to the element.
using Element = std::vector<std::pair<int, int>>;

Element square(int size) {
  Element element;
  for (int v = -size / 2; v <= size / 2; ++v) {
    for (int u = -size / 2; u <= size / 2; ++u) element.emplace_back(u, v);
  }
  return element;
}

/// A row of the ellipse reaches as far as the curve there, rounded to the nearest pixel (as OpenCV draws it).
Element ellipse(int size) {
  Element element;
  const int r = size / 2;
  for (int v = -r; v <= r; ++v) {
    const int reach = r == 0 ? 0 : static_cast<int>(std::nearbyint(r * std::sqrt((r * r - v * v) / double(r * r))));
    for (int u = -reach; u <= reach; ++u) element.emplace_back(u, v);
  }
  return element;
}

/// Eq. (4): the extreme value under the element; pixels outside the picture take no part. A row at a time, so that the
/// inner loop is one that a compiler makes quick.
template <class Pick>
Picture extreme(const Picture& in, const Element& element, Pick pick) {
  Picture out = in;  // the anchor belongs to all our elements
  for (int v = 0; v < in.height; ++v) {
    for (const auto& [du, dv] : element) {
      if (v + dv < 0 || v + dv >= in.height) continue;
      const int first = std::max(0, -du);
      const int end = std::min(in.width, in.width - du);
      const double* from = in.row(v + dv) + du;
      double* to = out.row(v);
      for (int u = first; u < end; ++u) to[u] = pick(to[u], from[u]);
    }
  }
  return out;
}

Picture eroded(const Picture& in, const Element& element) {
  return extreme(in, element, [](double a, double b) { return b < a ? b : a; });
}
Picture dilated(const Picture& in, const Element& element) {
  return extreme(in, element, [](double a, double b) { return b > a ? b : a; });
}

/// He et al. (2011), 4.4: the mean brightness where the dark channel is brightest, ties included.
double light_of(const Picture& dark, const Picture& brightness, double fraction) {
  std::vector<double> sorted = dark.values;
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  const double wanted = std::max(1.0, std::ceil(fraction * double(sorted.size())));
  const double last = sorted[static_cast<std::size_t>(wanted) - 1];
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < dark.values.size(); ++i) {
    if (dark.values[i] < last) continue;
    sum += brightness.values[i];
    count += 1.0;
  }
  return sum / count;
}

struct Partition {
  long double cost = 0.0L;
  std::size_t first_end = 0;  // one past the last value of the first cluster
};

/// best[k][n]: the first n values in k clusters; the ends are kept to read back where the first one was.
Partition optimum(const std::map<double, std::uint64_t>& pixels_of_value, int cluster_count) {
  const std::vector<std::pair<double, std::uint64_t>> points(pixels_of_value.begin(), pixels_of_value.end());
  const std::size_t n = points.size();
  const std::size_t clusters = std::min<std::size_t>(static_cast<std::size_t>(cluster_count), n);
  constexpr long double kNone = std::numeric_limits<long double>::infinity();
  std::vector<std::vector<long double>> best(clusters + 1, std::vector<long double>(n + 1, kNone));
  std::vector<std::vector<std::size_t>> start(clusters + 1, std::vector<std::size_t>(n + 1, 0));
  best[0][0] = 0.0L;
  for (std::size_t k = 1; k <= clusters; ++k) {
    for (std::size_t end = k; end <= n; ++end) {
      // Grow the last cluster downwards; mean and cost by Welford's update.
      long double weight = 0.0L, mean = 0.0L, cost = 0.0L;
      for (std::size_t first = end; first-- > k - 1;) {
        const auto w = static_cast<long double>(points[first].second);
        const long double off = points[first].first - mean;
        weight += w;
        mean += w / weight * off;
        cost += w * off * (points[first].first - mean);
        const long double total = best[k - 1][first] + cost;
        if (total < best[k][end]) {
          best[k][end] = total;
          start[k][end] = first;
        }
      }
    }
  }
  std::size_t end = n;
  for (std::size_t k = clusters; k > 1; --k) end = start[k][end];
  return {best[clusters][n], end};
}

}  // namespace

double darkest_cluster_end(const std::map<double, std::uint64_t>& pixels_of_value, int cluster_count) {
  const std::size_t end = optimum(pixels_of_value, cluster_count).first_end;
  return std::next(pixels_of_value.begin(), static_cast<std::ptrdiff_t>(end) - 1)->first;
}

long double least_cost(const std::map<double, std::uint64_t>& pixels_of_value, int cluster_count) {
  return optimum(pixels_of_value, cluster_count).cost;
}

Answer judge(const ImageView& frame, const FinderConfig& config, int patch_px, int element_px) {
  Picture smallest(frame.width, frame.height);
  Picture brightness(frame.width, frame.height);
  for (int v = 0; v < frame.height; ++v) {
    for (int u = 0; u < frame.width; ++u) {
      const Colour colour = colour_at(frame, config.grey16_depth_bits, u, v);
      smallest.at(u, v) = colour.smallest;
      brightness.at(u, v) = colour.mean;
    }
  }
  const Picture dark = eroded(smallest, square(patch_px));  // eq. (3)

  Answer answer;
  const double a = light_of(dark, brightness, config.atmospheric_light_fraction);
  answer.atmospheric_light = a;
  const auto depth_at = [&config, a](double level) {
    const double t = a > 0.0 ? std::max(1.0 - config.omega * (level / a), config.transmission_min) : 1.0;  // eq. (3)
    return std::abs(std::log(t)) / config.scattering_coefficient;                                          // eq. (2)
  };
  Picture depth = dark;
  std::transform(dark.values.begin(), dark.values.end(), depth.values.begin(), depth_at);
  const Element element = ellipse(element_px);
  const Picture closed = eroded(dilated(depth, element), element);      // eq. (5), on the depth itself
  const Picture closed_dark = eroded(dilated(dark, element), element);  // only for the verdict, which is in levels

  std::map<double, std::uint64_t> pixels_of_value;
  for (const double d : closed.values) ++pixels_of_value[d];
  answer.threshold_depth = darkest_cluster_end(pixels_of_value, config.cluster_count);  // eq. (6) and (7)

  double m00 = 0.0, m10 = 0.0, m01 = 0.0;  // eq. (8)
  double darkest = 255.0, brightest = 0.0;
  for (int v = 0; v < frame.height; ++v) {
    for (int u = 0; u < frame.width; ++u) {
      darkest = std::min(darkest, closed_dark.at(u, v));
      brightest = std::max(brightest, closed_dark.at(u, v));
      if (closed.at(u, v) > answer.threshold_depth) continue;
      answer.threshold_level = std::max(answer.threshold_level, static_cast<int>(closed_dark.at(u, v)));
      m00 += 1.0;
      m10 += u;
      m01 += v;
    }
  }
  answer.u_px = m10 / m00;  // eq. (9)
  answer.v_px = m01 / m00;
  answer.area_fraction = m00 / double(closed.values.size());

  if (a < config.too_dark_light_max) {
    answer.status = Status::kTooDark;
  } else if (darkest >= config.too_bright_level_min) {
    answer.status = Status::kTooBright;
  } else if (brightest - darkest < config.contrast_levels_min || pixels_of_value.size() < 2) {
    answer.status = Status::kNoContrast;
  } else if (answer.area_fraction < config.area_fraction_min) {
    answer.status = Status::kNoRegion;
  } else {
    answer.status = Status::kFound;
  }
  return answer;
}

}  // namespace adit::reference
