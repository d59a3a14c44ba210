// The report of a run while it runs: `adit run --report`.
#pragma once

#include <filesystem>

#include "adit/io/configuration.hpp"
#include "adit/io/table.hpp"
#include "report.hpp"

namespace adit::tools {

class RunReport {
 public:
  /// @param inputs  for the title.
  RunReport(const std::vector<std::string>& inputs, const io::Configuration& configuration);

  /// Are pictures of this frame to be made? @param row  counts frames from 0.
  [[nodiscard]] bool wants(std::int64_t row) const noexcept { return report_.pictures.frames.wants(row); }
  /// Every frame, in order.
  void add_row(const io::TableRow& row);
  /// In order of rows; those of frames that are not wanted any more are passed over.
  void add_shot(std::int64_t row, const cv::Size& frame_size, ReportShot shot);
  /// @throws io::OutputError
  void write(const std::filesystem::path& path);

 private:
  Report report_;
};

/// Settings of a run and what made it, into its folder. @param camera_file  "" for none. @throws io::OutputError
void write_run_origin(const std::filesystem::path& folder, const io::Configuration& configuration,
                      const std::string& camera_file);

}  // namespace adit::tools
