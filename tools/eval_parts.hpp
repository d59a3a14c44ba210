// Judged frames in parts: --shard of `adit eval`, and how `adit merge` joins them.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "eval_work.hpp"
#include "exit_code.hpp"
#include "parts.hpp"

namespace adit::tools {

/// The arguments that a subcommand was given, but for --shard: what gives the same options again.
[[nodiscard]] std::vector<std::string> arguments_of(const CLI::App& subcommand);

/// What the parts of this evaluation say of themselves.
[[nodiscard]] PartLabel eval_label(const EvalWork& work, const std::vector<std::string>& arguments);

/// The frames that were judged in this shard, beside the file that the whole will be.
void write_eval_part(const std::filesystem::path& whole, const PartLabel& label, const EvalWork& work,
                     const EvalResult& result);

/// Frames as the parts have them, in the place of judging them. @throws io::InputError
void take_eval_parts(EvalWork& work, EvalResult& result);

/// Everything that `adit eval` with these arguments writes, its frames taken from parts (eval.cpp).
[[nodiscard]] ExitCode eval_from_parts(const std::vector<Part>& parts);

}  // namespace adit::tools
