// What `adit run` writes: tables, a video, pictures of the frames.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "adit/io/output_file.hpp"
#include "adit/io/table.hpp"
#include "adit/io/video_file.hpp"
#include "file_uses.hpp"
#include "parts.hpp"

namespace adit::tools {

struct OutputOptions {
  std::string csv;
  std::string jsonl;
  std::string video;
  std::string frames_folder;
  std::string folder;  ///< for headings.csv, settings.yaml, made_by.json
  std::string report;
  bool timing = false;
  std::optional<PartLabel> part;  ///< the tables are parts of a whole

  [[nodiscard]] bool wants_pictures() const { return !video.empty() || !frames_folder.empty(); }
};

/// Makes `folder`, if one is asked for. @throws io::OutputError
void make_run_folder(const OutputOptions& options);

/// Puts the table into `folder` unless it has a place of its own. Refuses outputs that would overwrite each other or
/// what is read. @throws CLI::ValidationError
void check_outputs(OutputOptions& options, FileUses& uses);

class RunOutputs {
 public:
  /// Opens everything, so that a place that cannot be written to is found out before the work. Without any output in
  /// the options, the table goes to standard output as CSV. @throws io::OutputError
  RunOutputs(const OutputOptions& options, double video_rate_hz);

  /// Rows are held back until release(), so that a run that judges nothing leaves nothing behind.
  void write_row(const io::TableRow& row);
  void release();

  /// @param png  an encoded picture; `number` counts the frames of the whole run from 0.
  void write_frame(std::int64_t number, const std::string& source, const std::vector<unsigned char>& png);
  void write_video(const cv::Mat& bgr) { video_->write(bgr); }

  /// Everything appears under its name. @throws io::OutputError
  void commit();

 private:
  void add_table(const std::string& path, bool json);

  struct Table {
    std::variant<io::OutputFile, PartFile> file;
    bool json;
    std::string held;
  };

  OutputOptions options_;
  std::vector<Table> tables_;
  std::optional<io::VideoFile> video_;
  bool released_ = false;
};

}  // namespace adit::tools
