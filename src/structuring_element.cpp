#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>

#include "adit/morphology.hpp"

namespace adit {
namespace {

constexpr int kElementSideMax_px = 1023;

void check_side(const char* name, int side_px) {
  if (side_px >= 1 && side_px <= kElementSideMax_px && side_px % 2 == 1) return;
  throw std::invalid_argument(std::string("structuring element ") + name + ": " + std::to_string(side_px) +
                              " is not an odd number from 1 to " + std::to_string(kElementSideMax_px));
}

}  // namespace

StructuringElement::StructuringElement(int width_px, int height_px, std::vector<int> half_chords)
    : width_(width_px), height_(height_px), is_rectangle_(true), half_chords_(std::move(half_chords)) {
  for (const int half : half_chords_) is_rectangle_ = is_rectangle_ && half == width_px / 2;
}

StructuringElement StructuringElement::rectangle(int width_px, int height_px) {
  check_side("width", width_px);
  check_side("height", height_px);
  return {width_px, height_px, std::vector<int>(static_cast<std::size_t>(height_px), width_px / 2)};
}

StructuringElement StructuringElement::ellipse(int width_px, int height_px) {
  check_side("width", width_px);
  check_side("height", height_px);
  const int a = width_px / 2;
  const int b = height_px / 2;
  std::vector<int> half_chords(static_cast<std::size_t>(height_px), 0);
  // The order of the floating-point steps is OpenCV's, so that halves round the same way. With one row it keeps the
  // anchor alone, and so do we.
  const double inverse_b2 = b > 0 ? 1.0 / (static_cast<double>(b) * b) : 0.0;
  for (int v = 0; v < height_px; ++v) {
    const int dv = v - b;
    const double half = a * std::sqrt((b * b - dv * dv) * inverse_b2);
    half_chords[static_cast<std::size_t>(v)] = static_cast<int>(std::lrint(half));
  }
  return {width_px, height_px, std::move(half_chords)};
}

}  // namespace adit
