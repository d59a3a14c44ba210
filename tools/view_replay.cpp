#include "view_replay.hpp"

#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

#include "adit/io/errors.hpp"
#include "adit/io/frame_source.hpp"
#include "eval_csv.hpp"
#include "interrupt.hpp"
#include "report.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kDegree = std::numbers::pi / 180.0;

/// The other way round than io::flags_text().
SightFlags flags_of(const std::string& text) {
  const auto has = [words = "+" + text + "+"](const char* name) {
    return words.find(std::string("+").append(name).append("+")) != std::string::npos;
  };
  return {has("dust"), has("glare"), has("blocked_lens"), has("too_dark"), has("too_bright"), has("dirty_lens")};
}

/// What a row of flight.csv says. Folders of before lack some columns.
class FlightRows {
 public:
  explicit FlightRows(const fs::path& path) : table_(path) {}

  [[nodiscard]] std::size_t size() const noexcept { return table_.size(); }
  [[nodiscard]] double stamp_s(std::size_t row) const { return number(row, "stamp_s"); }

  [[nodiscard]] LiveFrame frame(std::size_t row) const {
    LiveFrame frame;
    frame.stamp_s = stamp_s(row);
    OpenSpace& o = frame.open_space;
    if (!parse(text(row, "status"), o.status)) o.status = Status::kBadFrame;  // dropped: there was no frame
    const auto known = [](double value) { return std::isfinite(value) ? value : 0.0; };
    o.confidence = number(row, "confidence");  // of a dropped frame there is none
    o.centroid_px = {known(number(row, "u_px")), known(number(row, "v_px"))};
    o.point = {known(number(row, "sx")), known(number(row, "sy"))};
    o.bearing = {known(number(row, "azimuth_deg")) * kDegree, known(number(row, "elevation_deg")) * kDegree};
    if (const auto flags = table_.column("flags")) o.flags = flags_of(table_.text(row, *flags));
    HeadingCommand command;
    for (const HeadingState state : {HeadingState::kSteer, HeadingState::kCoast, HeadingState::kHold})
      if (to_string(state) == text(row, "command")) command.state = state;
    command.yaw_rate_rad_s = known(number(row, "yaw_rate_rad_s"));
    frame.command = command;
    if (const double share = table_.number(row, table_.column("speed_scale")); std::isfinite(share))
      frame.speed_scale = share;
    frame.pose = LivePose{number(row, "x_m"), number(row, "y_m"), number(row, "yaw_deg") * kDegree};
    return frame;
  }

 private:
  [[nodiscard]] double number(std::size_t row, const char* name) const {
    return table_.number(row, table_.needed(name));
  }
  [[nodiscard]] const std::string& text(std::size_t row, const char* name) const {
    return table_.text(row, table_.needed(name));
  }

  CsvTable table_;
};

}  // namespace

bool is_flight_folder(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / "flight.csv", error);
}

LivePlan plan_of_folder(const fs::path& folder) {
  const auto map = read_map(folder);
  return map ? LivePlan{map->png, map->x_min_m, map->y_min_m, map->cell_m} : LivePlan{};
}

std::int64_t replay_flight(const fs::path& folder, LiveView& live) {
  const fs::path film = folder / "flight.mp4";
  std::error_code error;
  if (!fs::is_regular_file(film, error))
    throw io::InputError(film.string() + ": there is no film of this flight; fly it again with --video");
  const FlightRows rows(folder / "flight.csv");
  const auto sources = io::open_sources({film.string()}, {});
  const auto begin = Clock::now();
  std::size_t row = 0;
  for (; row < rows.size() && !is_interrupted(); ++row) {
    auto pictures = sources.front()->next();
    if (!pictures) break;
    constexpr auto kLook = std::chrono::milliseconds(50);  // for a signal
    const auto due = begin + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(rows.stamp_s(row) - rows.stamp_s(0)));
    while (!is_interrupted() && Clock::now() < due) std::this_thread::sleep_until(std::min(due, Clock::now() + kLook));
    LiveFrame frame = rows.frame(row);
    frame.panel = std::move(pictures->pixels);
    live.show(std::move(frame));
  }
  return static_cast<std::int64_t>(row);
}

}  // namespace adit::tools
