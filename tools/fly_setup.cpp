#include "fly_setup.hpp"

#include <CLI/Error.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "adit/io/errors.hpp"
#include "adit/sim/course_fields.hpp"
#include "adit/sim/door.hpp"
#include "adit/sim/flight_fields.hpp"
#include "adit/sim/mesh_file.hpp"
#include "adit/sim/rig_fields.hpp"
#include "adit/sim/world_error.hpp"
#include "adit/sim/world_file.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;

constexpr float kGrainsPerExtinction = 1000.0f;  // coarse grains rise with the dust: some tens in sight at 0.1 1/m

/// Folders that hold courses, the nearest first.
std::vector<fs::path> course_folders() {
  std::vector<fs::path> folders = {"courses"};
  if (const char* named = std::getenv("ADIT_COURSES")) folders.emplace_back(named);
  folders.emplace_back(ADIT_COURSES_SOURCE);
  folders.emplace_back(ADIT_COURSES_INSTALLED);
  folders.emplace_back("/usr/share/adit/courses");  // Debian packages (cmake/packaging.cmake) go there from any prefix
  return folders;
}

std::string known_courses() {
  std::vector<std::string> names;
  for (const fs::path& folder : course_folders()) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
      if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
    if (!names.empty()) break;
  }
  std::sort(names.begin(), names.end());
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

/// The section `lamp`: a field of it sets that of every lamp of the rig.
io::SettingSection lamps_alike(sim::LampRig& rig) {
  io::SettingSection section{"lamp", {}, [] { return std::string(); }};
  if (rig.lamps.empty()) return section;
  sim::Lamp& first = rig.lamps.front();
  visit_fields(first, [&](const FieldNote& note, auto& member) {
    io::Setting setting = io::setting_of(note, member);
    setting.take = [&rig, name = std::string(note.name)](std::string_view text) {
      std::string why;
      for (sim::Lamp& lamp : rig.lamps)
        visit_fields(lamp, [&](const FieldNote& field, auto& value) {
          if (why.empty() && name == field.name) why = io::take_number(field, text, value);
        });
      return why;
    };
    section.settings.push_back(std::move(setting));
  });
  return section;
}

bool is_sdf(const fs::path& path) { return path.extension() == ".world" || path.extension() == ".sdf"; }

/// Is there a pilot that chooses at junctions?
bool is_navigated(const sim::FlightSettings& s) {
  return s.flight.pilot == sim::Pilot::kNavigator ||
         (s.flight.pilot == sim::Pilot::kByMethod && s.finder.method != Method::kPaper);
}

/// Far enough for any tunnel's floor or wall, and near enough to be no rock of elsewhere.
constexpr float kFloorFarthest_m = 50.0f, kWallFarthest_m = 10.0f;

/// @throws io::ConfigError when nothing is beneath or around the start: there would be nothing to fly in.
void refuse_void(const std::vector<double>& start, const Site& site) {
  const Eigen::Vector3f& place = site.world.start.place;
  const Eigen::Vector3f above = place + Eigen::Vector3f(0.0f, 0.0f, 1.0f);  // a start may lie a little under the floor
  if (site.scene->closest_hit(above, -Eigen::Vector3f::UnitZ(), kFloorFarthest_m)) return;
  if (site.scene->nearest(place, kWallFarthest_m)) return;
  throw io::ConfigError("--start " + io::number_text(start[0]) + "," + io::number_text(start[1]) + "," +
                        io::number_text(start[2]) + "," + io::number_text(start[3]) +
                        ": there is no rock beneath or around this place; give one within the tunnel");
}

sim::MeshUp mesh_up_of(const std::string& name) {
  if (name == "x") return sim::MeshUp::kX;
  if (name == "y") return sim::MeshUp::kY;
  if (name == "z") return sim::MeshUp::kZ;
  return sim::MeshUp::kFile;
}

sim::World load(const FlyOptions& options, const FlySettings& settings) {
  if (options.world_file.empty()) return sim::build_course(settings.course);
  if (is_sdf(options.world_file)) {
    sim::WorldFileConfig config;
    config.models = options.models;
    config.world_lights = options.world_lights;
    return sim::load_world(options.world_file, config);
  }
  return sim::load_mesh(options.world_file, {options.mesh_scale, mesh_up_of(options.mesh_up)});
}

}  // namespace

io::Settings sections_of(FlySettings& s) {
  io::Settings settings;
  settings.add("flight", s.flight.flight);
  settings.add("vehicle", s.flight.vehicle);
  settings.add("truth", s.flight.truth);
  settings.add("lidar", s.flight.lidar);
  settings.add("imu", s.flight.imu);
  settings.add("finder", s.flight.finder);
  settings.add("heading", s.flight.heading);
  settings.add("column_range", s.flight.column_range);
  settings.add("range_memory", s.flight.range_memory);
  settings.add("tracker", s.flight.tracker);
  settings.add("steering", s.flight.steering);
  settings.add("frame_watch", s.flight.frame_watch);
  settings.add("lens_watch", s.flight.lens_watch);
  settings.add(lamps_alike(s.rig.lamps));
  settings.add("lamps", s.rig.lamps);
  settings.add("lens", s.rig.lens);
  settings.add("sensor", s.rig.sensor);
  settings.add("dust", s.rig.dust);
  settings.add("dirt", s.rig.dirt);
  settings.add("render", s.render);
  settings.add("course", s.course);
  return settings;
}

std::string course_path(const std::string& course) {
  std::error_code ignored;
  if (fs::path(course).extension() == ".yaml" && fs::is_regular_file(course, ignored)) return course;
  for (const fs::path& folder : course_folders())
    if (fs::is_regular_file(folder / (course + ".yaml"), ignored)) return (folder / (course + ".yaml")).string();
  throw io::InputError("there is no course '" + course + "'; there are: " + known_courses());
}

FlySettings fly_settings_of(const FlyOptions& options, const std::function<void(io::Settings&)>& add_more) {
  try {
    FlySettings s;
    if (options.world_file.empty()) s.course = sim::read_course(course_path(options.course));
    if (!options.lamp.empty()) s.rig = sim::rig_preset(options.lamp);
    io::Settings sections = sections_of(s);
    if (add_more) add_more(sections);
    if (!options.config_file.empty()) sections.read_file(options.config_file);
    if (!options.method.empty()) sections.set("finder.method=" + options.method);
    if (!options.prefer.empty()) sections.set("steering.prefer=" + options.prefer);
    if (options.speed_m_s > 0.0) sections.set("flight.speed_m_s=" + io::number_text(options.speed_m_s));
    if (options.time_s > 0.0) sections.set("flight.time_max_s=" + io::number_text(options.time_s));
    if (options.dust_1_m >= 0.0) {
      sections.set("dust.extinction_1_m=" + io::number_text(options.dust_1_m));
      s.rig.dust.grains_per_m3 = kGrainsPerExtinction * s.rig.dust.extinction_1_m;
    }
    for (const std::string& setting : options.settings) sections.set(setting);
    if (!options.prefer.empty() && !is_navigated(s.flight))
      throw CLI::ValidationError("--prefer", "the published pilot of method " +
                                                 std::string(to_string(s.flight.finder.method)) +
                                                 " chooses no way; leave it out, or add --set pilot=navigator");
    return s;
  } catch (const sim::WorldError& e) {
    throw io::InputError(e.what());
  } catch (const std::invalid_argument& e) {
    throw io::ConfigError(e.what());
  }
}

Site site_of(const FlyOptions& options, const FlySettings& settings) {
  try {
    Site site{load(options, settings), nullptr};
    if (!options.start.empty()) {
      const auto& p = options.start;
      site.world.start.place = Eigen::Vector3d(p[0], p[1], p[2]).cast<float>();
      site.world.start.yaw_rad = static_cast<float>(p[3] * std::numbers::pi / 180.0);
    } else if (!options.world_file.empty() && site.world.nodes.empty()) {
      throw io::ConfigError(options.world_file + ": where the flight begins is not known; give --start x,y,z,yaw_deg");
    }
    if (options.door) sim::close_behind_start(site.world);
    site.scene = std::make_shared<const sim::RayScene>(site.world.mesh);
    if (!options.start.empty()) refuse_void(options.start, site);
    return site;
  } catch (const sim::WorldError& e) {
    throw io::InputError(e.what());
  } catch (const std::invalid_argument& e) {
    throw io::InputError((options.world_file.empty() ? options.course : options.world_file) + ": " + e.what());
  }
}

}  // namespace adit::tools
