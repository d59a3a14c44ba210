#include "report_run.hpp"

#include <fstream>
#include <iterator>

#include "adit/io/output_file.hpp"
#include "eval_csv.hpp"
#include "report_figures.hpp"

namespace adit::tools {
namespace {

ReportOrigin origin_of(const io::Configuration& configuration) {
  return origin_now(io::to_yaml(configuration), io::to_yaml({}));
}

}  // namespace

RunReport::RunReport(const std::vector<std::string>& inputs, const io::Configuration& configuration) {
  report_.table = ReportTable(csv_cells_of(io::csv_header(false)), "table");
  report_.origin = origin_of(configuration);
  report_.title = "Run over " + std::filesystem::path(inputs.front()).filename().string();
  if (inputs.size() > 1) report_.title += " and " + std::to_string(inputs.size() - 1) + " more";
}

void RunReport::add_row(const io::TableRow& row) { report_.table.add(csv_cells_of(io::csv_line(row, false))); }

void RunReport::add_shot(std::int64_t row, const cv::Size& frame_size, ReportShot shot) {
  report_.pictures.add(row, frame_size, std::move(shot));
}

void RunReport::write(const std::filesystem::path& path) {
  report_.figures.clear();
  add_figures_of_table(report_.table, report_.figures);
  write_report(path, report_);
}

void write_run_origin(const std::filesystem::path& folder, const io::Configuration& configuration,
                      const std::string& camera_file) {
  write_origin(folder, origin_of(configuration));
  if (camera_file.empty()) return;
  std::ifstream file(camera_file, std::ios::binary);
  io::write_file(folder / "camera.yaml", std::string(std::istreambuf_iterator<char>(file), {}));
}

}  // namespace adit::tools
