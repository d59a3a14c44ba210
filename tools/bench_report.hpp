// The figures of `adit bench`, for people and for programs.
#pragma once

#include <string>

#include "bench_measure.hpp"

namespace adit::tools {

/// The table, the ratios with what they should reach, and the machine: what the README quotes.
[[nodiscard]] std::string table_of(const BenchFigures& figures);

/// All of it as one JSON object; times in ms.
[[nodiscard]] std::string json_of(const BenchFigures& figures);

}  // namespace adit::tools
