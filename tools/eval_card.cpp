#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "eval_gallery.hpp"
#include "pages.hpp"

namespace adit::tools {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

std::string polygon(const std::vector<Pixel>& corners, const char* kind) {
  std::string points;
  for (const Pixel& corner : corners) points += fmt::format("{:.1f},{:.1f} ", corner.u_px, corner.v_px);
  if (!points.empty()) points.pop_back();
  return fmt::format("<polygon class=\"{}\" points=\"{}\"/>", kind, points);
}

std::string diamond(Pixel at, double size_px, const char* kind, const char* meaning) {
  return fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}l{s} {s}l-{s} {s}l-{s} -{s}z\"><title>{}</title></path>",
                     kind, at.u_px, at.v_px - size_px, meaning, fmt::arg("s", size_px));
}

std::string truth_marks(const EvalFrame& frame, const JudgedFrame& judged, double unit_px) {
  std::string svg = "<g class=\"truth\">";
  for (const auto& outline : judged.open_area) svg += polygon(outline, "area");
  for (const eval::Outline& outline : frame.truth.outlines) svg += polygon(outline.corners, "mark");
  for (const Pixel& branch : judged.branches) svg += diamond(branch, 1.2 * unit_px, "branch", "a passage in sight");
  if (judged.passage) svg += diamond(*judged.passage, 0.7 * unit_px, "branch", "the passage ahead");
  if (judged.deepest) svg += diamond(*judged.deepest, 1.2 * unit_px, "deepest", "the deepest direction");
  return svg + "</g>";
}

std::string answer_mark(const Judged& judged, const std::string& name, std::size_t row, double unit_px) {
  if (!judged.score.answered) return "";
  const Pixel at = judged.given.answer.place;
  std::string svg = fmt::format("<g class=\"answer m{}\" stroke=\"{}\">", row, method_colour(row));
  for (const Pixel& named : judged.given.answer.openings)
    svg += fmt::format("<circle class=\"named\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>", named.u_px, named.v_px,
                       0.7 * unit_px);
  svg += fmt::format(
      "<circle class=\"under\" cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2:.1f}\"/>"
      "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2:.1f}\"/>"
      "<path d=\"M{3:.1f} {1:.1f}h{4:.1f}M{0:.1f} {5:.1f}v{4:.1f}\"/>",
      at.u_px, at.v_px, 1.3 * unit_px, at.u_px - 0.5 * unit_px, unit_px, at.v_px - 0.5 * unit_px);
  return svg + "<title>" + html_of(name) + "</title></g>";
}

std::string answer_words(const Judged& judged, const std::string& name, std::size_t row) {
  const eval::FrameScore& score = judged.score;
  std::string words =
      fmt::format("<li class=\"m{} {}\"><i style=\"background:{}\"></i><b>{}</b> {}", row,
                  eval::to_string(score.verdict), method_colour(row), html_of(name), eval::to_string(score.verdict));
  if (!score.answered) words += " (" + html_of(judged.given.status) + ")";
  if (!std::isnan(score.error_rad)) words += fmt::format(", {:.1f}&deg;", score.error_rad / kDegree);
  if (!std::isnan(score.open_ratio)) words += fmt::format(", open {:.2f}", score.open_ratio);
  if (!std::isnan(score.confidence)) words += fmt::format(", confidence {:.2f}", score.confidence);
  return words + "</li>";
}

}  // namespace

std::string frame_card(const EvalFrame& frame, const JudgedFrame& judged, const SetResult& set,
                       const std::string& picture) {
  const double unit_px = std::max(2.0, judged.width / 60.0);
  std::string verdicts, marks, words;
  for (std::size_t row = 0; row < set.methods.size(); ++row) {
    const MethodResult& method = set.methods[row];
    const Judged& one = judged.methods[method.contender.front()];
    verdicts += fmt::format(" data-v{}=\"{}\" data-e{}=\"{:.2f}\"", row, eval::to_string(one.score.verdict), row,
                            std::isnan(one.score.error_rad) ? 0.0 : one.score.error_rad / kDegree);
    marks += answer_mark(one, method.name, row, unit_px);
    words += answer_words(one, method.name, row);
  }
  std::string card = fmt::format("<figure class=\"card\" data-set=\"{}\"{}>\n", html_of(set.name), verdicts);
  card += fmt::format(
      "<button type=\"button\" aria-expanded=\"false\" aria-label=\"Enlarge {4}\">"
      "<svg viewBox=\"-0.5 -0.5 {0} {1}\" style=\"--w:{2:.2f}px\"><image x=\"-0.5\" y=\"-0.5\" href=\"{3}\" "
      "width=\"{0}\" height=\"{1}\"/>",
      judged.width, judged.height, judged.width / 320.0, html_of(picture), html_of(frame.name));
  card += truth_marks(frame, judged, unit_px) + marks + "</svg></button>\n";
  const char* scene = frame.truth.scene == eval::Scene::kOpen   ? ""
                      : frame.truth.scene == eval::Scene::kNone ? " &middot; no opening"
                                                                : " &middot; undecided";
  return card + fmt::format("<figcaption><b>{}</b> &middot; {} &middot; {}{}<ul>{}</ul></figcaption></figure>\n",
                            html_of(frame.name), html_of(set.name), html_of(frame.place), scene, words);
}

}  // namespace adit::tools
