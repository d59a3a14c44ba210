// The bench compares like with like: the strong OpenCV chain answers as the finder does, pixel for pixel.
#include "opencv_chains.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "adit/io/image_file.hpp"

namespace adit::tools {
namespace {

cv::Mat tunnel() { return io::read_image(ADIT_SOURCE_DIR "/data/tunnel.jpg"); }

TEST(OpenCvChains, TheStrongChainAgreesWithTheFinder) {
  cv::Mat noise(120, 161, CV_8UC3);
  cv::RNG(5).fill(noise, cv::RNG::UNIFORM, 0, 256);
  cv::Mat half;
  cv::resize(tunnel(), half, {321, 239}, 0, 0, cv::INTER_AREA);
  for (const cv::Mat& frame : {tunnel(), noise, half}) {
    OpenSpaceFinder finder(paper_preset());
    const OpenSpace seen = finder.find(io::view_of(frame));
    StrongOpenCvChain chain(finder.config(), frame.size());
    for (int i = 0; i < 2; ++i) {
      const ChainAnswer answer = chain.find(frame);
      EXPECT_EQ(answer.area_px, static_cast<double>(seen.moments.m00));
      EXPECT_NEAR(answer.centroid_px.x, seen.centroid_px.u_px, 1e-9);
      EXPECT_NEAR(answer.centroid_px.y, seen.centroid_px.v_px, 1e-9);
      EXPECT_NEAR(answer.atmospheric_light, seen.atmospheric_light, 1e-9);
    }
  }
}

TEST(OpenCvChains, TheOtherOneIsNotFarOff) {
  const cv::Mat frame = tunnel();
  OpenSpaceFinder finder(paper_preset());
  const OpenSpace seen = finder.find(io::view_of(frame));
  OpenCvChain chain(finder.config(), frame.size());
  cv::setRNGSeed(1);
  const ChainAnswer answer = chain.find(frame);  // one random start
  EXPECT_NEAR(answer.atmospheric_light, seen.atmospheric_light, 1e-9);
  EXPECT_NEAR(answer.centroid_px.x, seen.centroid_px.u_px, 80.0);
  EXPECT_NEAR(answer.centroid_px.y, seen.centroid_px.v_px, 80.0);
}

}  // namespace
}  // namespace adit::tools
