// A configuration struct as a Python class: every field by name, from visit_fields().
#pragma once

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>
#include <type_traits>

#include "adit/navigator_fields.hpp"

namespace adit::python {

namespace py = pybind11;

/// Calls visit(note, member) for the field of that name; false when there is none.
template <class Config, class Visitor>
bool at_field(Config& config, std::string_view name, const Visitor& visit) {
  bool found = false;
  visit_fields(config, [&](const FieldNote& note, auto& member) {
    if (found || name != note.name) return;
    found = true;
    visit(note, member);
  });
  return found;
}

template <class Config>
py::object field_value(const Config& config, std::string_view name) {
  py::object value;
  at_field(config, name, [&](const FieldNote&, const auto& member) {
    if constexpr (std::is_enum_v<std::remove_cvref_t<decltype(member)>>) {
      value = py::str(std::string(to_string(member)));
    } else {
      value = py::cast(member);
    }
  });
  return value;
}

/// @throws py::type_error for a name or a type that is none, py::value_error for a choice that is none.
template <class Config>
void assign_field(Config& config, const std::string& name, const py::handle& value) {
  const bool known = at_field(config, name, [&](const FieldNote& note, auto& member) {
    using Member = std::remove_reference_t<decltype(member)>;
    try {
      if constexpr (std::is_enum_v<Member>) {
        const auto text = value.cast<std::string>();
        if (parse(text, member)) return;
        std::string names;
        for (int i = 0; i <= static_cast<int>(note.maximum); ++i)
          names.append(i > 0 ? ", " : "").append(to_string(static_cast<Member>(i)));
        throw py::value_error(name + ": '" + text + "' is none of: " + names);
      } else {
        member = value.cast<Member>();
      }
    } catch (const py::cast_error&) {
      throw py::type_error(name + ": " + std::string(py::repr(value)) + " is no " +
                           (std::is_enum_v<Member>       ? "text"
                            : std::is_integral_v<Member> ? "whole number that fits"
                                                         : "number"));
    }
  });
  if (!known) throw py::type_error("there is no field '" + name + "'; fields() names all");
}

/// Takes the value unless the struct then has a fault. @throws py::value_error, py::type_error
template <class Config>
void set_field(Config& config, const std::string& name, const py::handle& value) {
  Config changed = config;
  assign_field(changed, name, value);
  if (const auto fault = fault_of(changed)) throw py::value_error(*fault);
  config = changed;
}

/// Takes all of them, and only then looks for a fault: some fields have to fit each other.
template <class Config>
Config config_of(const py::dict& fields) {
  Config config;
  for (const auto& [key, value] : fields) assign_field(config, key.template cast<std::string>(), value);
  if (const auto fault = fault_of(config)) throw py::value_error(*fault);
  return config;
}

/// Meaning, unit, range and source, as in the docs.
inline std::string doc_of(const FieldNote& note) {
  py::object text = py::str("{} Unit: {}; range: {:g} to {:g}. Source: {}");
  const std::string unit = *note.unit != '\0' ? note.unit : "none";
  return py::str(text.attr("format")(note.meaning, unit, note.minimum, note.maximum, note.source));
}

template <class Config>
void bind_config(py::module_& module, const char* name, const char* about) {
  py::class_<Config> made(module, name, about);
  made.def(py::init([](const py::kwargs& fields) { return config_of<Config>(fields); }));
  const Config defaults;
  visit_fields(defaults, [&](const FieldNote& note, const auto&) {
    const std::string field = note.name;
    made.def_property(
        note.name, [field](const Config& config) { return field_value(config, field); },
        [field](Config& config, const py::object& value) { set_field(config, field, value); }, doc_of(note).c_str());
  });
  made.def_static(
      "fields",
      [] {
        const Config config;
        py::dict all;
        visit_fields(config, [&](const FieldNote& note, const auto&) {
          py::dict about_field;
          about_field["default"] = field_value(config, note.name);
          about_field["unit"] = note.unit;
          about_field["minimum"] = note.minimum;
          about_field["maximum"] = note.maximum;
          about_field["meaning"] = note.meaning;
          about_field["source"] = note.source;
          all[note.name] = about_field;
        });
        return all;
      },
      "Every field: default, unit, minimum, maximum, meaning, source.");
  made.def("__copy__", [](const Config& config) { return Config(config); });
  made.def("__deepcopy__", [](const Config& config, const py::dict&) { return Config(config); });
  const auto to_dict = [](const Config& config) {
    py::dict all;
    visit_fields(config, [&](const FieldNote& note, const auto&) { all[note.name] = field_value(config, note.name); });
    return all;
  };
  made.def("to_dict", to_dict, "The fields and their values.");
  made.def("__eq__", [to_dict](const Config& a, const py::object& b) {
    return py::isinstance<Config>(b) && to_dict(a).equal(to_dict(b.cast<const Config&>()));
  });
  made.def("__repr__", [to_dict, label = std::string(name)](const Config& config) {
    const py::dict defaults_of = to_dict(Config());
    std::string text;
    for (const auto& [key, value] : to_dict(config))
      if (!value.equal(defaults_of[key]))
        text += (text.empty() ? "" : ", ") + std::string(py::str(key)) + "=" + std::string(py::repr(value));
    return label + "(" + text + ")";
  });
  made.def(py::pickle(to_dict, [](const py::dict& state) { return config_of<Config>(state); }));
}

}  // namespace adit::python
