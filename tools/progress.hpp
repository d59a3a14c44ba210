// How far long work has come, on standard error: a bar on a terminal, plain lines now and then otherwise.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace adit::tools {

class Progress {
 public:
  /// @param total  steps in all, where that is known.
  /// @param unit   what is counted, "frames".
  Progress(std::optional<std::int64_t> total, std::string unit, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Says that so many steps are done; shown ten times a second at the most.
  void show(std::int64_t done);
  /// Prints a line above the bar, also when quiet: for warnings and errors.
  void say(const std::string& line);
  /// Takes the bar away.
  void clear();

  [[nodiscard]] double elapsed_s() const;

 private:
  [[nodiscard]] std::string status(std::int64_t done) const;

  using Clock = std::chrono::steady_clock;
  std::optional<std::int64_t> total_;
  std::string unit_;
  bool quiet_;
  bool terminal_;
  bool bar_shown_ = false;
  Clock::time_point begin_;
  Clock::time_point next_show_;
};

/// One line to standard error; control characters (from file names) become spaces, so that it stays one.
void print_line(const std::string& line);

}  // namespace adit::tools
