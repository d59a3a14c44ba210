// What a course promises: the same bytes on any number of threads, rock all round, faces to the inside, the section
// that was asked for.
#include "adit/sim/course.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "adit/sim/scene.hpp"
#include "adit/sim/world_error.hpp"
#include "short_drift.hpp"

namespace adit::sim {
namespace {

/// All bytes that a renderer or a collision test could look at.
std::string bytes_of(const Mesh& mesh) {
  std::string bytes;
  const auto append = [&](const void* from, std::size_t size) { bytes.append(static_cast<const char*>(from), size); };
  append(mesh.vertices.data(), mesh.vertices.size() * sizeof(mesh.vertices[0]));
  append(mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
  append(mesh.materials.data(), mesh.materials.size());
  return bytes;
}

World built_with(const CourseConfig& config, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  return build_course(config);
}

TEST(Course, SameSeedSameBytesOnOneAndTwoThreads) {
  const CourseConfig config = short_drift();
  const std::string one = bytes_of(built_with(config, 1).mesh);
  const std::string two = bytes_of(built_with(config, 2).mesh);
  EXPECT_GT(one.size(), 100000u);
  EXPECT_TRUE(one == two);
}

TEST(Course, AnotherSeedAnotherRock) {
  CourseConfig config = short_drift();
  const std::string first = bytes_of(build_course(config).mesh);
  config.seed = 2;
  EXPECT_FALSE(first == bytes_of(build_course(config).mesh));
}

/// Directions spread evenly over the sphere.
std::vector<Eigen::Vector3f> directions(int count) {
  std::vector<Eigen::Vector3f> result;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - 2.0 * (i + 0.5) / count;
    const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double r = std::sqrt(1.0 - z * z);
    result.push_back(Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z).cast<float>());
  }
  return result;
}

/// True when a ray that leaves the rock does so through one of the mouths.
bool leaves_through_mouth(const World& world, const Eigen::Vector3f& from, const Eigen::Vector3f& way) {
  for (const Node& node : world.nodes) {
    if (node.kind != NodeKind::kMouth) continue;
    const Eigen::Vector3f middle = node.place + Eigen::Vector3f(0.0f, 0.0f, 1.7f);
    const float along = (middle - from).dot(way);
    if (along > -3.0f && (from + way * std::max(along, 0.0f) - middle).norm() < 3.5f) return true;
  }
  return false;
}

TEST(Course, NoRayFromTheAxisGetsThroughTheRock) {
  const World world = build_course(short_drift());
  const RayScene scene(world.mesh);
  int met = 0;
  for (const Passage& passage : world.passages) {
    for (std::size_t i = 2; i + 2 < passage.axis.size(); i += 3) {
      const Eigen::Vector3f eye = passage.axis[i].place + Eigen::Vector3f(0.0f, 0.0f, 1.5f);
      for (const Eigen::Vector3f& way : directions(400)) {
        const auto hit = scene.closest_hit(eye, way);
        if (hit) {
          ++met;
        } else {
          EXPECT_TRUE(leaves_through_mouth(world, eye, way)) << eye.transpose() << " towards " << way.transpose();
        }
      }
    }
  }
  EXPECT_GT(met, 3000);
}

TEST(Course, FacesLookInside) {
  const World world = build_course(short_drift());
  const RayScene scene(world.mesh);
  const Mesh& mesh = world.mesh;
  int seen = 0, turned = 0;
  for (const AxisPoint& point : world.passages.front().axis) {
    for (const Eigen::Vector3f& way : directions(100)) {
      const auto hit = scene.closest_hit(point.place + Eigen::Vector3f(0.0f, 0.0f, 1.5f), way);
      if (!hit) continue;
      const auto& triangle = mesh.triangles[hit->triangle];
      const Eigen::Vector3f a = mesh.vertices[triangle[0]];
      const Eigen::Vector3f normal = (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
      ++seen;
      if (normal.dot(way) > 0.0f) ++turned;
    }
  }
  ASSERT_GT(seen, 1000);
  EXPECT_EQ(turned, 0);
}

TEST(Course, SectionIsWhatWasAskedFor) {
  CourseConfig config = short_drift();
  config.pipe_count = config.cable_count = 0;
  config.prop_spacing_m = config.stones_per_m2 = 0.0;
  const World world = build_course(config);
  const RayScene scene(world.mesh);
  double width_sum = 0.0, height_sum = 0.0;
  int count = 0;
  const std::vector<AxisPoint>& axis = world.passages.front().axis;
  for (std::size_t i = 2; i + 1 < axis.size(); ++i) {
    const Eigen::Vector3f ahead = (axis[i + 1].place - axis[i - 1].place).normalized();
    const Eigen::Vector3f aside(-ahead.y(), ahead.x(), 0.0f);
    const Eigen::Vector3f eye = axis[i].place + Eigen::Vector3f(0.0f, 0.0f, 1.5f);
    const auto left = scene.closest_hit(eye, aside), right = scene.closest_hit(eye, -aside);
    const auto up = scene.closest_hit(eye, Eigen::Vector3f::UnitZ()),
               down = scene.closest_hit(eye, -Eigen::Vector3f::UnitZ());
    ASSERT_TRUE(left && right && up && down);
    EXPECT_NEAR(left->range_m + right->range_m, axis[i].width_m, 1.0);
    EXPECT_NEAR(up->range_m + down->range_m, axis[i].height_m, 0.7);
    EXPECT_NEAR(down->range_m, 1.5, 0.2);
    width_sum += left->range_m + right->range_m - axis[i].width_m;
    height_sum += up->range_m + down->range_m - axis[i].height_m;
    ++count;
  }
  ASSERT_GT(count, 20);
  EXPECT_NEAR(width_sum / count, 0.0, 0.25);
  EXPECT_NEAR(height_sum / count, 0.0, 0.25);
}

TEST(Course, BadPlansAreNamed) {
  CourseConfig config = short_drift();
  config.cell_m = -1.0;
  EXPECT_THROW((void)build_course(config), WorldError);
  config = short_drift();
  config.passages.front().from = "nowhere";
  try {
    (void)build_course(config);
    FAIL() << "a passage from nowhere was built";
  } catch (const WorldError& error) {
    EXPECT_NE(std::string(error.what()).find("nowhere"), std::string::npos);
  }
}

}  // namespace
}  // namespace adit::sim
