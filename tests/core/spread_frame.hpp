// The same pixels in layouts of memory in which they do not lie side by side.
#pragma once

#include <string>
#include <vector>

#include "frames.hpp"

namespace adit::test {

struct SpreadFrame {
  std::string name;
  std::vector<std::uint8_t> memory;  ///< what belongs to no pixel is noise
  ImageView view;                    ///< into memory: moved, never copied

  SpreadFrame(const Frame& frame, std::string what, std::ptrdiff_t row, std::ptrdiff_t pixel, std::ptrdiff_t channel,
              std::ptrdiff_t offset = 0);
  SpreadFrame(const SpreadFrame& other);
};

/// Mirrored, turned upside down, every second column, columns first, with gaps of odd length; in colour also planes,
/// lines of planes, and channels from the other end.
[[nodiscard]] std::vector<SpreadFrame> spreads_of(const Frame& frame);

}  // namespace adit::test
