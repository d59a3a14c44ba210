#include "spread_frame.hpp"

#include <algorithm>

namespace adit::test {

SpreadFrame::SpreadFrame(const Frame& frame, std::string what, std::ptrdiff_t row, std::ptrdiff_t pixel,
                         std::ptrdiff_t channel, std::ptrdiff_t offset)
    : name(std::move(what)) {
  const int bytes = bytes_per_pixel(frame.format);
  const bool is_colour = bytes >= 3;
  // Where the lowest byte lies, from the first pixel, and how many there are.
  std::ptrdiff_t low = 0, high = is_colour ? 0 : bytes - 1;
  for (const auto& [stride, count] :
       {std::pair{row, frame.height}, {pixel, frame.width}, {channel, is_colour ? bytes : 1}}) {
    low += std::min<std::ptrdiff_t>(0, stride * (count - 1));
    high += std::max<std::ptrdiff_t>(0, stride * (count - 1));
  }
  memory = noise(static_cast<int>(high - low + 1 + offset), 1, PixelFormat::kGrey8, 5).bytes;
  std::uint8_t* const first = memory.data() + offset - low;
  for (int v = 0; v < frame.height; ++v)
    for (int u = 0; u < frame.width; ++u)
      for (int byte = 0; byte < bytes; ++byte)
        first[v * row + u * pixel + byte * (is_colour ? channel : 1)] = frame.pixel(u, v)[byte];
  view = {first, frame.width, frame.height, row, frame.format, pixel, is_colour ? channel : kSideBySide};
}

SpreadFrame::SpreadFrame(const SpreadFrame& other) : name(other.name), memory(other.memory), view(other.view) {
  view.data = memory.data() + (other.view.data - other.memory.data());
}

std::vector<SpreadFrame> spreads_of(const Frame& frame) {
  const std::ptrdiff_t n = bytes_per_pixel(frame.format), w = frame.width, h = frame.height;
  std::vector<SpreadFrame> all;
  all.emplace_back(frame, "mirrored", n * w, -n, 1);
  all.emplace_back(frame, "mirrored and upside down", -n * w, -n, 1);
  all.emplace_back(frame, "every second column", 2 * n * w, 2 * n, 1);
  all.emplace_back(frame, "columns first", n, n * h, 1);
  all.emplace_back(frame, "columns first, from the lower right", -n, -n * h, 1);
  all.emplace_back(frame, "gaps of odd length, at an odd address", (n + 1) * w + 3, n + 1, 1, 1);
  if (n < 3) return all;
  all.emplace_back(frame, "planes", w, 1, w * h);
  all.emplace_back(frame, "planes from the last", w, 1, -w * h);
  all.emplace_back(frame, "mirrored planes", w, -1, w * h);
  all.emplace_back(frame, "lines of planes", n * w, 1, w);
  all.emplace_back(frame, "channels from the other end", n * w, n, -1);
  return all;
}

}  // namespace adit::test
