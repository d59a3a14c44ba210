// What a robot's program does with adit: wrap the camera's pixels, ask, steer.
#include <adit/finder.hpp>
#include <adit/heading.hpp>
#include <iostream>
#include <vector>

#ifdef WITH_IO
bool reads_back(const adit::ImageView& frame);
#endif
#ifdef WITH_SIM
std::size_t presets();
#endif

int main() {
  constexpr int kWidth_px = 64;
  constexpr int kHeight_px = 48;
  const std::vector<std::uint8_t> pixels(static_cast<std::size_t>(kWidth_px * kHeight_px), 100);
  const adit::ImageView frame{pixels.data(), kWidth_px, kHeight_px, kWidth_px, adit::PixelFormat::kGrey8};
  adit::FinderConfig config = adit::paper_preset();
  config.method = adit::Method::kPaper;
  adit::OpenSpaceFinder finder(config);
  const adit::OpenSpace open_space = finder.find(frame);
  adit::HeadingController controller;
  const adit::HeadingCommand command = controller.update(open_space, 0.0);
  std::cout << "adit says: " << adit::to_string(open_space.status) << ", yaw rate " << command.yaw_rate_rad_s << '\n';
#ifdef WITH_IO
  if (!reads_back(frame)) return 1;
#endif
#ifdef WITH_SIM
  if (presets() == 0) return 1;
#endif
  return 0;
}
