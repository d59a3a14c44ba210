// Draws the clip that adit ships: make_clip FOLDER writes FOLDER/clip.avi (320 x 240 px, Motion JPEG) and
// FOLDER/tunnel.jpg (one frame of it, 640 x 480 px). The same files on every run.
#include <cstdio>
#include <exception>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <stdexcept>
#include <string>

#include "drawn_tunnel.hpp"

namespace {

constexpr int kStillIndex = 45;
constexpr int kStillQuality = 92;
constexpr int kClipQuality = 40;
constexpr int kShrink = 2;  // the clip is drawn at the camera's size and halved: four drawn pixels for each of its own

void make_clip(const std::string& folder) {
  using namespace adit::drawn;
  const cv::Size size(kWidth_px / kShrink, kHeight_px / kShrink);
  // OpenCV's own writer: no outside encoder, so the bytes do not depend on the machine.
  cv::VideoWriter clip;
  if (!clip.open(folder + "/clip.avi", cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), kRate_hz,
                 size)) {
    throw std::runtime_error(folder + "/clip.avi: cannot be written");
  }
  clip.set(cv::VIDEOWRITER_PROP_QUALITY, kClipQuality);
  for (int index = 0; index < kFrameCount; ++index) {
    const cv::Mat frame = tunnel_frame(index, kWidth_px, kHeight_px);
    if (index == kStillIndex &&
        !cv::imwrite(folder + "/tunnel.jpg", frame, {cv::IMWRITE_JPEG_QUALITY, kStillQuality})) {
      throw std::runtime_error(folder + "/tunnel.jpg: cannot be written");
    }
    cv::Mat small;
    cv::resize(frame, small, size, 0, 0, cv::INTER_AREA);
    clip.write(small);
    std::fprintf(stderr, "frame %d of %d\n", index + 1, kFrameCount);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 || argv[1][0] == '-') {
    std::fprintf(stderr,
                 "usage: make_clip FOLDER   writes clip.avi and tunnel.jpg there; a quarter of an hour on one core\n");
    return 2;
  }
  try {
    make_clip(argv[1]);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "make_clip: %s\n", e.what());
    return 1;
  }
}
