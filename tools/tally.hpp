// How many frames came to what, and what the shell is told of it.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "adit/finder.hpp"
#include "exit_code.hpp"

namespace adit::tools {

class Tally {
 public:
  void add(Status status) { ++by_status_[static_cast<std::size_t>(status)]; }
  void add_unreadable() { ++unreadable_; }

  [[nodiscard]] std::int64_t frames() const;
  /// Frames that the finder looked at.
  [[nodiscard]] std::int64_t judged() const;
  /// kSuccess when every frame was judged, kSomeUnreadable when some, and why not when none.
  [[nodiscard]] ExitCode exit_code() const;
  /// "20 frames: 17 found, 2 no_region, 1 unreadable"
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] std::int64_t count(Status status) const { return by_status_[static_cast<std::size_t>(status)]; }

  std::array<std::int64_t, kStatusCount> by_status_{};
  std::int64_t unreadable_ = 0;
};

}  // namespace adit::tools
