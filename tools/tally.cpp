#include "tally.hpp"

#include <numeric>

namespace adit::tools {

std::int64_t Tally::frames() const {
  return std::accumulate(by_status_.begin(), by_status_.end(), std::int64_t{0}) + unreadable_;
}

std::int64_t Tally::judged() const {
  return frames() - unreadable_ - count(Status::kBadFrame) - count(Status::kWrongSize);
}

ExitCode Tally::exit_code() const {
  if (judged() == frames()) return kSuccess;
  if (judged() > 0) return kSomeUnreadable;
  return count(Status::kWrongSize) > 0 ? kBadConfiguration : kBadInput;
}

std::string Tally::text() const {
  std::string text = std::to_string(frames()) + (frames() == 1 ? " frame" : " frames");
  const char* separator = ": ";
  const auto add = [&](std::int64_t number, std::string_view name) {
    if (number == 0) return;
    text += separator;
    text += std::to_string(number) + " ";
    text += name;
    separator = ", ";
  };
  for (int i = 0; i < kStatusCount; ++i) add(count(static_cast<Status>(i)), to_string(static_cast<Status>(i)));
  add(unreadable_, "unreadable");
  return text;
}

}  // namespace adit::tools
