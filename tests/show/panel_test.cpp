#include "adit/io/panel.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "adit/io/image_file.hpp"

namespace adit::io {
namespace {

PanelSubject subject_of(const cv::Mat& frame, const FinderConfig& config = {}) {
  PanelSubject subject{"a frame", frame, {}, {}, config, false};
  OpenSpaceFinder finder(config);
  subject.open_space = finder.explain(view_of(frame), subject.stages);
  return subject;
}

cv::Mat tunnel() { return read_image(ADIT_SOURCE_DIR "/data/tunnel.jpg"); }

/// The verdict's colour, left of its first letter.
cv::Vec3b pill_of(const cv::Mat& panel) { return panel.at<cv::Vec3b>(30, 1920 - 36 - 4); }

TEST(Panel, ARealLikeFrame) {
  const PanelSubject subject = subject_of(tunnel());
  ASSERT_TRUE(subject.open_space.found());
  const cv::Mat panel = explain_panel(subject);
  EXPECT_EQ(panel.cols, 1920);
  EXPECT_EQ(panel.type(), CV_8UC3);
  const cv::Vec3b pill = pill_of(panel);
  EXPECT_GT(pill[1], pill[2]) << "green when found";
}

TEST(Panel, TheRedCircleIsOnTheFrame) {
  const PanelSubject subject = subject_of(tunnel());
  const cv::Mat panel = explain_panel(subject);
  // The frame begins at the margin, 84 + 58 px down, and is shown (1920 - 3 * 36) / 2 px wide.
  const double zoom = 906.0 / 640.0;
  const int u = static_cast<int>(36 + subject.open_space.centroid_px.u_px * zoom);
  const int v = static_cast<int>(142 + subject.open_space.centroid_px.v_px * zoom);
  const cv::Vec3b pixel = panel.at<cv::Vec3b>(v, u);
  EXPECT_GT(pixel[2], 200);
  EXPECT_LT(pixel[1], 90);
}

TEST(Panel, RefusedFramesHaveAPanelToo) {
  cv::Mat speck(480, 640, CV_8UC3, cv::Scalar::all(120));
  cv::rectangle(speck, {300, 200, 20, 20}, cv::Scalar::all(20), cv::FILLED);
  FinderConfig strict = paper_preset();
  strict.area_fraction_min = 0.2;
  struct Case {
    Status status;
    cv::Mat frame;
    FinderConfig config = paper_preset();
  };
  const Case cases[] = {{Status::kTooDark, cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(0)), {}},
                        {Status::kTooBright, cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(255)), {}},
                        {Status::kNoContrast, cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(90)), {}},
                        {Status::kNoRegion, speck, strict},
                        {Status::kBadFrame, cv::Mat(8, 8, CV_8UC3, cv::Scalar::all(90)), {}}};
  for (const Case& c : cases) {
    const PanelSubject subject = subject_of(c.frame, c.config);
    EXPECT_EQ(subject.open_space.status, c.status);
    const cv::Mat panel = explain_panel(subject);
    EXPECT_EQ(panel.cols, 1920);
    const cv::Vec3b pill = pill_of(panel);
    EXPECT_GT(pill[2], pill[1]) << "red when refused: " << to_string(c.status);
  }
}

TEST(Panel, AFrameOfAnotherSizeThanTheCamera) {
  PanelSubject subject{"a frame", tunnel(), {}, {}, {}, true};
  OpenSpaceFinder finder(paper_preset(), Camera(pinhole(320, 240, 75)));
  subject.open_space = finder.explain(view_of(subject.frame), subject.stages);
  EXPECT_EQ(subject.open_space.status, Status::kWrongSize);
  EXPECT_EQ(explain_panel(subject).cols, 1920);
}

TEST(Panel, OddShapesAndDepths) {
  for (const cv::Size size : {cv::Size(16, 16), cv::Size(33, 21), cv::Size(16, 400), cv::Size(1200, 16)}) {
    cv::Mat grey(size, CV_8UC1);
    cv::RNG(3).fill(grey, cv::RNG::UNIFORM, 0, 256);
    EXPECT_EQ(explain_panel(subject_of(grey)).cols, 1920);
    cv::Mat deep;
    grey.convertTo(deep, CV_16U, 257.0);
    EXPECT_EQ(explain_panel(subject_of(deep)).cols, 1920);
  }
}

}  // namespace
}  // namespace adit::io
