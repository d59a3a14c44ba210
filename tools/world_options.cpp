#include "world_options.hpp"

#include <CLI/CLI.hpp>

#include "number_in.hpp"

namespace adit::tools {

void add_world_options(CLI::App& command, FlyOptions& options) {
  command.add_option("course", options.course, "One of courses/*.yaml, by name or file")->type_name("COURSE");
  command.add_option("--world", options.world_file, "Instead: .world, .sdf, or a mesh (.stl .obj .dae .ply)")
      ->type_name("FILE");
  command.add_option("--start", options.start, "Where to begin, over the floor")
      ->type_name("X,Y,Z,YAW_DEG")
      ->delimiter(',')
      ->expected(4)
      ->check(finite_number());
  command.add_option("--models", options.models, "Where model://NAME is looked for; repeatable")
      ->type_name("DIR")
      ->allow_extra_args(false);
  command.add_option("--mesh-scale", options.mesh_scale, "Metres per unit of a mesh (1)")
      ->type_name("M")
      ->check(NumberIn(1e-6, 1e6));
  command.add_option("--mesh-up", options.mesh_up, "Axis of a mesh that points up: x, y, z, file")
      ->type_name("AXIS")
      ->check(CLI::IsMember({"file", "x", "y", "z"}));
  command.add_flag("--world-lights", options.world_lights,
                   "Keep the lights of a world file as lamps; they are passed over otherwise");
  command.add_flag("--door", options.door, "Shut the passage behind the start: flights stay inside");
}

void add_reads(const FlyOptions& options, FileUses& uses) {
  if (!options.course.empty()) uses.reads("COURSE", course_path(options.course));
  uses.reads("--world", options.world_file);
  uses.reads("--config", options.config_file);
  for (const std::string& folder : options.models) uses.reads_all_in("--models", folder);
}

}  // namespace adit::tools
