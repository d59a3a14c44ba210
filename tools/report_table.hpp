// The rows of a table of `adit run` or `adit fly`, column by column, as a report shows them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace adit::tools {

/// A column of numbers; NaN where there is none.
struct ReportColumn {
  std::string name;
  std::vector<float> values;
};

/// A column of few different words: which word each row has.
struct ReportWords {
  std::string name;
  std::vector<std::string> known;
  std::vector<std::uint8_t> codes;
};

class ReportTable {
 public:
  ReportTable() = default;
  /// @param header  cells of the first line. Columns that a report does not show are passed over.
  /// @throws io::InputError when it is neither a table of `run` nor one of `fly`. @param name  of the file, for that.
  ReportTable(const std::vector<std::string>& header, std::string_view name);

  /// @param cells  as many as the header has. A cell that is no number counts as empty.
  void add(const std::vector<std::string>& cells);

  [[nodiscard]] bool is_flight() const noexcept { return is_flight_; }
  [[nodiscard]] std::size_t size() const noexcept { return time_s_.size(); }
  /// Time of each row, always growing: sources that begin again at 0 are put one after the other.
  [[nodiscard]] const std::vector<double>& time_s() const noexcept { return time_s_; }
  [[nodiscard]] const std::vector<ReportColumn>& columns() const noexcept { return columns_; }
  [[nodiscard]] const std::vector<ReportWords>& words() const noexcept { return words_; }
  /// First row of each source, and the source; empty for flights.
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::string>>& sources() const noexcept { return sources_; }

  /// Rows whose stamp is not later than the one before: there another sequence begins. Images of one sequence are
  /// sources of their own, and their stamps go on.
  [[nodiscard]] const std::vector<std::size_t>& restarts() const noexcept { return restarts_; }

  /// NaN where there is none, or no such column.
  [[nodiscard]] double number(std::string_view column, std::size_t row) const;
  /// "" where there is none, or no such column.
  [[nodiscard]] std::string_view word(std::string_view column, std::size_t row) const;

 private:
  void add_time(double stamp_s, bool new_source);

  bool is_flight_ = false;
  int stamp_at_ = -1, source_at_ = -1;
  std::vector<int> column_at_, word_at_;
  std::vector<ReportColumn> columns_;
  std::vector<ReportWords> words_;
  std::vector<double> time_s_;
  std::vector<std::pair<std::size_t, std::string>> sources_;
  std::vector<std::size_t> restarts_;
  double offset_s_ = 0.0, interval_s_ = 0.0;
};

/// Something that happened, from one row to another.
struct ReportEvent {
  std::size_t first = 0, last = 0;
  std::string kind;  ///< "refused", "dust", "jump", ...
  std::string text;
};

/// Spells of refusals, flags, holds, turns, lost frames, and changes of branch: the tracker follows another opening
/// than before. Where nobody kept track (the published method) jumps of the answer by more than kJump_deg stand for
/// them. Both between frames of one source. Spells of the same kind closer than kSpellGap_s are one. In order of their
/// first row.
[[nodiscard]] std::vector<ReportEvent> events_of(const ReportTable& table);
inline constexpr double kJump_deg = 15.0;   ///< wider than jitter of one opening, narrower than two branches are apart
inline constexpr double kSpellGap_s = 0.5;  ///< as heading.hold_after_s: what is shorter the controller coasts over
inline constexpr double kHoldCounts_s = 0.5;  ///< shorter holds are those at take-off

}  // namespace adit::tools
