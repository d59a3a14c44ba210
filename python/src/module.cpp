// Python module adit._adit; python/adit/__init__.py gives its names to the world.
#include <pybind11/stl.h>

#include "adit/cpu_target.hpp"
#include "bind_config.hpp"
#include "bindings.hpp"

namespace adit::python {

void bind_configs(py::module_& module) {
  bind_config<FinderConfig>(module, "Config", "Every constant of the finder's chain; fields() tells about each.");
  bind_config<HeadingConfig>(module, "HeadingConfig", "Every constant of the heading controller.");
  bind_config<ColumnRangeConfig>(module, "ColumnRangeConfig", "Every constant of the photometric pseudo-range.");
  bind_config<RangeMemoryConfig>(module, "RangeMemoryConfig", "Every constant of the memory of ranges.");
  bind_config<TrackerConfig>(module, "TrackerConfig", "Every constant of the tracker of openings.");
  bind_config<SteeringConfig>(module, "SteeringConfig", "Every constant of the steering.");
  bind_config<FrameWatchConfig>(module, "FrameWatchConfig", "Every constant of the watch over the stream of frames.");
  bind_config<LensWatchConfig>(module, "LensWatchConfig", "Every constant of the watch over dirt on the lens.");
}

}  // namespace adit::python

PYBIND11_MODULE(_adit, module) {
  using namespace adit::python;
  module.doc() = "Where the open space is, in the dark, from one camera.";
  module.attr("__version__") = ADIT_VERSION;
  bind_configs(module);
  bind_camera(module);
  bind_finder(module);
  bind_navigator(module);
  module.def(
      "cpu_target", [] { return std::string(adit::cpu_target()); }, "The instruction set in use.");
  module.def(
      "supported_cpu_targets",
      [] {
        std::vector<std::string> names;
        for (const std::string_view name : adit::supported_cpu_targets()) names.emplace_back(name);
        return names;
      },
      "Instruction sets that this machine can run, the fastest first. All give the same bits.");
  module.def(
      "use_cpu_target",
      [](const std::string& name) {
        if (!adit::use_cpu_target(name)) throw py::value_error("'" + name + "' is none of supported_cpu_targets()");
      },
      py::arg("name"), "Chooses one for all calls from now on.");
}
