// The parts of the Python module, a file for each.
#pragma once

#include <pybind11/pybind11.h>

namespace adit::python {

void bind_configs(pybind11::module_& module);
void bind_camera(pybind11::module_& module);
void bind_finder(pybind11::module_& module);
void bind_navigator(pybind11::module_& module);

}  // namespace adit::python
