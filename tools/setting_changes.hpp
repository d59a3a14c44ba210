// Settings that were changed by hand while something ran, as summaries and reports tell of them.
#pragma once

#include <string>
#include <vector>

#include "adit/io/configuration.hpp"

namespace adit::tools {

/// One setting, changed before the frame of this stamp was judged.
struct SettingChange {
  double stamp_s = 0.0;
  std::string setting;  ///< "finder.cluster_count"
  std::string from, to;
};

/// What differs, in the order of the settings.
[[nodiscard]] std::vector<SettingChange> changes_between(io::Configuration before, io::Configuration after,
                                                         double stamp_s);

/// Those that a flight's summary.json tells of; none where it tells of none or cannot be read.
[[nodiscard]] std::vector<SettingChange> changes_in(const std::string& summary_json);

/// "finder.cluster_count 10 → 5"
[[nodiscard]] std::string text_of(const SettingChange& change);
/// What to make of a flight in which these were changed, for people; "" where none were.
[[nodiscard]] std::string note_of(const std::vector<SettingChange>& changes);

}  // namespace adit::tools
