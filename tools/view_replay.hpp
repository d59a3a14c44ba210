// A flight that lies in a folder, played again in a page.
#pragma once

#include <filesystem>

#include "live_view.hpp"

namespace adit::tools {

/// Is this what `adit fly --out` leaves?
[[nodiscard]] bool is_flight_folder(const std::filesystem::path& folder);
/// Its map; empty where there is none.
[[nodiscard]] LivePlan plan_of_folder(const std::filesystem::path& folder);
/// Shows film and table in their own time, until the end or a signal. Returns how many rows were shown.
/// @throws io::InputError when the table or the film is missing or broken.
[[nodiscard]] std::int64_t replay_flight(const std::filesystem::path& folder, LiveView& live);

}  // namespace adit::tools
