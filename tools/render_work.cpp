#include "render_work.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <numbers>
#include <stdexcept>

#include "adit/io/errors.hpp"
#include "adit/sim/rendered_eye.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "worker_pool.hpp"

namespace adit::tools {
namespace {

constexpr int kProbeWidth = 80;  ///< px, of the small frames by which exposure settles
constexpr int kProbesMax = 16;
constexpr double kSettled = 0.02;  ///< of the product of time and gain, from probe to probe
constexpr float kFloorReach_m = 20.0f;
constexpr std::uint64_t kFrameSeedStep = 0x9e3779b97f4a7c15ull;

sim::RigConfig probe_rig(const sim::RigConfig& rig) {
  sim::RigConfig small = rig;
  small.lens.height = std::max(16, rig.lens.height * kProbeWidth / rig.lens.width);
  small.lens.width = kProbeWidth;
  small.sensor.jpeg_quality = 0;
  // At full speed exposure would swing about its aim, since the tone curve is not the one it takes for granted.
  if (small.sensor.exposure_speed > 0.0f) small.sensor.exposure_speed = 0.7f;
  return small;
}

/// What makes frames, one for each thread.
class FrameMaker {
 public:
  FrameMaker(const FlySettings& settings, const Site& site, const sim::Network& network, std::uint64_t seed)
      : site_(&site),
        seed_(seed),
        renderer_(site.world, settings.rig, settings.render, site.scene),
        probe_(site.world, probe_rig(settings.rig), settings.render, site.scene),
        surveyor_(settings.flight.truth, *site.scene, network, static_cast<double>(settings.rig.lens.hfov_deg)) {}

  TruthRow make(std::int64_t frame, const FiledPose& filed, sim::Frame& picture) {
    TruthRow row;
    row.frame = frame;
    row.vehicle = filed.vehicle;
    row.stamp_s = filed.stamp_s.value_or(static_cast<double>(frame));
    if (row.vehicle.height_m <= 0.0) {
      const auto floor =
          site_->scene->closest_hit(row.vehicle.place.cast<float>(), -Eigen::Vector3f::UnitZ(), kFloorReach_m);
      row.vehicle.height_m = static_cast<double>(floor ? floor->range_m : 1.0f);
    }
    sim::Shot shot{
        sim::rig_pose_of(row.vehicle), {}, row.stamp_s, seed_ * kFrameSeedStep + static_cast<std::uint64_t>(frame)};
    row.exposure = shot.exposure = settled(shot);
    shot.lamps_on = is_lit(frame);
    renderer_.render(shot, picture);
    row.mean_level = picture.mean_level;
    const double yaw_rad = row.vehicle.yaw_rad;
    row.truth = surveyor_.look(row.vehicle.place, {std::cos(yaw_rad), std::sin(yaw_rad), 0.0},
                               renderer_.camera_pose(shot.pose).cast<double>(), row.vehicle.height_m, std::nullopt);
    return row;
  }

  /// Of lamps that flash, the even frames.
  [[nodiscard]] bool is_lit(std::int64_t frame) const { return !renderer_.rig().lamps.flash || frame % 2 == 0; }

  [[nodiscard]] const CameraModel& camera() const { return renderer_.camera().model(); }

 private:
  /// The exposure at which the camera's own loop comes to rest before this view.
  sim::Exposure settled(const sim::Shot& shot) {
    sim::AutoExposure exposure(probe_.rig().sensor);
    sim::Shot probe = shot;
    for (int i = 0; i < kProbesMax; ++i) {
      probe.exposure = exposure.current();
      probe_.render(probe, small_);
      exposure.observe(small_.mean_level);
      const sim::Exposure next = exposure.current();
      const float before = probe.exposure.time_s * probe.exposure.gain;
      if (std::abs(next.time_s * next.gain / before - 1.0f) < static_cast<float>(kSettled)) break;
    }
    return exposure.current();
  }

  const Site* site_;
  std::uint64_t seed_;
  sim::Renderer renderer_, probe_;
  sim::Surveyor surveyor_;
  sim::Frame small_;
};

/// The row of the table from which frame i is made: all of them, or as many as are asked for, evenly spread.
const FiledPose& filed_pose(const RenderWork& work, std::int64_t frame) {
  const auto rows = static_cast<std::int64_t>(work.poses.size());
  return work.poses[static_cast<std::size_t>(frame * rows / work.frames)];
}

}  // namespace

ExitCode render_frames(const RenderWork& work, const FlySettings& settings, const sim::ViewpointConfig& viewpoints,
                       const Site& site) {
  try {
    FlySettings each = settings;
    each.render.threads = 1;
    const sim::ViewpointSource source(viewpoints, site.world, *site.scene, work.seed);
    const sim::Network network(site.world);
    std::vector<std::unique_ptr<FrameMaker>> makers;
    for (int i = 0; i < work.jobs; ++i) makers.push_back(std::make_unique<FrameMaker>(each, site, network, work.seed));
    const DatasetOutputs outputs(work.out);
    std::vector<std::optional<TruthRow>> rows(static_cast<std::size_t>(work.frames));
    Progress progress(work.frames, "frames", work.quiet);
    {
      WorkerPool pool(work.jobs);
      std::vector<std::future<void>> tasks;
      for (std::int64_t i = 0; i < work.frames; ++i)
        tasks.push_back(pool.submit([&, i](int worker) {
          static thread_local sim::Frame picture;
          if (is_interrupted()) return;
          // With lamps that flash two frames share a place, one with the lamps on and one with them off.
          const std::int64_t drawn = settings.rig.lamps.flash ? i - i % 2 : i;
          const FiledPose pose = work.poses.empty() ? FiledPose{source.draw(drawn), {}} : filed_pose(work, i);
          TruthRow row = makers[static_cast<std::size_t>(worker)]->make(i, pose, picture);
          outputs.write_frame(i, picture);
          rows[static_cast<std::size_t>(i)] = std::move(row);
        }));
      std::int64_t done = 0;
      for (auto& task : tasks) {
        task.get();
        progress.show(++done);
      }
    }
    progress.clear();
    DatasetNote note = work.note;
    note.interrupted = is_interrupted();
    outputs.commit(rows, note, makers.front()->camera(), work.settings_yaml);
    const auto written = std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.has_value(); });
    const std::string count = std::to_string(written) + " of " + std::to_string(work.frames) + " frames";
    if (note.interrupted) print_line("adit: interrupted after " + count + "; what was written is whole");
    if (!note.interrupted && !work.quiet) {
      char rate[48];
      std::snprintf(rate, sizeof rate, " in %.1f s", progress.elapsed_s());
      print_line(count + rate + ": " + work.out);
    }
    return note.interrupted ? kInterrupted : kSuccess;
  } catch (const std::invalid_argument& e) {
    throw io::ConfigError(e.what());
  } catch (const sim::NoFreePlace& e) {
    throw io::ConfigError(e.what());
  }
}

}  // namespace adit::tools
