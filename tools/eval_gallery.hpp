// A page with every frame and every answer, failures first.
#pragma once

#include <filesystem>

#include "eval_work.hpp"
#include "report.hpp"

namespace adit::tools {

/// One HTML page that needs no network and nothing else.
/// @param path  NAME.html: one file, pictures within; anything else: a folder with index.html and thumbs/.
/// @param origin  version, command and settings, which the page ends with.
/// @throws io::OutputError
void write_gallery(const std::filesystem::path& path, const EvalWork& work, const EvalResult& result,
                   const ReportOrigin& origin);

/// "#e69f00": of the method in a row of the table.
[[nodiscard]] const char* method_colour(std::size_t row) noexcept;

/// Reliability diagram as SVG: a dot a bin, its area the share of answers; on the diagonal confidence is probability.
[[nodiscard]] std::string reliability_diagram(const std::string& title, const eval::Figures& figures,
                                              const char* colour);

/// One frame with marks and answers. @param picture  an address or the picture itself (data:).
[[nodiscard]] std::string frame_card(const EvalFrame& frame, const JudgedFrame& judged, const SetResult& set,
                                     const std::string& picture);

}  // namespace adit::tools
