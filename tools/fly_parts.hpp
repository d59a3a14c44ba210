// Flights of a campaign in parts: --shard of `adit fly`, and how `adit merge` joins them.
#pragma once

#include <filesystem>
#include <vector>

#include "fly_runs.hpp"
#include "parts.hpp"

namespace adit::tools {

/// What the parts of this campaign say of themselves. @param seeds  of all parts together.
[[nodiscard]] PartLabel fly_label(const Shard& shard, const std::vector<std::uint64_t>& seeds, FlySettings settings,
                                  const FlyOptions& options, const Site& site);

/// DIR/runs.part-I-of-N
void write_fly_part(const std::filesystem::path& folder, const PartLabel& label, const std::vector<Flown>& runs,
                    sim::Outcome aim);

/// DIR/runs.csv and DIR/runs.json as one machine writes them, and its table on standard output.
void join_flights(const std::filesystem::path& folder, const std::vector<Part>& parts, bool quiet);

}  // namespace adit::tools
