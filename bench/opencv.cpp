// The same stages and chains with OpenCV, in one thread.
#include <cstddef>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <string>

#include "opencv_chains.hpp"
#include "scenes.hpp"

namespace adit::bench {
namespace {

cv::Mat as_mat(const reference::Plane& plane) {
  return cv::Mat(plane.height, plane.width, CV_8UC1, const_cast<std::uint8_t*>(plane.pixels.data()));
}

cv::Mat as_mat(const ImageView& view) {
  return cv::Mat(view.height, view.width, CV_8UC3, const_cast<std::uint8_t*>(view.data),
                 static_cast<std::size_t>(view.stride_bytes));
}

void run_dark_channel(benchmark::State& state, const Scene& scene) {
  const cv::Mat frame = as_mat(scene.view());
  const cv::Mat patch = cv::getStructuringElement(cv::MORPH_RECT, {scene.patch.width(), scene.patch.height()});
  cv::Mat channels[3];
  cv::Mat dark;
  for (auto _ : state) {
    cv::split(frame, channels);
    cv::min(channels[0], channels[1], channels[0]);
    cv::min(channels[0], channels[2], channels[0]);
    cv::erode(channels[0], dark, patch);
    benchmark::ClobberMemory();
  }
}

void run_closing(benchmark::State& state, const Scene& scene) {
  const cv::Mat dark = as_mat(scene.dark);
  const cv::Mat element = cv::getStructuringElement(cv::MORPH_ELLIPSE, {scene.element.width(), scene.element.height()});
  cv::Mat closed;
  for (auto _ : state) {
    cv::morphologyEx(dark, closed, cv::MORPH_CLOSE, element);
    benchmark::ClobberMemory();
  }
}

void run_histogram(benchmark::State& state, const Scene& scene) {
  const cv::Mat closed = as_mat(scene.closed);
  const int channel = 0;
  const int bins = 256;
  const float range[] = {0.0F, 256.0F};
  const float* ranges[] = {range};
  cv::Mat histogram;
  for (auto _ : state) {
    cv::calcHist(&closed, 1, &channel, {}, histogram, 1, &bins, ranges);
    benchmark::ClobberMemory();
  }
}

void run_moments(benchmark::State& state, const Scene& scene) {
  const cv::Mat closed = as_mat(scene.closed);
  cv::Mat mask;
  for (auto _ : state) {
    cv::threshold(closed, mask, scene.clusters.last_level[0], 255, cv::THRESH_BINARY_INV);
    benchmark::DoNotOptimize(cv::moments(mask, true));
  }
}

template <class Chain>
void run_chain(benchmark::State& state, const Scene& scene) {
  const cv::Mat frame = as_mat(scene.view());
  Chain chain(paper_preset(), frame.size());
  for (auto _ : state) benchmark::DoNotOptimize(chain.find(frame));
}

template <class Run>
void register_each(const char* stage, Run run, bool once_when_large) {
  for (const Scene& scene : scenes()) {
    const bool is_large = scene.view().width > 640;
    auto* registered = benchmark::RegisterBenchmark((stage + ('/' + scene.name)).c_str(),
                                                    [run, &scene](benchmark::State& state) { run(state, scene); });
    // Some take seconds a frame.
    if (is_large && once_when_large) registered->Iterations(1);
  }
}

}  // namespace

void register_opencv() {
  cv::setNumThreads(1);
  register_each("opencv_dark_channel", run_dark_channel, false);
  register_each("opencv_closing", run_closing, true);
  register_each("opencv_histogram", run_histogram, false);
  register_each("opencv_moments", run_moments, false);
  register_each("opencv_chain", run_chain<tools::OpenCvChain>, true);
  register_each("opencv_strong_chain", run_chain<tools::StrongOpenCvChain>, true);
}

}  // namespace adit::bench
