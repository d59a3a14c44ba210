// Gazebo's own reader takes the model and the world; the topics are those that the README names.
#include <gtest/gtest.h>

#include <sdf/sdf.hh>

namespace {

const std::string kFolder = std::string(ADIT_SOURCE_FOLDER) + "/gz/";

TEST(GzModelTest, TheQuadrotorIsReadWithoutAComplaint) {
  sdf::Root root;
  const sdf::Errors errors = root.Load(kFolder + "adit_quadrotor/model.sdf");
  for (const auto& error : errors) ADD_FAILURE() << error.Message();
  const sdf::Model* model = root.Model();
  ASSERT_NE(model, nullptr);
  EXPECT_EQ(model->Name(), "adit_quadrotor");
  EXPECT_EQ(model->LinkCount(), 5u);
  EXPECT_EQ(model->JointCount(), 4u);
  const sdf::Link* body = model->LinkByName("base_link");
  ASSERT_NE(body, nullptr);
  const sdf::Sensor* camera = body->SensorByName("camera");
  ASSERT_NE(camera, nullptr);
  EXPECT_EQ(camera->Topic(), "camera");
  EXPECT_EQ(camera->CameraSensor()->ImageWidth(), 640u);
  EXPECT_EQ(camera->CameraSensor()->ImageHeight(), 480u);
  EXPECT_EQ(camera->UpdateRate(), 30.0);
  EXPECT_NE(body->SensorByName("imu"), nullptr);
}

TEST(GzModelTest, TheWorldIsReadWithoutAComplaint) {
  sdf::ParserConfig config;
  config.SetFindCallback([](const std::string& uri) {
    const std::string prefix = "model://";
    return kFolder + (uri.rfind(prefix, 0) == 0 ? uri.substr(prefix.size()) : uri);
  });
  sdf::Root root;
  const sdf::Errors errors = root.Load(kFolder + "worlds/empty_dark.sdf", config);
  for (const auto& error : errors) ADD_FAILURE() << error.Message();
  ASSERT_EQ(root.WorldCount(), 1u);
  EXPECT_NE(root.WorldByIndex(0)->ModelByName("adit_quadrotor"), nullptr);
}

}  // namespace
