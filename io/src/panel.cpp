#include "adit/io/panel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "adit/io/draw.hpp"
#include "marks.hpp"
#include "panel_parts.hpp"

namespace adit::io {
namespace {

constexpr int kWidth_px = 1920;
constexpr int kMargin_px = 36;
constexpr int kTitle_px = 84;
constexpr int kHeading_px = 58;
constexpr int kArrow_px = 30;  // room between two stages
constexpr int kCaption_px = 84;
constexpr int kFigures_px = 330;

/// Height of a picture of the frame's shape at a width; extreme shapes are letterboxed.
int height_at(int width_px, cv::Size frame) {
  return static_cast<int>(
      std::lround(width_px * std::clamp(static_cast<double>(frame.height) / frame.width, 0.3, 1.2)));
}

void draw_panel_title(cv::Mat& panel, const PanelSubject& subject) {
  const OpenSpace& seen = subject.open_space;
  char words[160];
  if (seen.found()) {
    std::snprintf(words, sizeof words, "open space found, confidence %.2f", seen.confidence);
  } else {
    std::snprintf(words, sizeof words, "no open space: %s", reason_of(seen.status).c_str());
  }
  const Lettering verdict{20, cv::Scalar(255, 255, 255), true, Align::kCentre};
  const cv::Size size = size_of_text(words, verdict);
  const cv::Rect pill(kWidth_px - kMargin_px - size.width - 40, 26, size.width + 40, 48);
  cv::rectangle(panel, pill, seen.found() ? kGood * 0.75 : kBad, cv::FILLED);
  write_text(panel, words, {pill.x + pill.width / 2, pill.y + 14}, verdict);
  const Lettering title{24, kInk, false, Align::kLeft};
  const std::string size_text = std::to_string(subject.frame.cols) + " x " + std::to_string(subject.frame.rows) + " px";
  const Lettering small{16, kFaint, false, Align::kLeft};
  const int room = pill.x - 2 * kMargin_px - size_of_text(size_text, small).width - 24;
  const std::string name = fitted(subject.name, title, room);
  write_text(panel, name, {kMargin_px, 38}, title);
  write_text(panel, size_text, {kMargin_px + size_of_text(name, title).width + 24, 44}, small);
}

void draw_section(cv::Mat& panel, int top, const std::string& name, const std::string& remark) {
  const Lettering bold{15, kInk, true, Align::kLeft};
  write_text(panel, name, {kMargin_px, top + 28}, bold);
  const Lettering faint{14, kFaint, false, Align::kLeft};
  write_text(panel, remark, {kMargin_px + size_of_text(name, bold).width + 24, top + 28}, faint);
}

/// Fig. 2. Drawn at the size it is shown at, so that the circle and the words are as large on every frame.
void draw_pair(cv::Mat& panel, cv::Rect box, const PanelSubject& subject) {
  const int width = (box.width - kMargin_px) / 2;
  const cv::Rect left(box.x, box.y, width, box.height), right(box.x + width + kMargin_px, box.y, width, box.height);
  const cv::Rect frame = place(panel, left, bgr_of(subject.frame, subject.config.grey16_depth_bits));
  const bool has_depth = !subject.stages.closing.empty();
  const cv::Rect map = has_depth ? place(panel, right, depth_map(subject.stages)) : right;
  if (!has_depth) {
    cv::rectangle(panel, right, kEmpty, cv::FILLED);
    write_text(panel, "no depth map was made", {right.x + right.width / 2, right.y + right.height / 2},
               {18, kFaint, false, Align::kCentre});
  }
  if (!subject.open_space.found()) return;
  for (const cv::Rect& shown : {frame, map}) {
    const double zoom = static_cast<double>(shown.width) / subject.frame.cols;
    Scale scale = scale_of(shown.size());
    scale.radius_px = std::max(scale.radius_px, 18);
    const Pixel centre{(subject.open_space.centroid_px.u_px + 0.5) * zoom - 0.5,
                       (subject.open_space.centroid_px.v_px + 0.5) * zoom - 0.5};
    cv::Mat part = panel(shown);
    draw_circle(part, centre, kCircle, scale);
  }
}

/// Fig. 1.
void draw_stages(cv::Mat& panel, cv::Rect box, const PanelSubject& subject) {
  const std::vector<StageTile> tiles = stage_tiles(subject);
  const int count = static_cast<int>(tiles.size());
  const int width = (box.width - (count - 1) * kArrow_px) / count;
  const int height = box.height - kCaption_px;
  Scale arrow;
  arrow.text_px = 12;
  arrow.line_px = 2;
  for (int i = 0; i < count; ++i) {
    const StageTile& tile = tiles[static_cast<std::size_t>(i)];
    const cv::Rect room(box.x + i * (width + kArrow_px), box.y, width, height);
    if (tile.picture.empty()) {
      cv::rectangle(panel, room, kEmpty, cv::FILLED);
      write_text(panel, "not reached", {room.x + width / 2, room.y + height / 2 - 6},
                 {13, kFaint, false, Align::kCentre});
    } else {
      place(panel, room, tile.picture);
    }
    if (i + 1 < count) {
      const int middle = room.y + height / 2;
      draw_arrow(panel, {room.x + width + 4, middle}, {room.x + width + kArrow_px - 5, middle}, kInk, arrow);
    }
    const Lettering name{14, kInk, true, Align::kLeft}, faint{12, kFaint, false, Align::kLeft};
    write_text(panel, fitted(tile.name, name, width + kArrow_px / 2), {room.x, room.y + height + 12}, name);
    write_text(panel, fitted(tile.equation, faint, width + kArrow_px / 2), {room.x, room.y + height + 38}, faint);
    write_text(panel, fitted(tile.note, faint, width + kArrow_px / 2), {room.x, room.y + height + 62}, faint);
  }
}

}  // namespace

cv::Rect place(cv::Mat& panel, cv::Rect box, const cv::Mat& picture) {
  const double zoom =
      std::min(static_cast<double>(box.width) / picture.cols, static_cast<double>(box.height) / picture.rows);
  const cv::Size size(std::clamp(static_cast<int>(std::lround(picture.cols * zoom)), 1, box.width),
                      std::clamp(static_cast<int>(std::lround(picture.rows * zoom)), 1, box.height));
  const cv::Rect where(box.x + (box.width - size.width) / 2, box.y + (box.height - size.height) / 2, size.width,
                       size.height);
  cv::rectangle(panel, box, kSheet, cv::FILLED);
  cv::resize(picture, panel(where), size, 0, 0, zoom < 1.0 ? cv::INTER_AREA : cv::INTER_NEAREST);
  return where;
}

cv::Mat explain_panel(const PanelSubject& subject) {
  const cv::Size frame = bgr_of(subject.frame, subject.config.grey16_depth_bits).size();
  const int inner = kWidth_px - 2 * kMargin_px;
  const int pair_px = height_at((inner - kMargin_px) / 2, frame);
  const int stage_count = kStageCount + 2;  // and the frame, and the transmission
  const int stages_px = height_at((inner - (stage_count - 1) * kArrow_px) / stage_count, frame) + kCaption_px;
  const int pair_top = kTitle_px + kHeading_px;
  const int stages_top = pair_top + pair_px + kHeading_px;
  const int figures_top = stages_top + stages_px + kHeading_px;
  cv::Mat panel(figures_top + kFigures_px + kMargin_px, kWidth_px, CV_8UC3, kPaper);
  draw_panel_title(panel, subject);
  draw_section(panel, kTitle_px, "The answer",
               "Fig. 2: the centroid on the frame; the depth map, dark = far, bright = near");
  draw_pair(panel, {kMargin_px, pair_top, inner, pair_px}, subject);
  draw_section(panel, stages_top - kHeading_px, "How it came about", "Fig. 1, stage by stage");
  draw_stages(panel, {kMargin_px, stages_top, inner, stages_px}, subject);
  const int histogram_px = inner * 11 / 20;
  draw_section(panel, figures_top - kHeading_px, "Grey levels and clusters",
               "closed dark channel, pixels per level (square-root scale); red: the darkest cluster");
  draw_histogram(panel, {kMargin_px, figures_top, histogram_px, kFigures_px}, subject);
  draw_figures(panel, {2 * kMargin_px + histogram_px, figures_top, inner - histogram_px - kMargin_px, kFigures_px},
               subject);
  return panel;
}

}  // namespace adit::io
