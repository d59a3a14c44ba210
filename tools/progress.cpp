#include "progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace adit::tools {
namespace {

using std::chrono::duration;
constexpr auto kBarEvery = std::chrono::milliseconds(100);
constexpr auto kLineEvery = std::chrono::seconds(5);

int terminal_width() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

/// "0:07", "12:34", "1:02:03"
std::string clock_text(double seconds) {
  const auto whole = static_cast<long long>(std::clamp(std::ceil(seconds), 0.0, 1e9));
  char text[40];
  if (whole >= 3600) {
    std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60, whole % 60);
  } else {
    std::snprintf(text, sizeof text, "%lld:%02lld", whole / 60, whole % 60);
  }
  return text;
}

std::string bar(double share, int width) {
  const int filled = static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * width));
  std::string cells(static_cast<std::size_t>(width), '-');
  std::fill_n(cells.begin(), filled, '#');
  return "[" + cells + "] ";
}

}  // namespace

void print_line(const std::string& line) {
  std::string clean = line;
  for (char& c : clean) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  std::fprintf(stderr, "%s\n", clean.c_str());
}

Progress::Progress(std::optional<std::int64_t> total, std::string unit, bool quiet)
    : total_(total),
      unit_(std::move(unit)),
      quiet_(quiet),
      terminal_(::isatty(STDERR_FILENO) == 1),
      begin_(Clock::now()),
      next_show_(begin_ + (terminal_ ? Clock::duration(kBarEvery) : Clock::duration(kLineEvery))) {}

Progress::~Progress() { clear(); }

double Progress::elapsed_s() const { return duration<double>(Clock::now() - begin_).count(); }

std::string Progress::status(std::int64_t done) const {
  const double rate_hz = static_cast<double>(done) / std::max(elapsed_s(), 1e-9);
  char rate[64];
  std::snprintf(rate, sizeof rate, rate_hz < 10.0 ? "%.1f" : "%.0f", rate_hz);
  std::string text = std::to_string(done);
  if (total_) text += " of " + std::to_string(*total_);
  text += " " + unit_ + ", " + rate + " a second";
  if (total_ && done > 0) {
    text += ", " + clock_text(static_cast<double>(std::max<std::int64_t>(*total_ - done, 0)) / rate_hz) + " left";
  }
  return text;
}

void Progress::show(std::int64_t done) {
  if (quiet_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_show_) return;
  const std::string text = status(done);
  if (!terminal_) {
    next_show_ = now + kLineEvery;
    print_line(text);
    return;
  }
  next_show_ = now + kBarEvery;
  std::string line;
  const int room = terminal_width() - static_cast<int>(text.size()) - 4;
  if (total_ && *total_ > 0 && room >= 10) {
    line = bar(static_cast<double>(done) / static_cast<double>(*total_), std::min(room, 40));
  }
  std::fprintf(stderr, "\r\033[K%s%s", line.c_str(), text.c_str());
  std::fflush(stderr);
  bar_shown_ = true;
}

void Progress::say(const std::string& line) {
  clear();
  print_line(line);
}

void Progress::clear() {
  if (!bar_shown_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  bar_shown_ = false;
}

}  // namespace adit::tools
