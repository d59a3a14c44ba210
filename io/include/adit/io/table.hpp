// The table of answers, a row for each frame, as CSV (RFC 4180, lines end with \n) or as JSON Lines.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "adit/finder.hpp"
#include "adit/heading.hpp"
#include "adit/tracker.hpp"

namespace adit::io {

/// What is known of a frame. Numbers that do not exist are empty in CSV and null in JSON, never 0.
struct TableRow {
  std::string source;
  std::int64_t frame = 0;
  double stamp_s = 0.0;
  std::optional<OpenSpace> open_space;    ///< nothing: the frame could not be read; its status is "unreadable"
  std::optional<HeadingCommand> command;  ///< nothing: no command came of this frame
  std::string message;                    ///< why it could not be read
  std::optional<Track> track = {};        ///< the opening that is followed from frame to frame; nothing: none
};

/// Those that are up, joined with a plus: "dust+glare". "" when none is.
[[nodiscard]] std::string flags_text(const SightFlags& flags);

/// Reals have a fixed number of digits, with a point in every locale, so that equal answers are equal bytes.
/// @param timing  also the column find_ms, which is never the same twice.
[[nodiscard]] std::string csv_header(bool timing);
[[nodiscard]] std::string csv_line(const TableRow& row, bool timing);
/// One JSON object, with the columns' names as keys, and a line end.
[[nodiscard]] std::string json_line(const TableRow& row, bool timing);

}  // namespace adit::io
