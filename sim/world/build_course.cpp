#include <fmt/format.h>

#include "adit/sim/course.hpp"
#include "adit/sim/world_error.hpp"
#include "fittings.hpp"
#include "layout.hpp"
#include "rock.hpp"
#include "surface_nets.hpp"

namespace adit::sim {

World build_course(const CourseConfig& config) {
  if (const auto fault = fault_of(config)) throw WorldError(fmt::format("{}: {}", config.name, *fault));
  Layout layout = lay_out(config);
  const PassageField field(layout, static_cast<float>(config.crown_fraction), static_cast<float>(config.blend_m),
                           static_cast<float>(config.apron_m));
  World world;
  world.name = config.name;
  world.materials = materials_of(config);
  world.mesh = mesh_of(field, config);
  add_fittings(field, config, layout, world.mesh);
  for (const LampPlan& lamp : config.lamps) {
    WorldLamp hung;
    hung.place = Eigen::Vector3d(lamp.x_m, lamp.y_m, lamp.z_m).cast<float>();
    hung.flux_lm = static_cast<float>(lamp.flux_lm);
    hung.emitter_radius_m = static_cast<float>(lamp.emitter_radius_m);
    world.lamps.push_back(hung);
  }
  world.sky_lux = static_cast<float>(config.sky_lux);
  world.start = layout.start;
  world.nodes = std::move(layout.nodes);
  world.passages = std::move(layout.passages);
  return world;
}

}  // namespace adit::sim
