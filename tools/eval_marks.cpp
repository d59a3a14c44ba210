// openings.json: {"size": [640, 480], "openings": {"a.png": [[u0, v0, u1, v1], [[u, v], [u, v], ...]], "b.png":
// "none"}, "places": {"a.png": "north drift"}}
#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "adit/io/camera_file.hpp"
#include "adit/io/errors.hpp"
#include "eval_sets_parts.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json parse(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw io::InputError(path.string() + ": cannot be read; is it there?");
  try {
    return Json::parse(file);
  } catch (const Json::parse_error& e) {
    throw io::InputError(path.string() + ": no JSON from byte " + std::to_string(e.byte) +
                         " on; is a bracket or a comma missing?");
  }
}

bool is_place(const Json& value) {
  return value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
}

bool is_box(const Json& value) {
  return value.is_array() && value.size() == 4 &&
         std::all_of(value.begin(), value.end(), [](const Json& v) { return v.is_number(); });
}

eval::Outline outline_of(const Json& value, const std::string& where) {
  if (is_box(value))
    return eval::box_of({value[0].get<double>(), value[1].get<double>()},
                        {value[2].get<double>(), value[3].get<double>()});
  const bool polygon = value.is_array() && value.size() >= 3 && std::all_of(value.begin(), value.end(), is_place);
  if (!polygon)
    throw io::InputError(where + ": " + value.dump().substr(0, 60) +
                         " is neither a box [u0, v0, u1, v1] nor a polygon [[u, v], [u, v], [u, v], ...]");
  eval::Outline outline;
  for (const Json& corner : value) outline.corners.push_back({corner[0].get<double>(), corner[1].get<double>()});
  return outline;
}

/// Outlines, "none", or an object with "openings" and "place".
void take_marks(const Json& value, const std::string& where, EvalFrame& frame) {
  if (value.is_object()) {
    if (value.contains("place") && value["place"].is_string()) frame.place = value["place"].get<std::string>();
    if (!value.contains("openings"))
      throw io::InputError(where + ": there is no \"openings\"; give outlines, or \"none\" where there is none");
    return take_marks(value["openings"], where, frame);
  }
  frame.truth.scene = eval::Scene::kNone;
  if (value == "none") return;
  if (!value.is_array())
    throw io::InputError(where + ": " + value.dump().substr(0, 60) + " is neither a list of outlines nor \"none\"");
  for (const Json& outline : value) frame.truth.outlines.push_back(outline_of(outline, where));
  if (!frame.truth.outlines.empty()) frame.truth.scene = eval::Scene::kOpen;
}

void refuse_missing(const fs::path& marks, const std::vector<EvalFrame>& frames) {
  std::error_code error;
  std::size_t missing = 0;
  std::string first;
  for (const EvalFrame& frame : frames)
    if (!fs::is_regular_file(frame.image, error) && missing++ == 0) first = frame.name;
  if (missing > 0)
    throw io::InputError(marks.string() + ": " + std::to_string(missing) + " of its " + std::to_string(frames.size()) +
                         " images are not beside it, the first is " + first);
}

std::optional<std::pair<int, int>> size_of(const Json& json, const std::string& where) {
  if (!json.contains("size")) return std::nullopt;
  if (!is_place(json["size"])) throw io::InputError(where + ": size: it is [width, height] in px");
  return std::pair{json["size"][0].get<int>(), json["size"][1].get<int>()};
}

std::optional<std::string> place_in(const Json& json, const std::string& name) {
  if (!json.contains("places") || !json["places"].is_object()) return std::nullopt;
  const Json& places = json["places"];
  if (!places.contains(name) || !places[name].is_string()) return std::nullopt;
  return places[name].get<std::string>();
}

}  // namespace

void read_marked(const fs::path& marks, const std::string& prefix, EvalSet& set) {
  const std::string where = marks.string();
  const Json json = parse(marks);
  if (!json.is_object() || !json.contains("openings") || !json["openings"].is_object())
    throw io::InputError(where + ": there is no \"openings\": {\"IMAGE\": [outlines], ...}; make it with 'adit mark'");
  const auto size = size_of(json, where);
  std::optional<CameraModel> camera;
  if (const fs::path file = marks.parent_path() / "camera.yaml"; fs::exists(file)) camera = io::read_camera(file);
  std::vector<EvalFrame> frames;
  for (const auto& [name, value] : json["openings"].items()) {
    EvalFrame frame;
    frame.name = prefix + name;
    frame.image = marks.parent_path() / name;
    frame.size = size;
    frame.camera = camera;
    take_marks(value, where + ": " + name, frame);
    if (const auto place = place_in(json, name)) frame.place = *place;
    if (frame.place.empty()) frame.place = set.name + "/" + prefix + place_of_name(name);
    frames.push_back(std::move(frame));
  }
  if (frames.empty()) throw io::InputError(where + ": no frame is marked");
  refuse_missing(marks, frames);
  std::move(frames.begin(), frames.end(), std::back_inserter(set.frames));
}

}  // namespace adit::tools
