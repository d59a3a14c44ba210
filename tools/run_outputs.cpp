#include "run_outputs.hpp"

#include <CLI/Error.hpp>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "adit/io/errors.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;

bool same_place(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  return fs::weakly_canonical(fs::absolute(a), error) == fs::weakly_canonical(fs::absolute(b), error);
}

/// Devices and standard output may be written by several, /dev/null above all.
bool is_regular(const std::string& path) {
  std::error_code error;
  return path != "-" && (!fs::exists(path, error) || !fs::is_other(path, error));
}

}  // namespace

void make_run_folder(OutputOptions& options) {
  if (options.folder.empty()) return;
  io::make_folder(options.folder);
  if (options.csv.empty()) options.csv = (fs::path(options.folder) / "headings.csv").string();
}

void check_outputs(const OutputOptions& options, const std::vector<std::string>& inputs) {
  const std::vector<std::pair<const char*, const std::string*>> outputs{{"--csv", &options.csv},
                                                                        {"--jsonl", &options.jsonl},
                                                                        {"--video", &options.video},
                                                                        {"--frames", &options.frames_folder},
                                                                        {"--report", &options.report}};
  if (options.csv == "-" && options.jsonl == "-") {
    throw CLI::ValidationError("--jsonl", "standard output is taken by --csv");
  }
  for (auto a = outputs.begin(); a != outputs.end(); ++a) {
    if (a->second->empty() || !is_regular(*a->second)) continue;
    for (auto b = outputs.begin(); b != a; ++b) {
      if (!b->second->empty() && same_place(*a->second, *b->second)) {
        throw CLI::ValidationError(a->first, *a->second + " is taken by " + b->first);
      }
    }
    for (const std::string& input : inputs) {
      if (same_place(*a->second, input)) {
        throw CLI::ValidationError(a->first, *a->second + " is an input; it would be written over");
      }
    }
  }
}

RunOutputs::RunOutputs(const OutputOptions& options, double video_rate_hz) : options_(options) {
  const bool nothing_asked =
      options.csv.empty() && options.jsonl.empty() && !options.wants_pictures() && options.report.empty();
  if (!options.csv.empty() || nothing_asked) add_table(nothing_asked ? "-" : options.csv, false);
  if (!options.jsonl.empty()) add_table(options.jsonl, true);
  if (!options.video.empty()) video_.emplace(options.video, video_rate_hz);
  if (!options.frames_folder.empty()) io::make_folder(options.frames_folder);
}

void RunOutputs::add_table(const std::string& path, bool json) {
  const std::string head = json ? "" : io::csv_header(options_.timing);
  if (!options_.part) {
    tables_.push_back({io::OutputFile(path), json, head});
    return;
  }
  PartLabel label = *options_.part;
  label.kind = json ? "jsonl" : "csv";
  label.head = head;  // stands at the top of the whole, not of each part
  tables_.push_back({PartFile(path, label), json, ""});
}

void RunOutputs::write_row(const io::TableRow& row) {
  for (Table& table : tables_) {
    const std::string line = table.json ? io::json_line(row, options_.timing) : io::csv_line(row, options_.timing);
    if (released_) {
      std::visit([&line](auto& file) { file.write(line); }, table.file);
    } else {
      table.held += line;
    }
  }
}

void RunOutputs::release() {
  if (released_) return;
  released_ = true;
  for (Table& table : tables_) {
    std::visit([&table](auto& file) { file.write(table.held); }, table.file);
    table.held.clear();
  }
}

void RunOutputs::write_frame(std::int64_t number, const std::string& source, const std::vector<unsigned char>& png) {
  char digits[24];
  std::snprintf(digits, sizeof digits, "%06lld", static_cast<long long>(number));
  const std::string name = std::string(digits) + "_" + fs::path(source).stem().string().substr(0, 200) + ".png";
  io::write_file(fs::path(options_.frames_folder) / name, {reinterpret_cast<const char*>(png.data()), png.size()});
}

void RunOutputs::commit() {
  release();
  // First all bytes reach the disk, then the names appear: a full disk leaves none of them.
  for (Table& table : tables_) std::visit([](auto& file) { file.finish(); }, table.file);
  if (video_) video_->finish();
  for (Table& table : tables_) std::visit([](auto& file) { file.commit(); }, table.file);
  if (video_) video_->commit();
}

}  // namespace adit::tools
