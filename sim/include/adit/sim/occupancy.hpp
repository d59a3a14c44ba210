// A map of what the laser met, seen from above (paper, Fig. 4).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "adit/sim/lidar.hpp"

namespace adit::sim {

/// Part of the map as a picture: row 0 is the smallest y, column 0 the smallest x.
struct OccupancyPicture {
  double x_min_m = 0.0;  ///< of the middle of the first column
  double y_min_m = 0.0;  ///< of the middle of the first row
  double cell_m = 0.0;
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> probability_percent;  ///< 0 free to 100 occupied; kUnseen where no ray has been
  static constexpr std::uint8_t kUnseen = 255;
};

/// An occupancy grid of log-odds that grows where scans fall (Moravec and Elfes; update and clamping figures as in
/// OctoMap: Hornung et al., 2013).
class OccupancyGrid {
 public:
  /// @param cell_m  side of a cell, 0.01 to 10 m. @throws std::invalid_argument.
  explicit OccupancyGrid(double cell_m = 0.1);

  /// Takes a scan made at a known pose. Each cell counts once a scan: met if any ray ends there, else passed through.
  /// Rays that met nothing free the cells up to clear_max_m.
  void add(const Scan& scan, const Eigen::Vector3d& place, const Eigen::Quaterniond& attitude,
           double clear_max_m = 8.0);

  /// Probability that a place is occupied, [0, 1]; 0.5 where no ray has been.
  [[nodiscard]] double probability_at(double x_m, double y_m) const;
  /// Everything that was seen.
  [[nodiscard]] OccupancyPicture picture() const;

 private:
  static constexpr int kTileSide = 64;
  struct Cell {
    float log_odds = 0.0f;
    std::uint32_t scan = 0;  ///< the last that touched it
    bool met = false;        ///< in that scan
  };
  using Tile = std::array<Cell, kTileSide * kTileSide>;

  /// The tile that was asked for last: rays go from cell to cell.
  struct Nearby {
    Tile* tile = nullptr;
    int x = 0, y = 0;
  };

  [[nodiscard]] Cell& cell(int x, int y, Nearby& nearby);
  void mark(int x, int y, bool met, Nearby& nearby);
  void trace(double x0_m, double y0_m, double x1_m, double y1_m, bool met);

  double cell_m_;
  std::uint32_t scans_ = 0;
  std::map<std::pair<int, int>, Tile> tiles_;
};

}  // namespace adit::sim
