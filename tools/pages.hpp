// Pages for people, kept in the program; they lie as files in tools/pages.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace adit::tools {

/// Of `adit eval --gallery`; its parts are filled in by write_gallery().
[[nodiscard]] std::string_view gallery_page();
[[nodiscard]] std::string_view gallery_js();
/// Of `adit report`; @TITLE@, @CSS@, @JS@, @UPLOT_CSS@, @UPLOT_JS@ and @REPORT@ are to be filled in.
[[nodiscard]] std::string_view report_page();
/// Its script, in five parts that follow one another.
[[nodiscard]] std::string_view report_js();
[[nodiscard]] std::string_view report_charts_js();
[[nodiscard]] std::string_view report_status_js();
[[nodiscard]] std::string_view report_map_js();
[[nodiscard]] std::string_view report_scrubber_js();
/// How the pages of `adit report`, `adit view` and `adit eval` look.
[[nodiscard]] std::string_view look_css();
/// third_party/uPlot.
[[nodiscard]] std::string_view uplot_js();
[[nodiscard]] std::string_view uplot_css();
/// Of `adit mark`.
[[nodiscard]] std::string_view mark_page();

/// Of `adit view`; @CSS@, @JS@, @UPLOT_CSS@ and @UPLOT_JS@ are to be filled in.
[[nodiscard]] std::string_view view_page();
/// Its script, in five parts that follow one another.
[[nodiscard]] std::string_view view_js();
[[nodiscard]] std::string_view view_gauges_js();
[[nodiscard]] std::string_view view_plan_js();
[[nodiscard]] std::string_view view_settings_js();
[[nodiscard]] std::string_view view_look_js();

/// Parts of a script as one.
[[nodiscard]] std::string joined(std::initializer_list<std::string_view> parts);

/// A page with its parts filled in. What is filled in is not looked through for names of parts.
[[nodiscard]] std::string filled_page(std::string_view page,
                                      const std::vector<std::pair<std::string_view, std::string>>& parts);

/// Text as HTML shows it, also within quotes of an attribute.
[[nodiscard]] std::string html_of(std::string_view text);

}  // namespace adit::tools
