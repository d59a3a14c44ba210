#include "drawn_tunnel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "rock.hpp"

namespace adit::drawn {
namespace {

constexpr double kRange_m = 60.0;
constexpr double kSpeed_m_s = 6.0;
constexpr double kStart_m = 3.0;
constexpr double kLampOffset_m = 0.18;  // each lamp to its side of the lens
constexpr double kLampLobe = 3.0;       // a flood: cos^3 about the axis
constexpr double kLampTilt = -0.15;     // a little towards the floor
constexpr double kBounce = 0.12;        // light that the rock around throws into joints and shadows
constexpr double kLensBlur_px = 0.8;    // of 640, deviation
constexpr double kExposure = 24.0;      // full well is 1
constexpr double kFullWell_electrons = 3000.0;
constexpr double kReadNoise_electrons = 9.0;

struct View {
  Vec eye, right, up, ahead;
};

View view_at(double time_s) {
  const double z = kStart_m + kSpeed_m_s * time_s;
  View view;
  view.eye = {centre_x_m(z) + 0.35 * std::sin(0.9 * time_s + 0.4), 0.1 * std::sin(2.3 * time_s), z};
  const double look_m = 5.0;
  view.ahead = unit(Vec{centre_x_m(z + look_m) - view.eye.x, -0.02 * look_m, look_m});
  const double roll_rad = 0.03 * std::sin(1.7 * time_s);
  const Vec level = unit(Vec{view.ahead.z, 0.0, -view.ahead.x});
  const Vec above{level.y * -view.ahead.z - level.z * -view.ahead.y, level.z * -view.ahead.x - level.x * -view.ahead.z,
                  level.x * -view.ahead.y - level.y * -view.ahead.x};
  view.right = level * std::cos(roll_rad) + above * std::sin(roll_rad);
  view.up = above * std::cos(roll_rad) - level * std::sin(roll_rad);
  return view;
}

/// Distance along a ray to the rock, or kRange_m when there is none before.
double march_m(Vec from, Vec along) {
  double t = 0.2, free = 0.0;
  for (int step = 0; step < 160 && t < kRange_m; ++step) {
    const double room = distance_to_rock_m(from + along * t);
    if (room < 0.0) break;
    free = t;
    if (room < 0.0008 * t) return t;
    t += room;
  }
  if (t >= kRange_m) return kRange_m;
  // The last step went through an edge: back to where the rock begins.
  for (int halving = 0; halving < 8; ++halving) {
    const double middle = 0.5 * (free + t);
    (distance_to_rock_m(from + along * middle) < 0.0 ? t : free) = middle;
  }
  return free;
}

/// Is there rock between a point on the rock and a lamp?
bool is_shadowed(Vec from, Vec along, double end_m) {
  double t = 0.08;  // clear of the bump that the ray starts on
  for (int step = 0; step < 40 && t < end_m; ++step) {
    const double room = distance_to_rock_m(from + along * t);
    if (room < -0.004) return true;
    t += std::max(room, 0.03);
  }
  return false;
}

Vec normal_at(Vec p, double step_m) {
  const double here = distance_to_rock_m(p);
  return unit(Vec{distance_to_rock_m(p + Vec{step_m, 0, 0}) - here, distance_to_rock_m(p + Vec{0, step_m, 0}) - here,
                  distance_to_rock_m(p + Vec{0, 0, step_m}) - here});
}

/// Light that comes back along a ray, for red, green and blue, before exposure.
Vec radiance(const View& view, Vec along) {
  const double range = march_m(view.eye, along);
  if (range >= kRange_m) return {};
  const Vec hit = view.eye + along * range;
  const Vec normal = normal_at(hit, std::max(0.004, 0.0015 * range));
  const Vec lamp_axis = unit(view.ahead + view.up * kLampTilt);
  double light = 0.0;
  for (const double side : {-1.0, 1.0}) {
    const Vec lamp = view.eye + view.right * (side * kLampOffset_m);
    const Vec way = lamp - hit;
    const double distance = length(way);
    const Vec to_lamp = way * (1.0 / distance);
    const double facing = std::max(0.0, dot(normal, to_lamp));
    const double lobe = std::max(0.0, -dot(to_lamp, lamp_axis));
    const double arriving = std::pow(lobe, kLampLobe) / (distance * distance);
    const bool is_lit = facing > 0.0 && !is_shadowed(hit, to_lamp, std::min(distance, 2.5));
    light += arriving * ((is_lit ? facing : 0.0) + kBounce);
  }
  return albedo(hit) * light;
}

/// A number from the bell curve (mean 0, deviation 1) for a pixel of a frame.
double bell(int u, int v, int index, std::uint32_t salt) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - chance(u, v, index, salt)));
  return radius * std::cos(2.0 * std::numbers::pi * chance(u, v, index, salt + 1));
}

/// Photons, noise, clipping, and the sRGB curve.
std::uint8_t developed(double exposed, double chance_bell) {
  const double electrons = exposed * kFullWell_electrons;
  const double deviation = std::sqrt(electrons + kReadNoise_electrons * kReadNoise_electrons);
  const double linear = std::clamp((electrons + deviation * chance_bell) / kFullWell_electrons, 0.0, 1.0);
  const double curve = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * curve));
}

/// Exposed light for each pixel, before the sensor, in the order blue, green, red.
cv::Mat exposed_light(const View& view, int width, int height) {
  const double focal_px = width / 2.0 / std::tan(kHfov_deg / 2.0 * std::numbers::pi / 180.0);
  cv::Mat exposed(height, width, CV_64FC3);
  cv::parallel_for_({0, height}, [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v) {
      for (int u = 0; u < width; ++u) {
        const double x = (u - (width - 1) / 2.0) / focal_px, y = ((height - 1) / 2.0 - v) / focal_px;
        const Vec along = unit(view.ahead + view.right * x + view.up * y);
        const double off_axis = dot(along, view.ahead);
        const double vignette = off_axis * off_axis * off_axis;
        const Vec light = radiance(view, along) * (kExposure * vignette);
        exposed.at<cv::Vec3d>(v, u) = {light.z * 0.92, light.y, light.x};
      }
    }
  });
  return exposed;
}

}  // namespace

cv::Mat tunnel_frame(int index, int width, int height) {
  cv::Mat exposed = exposed_light(view_at(index / kRate_hz), width, height);
  cv::GaussianBlur(exposed, exposed, {}, kLensBlur_px * width / 640.0);
  cv::Mat frame(height, width, CV_8UC3);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      for (int c = 0; c < 3; ++c) {
        frame.at<cv::Vec3b>(v, u)[c] =
            developed(exposed.at<cv::Vec3d>(v, u)[c], bell(u, v, index, 200U + 2U * static_cast<unsigned>(c)));
      }
    }
  }
  return frame;
}

}  // namespace adit::drawn
