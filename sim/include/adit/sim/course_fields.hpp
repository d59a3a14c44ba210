// The fields of a course: name, unit, range, meaning and source, once for all users (YAML keys, docs, checks).
#pragma once

#include <type_traits>

#include "adit/fields.hpp"
#include "adit/sim/course.hpp"

namespace adit::sim {

/// Calls visit(const FieldNote&, member&) for each plain field, in the order of the struct. `Config` may be const.
/// The lists (passages, rooms, tiles, lamps) are not visited.
template <class Config, class Visitor>
requires std::is_same_v<std::remove_const_t<Config>, CourseConfig>
void visit_fields(Config& c, Visitor&& visit) {
  using adit::FieldNote;
  visit(FieldNote{"name", "", 0, 0, "Name of the course.", "the file's"}, c.name);
  visit(FieldNote{"about", "", 0, 0, "One line for people.", "the file's"}, c.about);
  visit(FieldNote{"layout", "", 0, 3, "moves, random_tunnel, random_network or tiles.",
                  "chosen: what the course's file lists"},
        c.layout);
  visit(FieldNote{"seed", "", 0, 2147483647, "Seed of relief, fittings and random layouts.", "any"}, c.seed);

  visit(FieldNote{"width_m", "m", 1.2, 30, "Width of a passage where nothing else is said.", "drifts: 4 to 6 m"},
        c.width_m);
  visit(FieldNote{"height_m", "m", 1.2, 20, "Height of a passage where nothing else is said.", "drifts: 3 to 5 m"},
        c.height_m);
  visit(FieldNote{"crown_fraction", "", 0, 1,
                  "Radius of the upper corners as a share of the largest that fits: 1 is an arch, 0 a box.",
                  "arched and flat-backed drifts"},
        c.crown_fraction);
  visit(FieldNote{"blend_m", "m", 0, 3, "Rounding where passages meet.", "blasted corners break off"}, c.blend_m);
  visit(FieldNote{"run_out_m", "m", 2, 100, "Passage behind the goal, before the mouth.",
                  "so that the last metres look like the others"},
        c.run_out_m);
  visit(FieldNote{"start_along_m", "m", -100, 1000, "Start on the first passage's axis, negative: outside.",
                  "chosen: 3 m in; before the mouth in the courses that begin outside"},
        c.start_along_m);
  visit(FieldNote{"start_offset_m", "m", -20, 20, "Start to the left of the axis.",
                  "the paper starts off-centre outside the mouth"},
        c.start_offset_m);
  visit(
      FieldNote{"start_yaw_deg", "deg", -180, 180, "Nose to the left of the axis.", "chosen: the nose along the axis"},
      c.start_yaw_deg);
  visit(FieldNote{"apron_m", "m", 0, 40, "Ground and rock face outside the first mouth; 0: none.",
                  "chosen: none but where a course begins outside"},
        c.apron_m);
  visit(
      FieldNote{"sky_lux", "lx", 0, 100000, "Daylight outside; 0: night.", "full daylight 10000 to 25000, sun 100000"},
      c.sky_lux);

  visit(FieldNote{"length_m", "m", 20, 20000, "Random layouts: length of all passages.",
                  "chosen: some minutes of flight at 1 m/s"},
        c.length_m);
  visit(FieldNote{"width_min_m", "m", 1.2, 30, "Random layouts: narrowest.", "4 to 6 m"}, c.width_min_m);
  visit(FieldNote{"width_max_m", "m", 1.2, 30, "Random layouts: widest.", "4 to 6 m"}, c.width_max_m);
  visit(FieldNote{"radius_min_m", "m", 2, 200, "Random layouts: tightest bend on the axis.",
                  "haulage curves are wider, hand-driven ones as tight"},
        c.radius_min_m);
  visit(FieldNote{"turn_max_deg", "deg", 0, 170, "Random layouts: largest bend.",
                  "chosen: the sharpest bend of the paper's world, 90, and a little more"},
        c.turn_max_deg);
  visit(FieldNote{"grade_max", "m/m", 0, 0.4, "Random layouts: steepest floor.", "ramps of mines: 1:7 at the most"},
        c.grade_max);
  visit(FieldNote{"branch_probability", "", 0, 1, "Random networks: chance of a branch at a crossing of the grid.",
                  "chosen: a third of the crossings branch"},
        c.branch_probability);
  visit(FieldNote{"grid_m", "m", 12, 200, "Random networks: distance of crossings.",
                  "room and pillar: 15 to 30 m between centres"},
        c.grid_m);
  visit(FieldNote{"goal_min_m", "m", 0, 20000,
                  "Random networks: no goal nearer along the axes; where none is that far, the furthest end is one.",
                  "chosen: a flight that leaves by the first side drift shows little"},
        c.goal_min_m);

  visit(FieldNote{"cell_m", "m", 0.04, 0.5, "Cell of the mesh.", "0.13: 200,000 triangles in a drift of 60 m"},
        c.cell_m);
  visit(FieldNote{"undulation_m", "m", 0, 2, "Relief of the largest scale.", "overbreak of drill and blast"},
        c.undulation_m);
  visit(FieldNote{"undulation_size_m", "m", 0.5, 50, "Its size: about a round of blasting.", "rounds of 3 to 5 m"},
        c.undulation_size_m);
  visit(FieldNote{"facet_depth_m", "m", 0, 2, "Depth of the steps between facets.", "joint spacing"}, c.facet_depth_m);
  visit(FieldNote{"facet_size_m", "m", 0.2, 20, "Size of facets.", "joint spacing, 0.6 to 2 m: wide"}, c.facet_size_m);
  visit(FieldNote{"chip_depth_m", "m", 0, 1, "The same, small.",
                  "chosen: judged by eye, contact sheet in docs/simulation.md"},
        c.chip_depth_m);
  visit(FieldNote{"chip_size_m", "m", 0.1, 10, "The same, small.", "joint spacing, 0.2 to 0.6 m: moderate"},
        c.chip_size_m);
  visit(FieldNote{"grain_depth_m", "m", 0, 0.5, "Depth of creases.",
                  "chosen: judged by eye, contact sheet in docs/simulation.md"},
        c.grain_depth_m);
  visit(FieldNote{"grain_size_m", "m", 0.05, 5, "Distance of creases.", "chosen: a few cells of the mesh"},
        c.grain_size_m);
  visit(FieldNote{"floor_roughness_m", "m", 0, 0.5, "Ruts and lumps of the floor.",
                  "chosen: some centimetres, ruts and muck"},
        c.floor_roughness_m);

  visit(FieldNote{"rock_albedo", "", 0.02, 0.8, "Mean diffuse reflectance of dry rock.",
                  "0.02 coal, 0.2 granite and basalt, 0.6 limestone and gypsum"},
        c.rock_albedo);
  visit(FieldNote{"rock_albedo_log_sigma", "", 0, 1, "Sigma of its log-normal patches.",
                  "chosen: most patches within 0.7 to 1.4 of the mean"},
        c.rock_albedo_log_sigma);
  visit(FieldNote{"wet_fraction", "", 0, 1, "Share of the surface that is wet.",
                  "chosen: about an eighth, seeps and puddles"},
        c.wet_fraction);
  visit(FieldNote{"stones_per_m2", "1/m^2", 0, 50, "Loose stones on the floor.",
                  "chosen: judged by eye, contact sheet in docs/simulation.md"},
        c.stones_per_m2);
  visit(FieldNote{"stone_size_m", "m", 0.02, 0.5, "Their median diameter.", "muck left after loading"}, c.stone_size_m);
  visit(FieldNote{"pipe_count", "", 0, 6, "Pipes along the wall of every passage.", "water and compressed air: 2"},
        c.pipe_count);
  visit(FieldNote{"cable_count", "", 0, 8, "Cables that hang along the other wall.",
                  "chosen: power and signal on one wall"},
        c.cable_count);
  visit(FieldNote{"prop_spacing_m", "m", 0, 100, "Sets of props along the walls, this far apart on average; 0: none.",
                  "chosen: something on the walls in most frames"},
        c.prop_spacing_m);
  visit(FieldNote{"duct_diameter_m", "m", 0, 2, "Ventilation duct under the crown; 0: none.",
                  "ducts of 0.6 to 1.2 m are common"},
        c.duct_diameter_m);
}

}  // namespace adit::sim
