#include <pybind11/stl.h>

#include "adit/camera.hpp"
#include "bindings.hpp"

namespace py = pybind11;

namespace adit::python {
namespace {

Camera camera_of(int width, int height, double fx, double fy, double ox, double oy, const std::string& distortion_model,
                 const std::vector<double>& distortion) {
  CameraModel model;
  model.width = width;
  model.height = height;
  model.focal_length_x_px = fx;
  model.focal_length_y_px = fy;
  model.principal_point_x_px = ox;
  model.principal_point_y_px = oy;
  if (!parse(distortion_model, model.distortion_model))
    throw py::value_error("distortion_model: '" + distortion_model +
                          "' is none of none, plumb_bob, rational_polynomial, equidistant");
  if (distortion.size() != static_cast<std::size_t>(coefficient_count(model.distortion_model)))
    throw py::value_error("distortion: " + distortion_model + " has " +
                          std::to_string(coefficient_count(model.distortion_model)) + " coefficients, not " +
                          std::to_string(distortion.size()));
  std::copy(distortion.begin(), distortion.end(), model.distortion.begin());
  return Camera(model);
}

}  // namespace

void bind_camera(py::module_& module) {
  py::class_<Camera> camera(module, "Camera",
                            "A calibration, as in a ROS camera_info file: pixels to directions and back.\n\n"
                            "Lengths in px, pixel centres at integers, origin top left. Azimuth is positive to the "
                            "right, elevation upwards, rad.");
  camera.def(py::init(&camera_of), py::arg("width"), py::arg("height"), py::kw_only(), py::arg("focal_length_x_px"),
             py::arg("focal_length_y_px"), py::arg("principal_point_x_px"), py::arg("principal_point_y_px"),
             py::arg("distortion_model") = "none", py::arg("distortion") = std::vector<double>(),
             "distortion_model: none, plumb_bob (5 coefficients), rational_polynomial (8), equidistant (4).");
  camera.def_static(
      "pinhole", [](int width, int height, double hfov_deg) { return Camera(pinhole(width, height, hfov_deg)); },
      py::arg("width"), py::arg("height"), py::arg("hfov_deg"),
      "An ideal pinhole with square pixels and this horizontal field of view, 10 to 170 deg.");
  camera.def_property_readonly(
      "width", [](const Camera& c) { return c.model().width; }, "px");
  camera.def_property_readonly(
      "height", [](const Camera& c) { return c.model().height; }, "px");
  camera.def(
      "bearing_of",
      [](const Camera& c, double u_px, double v_px) {
        const Bearing bearing = c.bearing_of(Pixel{u_px, v_px});
        return std::pair(bearing.azimuth_rad, bearing.elevation_rad);
      },
      py::arg("u_px"), py::arg("v_px"), "(azimuth_rad, elevation_rad) of a pixel.");
  camera.def(
      "pixel_of",
      [](const Camera& c, double azimuth_rad, double elevation_rad) -> std::optional<std::pair<double, double>> {
        const auto pixel = c.pixel_of(Bearing{azimuth_rad, elevation_rad});
        if (!pixel) return std::nullopt;
        return std::pair(pixel->u_px, pixel->v_px);
      },
      py::arg("azimuth_rad"), py::arg("elevation_rad"),
      "(u_px, v_px) where a direction is seen; None at or behind the image plane.");
  camera.def(
      "normalised_of",
      [](const Camera& c, double u_px, double v_px) {
        const NormalisedPoint point = c.normalised_of({u_px, v_px});
        return std::pair(point.sx, point.sy);
      },
      py::arg("u_px"), py::arg("v_px"), "(sx, sy) of a pixel: eq. (10), with the distortion undone.");
}

}  // namespace adit::python
