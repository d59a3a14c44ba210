// What `adit bench` measures.
#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <utility>
#include <vector>

#include "adit/finder.hpp"
#include "bench_timing.hpp"

namespace adit::tools {

/// What to measure with.
struct BenchSubject {
  std::string name;       ///< of the frame, for people
  cv::Mat bgr;            ///< 8-bit, 3 channels
  double seconds = 10.0;  ///< about how long in all; > 0
  TimeKind time_kind = TimeKind::kPassed;
};

/// All times of one run, on one core.
struct BenchFigures {
  TimeKind time_kind = TimeKind::kPassed;  ///< of all but the stages, which always count what passed
  std::string frame_name;
  cv::Size size;  ///< px
  int patch_size_px = 0;
  int structuring_element_size_px = 0;
  std::string target;              ///< CPU target of the pixel loops
  int core = -1;                   ///< that the thread was tied to; -1: it was not allowed
  std::int64_t interruptions = 0;  ///< while the frames of `frame` were timed
  Samples frame;                   ///< OpenSpaceFinder::find, method `paper`
  std::array<Samples, kStageCount> stages;
  Samples copy;                                          ///< memcpy of the frame
  Samples strong;                                        ///< StrongOpenCvChain
  Samples opencv;                                        ///< OpenCvChain
  Samples adit_frame;                                    ///< the same frame by the method `adit`
  Samples noise;                                         ///< find on a frame of noise, the same size
  Samples frame_4k;                                      ///< find on 3840 x 2160 px, patch and element 101 px
  std::vector<std::pair<std::string, Samples>> targets;  ///< find, by each target this CPU can run
};

/// At least so many frames are timed for the 99.9th percentile, unless that takes four times the seconds asked for.
inline constexpr std::size_t kFramesMin = 3000;

/// Times everything, in turns, on the calling thread, which it ties to its core. Sets OpenCV to one thread.
[[nodiscard]] BenchFigures measure(const BenchSubject& subject);

}  // namespace adit::tools
