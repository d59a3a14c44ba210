// The two kinds of sets, for eval_sets.cpp alone.
#pragma once

#include "eval_sets.hpp"

namespace adit::tools {

void read_marked(const std::filesystem::path& marks, EvalSet& set);
void read_rendered(const std::filesystem::path& truth, EvalSet& set);

}  // namespace adit::tools
