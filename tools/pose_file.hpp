// Poses out of a table that `adit fly` wrote, or of any CSV with the same columns.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "adit/sim/vehicle.hpp"

namespace adit::tools {

/// One row of it.
struct FiledPose {
  sim::VehicleState vehicle;  ///< height_m is 0 where the table does not say
  std::optional<double> stamp_s;
};

/// Needs x_m, y_m, z_m, roll_deg, pitch_deg, yaw_deg; takes vx_m_s, vy_m_s, vz_m_s, height_m and stamp_s where they
/// are. Rates of turn come from the neighbours' angles and stamps; without stamps they are 0.
/// @throws io::InputError "FILE:LINE: ..." for a missing column, a cell that is no number, or a table without rows.
[[nodiscard]] std::vector<FiledPose> read_poses(const std::filesystem::path& path);

}  // namespace adit::tools
