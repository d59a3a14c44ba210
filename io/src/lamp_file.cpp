#include "adit/io/lamp_file.hpp"

#include "text_file.hpp"
#include "yaml.hpp"

namespace adit::io {
namespace {

double number_of(const YAML::Node& node, const std::string& field, std::string_view file) {
  double value = 0.0;
  if (!node.IsScalar() || !parse_number(node.Scalar(), value)) {
    throw ConfigError(place_of(file, node.Mark()) + ": " + field + ": " +
                      (node.IsScalar() ? in_quotes(node.Scalar()) : "this") + " is not a number");
  }
  return value;
}

}  // namespace

LampPattern lamp_of_yaml(std::string_view text, std::string_view name) {
  const YAML::Node root = load_yaml(text, name);
  LampPattern pattern;
  bool has_lobe = false, has_frames = false;
  for (const auto& entry : root) {
    const std::string field = entry.first.IsScalar() ? entry.first.Scalar() : "";
    if (field == "frames") {
      pattern.frames = number_of(entry.second, field, name);
      has_frames = true;
    } else if (field == "lobe") {
      if (!entry.second.IsSequence() || entry.second.size() != pattern.lobe.size()) {
        throw ConfigError(place_of(name, entry.second.Mark()) + ": lobe: not a list of six numbers");
      }
      for (std::size_t i = 0; i < pattern.lobe.size(); ++i) pattern.lobe[i] = number_of(entry.second[i], field, name);
      has_lobe = true;
    } else {
      throw ConfigError(place_of(name, entry.first.Mark()) + ": " + in_quotes(field) + " is not known" +
                        hint_for(field, {"frames", "lobe"}));
    }
  }
  if (!has_lobe || !has_frames) {
    throw ConfigError(std::string(name) + ": " + (has_lobe ? "frames" : "lobe") +
                      ": missing; a file that 'adit run --learn-lamp' wrote is wanted");
  }
  if (const std::string fault = fault_of(pattern); !fault.empty()) throw ConfigError(std::string(name) + ": " + fault);
  return pattern;
}

LampPattern read_lamp(const std::filesystem::path& path) {
  return lamp_of_yaml(read_settings_text(path), path.string());
}

std::string to_yaml(const LampPattern& pattern) {
  std::string text =
      "# The pattern of a vehicle's lamp and lens, learnt from its frames. For adit run --lamp.\n"
      "# Natural logarithm of light: 1, x, y, x^2, y^2, log(1 + tan^2 of the angle to the axis).\nlobe: [";
  for (std::size_t i = 0; i < pattern.lobe.size(); ++i)
    text.append(i > 0 ? ", " : "").append(shortest(pattern.lobe[i]));
  return text.append("]\n# Frames it was learnt from; it counts by frames / (frames + 100).\nframes: ")
      .append(shortest(pattern.frames))
      .append("\n");
}

}  // namespace adit::io
