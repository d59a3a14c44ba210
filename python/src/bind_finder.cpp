#include <pybind11/stl.h>

#include <memory>
#include <mutex>

#include "adit/finder.hpp"
#include "bindings.hpp"
#include "image_array.hpp"

namespace py = pybind11;

namespace adit::python {
namespace {

/// A finder serves one thread at a time; Python's threads may share one all the same.
struct LockedFinder {
  OpenSpaceFinder finder;
  std::mutex mutex;

  explicit LockedFinder(OpenSpaceFinder made) : finder(std::move(made)) {}

  OpenSpace find(const ImageArray& image) {
    const py::gil_scoped_release released;
    const std::lock_guard lock(mutex);
    return finder.find(image.view());
  }

  std::pair<OpenSpace, StageImages> explain(const ImageArray& image) {
    const py::gil_scoped_release released;
    const std::lock_guard lock(mutex);
    std::pair<OpenSpace, StageImages> both;
    both.first = finder.explain(image.view(), both.second);
    return both;
  }
};

/// A plane as an array that keeps its owner alive; None when it was not made.
template <class Value>
py::object array_of(const py::object& owner, const StageImages& images, const std::vector<Value>& plane) {
  if (plane.empty()) return py::none();
  // The method's own grid may be coarser than the frame.
  if (plane.size() != static_cast<std::size_t>(images.width) * static_cast<std::size_t>(images.height))
    return py::array_t<Value>(static_cast<py::ssize_t>(plane.size()), plane.data(), owner);
  return py::array_t<Value>(std::vector<py::ssize_t>{images.height, images.width}, plane.data(), owner);
}

template <class Class, class Value>
void bind_plane(Class& images, const char* name, std::vector<Value> StageImages::*plane, const char* about) {
  images.def_property_readonly(
      name,
      [plane](const py::object& self) {
        const auto& all = self.cast<const StageImages&>();
        return array_of(self, all, all.*plane);
      },
      about);
}

void bind_stage_images(py::module_& module) {
  py::class_<StageImages> images(
      module, "StageImages",
      "Pictures of the stages, arrays of shape (height, width); None where the method or the "
      "frame made none.");
  bind_plane(images, "dark_channel", &StageImages::dark_channel, "uint8, grey levels");
  bind_plane(images, "transmission", &StageImages::transmission, "float32, 0 to 1");
  bind_plane(images, "scattering_depth", &StageImages::scattering_depth, "float32, unitless; small is far");
  bind_plane(images, "closing", &StageImages::closing, "float32, the closed scattering depth");
  bind_plane(images, "closing_level", &StageImages::closing_level, "uint8, grey levels of the closed dark channel");
  bind_plane(images, "cluster", &StageImages::cluster, "uint8, 0 is the darkest cluster");
  bind_plane(images, "binary", &StageImages::binary, "uint8, 255 in the darkest cluster");
  bind_plane(images, "light", &StageImages::light, "float32, stops below full scale; method adit");
  bind_plane(images, "enclosure", &StageImages::enclosure, "float32, the score map; method adit");
  bind_plane(images, "openings", &StageImages::openings, "uint8, 1 the best opening, 2 the next; method adit");
}

/// What OpenSpace and Opening say alike.
template <class Class, class Struct>
void bind_place(Class& made, Struct) {
  made.def_property_readonly(
      "centroid_px", [](const Struct& s) { return std::pair(s.centroid_px.u_px, s.centroid_px.v_px); },
      "(u, v), px: eq. (9)");
  made.def_property_readonly(
      "point", [](const Struct& s) { return std::pair(s.point.sx, s.point.sy); }, "(sx, sy): eq. (10)");
  made.def_property_readonly(
      "azimuth_rad", [](const Struct& s) { return s.bearing.azimuth_rad; },
      "Positive to the right of the optical axis.");
  made.def_property_readonly(
      "elevation_rad", [](const Struct& s) { return s.bearing.elevation_rad; }, "Positive upwards.");
  made.def_readonly("area_fraction", &Struct::area_fraction, "Of the frame, 0 to 1.");
  made.def_readonly("confidence", &Struct::confidence, "0 to 1; its meaning depends on the method (docs/method.md).");
}

void bind_opening(py::module_& module) {
  py::class_<Opening> opening(module, "Opening", "A place in the frame, and why it is believed to be open.");
  bind_place(opening, Opening());
  opening.def_property_readonly(
      "box_px",
      [](const Opening& o) {
        return py::make_tuple(o.top_left_px.u_px, o.top_left_px.v_px, o.bottom_right_px.u_px, o.bottom_right_px.v_px);
      },
      "(left, top, right, bottom), px; the last pixels belong to it.");
  opening.def_readonly("half_width_rad", &Opening::half_width_rad, "Half the angle between the box's sides.");
  opening.def_readonly("half_height_rad", &Opening::half_height_rad,
                       "Half the angle between its upper and lower edge.");
  opening.def_readonly("score", &Opening::score, "What the openings are ordered by, 0 to 1.");
  opening.def_readonly("contrast", &Opening::contrast, "How much darker it is than the rock on its rim: 1 is black.");
  opening.def_readonly("touches_border", &Opening::touches_border, "Cut by the edge of the frame.");
}

std::string repr(const OpenSpace& s) {
  if (!s.found()) return "<OpenSpace " + std::string(to_string(s.status)) + ">";
  return py::str("<OpenSpace found azimuth_rad={:.3f} elevation_rad={:.3f} confidence={:.2f}>")
      .attr("format")(s.bearing.azimuth_rad, s.bearing.elevation_rad, s.confidence)
      .cast<std::string>();
}

void bind_open_space(py::module_& module) {
  py::class_<OpenSpace> open_space(module, "OpenSpace", "The answer for one frame, with its evidence.");
  open_space.def_property_readonly("found", &OpenSpace::found, "Is there a bearing to follow?");
  open_space.def_property_readonly(
      "status", [](const OpenSpace& s) { return std::string(to_string(s.status)); },
      "found, too_dark, too_bright, no_contrast, no_region, bad_frame, wrong_size, no_opening, blocked_lens, dust");
  bind_place(open_space, OpenSpace());
  open_space.def_property_readonly(
      "openings",
      [](const OpenSpace& s) { return std::vector<Opening>(s.openings.begin(), s.openings.begin() + s.opening_count); },
      "The best first; empty unless found.");
  open_space.def_property_readonly(
      "rule", [](const OpenSpace& s) { return std::string(to_string(s.rule)); },
      "By which the best opening was chosen.");
  open_space.def_property_readonly(
      "flags",
      [](const OpenSpace& s) {
        py::dict flags;
        flags["dust"] = s.flags.dust;
        flags["glare"] = s.flags.glare;
        flags["blocked_lens"] = s.flags.blocked_lens;
        flags["too_dark"] = s.flags.too_dark;
        flags["too_bright"] = s.flags.too_bright;
        flags["dirty_lens"] = s.flags.dirty_lens;
        return flags;
      },
      "What disturbs the view, by name.");
  open_space.def_readonly("veil_fraction", &OpenSpace::veil_fraction, "0 clear air, 1 nothing but veil; method adit.");
  open_space.def_readonly("atmospheric_light", &OpenSpace::atmospheric_light, "Grey levels, 0 to 255.");
  open_space.def_readonly("darkest_level", &OpenSpace::darkest_level, "Of the closed dark channel, 0 to 255.");
  open_space.def_readonly("brightest_level", &OpenSpace::brightest_level, "Of the closed dark channel, 0 to 255.");
  open_space.def_readonly("threshold_level", &OpenSpace::threshold_level, "Last level of the darkest cluster.");
  open_space.def_readonly("total_ns", &OpenSpace::total_ns, "Time the whole chain took.");
  open_space.def_property_readonly(
      "stage_ns",
      [](const OpenSpace& s) {
        py::dict all;
        for (int i = 0; i < kStageCount; ++i)
          all[py::str(std::string(to_string(static_cast<Stage>(i))))] = s.stage_ns[static_cast<std::size_t>(i)];
        return all;
      },
      "Time each stage took, by name.");
  open_space.def("__repr__", &repr);
}

}  // namespace

void bind_finder(py::module_& module) {
  bind_stage_images(module);
  bind_opening(module);
  bind_open_space(module);
  py::class_<LockedFinder> finder(
      module, "OpenSpaceFinder",
      "One frame in, the open space out. Each frame is judged alone.\n\n"
      "Threads may share a finder, but wait for each other; one finder a thread is faster.");
  finder.def(
      py::init([](const FinderConfig& config, const std::optional<Camera>& camera) {
        return std::make_unique<LockedFinder>(camera ? OpenSpaceFinder(config, *camera) : OpenSpaceFinder(config));
      }),
      py::arg("config") = FinderConfig(), py::arg("camera") = py::none(),
      "Without a camera, frames of any size, and an ideal pinhole with assumed_hfov_deg.");
  finder.def_property_readonly("config", [](const LockedFinder& f) { return f.finder.config(); });
  finder.def(
      "find",
      [](LockedFinder& self, const py::array& frame, const std::string& order) {
        return self.find(ImageArray(frame, order));
      },
      py::arg("frame"), py::arg("order") = "",
      "Judges one frame: uint8 of shape (height, width[, 1, 3 or 4]), or uint16 of shape (height, width).\n\n"
      "order: bgr (default), rgb, bgra (default with 4 channels), rgba, grey. Arrays of any stride are read where they "
      "lie, none\n"
      "is copied; those whose pixels do not lie side by side (mirrored, every second column, planes, columns first)\n"
      "take longer. The interpreter's lock is released meanwhile.");
  finder.def(
      "explain",
      [](LockedFinder& self, const py::array& frame, const std::string& order) {
        return self.explain(ImageArray(frame, order));
      },
      py::arg("frame"), py::arg("order") = "", "As find(), and the pictures of its stages: (OpenSpace, StageImages).");
}

}  // namespace adit::python
