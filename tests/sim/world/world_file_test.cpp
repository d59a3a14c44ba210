// Gazebo worlds and bare meshes: what is read, what is passed over and said, and what is refused in one line.
#include "adit/sim/world_file.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "adit/sim/course.hpp"
#include "adit/sim/mesh_file.hpp"
#include "adit/sim/world_error.hpp"

namespace adit::sim {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test.
class WorldFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("adit_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "models");
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  void write_model(const std::string& name, const std::string& inside) {
    const std::string folder = std::string("models/") + name;
    write(folder + "/model.config",
          std::string("<model><name>") + name + "</name><sdf version='1.6'>model.sdf</sdf></model>");
    write(folder + "/model.sdf", std::string("<sdf version='1.6'><model name='") + name + "'><static>true</static>" +
                                     inside + "</model></sdf>");
  }
  std::string write_world(const std::string& inside) {
    return write("a.world", std::string("<sdf version='1.6'><world name='w'>") + inside + "</world></sdf>");
  }
  static std::string error_of(const std::string& path) {
    try {
      if (path.ends_with(".world"))
        (void)load_world(path);
      else
        (void)load_mesh(path);
    } catch (const WorldError& error) {
      return error.what();
    }
    return "";
  }
  static void expect_one_line(const std::string& error, const std::string& word) {
    EXPECT_NE(error.find(word), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }

  fs::path folder_;
};

constexpr const char* kBoxLink =
    "<link name='l'><visual name='v'><geometry><box><size>2 4 6</size></box></geometry></visual></link>";
constexpr const char* kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

struct Box {
  Eigen::Vector3f low, high;
};
Box box_of(const Mesh& mesh) {
  Box box{mesh.vertices.front(), mesh.vertices.front()};
  for (const Eigen::Vector3f& v : mesh.vertices) {
    box.low = box.low.cwiseMin(v);
    box.high = box.high.cwiseMax(v);
  }
  return box;
}

TEST_F(WorldFile, PosesOfIncludesModelsLinksAndVisualsAddUp) {
  write_model("crate", kBoxLink);
  const World world = load_world(write_world(
      "<include><uri>model://crate</uri><pose>10 0 0 0 0 1.5707963</pose></include>"
      "<model name='m'><pose>0 100 0 0 0 0</pose><link name='k'><pose>0 0 7 0 0 0</pose><visual name='v'>"
      "<pose>1 0 0 0 0 0</pose><geometry><sphere><radius>1</radius></sphere></geometry></visual></link></model>"));
  EXPECT_EQ(world.name, "w");
  ASSERT_EQ(world.mesh.triangles.size(), world.mesh.materials.size());
  Mesh crate, ball;
  for (const Eigen::Vector3f& v : world.mesh.vertices) (v.y() < 50.0f ? crate : ball).vertices.push_back(v);
  const Box crate_box = box_of(crate), ball_box = box_of(ball);
  EXPECT_TRUE(crate_box.low.isApprox(Eigen::Vector3f(8, -1, -3), 1e-4f)) << crate_box.low.transpose();
  EXPECT_TRUE(crate_box.high.isApprox(Eigen::Vector3f(12, 1, 3), 1e-4f)) << crate_box.high.transpose();
  EXPECT_TRUE((0.5f * (ball_box.low + ball_box.high)).isApprox(Eigen::Vector3f(1, 100, 7), 1e-4f));
}

TEST_F(WorldFile, MeshesKeepTheirScaleAndFaceOutward) {
  write("models/tent/tent.obj", kTetrahedron);
  write_model("tent",
              "<link name='l'><visual name='v'><geometry><mesh><scale>-2 2 2</scale>"
              "<uri>model://tent/tent.obj</uri></mesh></geometry></visual></link>");
  const World world = load_world(write_world("<include><uri>model://tent</uri></include>"));
  ASSERT_EQ(world.mesh.triangles.size(), 4u);
  EXPECT_TRUE(box_of(world.mesh).low.isApprox(Eigen::Vector3f(-2, 0, 0)));
  double volume = 0.0;  // positive when all faces look outward, mirrored or not
  for (const auto& t : world.mesh.triangles)
    volume += world.mesh.vertices[t[0]].dot(world.mesh.vertices[t[1]].cross(world.mesh.vertices[t[2]])) / 6.0;
  EXPECT_NEAR(volume, 8.0, 1e-5);
}

TEST_F(WorldFile, NestedIncludesAndMissingModelsAreListed) {
  write_model("crate", kBoxLink);
  write_model("pair",
              "<include><uri>model://crate</uri><name>a</name><pose>0 0 1 0 0 0</pose></include>"
              "<include><uri>model://crate</uri><name>b</name><pose>0 0 2 0 0 0</pose></include>"
              "<include><uri>model://ghost</uri></include>");
  const World world =
      load_world(write_world("<include><uri>model://pair</uri><pose>5 0 0 0 0 0</pose></include>"
                             "<include><uri>model://ghost</uri></include>"));
  EXPECT_EQ(world.mesh.triangles.size(), 24u);
  EXPECT_FLOAT_EQ(box_of(world.mesh).high.z(), 5.0f);
  ASSERT_FALSE(world.notes.empty());
  EXPECT_NE(world.notes.front().find("model://ghost (2 times)"), std::string::npos) << world.notes.front();
}

TEST_F(WorldFile, LightsAreKeptWhenAskedFor) {
  write_model("crate", kBoxLink);
  const std::string path = write_world(
      "<include><uri>model://crate</uri></include>"
      "<light name='a' type='point'><pose>1 2 3 0 0 0</pose><diffuse>0.5 0.5 0.5 1</diffuse></light>"
      "<light name='b' type='directional'><direction>0 0 -1</direction></light>");
  EXPECT_TRUE(load_world(path).lamps.empty());
  const World world = load_world(path, {.models = {}, .world_lights = true});
  ASSERT_EQ(world.lamps.size(), 1u);
  EXPECT_TRUE(world.lamps[0].place.isApprox(Eigen::Vector3f(1, 2, 3)));
  EXPECT_GT(world.lamps[0].flux_lm, 10.0f);
}

TEST_F(WorldFile, VisualAndCollisionShapesAreApart) {
  const std::string path = write_world(
      "<model name='m'><link name='l'>"
      "<visual name='v'><geometry><box><size>1 1 1</size></box></geometry></visual>"
      "<collision name='c'><geometry><cylinder><radius>1</radius><length>8</length></cylinder></geometry></collision>"
      "</link></model>");
  EXPECT_FLOAT_EQ(box_of(load_world(path).mesh).high.z(), 0.5f);
  EXPECT_FLOAT_EQ(box_of(load_world(path, {.models = {}, .geometry = Geometry::kCollision}).mesh).high.z(), 4.0f);
}

TEST_F(WorldFile, BadWorldsEndInOneClearLine) {
  expect_one_line(error_of((folder_ / "none.world").string()), "none.world: no such file");
  expect_one_line(error_of(write("a.world", "<sdf version='1.6'><world name='w'>\n<model name='m'")), "broken XML");
  expect_one_line(error_of(write("a.world", "<urdf/>")), "<urdf>");
  expect_one_line(error_of(write("a.world", "")), "broken XML");
  expect_one_line(error_of(write_world("")), "no faces");
  expect_one_line(error_of(write("a.world", "<sdf version='1.6'></sdf>")), "no world and no model");
  expect_one_line(error_of(write_world("<include><uri>model://gone</uri></include>")), "model://gone");
  expect_one_line(error_of(write_world("<include><uri>model://../../etc</uri></include>")), "leads out");
  expect_one_line(error_of(write_world("<include><uri>model:///etc</uri></include>")), "leads out");
}

TEST_F(WorldFile, CirclesAreRefused) {
  write_model("snake", "<include><uri>model://tail</uri></include>");
  write_model("tail", "<include><uri>model://snake</uri></include>");
  expect_one_line(error_of(write_world("<include><uri>model://snake</uri></include>")), "leads back to itself");
  write("models/a.world", "");
  expect_one_line(error_of(write_world("<include><uri>a.world</uri></include>")), "leads back to itself");
}

TEST_F(WorldFile, DeepNestingAndFloodsAreRefused) {
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += "<model name='m'>";
  EXPECT_NE(error_of(write_world(deep)), "");
  // Ten models that each hold the one before ten times: 10^10 boxes.
  write_model("m0", kBoxLink);
  for (int i = 1; i <= 10; ++i) {
    std::string inside;
    for (int k = 0; k < 10; ++k)
      inside.append("<include><uri>model://m").append(std::to_string(i - 1)).append("</uri></include>");
    write_model(std::string("m").append(std::to_string(i)), inside);
  }
  expect_one_line(error_of(write_world("<include><uri>model://m10</uri></include>")), "more than");
}

TEST_F(WorldFile, MeshFilesAreScaledAndTurned) {
  const std::string path = write("a.obj", kTetrahedron);
  EXPECT_TRUE(box_of(load_mesh(path).mesh).high.isApprox(Eigen::Vector3f(1, 2, 3)));
  const Box y_up = box_of(load_mesh(path, {.mesh_scale = 0.5, .mesh_up = MeshUp::kY}).mesh);
  EXPECT_TRUE(y_up.high.isApprox(Eigen::Vector3f(0.5f, 0.0f, 1.0f))) << y_up.high.transpose();
  EXPECT_TRUE(y_up.low.isApprox(Eigen::Vector3f(0.0f, -1.5f, 0.0f))) << y_up.low.transpose();
  EXPECT_FLOAT_EQ(box_of(load_mesh(path, {.mesh_up = MeshUp::kX}).mesh).high.z(), 1.0f);
}

TEST_F(WorldFile, BadMeshesEndInOneClearLine) {
  expect_one_line(error_of((folder_ / "none.stl").string()), "no such file");
  expect_one_line(error_of(write("a.txt", "hello")), ".txt");
  expect_one_line(error_of(write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")), "a.obj: ");
  expect_one_line(error_of(write("b.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")), "b.obj: ");
  expect_one_line(error_of(write("c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")), "c.obj: ");
  expect_one_line(error_of(write("a.dae", "<COLLADA><asset>")), "a.dae: ");
  const std::string ply_head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\n";
  const std::string ply_body = "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(load_mesh(write("good.ply", ply_head + ply_body)).mesh.triangles.size(), 1u);
  expect_one_line(error_of(write("a.ply", ply_head)), "end_header");
  expect_one_line(error_of(write("b.ply", ply_head + "end_header\n0 0\n")), "b.ply: ");
  expect_one_line(error_of(write("c.ply",
                                 "ply\nformat binary_little_endian 1.0\nelement vertex 999999999\n"
                                 "property float x\nend_header\n")),
                  "c.ply: cut short");
  EXPECT_THROW((void)load_mesh(write("d.obj", kTetrahedron), {.mesh_scale = 0.0}), WorldError);
}

std::string binary_stl(std::uint32_t promised, std::uint32_t held, float first) {
  std::string text(80, ' ');
  text.append(reinterpret_cast<const char*>(&promised), 4);
  for (std::uint32_t i = 0; i < held; ++i) {
    const float numbers[12] = {0, 0, 1, first, 0, 0, 1, 0, 0, 0, 1, 0};
    text.append(reinterpret_cast<const char*>(numbers), 48);
    text.append(2, '\0');
  }
  return text;
}

TEST_F(WorldFile, BadStlEndsInOneClearLine) {
  EXPECT_EQ(load_mesh(write("good.stl", binary_stl(2, 2, 0.0f))).mesh.triangles.size(), 2u);
  expect_one_line(error_of(write("cut.stl", binary_stl(1000, 3, 0.0f))), "cut short");
  expect_one_line(error_of(write("nan.stl", binary_stl(2, 2, std::nanf("")))), "not finite");
  expect_one_line(error_of(write("none.stl", binary_stl(0, 0, 0.0f))), "none.stl: ");
  // Ten million triangles: the file is made of holes, so it takes no room on disk.
  const std::string path = write("many.stl", binary_stl(10'000'000, 1, 0.0f));
  fs::resize_file(path, 84u + 50u * 10'000'000u);
  expect_one_line(error_of(path), "10000000 triangles");
}

/// The world of the paper, from the folder of shared data.
TEST(PracticeWorld, LoadsWholeWithItsNetwork) {
  const char* from_environment = std::getenv("ADIT_DATA");
  const fs::path path =
      fs::path(from_environment != nullptr ? from_environment : ADIT_DATA_DEFAULT) / "worlds/tunnel_practice_2.world";
  if (!fs::exists(path)) GTEST_SKIP() << "no " << path << ": shared data are not here";
  const World world = load_world(path.string());
  EXPECT_EQ(world.mesh.triangles.size(), 496230u);
  const Box box = box_of(world.mesh);
  EXPECT_NEAR(box.low.x(), 10.0, 0.5);
  EXPECT_NEAR(box.high.x(), 363.0, 0.5);
  EXPECT_NEAR(box.low.y(), -183.0, 0.5);
  EXPECT_NEAR(box.high.y(), 103.0, 0.5);
  EXPECT_NEAR(box.low.z(), -13.0, 0.5);
  EXPECT_NEAR(box.high.z(), 4.6, 0.1);
  EXPECT_NE(world.notes.front().find("tunnel_staging_area"), std::string::npos);
  EXPECT_EQ(std::count_if(world.nodes.begin(), world.nodes.end(),
                          [](const Node& node) { return node.kind == NodeKind::kJunction; }),
            8);
  // Outside of the mouth at (10, 0), off its middle.
  EXPECT_TRUE(world.start.place.isApprox(Eigen::Vector3f(9, 1.2f, 0), 0.1f)) << world.start.place.transpose();
  EXPECT_NEAR(world.start.yaw_rad, 0.0, 0.01);
  const CourseConfig course = read_course(std::string(ADIT_COURSES) + "/practice_2.yaml");
  EXPECT_EQ(course.tiles.size(), 142u);
}

}  // namespace
}  // namespace adit::sim
