#include "bag_inputs.hpp"

#include <filesystem>
#include <utility>

#include "adit/io/errors.hpp"
#ifdef ADIT_WITH_BAG
#include "adit/io/bag_file.hpp"
#endif

namespace adit::tools {
namespace {

#ifdef ADIT_WITH_BAG
std::unique_ptr<io::FrameSource> bag_source(const std::string& input, const std::string& topic) {
  return io::open_bag(input, topic);
}
std::optional<CameraModel> bag_camera(const std::string& input, const std::string& topic) {
  return io::camera_of_bag(input, topic);
}
#else
[[noreturn]] void refuse(const std::string& input) {
  throw io::InputError(input +
                       ": this adit was built without bags (librosbag-storage-dev was not there); "
                       "scripts/setup --ros bag installs it");
}
std::unique_ptr<io::FrameSource> bag_source(const std::string& input, const std::string&) { refuse(input); }
std::optional<CameraModel> bag_camera(const std::string& input, const std::string&) { refuse(input); }
#endif

}  // namespace

bool is_bag(const std::string& input) { return std::filesystem::path(input).extension() == ".bag"; }

std::vector<std::unique_ptr<io::FrameSource>> sources_of(const std::vector<std::string>& inputs,
                                                         const io::SourceOptions& options, const std::string& topic) {
  std::vector<std::unique_ptr<io::FrameSource>> sources;
  std::vector<std::string> others;
  const auto open_others = [&] {
    if (others.empty()) return;
    for (auto& source : io::open_sources(std::exchange(others, {}), options)) sources.push_back(std::move(source));
  };
  for (const std::string& input : inputs) {
    if (!is_bag(input)) {
      others.push_back(input);
      continue;
    }
    open_others();
    sources.push_back(bag_source(input, topic));
  }
  open_others();
  return sources;
}

std::optional<Camera> camera_of_inputs(const FinderOptions& options, const std::vector<std::string>& inputs,
                                       const std::string& topic) {
  if (auto camera = camera_of(options)) return camera;
  if (inputs.size() != 1 || !is_bag(inputs.front())) return std::nullopt;
  const auto model = bag_camera(inputs.front(), topic);
  return model ? std::optional<Camera>(*model) : std::nullopt;
}

}  // namespace adit::tools
