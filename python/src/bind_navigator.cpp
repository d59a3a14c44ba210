#include <pybind11/stl.h>

#include <memory>
#include <mutex>

#include "adit/navigator.hpp"
#include "bindings.hpp"
#include "image_array.hpp"

namespace py = pybind11;

namespace adit::python {
namespace {

struct LockedNavigator {
  Navigator navigator;
  std::mutex mutex;

  explicit LockedNavigator(Navigator made) : navigator(std::move(made)) {}

  std::pair<NavigatorCommand, OpenSpace> update(const ImageArray& image, double stamp_s, const Motion& motion) {
    const py::gil_scoped_release released;
    const std::lock_guard lock(mutex);
    const Sight sight = navigator.look(image.view());
    return {navigator.steer(sight, stamp_s, motion), sight.open_space};
  }
};

void bind_heading(py::module_& module) {
  py::class_<HeadingCommand> command(module, "HeadingCommand", "What the vehicle should do about its heading.");
  command.def_property_readonly(
      "state", [](const HeadingCommand& c) { return std::string(to_string(c.state)); }, "steer, coast or hold");
  command.def_readonly("yaw_rate_rad_s", &HeadingCommand::yaw_rate_rad_s, "Positive to the left (REP 103).");
  py::class_<HeadingController> controller(module, "HeadingController", "Bearing in, yaw rate out.");
  controller.def(py::init<const HeadingConfig&>(), py::arg("config") = HeadingConfig());
  controller.def("update", &HeadingController::update, py::arg("open_space"), py::arg("stamp_s"),
                 "The command for a judged frame taken at stamp_s.");
  controller.def("tick", &HeadingController::tick, py::arg("now_s"),
                 "The command when no new frame has come by now_s.");
  controller.def("reset", &HeadingController::reset, "Forgets everything.");
}

void bind_command(py::module_& module) {
  py::class_<NavigatorCommand> command(module, "NavigatorCommand", "What the vehicle should do now.");
  command.def_property_readonly(
      "heading_state", [](const NavigatorCommand& c) { return std::string(to_string(c.heading.state)); },
      "steer, coast or hold");
  command.def_property_readonly(
      "yaw_rate_rad_s", [](const NavigatorCommand& c) { return c.heading.yaw_rate_rad_s; },
      "Positive to the left (REP 103).");
  command.def_readonly("speed_scale", &NavigatorCommand::speed_scale, "Share of the wanted speed, 0 to 1.");
  command.def_property_readonly(
      "manoeuvre", [](const NavigatorCommand& c) { return std::string(to_string(c.manoeuvre)); },
      "wait, follow, turn or give_up");
  command.def_property_readonly(
      "status", [](const NavigatorCommand& c) { return std::string(to_string(c.status)); },
      "Of the frame, with what only a sequence shows: frozen_frame, torn_frame.");
  command.def_property_readonly(
      "stamp_fault", [](const NavigatorCommand& c) { return std::string(to_string(c.stamp_fault)); },
      "none, not_later, backwards or jump");
  command.def_readonly("target_rad", &NavigatorCommand::target_rad,
                       "Azimuth that is steered to, positive to the right.");
  command.def_readonly("goal_rad", &NavigatorCommand::goal_rad, "Azimuth of the middle of the chosen gap.");
  command.def_readonly("free_m", &NavigatorCommand::free_m, "Free way straight ahead, on the pseudo-range's scale.");
}

}  // namespace

void bind_navigator(py::module_& module) {
  bind_heading(module);
  bind_command(module);
  py::class_<LockedNavigator> navigator(
      module, "Navigator",
      "Finder, ranges, tracker, steering and controller in a row, for sequences: what "
      "a robot runs.");
  navigator.def(
      py::init([](const FinderConfig& finder, const std::optional<Camera>& camera, const HeadingConfig& heading,
                  const ColumnRangeConfig& column_range, const RangeMemoryConfig& range_memory,
                  const TrackerConfig& tracker, const SteeringConfig& steering, const FrameWatchConfig& frame_watch,
                  const LensWatchConfig& lens_watch) {
        const NavigatorConfig config{finder,  heading,  column_range, range_memory,
                                     tracker, steering, frame_watch,  lens_watch};
        return std::make_unique<LockedNavigator>(camera ? Navigator(config, *camera) : Navigator(config));
      }),
      py::arg("config") = FinderConfig(), py::arg("camera") = py::none(), py::kw_only(),
      py::arg("heading") = HeadingConfig(), py::arg("column_range") = ColumnRangeConfig(),
      py::arg("range_memory") = RangeMemoryConfig(), py::arg("tracker") = TrackerConfig(),
      py::arg("steering") = SteeringConfig(), py::arg("frame_watch") = FrameWatchConfig(),
      py::arg("lens_watch") = LensWatchConfig());
  navigator.def(
      "update",
      [](LockedNavigator& self, const py::array& frame, double stamp_s, std::optional<double> yaw_rate_rad_s,
         std::optional<double> speed_m_s, const std::string& order) {
        return self.update(ImageArray(frame, order), stamp_s, {yaw_rate_rad_s, speed_m_s});
      },
      py::arg("frame"), py::arg("stamp_s"), py::kw_only(), py::arg("yaw_rate_rad_s") = py::none(),
      py::arg("speed_m_s") = py::none(), py::arg("order") = "",
      "Judges the frame and says what to do: (NavigatorCommand, OpenSpace). Motion that is not known is taken from the "
      "navigator's own commands.");
  navigator.def(
      "tick",
      [](LockedNavigator& self, double now_s) {
        const std::lock_guard lock(self.mutex);
        return self.navigator.tick(now_s);
      },
      py::arg("now_s"), py::call_guard<py::gil_scoped_release>(), "The command when no new frame has come by now_s.");
  navigator.def(
      "reset",
      [](LockedNavigator& self) {
        const std::lock_guard lock(self.mutex);
        self.navigator.reset();
      },
      py::call_guard<py::gil_scoped_release>(), "Forgets everything.");
}

}  // namespace adit::python
