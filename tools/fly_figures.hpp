// The paper's figures of a flight, by gnuplot.
#pragma once

#include <filesystem>
#include <string>

#include "adit/sim/occupancy.hpp"

namespace adit::tools {

/// What the figures say of the flight.
struct FigureTitle {
  std::string text;  ///< one line
};

/// Fig. 3 (3-D path; sx over time) and Fig. 4 (map with poses in red and commands in green) as fig3.png, fig3.svg,
/// fig4.png, fig4.svg, from flight.csv and map.png in the folder.
/// @return why there are none (gnuplot is missing or failed), "" when they are there.
[[nodiscard]] std::string draw_figures(const std::filesystem::path& folder, const FigureTitle& title,
                                       const sim::OccupancyPicture& map);

}  // namespace adit::tools
