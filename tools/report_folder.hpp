// The report of what lies in a folder.
#pragma once

#include <filesystem>
#include <functional>

#include "report.hpp"

namespace adit::tools {

/// @param folder  of `adit fly --out`, of `adit run --out`, or any with a table of these.
/// @param on_frame  told how many pictures have been looked at.
/// @throws io::InputError when there is no table, or more than one and none by a known name.
[[nodiscard]] Report report_of_folder(const std::filesystem::path& folder,
                                      const std::function<void(std::int64_t)>& on_frame);

}  // namespace adit::tools
