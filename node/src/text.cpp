#include "text.hpp"

#include <charconv>

namespace adit::node {

std::string text_of(double value, int digits) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits);
  return end.ec == std::errc() ? std::string(text, end.ptr) : "-";
}

std::string quoted(std::string_view words) {
  constexpr std::size_t kLongest = 40;
  std::string text = "'";
  for (const char c : words.substr(0, kLongest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (words.size() > kLongest ? "...'" : "'");
}

void add_latency(Diagnosis& diagnosis, const std::string& name, const LatencyMeter& latency) {
  const LatencyFigures f = latency.figures();
  const auto add = [&](const char* key, double value_s) {
    diagnosis.add(name + key, f.count > 0 ? text_of(1e3 * value_s, 3) : "-");
  };
  add(" p50 (ms)", f.p50_s);
  add(" p90 (ms)", f.p90_s);
  add(" p99 (ms)", f.p99_s);
  add(" max (ms)", f.max_s);
}

void add_stamps(Diagnosis& diagnosis, const StampCheck& stamps) {
  const double interval_s = stamps.interval_s();
  diagnosis.add("rate (Hz)", interval_s > 0.0 ? text_of(1.0 / interval_s, 2) : "-");
  diagnosis.add("dropped", std::to_string(stamps.lost()));
  for (std::size_t i = 0; i < kStampVerdictCount; ++i) {
    const auto verdict = static_cast<StampVerdict>(i);
    diagnosis.add("stamps " + std::string(to_string(verdict)), std::to_string(stamps.count(verdict)));
  }
}

}  // namespace adit::node
