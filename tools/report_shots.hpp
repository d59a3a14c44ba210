// The pictures of a report as files of a folder, so that a report can be made of it later.
#pragma once

#include <filesystem>

#include "report_pictures.hpp"

namespace adit::tools {

/// Of a flight's folder.
inline constexpr const char* kShotsFolder = "shots";

/// ROW.frame.jpg and ROW.stages.jpg, and what they show in shots.json. @throws io::OutputError
void write_shots(const std::filesystem::path& folder, const ReportPictures& pictures);

/// The same back; false, and nothing changed, where there is no shots.json. @throws io::InputError: it is damaged
[[nodiscard]] bool read_shots(const std::filesystem::path& folder, ReportPictures& pictures);

}  // namespace adit::tools
