#include "report_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "adit/io/errors.hpp"

namespace adit::tools {
namespace {

constexpr const char* kNumbers[] = {"confidence",
                                    "u_px",
                                    "v_px",
                                    "sx",
                                    "sy",
                                    "azimuth_deg",
                                    "elevation_deg",
                                    "area_fraction",
                                    "yaw_rate_rad_s",
                                    "speed_scale",
                                    "track",
                                    "track_azimuth_deg",
                                    "veil_fraction",
                                    "find_ms",
                                    "x_m",
                                    "y_m",
                                    "z_m",
                                    "yaw_deg",
                                    "height_m",
                                    "passage_azimuth_deg",
                                    "side_clearance_m"};
constexpr std::size_t kWordsMax = 255;

int column_of(const std::vector<std::string>& header, std::string_view name) {
  const auto found = std::find(header.begin(), header.end(), name);
  return found == header.end() ? -1 : static_cast<int>(found - header.begin());
}

double number_of(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? value : std::numeric_limits<double>::quiet_NaN();
}

std::uint8_t code_of(ReportWords& words, const std::string& word) {
  const auto found = std::find(words.known.begin(), words.known.end(), word);
  if (found != words.known.end()) return static_cast<std::uint8_t>(found - words.known.begin());
  if (words.known.size() == kWordsMax) return static_cast<std::uint8_t>(kWordsMax - 1);  // never with our own tables
  words.known.push_back(word);
  return static_cast<std::uint8_t>(words.known.size() - 1);
}

}  // namespace

ReportTable::ReportTable(const std::vector<std::string>& header, std::string_view name) {
  stamp_at_ = column_of(header, "stamp_s");
  source_at_ = column_of(header, "source");
  is_flight_ = column_of(header, "x_m") >= 0 && column_of(header, "delivery") >= 0;
  if (stamp_at_ < 0 || column_of(header, "status") < 0 || (!is_flight_ && source_at_ < 0))
    throw io::InputError(std::string(name) +
                         ": this is no table of 'adit run' or 'adit fly' (columns stamp_s, status and source, or "
                         "delivery and x_m); give the folder of one of these");
  for (const char* column : kNumbers)
    if (const int at = column_of(header, column); at >= 0) {
      column_at_.push_back(at);
      columns_.push_back({column, {}});
    }
  const std::pair<const char*, const char*> words[] = {{"status", "status"},         {"heading_state", "heading_state"},
                                                       {"command", "heading_state"}, {"delivery", "delivery"},
                                                       {"flags", "flags"},           {"rule", "rule"},
                                                       {"manoeuvre", "manoeuvre"}};
  for (const auto& [column, shown] : words)
    if (const int at = column_of(header, column); at >= 0) {
      word_at_.push_back(at);
      words_.push_back({shown, {""}, {}});
    }
}

void ReportTable::add(const std::vector<std::string>& cells) {
  bool new_source = false;
  if (source_at_ >= 0) {
    const std::string& source = cells[static_cast<std::size_t>(source_at_)];
    new_source = sources_.empty() || sources_.back().second != source;
    if (new_source) sources_.emplace_back(size(), source);
  }
  add_time(number_of(cells[static_cast<std::size_t>(stamp_at_)]), new_source);
  for (std::size_t i = 0; i < columns_.size(); ++i)
    columns_[i].values.push_back(static_cast<float>(number_of(cells[static_cast<std::size_t>(column_at_[i])])));
  for (std::size_t i = 0; i < words_.size(); ++i)
    words_[i].codes.push_back(code_of(words_[i], cells[static_cast<std::size_t>(word_at_[i])]));
}

void ReportTable::add_time(double stamp_s, bool new_source) {
  constexpr double kFallback_s = 1.0 / 30.0;  // as images without a clock
  const double step_s = interval_s_ > 0.0 ? interval_s_ : kFallback_s;
  if (time_s_.empty()) {
    offset_s_ = std::isfinite(stamp_s) ? -stamp_s : 0.0;
    time_s_.push_back(0.0);
    return;
  }
  double time_s = stamp_s + offset_s_;
  if (!std::isfinite(time_s) || time_s <= time_s_.back()) {
    time_s = time_s_.back() + step_s;
    if (new_source && std::isfinite(stamp_s)) {
      offset_s_ = time_s - stamp_s;
      restarts_.push_back(time_s_.size());
    }
  } else if (!new_source) {
    interval_s_ = time_s - time_s_.back();
  }
  time_s_.push_back(time_s);
}

double ReportTable::number(std::string_view column, std::size_t row) const {
  for (const ReportColumn& c : columns_)
    if (c.name == column) return static_cast<double>(c.values[row]);
  return std::numeric_limits<double>::quiet_NaN();
}

std::string_view ReportTable::word(std::string_view column, std::size_t row) const {
  for (const ReportWords& w : words_)
    if (w.name == column) return w.known[w.codes[row]];
  return "";
}

}  // namespace adit::tools
