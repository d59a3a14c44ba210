#include "sdf_file.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <sdf/sdf.hh>
#include <sstream>
#include <string_view>

#include "adit/sim/world_error.hpp"

namespace adit::sim {
namespace {

/// Name of the frame that stands for an include.
constexpr std::string_view kIncludeFrame = "adit_include_";
/// Sides of a plane are cut to this: Gazebo draws 100 m where it means endless.
constexpr double kPlaneSide_m = 100.0;
/// Gazebo's lights have no unit; full white is taken for a work light of this flux.
constexpr double kLightFlux_lm = 2000.0;

Eigen::Affine3d affine_of(const ignition::math::Pose3d& pose) {
  const auto& q = pose.Rot();
  return Eigen::Translation3d(pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z()) *
         Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).normalized();
}

Eigen::Vector3d vector_of(const ignition::math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }

/// Puts a frame in the place of every include, so that libsdformat works out its pose, and the file it names is read
/// once and not a hundred times (libsdformat takes about 10 ms for each model).
class IncludeCutter {
 public:
  IncludeCutter(std::string path, SdfFile& file) : path_(std::move(path)), file_(file) {}

  std::string cut() {
    if (document_.LoadFile(path_.c_str()) != tinyxml2::XML_SUCCESS)
      throw WorldError(fmt::format("{}:{}: broken XML ({}); mend it there or export the world again", path_,
                                   document_.ErrorLineNum(), short_name_of_error()));
    tinyxml2::XMLElement* root = document_.RootElement();
    if (root == nullptr || std::string_view(root->Name()) != "sdf")
      throw WorldError(fmt::format("{}:1: begins with <{}>; an SDF file begins with <sdf version=...>", path_,
                                   root != nullptr ? root->Name() : ""));
    cut_within(*root);
    tinyxml2::XMLPrinter printer;
    document_.Print(&printer);
    return printer.CStr();
  }

 private:
  std::string short_name_of_error() const {
    const std::string name = document_.ErrorName();
    return document_.ErrorID() == tinyxml2::XML_ERROR_FILE_NOT_FOUND ? "no such file" : name;
  }

  void cut_within(tinyxml2::XMLElement& parent) {
    for (auto* child = parent.FirstChildElement(); child != nullptr;) {
      auto* next = child->NextSiblingElement();
      const std::string_view kind = child->Name();
      if (kind == "plugin" || kind == "gui" || kind == "state" || kind == "physics") {
        parent.DeleteChild(child);
      } else if (kind == "include") {
        replace(parent, *child);
      } else if (kind == "world" || kind == "model") {
        cut_within(*child);
      } else if (kind == "actor" || kind == "population" || kind == "road") {
        file_.notes.push_back(fmt::format("{}:{}: <{}> passed over", path_, child->GetLineNum(), kind));
        parent.DeleteChild(child);
      }
      child = next;
    }
  }

  static std::string text_of(const tinyxml2::XMLElement& parent, const char* child) {
    const auto* element = parent.FirstChildElement(child);
    return element != nullptr && element->GetText() != nullptr ? element->GetText() : "";
  }

  void replace(tinyxml2::XMLElement& parent, tinyxml2::XMLElement& include) {
    SdfInclusion inclusion;
    inclusion.uri = text_of(include, "uri");
    inclusion.name = text_of(include, "name");
    const tinyxml2::XMLElement* pose = include.FirstChildElement("pose");
    inclusion.has_pose = pose != nullptr;
    const std::string frame_name = fmt::format("{}{}", kIncludeFrame, file_.inclusions.size());
    auto* frame = document_.NewElement("frame");
    frame->SetAttribute("name", frame_name.c_str());
    if (pose != nullptr) frame->InsertEndChild(pose->DeepClone(&document_));
    parent.InsertAfterChild(&include, frame);
    parent.DeleteChild(&include);
    file_.inclusions.push_back(inclusion);
  }

  std::string path_;
  SdfFile& file_;
  tinyxml2::XMLDocument document_;
};

/// Walks what libsdformat has read.
class SdfWalk {
 public:
  SdfWalk(std::string path, Geometry geometry, SdfFile& file)
      : path_(std::move(path)), geometry_(geometry), file_(file) {}

  void walk(const sdf::Root& root) {
    if (root.Model() != nullptr) {
      file_.is_model = true;
      file_.name = root.Model()->Name();
      file_.model_pose = affine_of(root.Model()->RawPose());
      walk_inside(*root.Model(), Eigen::Affine3d::Identity());
    }
    for (std::uint64_t i = 0; i < root.WorldCount(); ++i) {
      const sdf::World& world = *root.WorldByIndex(i);
      file_.name = world.Name();
      for (std::uint64_t k = 0; k < world.ModelCount(); ++k)
        walk_model(*world.ModelByIndex(k), Eigen::Affine3d::Identity());
      for (std::uint64_t k = 0; k < world.FrameCount(); ++k)
        take_frame(*world.FrameByIndex(k), Eigen::Affine3d::Identity());
      for (std::uint64_t k = 0; k < world.LightCount(); ++k)
        add_light(*world.LightByIndex(k), Eigen::Affine3d::Identity());
    }
  }

 private:
  template <class Posed>
  Eigen::Affine3d pose_of(const Posed& posed) {
    ignition::math::Pose3d pose;
    if (!posed.SemanticPose().Resolve(pose).empty()) {
      pose = posed.RawPose();
      if (!posed.PoseRelativeTo().empty())
        file_.notes.push_back(fmt::format("{}: pose of '{}' relative to '{}' taken as relative to its parent", path_,
                                          posed.Name(), posed.PoseRelativeTo()));
    }
    return affine_of(pose);
  }

  void walk_model(const sdf::Model& model, const Eigen::Affine3d& parent) {
    walk_inside(model, parent * pose_of(model));
  }

  void walk_inside(const sdf::Model& model, const Eigen::Affine3d& pose) {
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
      const sdf::Link& link = *model.LinkByIndex(i);
      walk_link(link, pose * pose_of(link));
    }
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i) walk_model(*model.ModelByIndex(i), pose);
    for (std::uint64_t i = 0; i < model.FrameCount(); ++i) take_frame(*model.FrameByIndex(i), pose);
  }

  void take_frame(const sdf::Frame& frame, const Eigen::Affine3d& parent) {
    if (!frame.Name().starts_with(kIncludeFrame)) return;
    const char* begin = frame.Name().data() + kIncludeFrame.size();
    std::size_t index = file_.inclusions.size();
    std::from_chars(begin, frame.Name().data() + frame.Name().size(), index);
    if (index < file_.inclusions.size()) file_.inclusions[index].pose = parent * pose_of(frame);
  }

  void walk_link(const sdf::Link& link, const Eigen::Affine3d& pose) {
    if (geometry_ == Geometry::kVisual) {
      for (std::uint64_t i = 0; i < link.VisualCount(); ++i) {
        const sdf::Visual& visual = *link.VisualByIndex(i);
        const std::size_t before = file_.shapes.size();
        if (visual.Geom() != nullptr) add_shape(*visual.Geom(), visual.Name(), pose * pose_of(visual));
        if (visual.Material() != nullptr && file_.shapes.size() > before)
          paint(*visual.Material(), file_.shapes.back());
      }
    } else {
      for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
        const sdf::Collision& collision = *link.CollisionByIndex(i);
        if (collision.Geom() != nullptr) add_shape(*collision.Geom(), collision.Name(), pose * pose_of(collision));
      }
    }
    for (std::uint64_t i = 0; i < link.LightCount(); ++i) add_light(*link.LightByIndex(i), pose);
  }

  static void paint(const sdf::Material& material, SdfShape& shape) {
    const auto colour = material.Diffuse();
    const float mean = (colour.R() + colour.G() + colour.B()) / 3.0f;
    if (!(mean > 0.02f && mean < 0.95f)) return;  // black and white are what nobody has chosen
    shape.has_colour = true;
    shape.albedo = std::min(mean, 0.8f);
    shape.tint = Eigen::Vector3f(colour.R(), colour.G(), colour.B()) / mean;
  }

  void add_shape(const sdf::Geometry& geometry, const std::string& name, const Eigen::Affine3d& pose) {
    SdfShape shape;
    shape.pose = pose;
    if (const sdf::Mesh* mesh = geometry.MeshShape()) {
      shape.mesh_uri = mesh->Uri();
      shape.submesh = mesh->Submesh();
      shape.centre_submesh = mesh->CenterSubmesh();
      shape.pose.scale(vector_of(mesh->Scale()));
    } else if (const sdf::Box* box = geometry.BoxShape()) {
      shape.made = box_mesh(vector_of(box->Size()));
    } else if (const sdf::Cylinder* cylinder = geometry.CylinderShape()) {
      shape.made = cylinder_mesh(cylinder->Radius(), cylinder->Length());
    } else if (const sdf::Sphere* sphere = geometry.SphereShape()) {
      shape.made = sphere_mesh(Eigen::Vector3d::Constant(sphere->Radius()));
    } else if (const sdf::Ellipsoid* ellipsoid = geometry.EllipsoidShape()) {
      shape.made = sphere_mesh(vector_of(ellipsoid->Radii()));
    } else if (const sdf::Plane* plane = geometry.PlaneShape()) {
      const auto size = plane->Size();
      shape.made =
          plane_mesh(vector_of(plane->Normal()), std::min(size.X(), kPlaneSide_m), std::min(size.Y(), kPlaneSide_m));
    } else {
      file_.notes.push_back(
          fmt::format("{}: shape of '{}' passed over: it is no mesh, box, cylinder, sphere, "
                      "ellipsoid or plane",
                      path_, name));
      return;
    }
    file_.shapes.push_back(std::move(shape));
  }

  void add_light(const sdf::Light& light, const Eigen::Affine3d& parent) {
    if (light.Type() == sdf::LightType::DIRECTIONAL) {
      file_.notes.push_back(
          fmt::format("{}: light '{}' passed over: it has a direction and no place", path_, light.Name()));
      return;
    }
    const Eigen::Affine3d pose = parent * pose_of(light);
    WorldLamp lamp;
    lamp.place = pose.translation().cast<float>();
    const auto colour = light.Diffuse();
    const double white = (colour.R() + colour.G() + colour.B()) / 3.0 * light.Intensity();
    lamp.flux_lm = static_cast<float>(std::clamp(kLightFlux_lm * white, 10.0, 20000.0));
    if (light.Type() == sdf::LightType::SPOT) {
      lamp.axis = (pose.linear() * vector_of(light.Direction())).normalized().cast<float>();
      // The lobe that falls to a half in the middle between the inner and the outer angle (both are full angles).
      const double half = 0.25 * (light.SpotInnerAngle().Radian() + light.SpotOuterAngle().Radian());
      lamp.lobe_exponent = static_cast<float>(std::log(0.5) / std::log(std::cos(std::clamp(half, 0.05, 1.4))));
    }
    file_.lamps.push_back(lamp);
  }

  std::string path_;
  Geometry geometry_;
  SdfFile& file_;
};

}  // namespace

SdfFile read_sdf_file(const std::string& path, Geometry geometry) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw WorldError(fmt::format("{}: no such file; give a Gazebo world (.world, .sdf)", path));
  SdfFile file;
  const std::string text = IncludeCutter(path, file).cut();
  sdf::Console::Instance()->SetQuiet(true);
  sdf::ParserConfig config;
  config.SetWarningsPolicy(sdf::EnforcementPolicy::LOG);
  sdf::Root root;
  sdf::Errors faults;
  try {
    faults = root.LoadSdfString(text, config);
  } catch (const std::exception& exception) {
    throw WorldError(fmt::format("{}: refused by libsdformat: {}", path, exception.what()));
  }
  if (root.WorldCount() == 0 && root.Model() == nullptr)
    throw WorldError(fmt::format("{}: holds no world and no model that libsdformat can read{}", path,
                                 faults.empty() ? "" : ": " + faults.front().Message()));
  for (const sdf::Error& fault : faults) file.notes.push_back(fmt::format("{}: {}", path, fault.Message()));
  SdfWalk(path, geometry, file).walk(root);
  return file;
}

}  // namespace adit::sim
