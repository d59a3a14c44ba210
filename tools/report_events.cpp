// What a person wants to be told of a run: spells of trouble, changes of branch, lost frames.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include "adit/tracker.hpp"
#include "report_table.hpp"

namespace adit::tools {
namespace {

/// What is followed from row to row, and when it is something else than before.
class Branches {
 public:
  Branches(const ReportTable& table, std::vector<ReportEvent>& events) : table_(&table), events_(&events) {
    for (const ReportColumn& column : table.columns())
      if (column.name == "track")
        is_tracked_ =
            std::any_of(column.values.begin(), column.values.end(), [](float id) { return std::isfinite(id); });
  }

  void see(std::size_t row) {
    if (begins(row)) last_ = kNone;
    const double azimuth_deg = table_->number(is_tracked_ ? "track_azimuth_deg" : "azimuth_deg", row);
    if (!std::isfinite(azimuth_deg)) return;
    if (last_ != kNone && table_->time_s()[row] - table_->time_s()[last_] <= kSpellGap_s) compare(last_, row);
    last_ = row;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Do its frames not follow the last one's? What was tracked through images follows them, each a source of its own.
  bool begins(std::size_t row) {
    if (is_tracked_) {
      const auto& restarts = table_->restarts();
      return std::binary_search(restarts.begin(), restarts.end(), row);
    }
    const auto& sources = table_->sources();
    return std::binary_search(sources.begin(), sources.end(), std::pair(row, std::string()),
                              [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  void compare(std::size_t before, std::size_t row) {
    const char* column = is_tracked_ ? "track_azimuth_deg" : "azimuth_deg";
    const double from_deg = table_->number(column, before), to_deg = table_->number(column, row);
    char text[120];
    if (is_tracked_) {
      if (table_->number("track", before) == table_->number("track", row)) return;
      // Nearer than the tracker's gate it is the same opening, seen twice.
      if (std::abs(to_deg - from_deg) <= TrackerConfig{}.gate_rad * 180.0 / std::numbers::pi) return;
      std::snprintf(text, sizeof text, "another opening is followed: at %+.1f deg, the one before was at %+.1f deg",
                    to_deg, from_deg);
      events_->push_back({row, row, "branch", text});
    } else if (std::abs(to_deg - from_deg) > kJump_deg) {
      std::snprintf(text, sizeof text, "the best opening moved from %+.1f to %+.1f deg", from_deg, to_deg);
      events_->push_back({row, row, "jump", text});
    }
  }

  const ReportTable* table_;
  std::vector<ReportEvent>* events_;
  bool is_tracked_ = false;
  std::size_t last_ = kNone;  ///< row of the last answer
};

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
  const std::string_view manoeuvre = table.word("manoeuvre", row);
  if (manoeuvre == "turn") spells.see(row, "turn", "nothing open ahead: it turned in place");
  if (manoeuvre == "give_up") spells.see(row, "give_up", "it has turned all the way round and found nothing");
}

}  // namespace

std::vector<ReportEvent> events_of(const ReportTable& table) {
  std::vector<ReportEvent> events;
  Spells spells(table, events);
  Branches branches(table, events);
  for (std::size_t row = 0; row < table.size(); ++row) {
    see_row(spells, table, row);
    branches.see(row);
  }
  spells.end_all();
  std::stable_sort(events.begin(), events.end(),
                   [](const ReportEvent& a, const ReportEvent& b) { return a.first < b.first; });
  return events;
}

}  // namespace adit::tools
