// Lines of a far plane are asked for a few at a time, while other work goes on. Internal to the morphology.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace adit {

/// A block of a plane that will be read or written soon. The memory serves a dozen lines at once and no more: asked for
/// all together, they would be waited for.
class LinesAhead {
 public:
  LinesAhead() = default;
  /// @param turns  calls of next() that the block's lines are spread over.
  LinesAhead(const std::uint8_t* first, std::ptrdiff_t pitch, int columns, int rows, int turns) noexcept
      : row_(first), pitch_(pitch), columns_(columns), rows_(rows) {
    const int lines = rows_ * ((columns_ + kLine - 1) / kLine);
    share_ = (lines + turns - 1) / std::max(1, turns);
  }

  void next() noexcept {
    for (int i = 0; i < share_ && rows_ > 0; ++i) {
      __builtin_prefetch(row_ + column_, 0, 2);
      column_ += kLine;
      if (column_ < columns_) continue;
      column_ = 0;
      row_ += pitch_;
      --rows_;
    }
  }

 private:
  static constexpr int kLine = 64;  ///< bytes

  const std::uint8_t* row_ = nullptr;
  std::ptrdiff_t pitch_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  int column_ = 0;
  int share_ = 0;
};

}  // namespace adit
