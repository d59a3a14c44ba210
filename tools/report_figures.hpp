// The figures of a whole run, in words.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report_table.hpp"

namespace adit::tools {

using NamedFigures = std::vector<std::pair<std::string, std::string>>;

/// Those of summary.json, "name": "value unit"; none when it cannot be read.
[[nodiscard]] NamedFigures flight_figures(const std::string& summary_json);
/// Counts of frames by status, and the time they span.
void add_figures_of_table(const ReportTable& table, NamedFigures& figures);

}  // namespace adit::tools
