// The results of `adit eval` for people and programs.
#pragma once

#include <string>

#include "eval_work.hpp"

namespace adit::tools {

/// A block a set: methods in rows, figures in columns; columns that nobody has are left out.
[[nodiscard]] std::string eval_text(const EvalWork& work, const EvalResult& result);
/// A row a set and method, with the interval of each figure in columns of their own.
[[nodiscard]] std::string eval_csv(const EvalWork& work, const EvalResult& result);
/// The same, with the reliability diagram and what each method said of each frame.
[[nodiscard]] std::string eval_json(const EvalWork& work, const EvalResult& result);

}  // namespace adit::tools
