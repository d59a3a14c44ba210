#include "field_server.hpp"

#include <stdexcept>
#include <variant>

#include "launch_parameters.hpp"

namespace adit_ros1 {
namespace {

using adit::node::Parameter;
using adit::node::ParameterValue;

const char* type_of(const ParameterValue& value) {
  constexpr const char* kNames[] = {"bool", "int", "double", "str"};
  return kNames[value.index()];
}

void add(dynamic_reconfigure::Config& config, const std::string& name, const ParameterValue& value) {
  const auto put = [&](auto& list, const auto& v) {
    list.emplace_back();
    list.back().name = name;
    list.back().value = v;
  };
  if (const auto* b = std::get_if<bool>(&value)) put(config.bools, *b);
  if (const auto* i = std::get_if<int>(&value)) put(config.ints, *i);
  if (const auto* d = std::get_if<double>(&value)) put(config.doubles, *d);
  if (const auto* s = std::get_if<std::string>(&value)) put(config.strs, *s);
}

/// The end of a parameter's range, in its own type.
ParameterValue limit_of(const Parameter& p, bool upper) {
  const double limit = upper ? p.maximum : p.minimum;
  if (std::holds_alternative<bool>(p.value)) return upper;
  if (std::holds_alternative<int>(p.value)) return static_cast<int>(limit);
  if (std::holds_alternative<double>(p.value)) return limit;
  return std::string();
}

/// A Python dictionary, as rqt_reconfigure reads it: a list to choose from.
std::string edit_method_of(const Parameter& p) {
  if (p.choices.empty()) return "";
  std::string list;
  for (const std::string& choice : p.choices)
    list += (list.empty() ? "" : ", ") + std::string("{'name': '") + choice + "', 'type': 'str', 'value': '" + choice +
            "', 'srcline': 0, 'srcfile': '', 'description': '', 'ctype': 'std::string', 'cconsttype': 'const char * "
            "const'}";
  return "{'enum': [" + list + "], 'enum_description': '" + p.name + "'}";
}

std::string description_of(const Parameter& p) {
  std::string text = p.meaning;
  if (!p.unit.empty()) text += " Unit: " + p.unit + ".";
  return text + " (" + p.source + ")";
}

/// Section names in the order of the fields.
std::vector<std::string> sections_of(const std::vector<Parameter>& parameters) {
  std::vector<std::string> sections;
  for (const Parameter& p : parameters)
    if (sections.empty() || sections.back() != p.section) sections.push_back(p.section);
  return sections;
}

void add_groups(dynamic_reconfigure::Config& config, const std::vector<Parameter>& parameters) {
  const auto put = [&](const std::string& name, int id) {
    config.groups.emplace_back();
    config.groups.back().name = name;
    config.groups.back().state = true;
    config.groups.back().id = id;
    config.groups.back().parent = 0;
  };
  put("Default", 0);
  int id = 0;
  for (const std::string& section : sections_of(parameters)) put(section, ++id);
}

}  // namespace

FieldServer::FieldServer(const ros::NodeHandle& private_nh, Fields fields)
    : nh_(private_nh), fields_(std::move(fields)), defaults_(fields_.list()) {
  read_parameters();
  fields_.apply();
  descriptions_ = nh_.advertise<dynamic_reconfigure::ConfigDescription>("parameter_descriptions", 1, true);
  updates_ = nh_.advertise<dynamic_reconfigure::Config>("parameter_updates", 1, true);
  descriptions_.publish(description());
  announce();
  service_ = nh_.advertiseService("set_parameters", &FieldServer::reconfigure, this);
}

void FieldServer::take(const std::string& name, const ParameterValue& value) {
  if (const std::string why = fields_.set(name, value); !why.empty())
    throw std::invalid_argument(nh_.getNamespace() + ": " + why);
}

void FieldServer::read_parameters() {
  for (const Parameter& p : defaults_)
    if (const auto value = parameter_at(nh_, p.name)) take(p.name, *value);
}

bool FieldServer::reconfigure(dynamic_reconfigure::Reconfigure::Request& request,
                              dynamic_reconfigure::Reconfigure::Response& response) {
  const auto before = fields_.list();
  const auto set = [&](const std::string& name, const ParameterValue& value) {
    const std::string why = fields_.set(name, value);
    if (!why.empty()) ROS_WARN("%s: %s", nh_.getNamespace().c_str(), why.c_str());
  };
  for (const auto& p : request.config.bools) set(p.name, static_cast<bool>(p.value));
  for (const auto& p : request.config.ints) set(p.name, p.value);
  for (const auto& p : request.config.strs) set(p.name, p.value);
  for (const auto& p : request.config.doubles) set(p.name, p.value);
  try {
    fields_.apply();
  } catch (const std::invalid_argument& e) {
    ROS_WARN("%s: %s", nh_.getNamespace().c_str(), e.what());
    for (const Parameter& p : before) (void)fields_.set(p.name, p.value);
  }
  announce();
  response.config = present();
  return true;
}

dynamic_reconfigure::Config FieldServer::present() const {
  dynamic_reconfigure::Config config;
  const auto parameters = fields_.list();
  for (const Parameter& p : parameters) add(config, p.name, p.value);
  add_groups(config, parameters);
  return config;
}

dynamic_reconfigure::ConfigDescription FieldServer::description() const {
  dynamic_reconfigure::ConfigDescription d;
  d.groups.emplace_back();
  d.groups.back().name = "Default";
  for (const std::string& section : sections_of(defaults_)) {
    d.groups.emplace_back();
    d.groups.back().name = section;
    d.groups.back().type = "tab";
    d.groups.back().id = static_cast<int>(d.groups.size()) - 1;
  }
  for (const Parameter& p : defaults_) {
    add(d.dflt, p.name, p.value);
    add(d.min, p.name, limit_of(p, false));
    add(d.max, p.name, limit_of(p, true));
    dynamic_reconfigure::ParamDescription line;
    line.name = p.name;
    line.type = type_of(p.value);
    line.description = description_of(p);
    line.edit_method = edit_method_of(p);
    for (auto& group : d.groups)
      if (group.name == p.section) group.parameters.push_back(line);
  }
  for (auto* config : {&d.dflt, &d.min, &d.max}) add_groups(*config, defaults_);
  return d;
}

/// To the parameter server and to whoever listens.
void FieldServer::announce() {
  for (const Parameter& p : fields_.list()) std::visit([&](const auto& v) { nh_.setParam(p.name, v); }, p.value);
  updates_.publish(present());
}

}  // namespace adit_ros1
