// Man pages and the completion of bash, made from what the command line is itself made of.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>

namespace adit::tools {

/// Writes adit.1, adit-SUBCOMMAND.1 and adit.bash into a folder that is there. @throws io::OutputError
void write_manual(const CLI::App& app, const std::filesystem::path& folder);

}  // namespace adit::tools
