#include "adit/io/camera_file.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "text_file.hpp"
#include "yaml.hpp"

namespace adit::io {
namespace {

/// A YAML map whose faults are told with the file's name and the line.
class Reader {
 public:
  Reader(const YAML::Node& map, std::string_view file) : map_(map), file_(file) {}

  [[noreturn]] void refuse(const YAML::Node& at, const std::string& why) const {
    throw ConfigError(place_of(file_, at.Mark()) + ": " + why);
  }

  YAML::Node field(const char* name) const {
    std::vector<std::string> present;
    for (const auto& entry : map_) {
      if (!entry.first.IsScalar()) continue;
      if (entry.first.Scalar() == name) return entry.second;
      present.push_back(entry.first.Scalar());
    }
    const std::string hint = hint_for(name, present);
    refuse(map_, std::string(name) + ": missing; a ROS camera_info file is wanted" +
                     (hint.starts_with("; did") ? " (the file has" + hint.substr(hint.find(" '")) + ")" : ""));
  }

  template <class Number>
  Number number(const char* name) const {
    const YAML::Node node = field(name);
    Number value{};
    if (!node.IsScalar() || !parse_number(node.Scalar(), value)) {
      refuse(node, std::string(name) + ": " + (node.IsScalar() ? in_quotes(node.Scalar()) : "this") +
                       (std::is_integral_v<Number> ? " is not a whole number" : " is not a number"));
    }
    return value;
  }

  /// The numbers of a matrix {rows, cols, data}, or of a plain list.
  std::vector<double> matrix(const char* name) const {
    const YAML::Node node = field(name);
    const YAML::Node list = node.IsMap() ? Reader(node, file_).field("data") : node;
    if (!list.IsSequence()) refuse(node, std::string(name) + ": not {rows, cols, data: [...]}");
    std::vector<double> values;
    for (const auto& item : list) {
      double value = 0.0;
      if (!item.IsScalar() || !parse_number(item.Scalar(), value)) {
        refuse(item, std::string(name) + ": " + (item.IsScalar() ? in_quotes(item.Scalar()) : "an entry") +
                         " is not a number");
      }
      values.push_back(value);
    }
    if (node.IsMap()) {
      const Reader size(node, file_);
      const long long wanted = static_cast<long long>(size.number<int>("rows")) * size.number<int>("cols");
      if (wanted != static_cast<long long>(values.size())) {
        refuse(node, std::string(name) + ": rows x cols is " + std::to_string(wanted) + ", but data has " +
                         std::to_string(values.size()) + " numbers");
      }
    }
    return values;
  }

 private:
  YAML::Node map_;
  std::string_view file_;
};

struct ModelName {
  const char* name;
  DistortionModel model;
  std::vector<std::size_t> counts;  ///< of coefficients that it may have
};

const ModelName& model_named(const Reader& reader, const YAML::Node& node) {
  static const std::vector<ModelName> kModels{
      {"plumb_bob", DistortionModel::kPlumbBob, {4, 5}},
      {"rational_polynomial", DistortionModel::kRationalPolynomial, {8}},
      {"equidistant", DistortionModel::kEquidistant, {4}},
      {"none", DistortionModel::kNone, {0}},
  };
  std::vector<std::string> names;
  for (const ModelName& known : kModels) {
    if (node.IsScalar() && node.Scalar() == known.name) return known;
    names.emplace_back(known.name);
  }
  const std::string name = node.IsScalar() ? node.Scalar() : "";
  reader.refuse(node, "distortion_model: " + in_quotes(name) + " is not known" + hint_for(name, names));
}

void read_distortion(const Reader& reader, CameraModel& camera) {
  const YAML::Node node = reader.field("distortion_model");
  const ModelName& named = model_named(reader, node);
  camera.distortion_model = named.model;
  if (named.model == DistortionModel::kNone) return;
  std::vector<double> values = reader.matrix("distortion_coefficients");
  // OpenCV writes up to 14; those of the thin prism and of the tilted sensor must be 0 here.
  while (values.size() > named.counts.back() && values.back() == 0.0) values.pop_back();
  for (const std::size_t count : named.counts) {
    if (values.size() != count) continue;
    std::copy(values.begin(), values.end(), camera.distortion.begin());
    return;
  }
  reader.refuse(reader.field("distortion_coefficients"), "distortion_coefficients: " + std::to_string(values.size()) +
                                                             " numbers, but " + named.name + " has " +
                                                             std::to_string(named.counts.back()));
}

}  // namespace

CameraModel camera_of_yaml(std::string_view text, std::string_view name) {
  const YAML::Node root = load_yaml(text, name);
  const Reader reader(root, name);
  CameraModel camera;
  camera.width = reader.number<int>("image_width");
  camera.height = reader.number<int>("image_height");
  const std::vector<double> k = reader.matrix("camera_matrix");
  if (k.size() != 9) {
    reader.refuse(reader.field("camera_matrix"),
                  "camera_matrix: " + std::to_string(k.size()) + " numbers; 9 are wanted (3 x 3)");
  }
  if (k[1] != 0.0 || k[3] != 0.0 || k[6] != 0.0 || k[7] != 0.0 || k[8] != 1.0) {
    reader.refuse(reader.field("camera_matrix"),
                  "camera_matrix: not of the form [fx, 0, ox, 0, fy, oy, 0, 0, 1]; skewed pixels are not modelled");
  }
  camera.focal_length_x_px = k[0];
  camera.principal_point_x_px = k[2];
  camera.focal_length_y_px = k[4];
  camera.principal_point_y_px = k[5];
  read_distortion(reader, camera);
  if (const auto fault = fault_of(camera)) throw ConfigError(std::string(name) + ": " + *fault);
  return camera;
}

CameraModel read_camera(const std::filesystem::path& path) {
  return camera_of_yaml(read_settings_text(path), path.string());
}

}  // namespace adit::io
