#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "eval_gallery.hpp"
#include "pages.hpp"

namespace adit::tools {
namespace {

constexpr double kSide = 180.0;                             ///< of the square, in units of the picture
constexpr double kLeft = 46.0, kTop = 44.0, kRight = 24.0;  // the largest dot clears name and edge
constexpr double kDotArea = 500.0;                          ///< of all answers in one bin

double x_of(double confidence) { return kLeft + kSide * confidence; }
double y_of(double right) { return kTop + kSide * (1.0 - right); }

std::string frame_and_ticks() {
  std::string svg = fmt::format(
      "<rect x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{2}\" class=\"plot\"/>"
      "<line x1=\"{3}\" y1=\"{4}\" x2=\"{5}\" y2=\"{6}\" class=\"diagonal\"/>",
      kLeft, kTop, kSide, x_of(0), y_of(0), x_of(1), y_of(1));
  for (const double tick : {0.0, 0.5, 1.0}) {
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"tick\" text-anchor=\"middle\">{}</text>", x_of(tick),
                       y_of(0) + 14.0, tick);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"tick\" text-anchor=\"end\">{}</text>", kLeft - 5.0,
                       y_of(tick) + 4.0, tick);
  }
  svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"tick\" text-anchor=\"middle\">confidence</text>",
                     x_of(0.5), y_of(0) + 28.0);
  return svg + fmt::format(
                   "<text transform=\"translate(11 {:.1f}) rotate(-90)\" class=\"tick\" text-anchor=\"middle\">"
                   "share of right answers</text>",
                   y_of(0.5));
}

}  // namespace

std::string reliability_diagram(const std::string& title, const eval::Figures& figures, const char* colour) {
  double total = 0.0;
  for (const eval::ReliabilityBin& bin : figures.reliability) total += bin.count;
  std::string svg = fmt::format(
      "<svg class=\"reliability\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" "
      "aria-label=\"Reliability of {}: calibration error {:.2f}\">",
      kLeft + kSide + kRight, kTop + kSide + 34.0, html_of(title), figures[eval::Figure::kCalibrationError].value);
  svg += fmt::format("<text x=\"{}\" y=\"16\" class=\"name\">{}: error {:.2f}</text>", kLeft, html_of(title),
                     figures[eval::Figure::kCalibrationError].value);
  svg += frame_and_ticks();
  for (const eval::ReliabilityBin& bin : figures.reliability) {
    if (bin.count == 0.0) continue;
    const double radius = std::max(2.0, std::sqrt(kDotArea * bin.count / total));
    svg += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\"><title>{:.0f} answers: confidence {:.2f}, right "
        "{:.2f}</title></circle>",
        x_of(bin.confidence), y_of(bin.right), radius, colour, bin.count, bin.confidence, bin.right);
  }
  return svg + "</svg>\n";
}

}  // namespace adit::tools
