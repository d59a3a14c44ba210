// What a person wants to be told of a run: spells of trouble, jumps, lost frames.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "report_table.hpp"

namespace adit::tools {
namespace {

std::string degrees_text(double from_deg, double to_deg) {
  char text[96];
  std::snprintf(text, sizeof text, "the best opening moved from %+.1f to %+.1f deg", from_deg, to_deg);
  return text;
}

/// Spells that go on, by kind and text.
class Spells {
 public:
  Spells(const ReportTable& table, std::vector<ReportEvent>& events) : table_(&table), events_(&events) {}

  void see(std::size_t row, const std::string& kind, const std::string& text) {
    const auto [at, is_new] = open_.try_emplace({kind, text}, ReportEvent{row, row, kind, text});
    if (is_new) return;
    ReportEvent& event = at->second;
    if (time(row) - time(event.last) > kSpellGap_s && row > event.last + 1) {
      end(event);
      event = {row, row, kind, text};
    } else {
      event.last = row;
    }
  }

  void end_all() {
    for (auto& [key, event] : open_) end(event);
  }

 private:
  [[nodiscard]] double time(std::size_t row) const { return table_->time_s()[row]; }
  void end(const ReportEvent& event) {
    if (event.kind == "hold" && time(event.last) - time(event.first) < kHoldCounts_s) return;
    events_->push_back(event);
  }

  const ReportTable* table_;
  std::vector<ReportEvent>* events_;
  std::map<std::pair<std::string, std::string>, ReportEvent> open_;
};

void see_flags(Spells& spells, std::size_t row, std::string_view flags) {
  while (!flags.empty()) {
    const std::size_t plus = flags.find('+');
    const std::string flag(flags.substr(0, plus));
    spells.see(row, flag, "flag " + flag);
    flags = plus == std::string_view::npos ? std::string_view() : flags.substr(plus + 1);
  }
}

void see_row(Spells& spells, const ReportTable& table, std::size_t row) {
  const std::string status(table.word("status", row));
  if (status == "unreadable") {
    spells.see(row, "unreadable", "the frame could not be read");
  } else if (!status.empty() && status != "found") {
    spells.see(row, "refused", status);
  }
  see_flags(spells, row, table.word("flags", row));
  const std::string delivery(table.word("delivery", row));
  if (!delivery.empty() && delivery != "fresh") spells.see(row, delivery, "the camera's frame was " + delivery);
  if (table.word("heading_state", row) == "hold") spells.see(row, "hold", "the command was to hold");
}

}  // namespace

std::vector<ReportEvent> events_of(const ReportTable& table) {
  std::vector<ReportEvent> events;
  Spells spells(table, events);
  std::int64_t last_found = -1;  // none yet
  std::size_t next_source = 0;
  for (std::size_t row = 0; row < table.size(); ++row) {
    if (next_source < table.sources().size() && table.sources()[next_source].first == row) {
      ++next_source;
      last_found = -1;  // another source: its frames do not follow the last one's
    }
    see_row(spells, table, row);
    const double azimuth_deg = table.number("azimuth_deg", row);
    if (!std::isfinite(azimuth_deg)) continue;
    const auto before = static_cast<std::size_t>(last_found);
    if (last_found >= 0 && table.time_s()[row] - table.time_s()[before] <= kSpellGap_s) {
      const double before_deg = table.number("azimuth_deg", before);
      if (std::abs(azimuth_deg - before_deg) > kJump_deg)
        events.push_back({row, row, "jump", degrees_text(before_deg, azimuth_deg)});
    }
    last_found = static_cast<std::int64_t>(row);
  }
  spells.end_all();
  std::stable_sort(events.begin(), events.end(),
                   [](const ReportEvent& a, const ReportEvent& b) { return a.first < b.first; });
  return events;
}

}  // namespace adit::tools
