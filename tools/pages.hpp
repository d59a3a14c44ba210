// Pages for people, kept in the program; they lie as files in tools/pages.
#pragma once

#include <string>
#include <string_view>

namespace adit::tools {

/// Of `adit eval --gallery`; @SUMMARY@, @DIAGRAMS@, @METHODS@, @SETS@ and @CARDS@ are to be filled in.
[[nodiscard]] std::string_view gallery_page();
/// Of `adit report`; @TITLE@, @CSS@, @JS@, @UPLOT_CSS@, @UPLOT_JS@ and @REPORT@ are to be filled in.
[[nodiscard]] std::string_view report_page();
[[nodiscard]] std::string_view report_js();
/// How the pages of `adit report` and `adit view` look.
[[nodiscard]] std::string_view look_css();
/// third_party/uPlot.
[[nodiscard]] std::string_view uplot_js();
[[nodiscard]] std::string_view uplot_css();
/// Of `adit mark`.
[[nodiscard]] std::string_view mark_page();

/// Text as HTML shows it, also within quotes of an attribute.
[[nodiscard]] std::string html_of(std::string_view text);

}  // namespace adit::tools
