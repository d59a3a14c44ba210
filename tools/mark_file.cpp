#include "mark_file.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "adit/image.hpp"
#include "adit/io/errors.hpp"
#include "adit/io/output_file.hpp"
#include "eval_sets.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kAbout =
    "Open area in each image, marked by hand, in px: boxes [u0, v0, u1, v1] and polygons [[u, v], ...]; \"none\" where "
    "there is no opening.";
constexpr std::size_t kOutlinesMost = 64, kCornersMost = 512, kPlaceLongest = 200;

bool is_coordinate(const Json& value) {
  return value.is_number() && std::abs(value.get<double>()) <= static_cast<double>(2 * kSideMax_px);
}

bool are_coordinates(const Json& value, std::size_t count) {
  return value.is_array() && value.size() == count && std::all_of(value.begin(), value.end(), is_coordinate);
}

bool is_outline(const Json& value) {
  if (are_coordinates(value, 4)) return true;
  return value.is_array() && value.size() >= 3 && value.size() <= kCornersMost &&
         std::all_of(value.begin(), value.end(), [](const Json& corner) { return are_coordinates(corner, 2); });
}

std::string fault_of_marks(const Json& marks) {
  if (!marks.is_object() || !marks.contains("openings")) return "there is no \"openings\"";
  const Json& openings = marks["openings"];
  const bool outlines = openings.is_array() && !openings.empty() && openings.size() <= kOutlinesMost &&
                        std::all_of(openings.begin(), openings.end(), is_outline);
  if (!outlines && !openings.is_null() && openings != "none") return "openings: neither outlines nor \"none\" nor null";
  if (marks.contains("place") &&
      (!marks["place"].is_string() || marks["place"].get_ref<const std::string&>().size() > kPlaceLongest))
    return "place: it is a name of at most 200 letters";
  return "";
}

Json read(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return Json{{"about", kAbout}, {"openings", Json::object()}};
  std::ifstream file(path, std::ios::binary);
  const Json json = Json::parse(file, nullptr, false);
  if (!json.is_object() || !json.contains("openings") || !json["openings"].is_object() ||
      (json.contains("places") && !json["places"].is_object()))
    throw io::InputError(path.string() + ": this file is there already, and is no openings.json; choose another --out");
  return json;
}

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// An image a line, so that people can read it and version control can compare it.
std::string text_of(const Json& content) {
  std::string text = "{";
  for (const auto& [key, value] : content.items()) {
    text += (text.size() > 1 ? ",\n  " : "\n  ") + line_of(key) + ": ";
    if (!value.is_object() || value.empty()) {
      text += line_of(value);
      continue;
    }
    std::string lines;
    for (const auto& [name, one] : value.items())
      lines += (lines.empty() ? "\n    " : ",\n    ") + line_of(name) + ": " + line_of(one);
    text += "{" + lines + "\n  }";
  }
  return text + "\n}\n";
}

}  // namespace

MarkFile::MarkFile(const fs::path& path, const std::vector<fs::path>& images)
    : path_(path), images_(images), content_(read(path)) {
  const fs::path folder = fs::weakly_canonical(fs::absolute(path)).parent_path();
  for (const fs::path& image : images)
    names_.push_back(fs::weakly_canonical(fs::absolute(image)).lexically_relative(folder).generic_string());
}

Json MarkFile::openings_of(std::size_t i) const {
  const Json& openings = content_["openings"];
  if (!openings.contains(names_[i])) return nullptr;
  const Json& marks = openings[names_[i]];
  return marks.is_object() && marks.contains("openings") ? marks["openings"] : marks;
}

std::size_t MarkFile::marked_count() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < size(); ++i) count += openings_of(i).is_null() ? 0 : 1;
  return count;
}

Json MarkFile::state() const {
  Json state = Json::array();
  for (std::size_t i = 0; i < size(); ++i) {
    Json one;
    one["name"] = names_[i];
    one["openings"] = openings_of(i);
    // An empty list means the same; the page knows one word for it.
    if (one["openings"].is_array() && one["openings"].empty()) one["openings"] = "none";
    const Json& marks = content_["openings"].contains(names_[i]) ? content_["openings"][names_[i]] : Json();
    one["place"] = "";
    if (marks.is_object() && marks.contains("place")) one["place"] = marks["place"];
    if (content_.contains("places") && content_["places"].contains(names_[i]))
      one["place"] = content_["places"][names_[i]];
    one["derived_place"] = place_of_name(names_[i]);
    state.push_back(std::move(one));
  }
  return state;
}

std::string MarkFile::take(std::size_t i, const Json& marks, int width, int height) {
  if (const std::string fault = fault_of_marks(marks); !fault.empty()) return fault;
  Json changed = content_;
  // Keys of an ordered object lie in a vector: a new one moves the others, so no reference is held.
  if (marks["openings"].is_null()) {
    changed["openings"].erase(names_[i]);
  } else {
    const Json size{width, height};
    if (changed["openings"].empty()) changed["size"] = size;
    if (changed.contains("size") && changed["size"] != size) changed.erase("size");
    changed["openings"][names_[i]] = marks["openings"];
  }
  const std::string place = marks.contains("place") ? marks["place"].get<std::string>() : "";
  if (!place.empty() && !marks["openings"].is_null()) {
    changed["places"][names_[i]] = place;
  } else if (changed.contains("places")) {
    changed["places"].erase(names_[i]);
  }
  io::write_file(path_, text_of(changed));
  content_ = std::move(changed);  // only what is on the disk counts
  return "";
}

}  // namespace adit::tools
