// The two kinds of sets, for eval_sets.cpp alone.
#pragma once

#include "eval_sets.hpp"

namespace adit::tools {

/// Both add frames to the set. @param prefix  of the frames' names, "" or "drift_1/".
void read_marked(const std::filesystem::path& marks, const std::string& prefix, EvalSet& set);
void read_rendered(const std::filesystem::path& truth, const std::string& prefix, EvalSet& set);

}  // namespace adit::tools
