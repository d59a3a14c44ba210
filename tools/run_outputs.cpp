#include "run_outputs.hpp"

#include <CLI/Error.hpp>
#include <cstdio>
#include <filesystem>

#include "adit/io/errors.hpp"

namespace adit::tools {

namespace fs = std::filesystem;

void make_run_folder(const OutputOptions& options) {
  if (!options.folder.empty()) io::make_folder(options.folder);
}

void check_outputs(OutputOptions& options, FileUses& uses) {
  if (!options.folder.empty() && options.csv.empty())
    options.csv = (fs::path(options.folder) / "headings.csv").string();
  if (options.csv == "-" && options.jsonl == "-") {
    throw CLI::ValidationError("--jsonl", "standard output is taken by --csv");
  }
  uses.writes_into("--out", options.folder, {"headings.csv", "settings.yaml", "made_by.json", "camera.yaml"});
  uses.writes_pictures_into("--frames", options.frames_folder);
  uses.writes("--csv", options.csv);
  uses.writes("--jsonl", options.jsonl);
  uses.writes("--video", options.video);
  uses.writes("--frames", options.frames_folder);
  uses.writes("--report", options.report);
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
