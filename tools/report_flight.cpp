#include "report_flight.hpp"

#include "adit/io/image_file.hpp"
#include "eval_csv.hpp"
#include "fly_outputs.hpp"
#include "report_figures.hpp"
#include "report_shots.hpp"

namespace adit::tools {
FlightReport::FlightReport(const sim::Flight& flight, ReportOrigin origin)
    : explainer_(flight.settings().finder, flight.camera()) {
  report_.table = ReportTable(csv_cells_of(flight_csv_header()), "flight.csv");
  report_.origin = std::move(origin);
}

void FlightReport::use(const sim::Flight& flight) {
  explainer_ = OpenSpaceFinder(flight.settings().finder, flight.camera());
}

void FlightReport::add(const sim::Flight& flight) {
  const auto row = static_cast<std::int64_t>(report_.table.size());
  report_.table.add(csv_cells_of(flight_csv_line(flight.row())));
  if (!report_.pictures.frames.wants(row) || flight.frame().data == nullptr) return;
  StageImages stages;
  const OpenSpace seen = explainer_.explain(flight.frame(), stages);
  const cv::Mat frame = io::mat_of(flight.frame());
  report_.pictures.add(row, frame.size(), shot_of(frame, seen, stages, flight.settings().finder));
}

void FlightReport::write(const std::filesystem::path& path, const sim::Flight& flight, const std::string& title,
                         const std::string& summary) {
  report_.title = title;
  report_.figures = flight_figures(summary);
  report_.changes = changes_in(summary);
  add_figures_of_table(report_.table, report_.figures);
  const sim::OccupancyPicture map = flight.map().picture();
  if (const auto png = map_png(map); !png.empty())
    report_.map = ReportMap{std::string(png.begin(), png.end()), map.x_min_m - 0.5 * map.cell_m,
                            map.y_min_m - 0.5 * map.cell_m, map.cell_m};
  write_report(path, report_);
}

void FlightReport::keep(const std::filesystem::path& flight_folder) const {
  write_shots(flight_folder / kShotsFolder, report_.pictures);
}

}  // namespace adit::tools
