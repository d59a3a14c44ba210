// courses/*.yaml: keys are the members of CourseConfig; an unknown key is an error that lists the known ones.
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <functional>
#include <map>
#include <type_traits>

#include "adit/sim/course.hpp"
#include "adit/sim/course_fields.hpp"
#include "adit/sim/world_error.hpp"
#include "course_names.hpp"

namespace adit::sim {
namespace {

/// Longest list a file may hold: ten times the largest layout there is.
constexpr std::size_t kListMax = 2000;

class CourseReader {
 public:
  explicit CourseReader(std::string path) : path_(std::move(path)) {}

  CourseConfig read() {
    CourseConfig config;
    config.name = std::filesystem::path(path_).stem().string();
    const YAML::Node root = parsed();
    if (!root.IsMap()) fail(root, "a course is a map of keys and values");
    Keys keys;
    visit_fields(config, [&](const FieldNote& note, auto& member) {
      keys[note.name] = [this, name = note.name, &member](const YAML::Node& node) { take(node, name, member); };
    });
    keys["passages"] = [&](const YAML::Node& node) { take_list(node, "passages", config.passages); };
    keys["rooms"] = [&](const YAML::Node& node) { take_list(node, "rooms", config.rooms); };
    keys["tiles"] = [&](const YAML::Node& node) { take_list(node, "tiles", config.tiles); };
    keys["lamps"] = [&](const YAML::Node& node) { take_list(node, "lamps", config.lamps); };
    take_map(root, keys);
    if (const auto fault = fault_of(config)) throw WorldError(fmt::format("{}: {}", path_, *fault));
    return config;
  }

 private:
  using Keys = std::map<std::string, std::function<void(const YAML::Node&)>>;

  YAML::Node parsed() const {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path_, error))
      throw WorldError(fmt::format("{}: no such file; give a course (courses/*.yaml)", path_));
    try {
      return YAML::LoadFile(path_);
    } catch (const YAML::Exception& exception) {
      throw WorldError(fmt::format("{}:{}: {}", path_, exception.mark.line + 1, exception.msg));
    }
  }

  [[noreturn]] void fail(const YAML::Node& node, const std::string& why) const {
    throw WorldError(fmt::format("{}:{}: {}", path_, node.Mark().line + 1, why));
  }

  void take_map(const YAML::Node& map, const Keys& keys) const {
    if (!map.IsMap()) fail(map, "keys and values are wanted here");
    for (const auto& item : map) {
      const std::string key = item.first.Scalar();
      const auto found = keys.find(key);
      if (found == keys.end()) fail(item.first, fmt::format("unknown key '{}'; known: {}", key, names_of(keys)));
      found->second(item.second);
    }
  }

  static std::string names_of(const Keys& keys) {
    std::string names;
    for (const auto& [name, taker] : keys) names += (names.empty() ? "" : ", ") + name;
    return names;
  }

  template <class Value>
  void take(const YAML::Node& node, const char* name, Value& value) const {
    if (!node.IsScalar()) fail(node, fmt::format("{} takes one value", name));
    if constexpr (std::is_enum_v<Value>) {
      take_enum(node, name, value);
    } else {
      try {
        value = node.as<Value>();
      } catch (const YAML::Exception&) {
        fail(node, fmt::format("{} is '{}'; a {} is wanted", name, node.Scalar(),
                               std::is_integral_v<Value> ? "whole number" : "number"));
      }
    }
  }
  template <class Value>
  void take(const YAML::Node& node, const char* name, std::optional<Value>& value) const {
    take(node, name, value.emplace());
  }

  template <class Enum>
  void take_enum(const YAML::Node& node, const char* name, Enum& value) const {
    std::string known;
    const auto& names = NamesOf<Enum>::names;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (node.Scalar() == names[i]) {
        value = static_cast<Enum>(i);
        return;
      }
      known += (i == 0 ? "" : ", ") + std::string(names[i]);
    }
    fail(node, fmt::format("{} is '{}'; known: {}", name, node.Scalar(), known));
  }

  template <class Item>
  void take_list(const YAML::Node& node, const char* name, std::vector<Item>& items) const {
    if (!node.IsSequence()) fail(node, fmt::format("{} is a list", name));
    if (node.size() > kListMax)
      fail(node, fmt::format("{} holds {} items; {} at the most", name, node.size(), kListMax));
    for (const YAML::Node& item : node) take_item(item, items.emplace_back());
  }

  template <class Value>
  auto to(const char* name, Value& value) const {
    return std::pair<const std::string, std::function<void(const YAML::Node&)>>(
        name, [this, name, &value](const YAML::Node& node) { take(node, name, value); });
  }

  void take_item(const YAML::Node& node, Move& move) const {
    take_map(node, {to("straight_m", move.straight_m), to("turn_deg", move.turn_deg), to("radius_m", move.radius_m),
                    to("rise_m", move.rise_m), to("width_m", move.width_m), to("height_m", move.height_m)});
  }
  void take_item(const YAML::Node& node, PassagePlan& plan) const {
    Keys keys{to("from", plan.from),         to("to", plan.to),
              to("end", plan.end),           to("width_m", plan.width_m),
              to("height_m", plan.height_m), to("heading_deg", plan.heading_deg)};
    keys["moves"] = [&](const YAML::Node& moves) { take_list(moves, "moves", plan.moves); };
    take_map(node, keys);
  }
  void take_item(const YAML::Node& node, RoomPlan& room) const {
    take_map(node, {to("x_m", room.x_m), to("y_m", room.y_m), to("z_m", room.z_m), to("width_m", room.width_m),
                    to("height_m", room.height_m)});
  }
  void take_item(const YAML::Node& node, TilePlan& tile) const {
    take_map(node, {to("model", tile.model), to("x_m", tile.x_m), to("y_m", tile.y_m), to("z_m", tile.z_m),
                    to("yaw_rad", tile.yaw_rad)});
  }
  void take_item(const YAML::Node& node, LampPlan& lamp) const {
    take_map(node, {to("x_m", lamp.x_m), to("y_m", lamp.y_m), to("z_m", lamp.z_m), to("flux_lm", lamp.flux_lm),
                    to("emitter_radius_m", lamp.emitter_radius_m)});
  }

  std::string path_;
};

}  // namespace

CourseConfig read_course(const std::string& path) { return CourseReader(path).read(); }

}  // namespace adit::sim
