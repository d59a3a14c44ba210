#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/core.hpp>
#include <string>

#include "adit/io/bag_file.hpp"
#include "adit/io/errors.hpp"
#include "scratch_folder.hpp"

namespace adit::io {
namespace {

cv::Mat picture(int number) {
  cv::Mat mat(48, 64, CV_8UC3);
  cv::RNG random(static_cast<std::uint64_t>(number) + 1);
  random.fill(mat, cv::RNG::UNIFORM, 0, 256);
  return mat;
}

/// Ten images with all that belongs to them.
std::string written(const std::filesystem::path& folder, BagImages images = BagImages::kRaw,
                    const BagTopics& topics = {}) {
  const std::string path = (folder / "flight.bag").string();
  BagWriter bag(path, images, topics);
  for (int i = 0; i < 10; ++i) {
    const double stamp_s = i / 30.0;
    bag.write_camera(stamp_s, pinhole(64, 48, 75.0));
    bag.write_image(stamp_s, picture(i));
    bag.write_motion(stamp_s, {});
    bag.write_command(stamp_s, 0.5, -0.1);
    bag.write_imu({stamp_s, {0, 0, 0.1}, {0, 0, 9.8}});
    bag.write_scan({stamp_s, -1.0, 0.5, 0.1, 0.1, 30.0, {1, 2, 3, 4, 5}});
  }
  bag.commit();
  return path;
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void put(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string fault_of_opening(const std::string& path, const std::string& topic = "") {
  try {
    (void)open_bag(path, topic);
    return "";
  } catch (const InputError& e) {
    return e.what();
  }
}

class BagTest : public ::testing::Test {
 protected:
  testing::ScratchFolder scratch_;
  std::filesystem::path folder_ = scratch_.path();
};

TEST_F(BagTest, WhatIsWrittenIsRead) {
  const auto source = open_bag(written(folder_));
  EXPECT_EQ(source->frame_count(), 10);
  EXPECT_TRUE(source->is_sequence());
  EXPECT_NEAR(source->rate_hz(), 30.0, 0.1);
  for (int i = 0; i < 10; ++i) {
    const auto frame = source->next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->fault, "");
    EXPECT_EQ(frame->index, i);
    EXPECT_NEAR(frame->stamp_s, i / 30.0, 1e-8);
    EXPECT_EQ(cv::norm(frame->pixels, picture(i), cv::NORM_INF), 0.0);
  }
  EXPECT_FALSE(source->next());
  EXPECT_EQ(source->fault(), "");
}

TEST_F(BagTest, CompressedImagesAreRead) {
  const auto source = open_bag(written(folder_, BagImages::kJpeg));
  const auto frame = source->next();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->pixels.size(), cv::Size(64, 48));
}

TEST_F(BagTest, TheCalibrationIsThatOfTheBag) {
  const auto camera = camera_of_bag(written(folder_));
  ASSERT_TRUE(camera);
  EXPECT_EQ(camera->width, 64);
  EXPECT_DOUBLE_EQ(camera->focal_length_x_px, pinhole(64, 48, 75.0).focal_length_x_px);
  const auto compressed = camera_of_bag(written(folder_, BagImages::kJpeg));
  EXPECT_TRUE(compressed) << "one folder further up";
  BagTopics without;
  without.camera_info.clear();
  EXPECT_FALSE(camera_of_bag(written(folder_, BagImages::kRaw, without)));
}

TEST_F(BagTest, AllTopicsAreThereWithTheirTypes) {
  std::string list;
  for (const BagTopic& topic : topics_of_bag(written(folder_)))
    list += topic.name + " " + topic.type + " " + std::to_string(topic.messages) + "\n";
  EXPECT_EQ(list,
            "/camera/camera_info sensor_msgs/CameraInfo 10\n/camera/image_raw sensor_msgs/Image 10\n"
            "/cmd_vel geometry_msgs/Twist 10\n/imu sensor_msgs/Imu 10\n/odom nav_msgs/Odometry 10\n"
            "/scan sensor_msgs/LaserScan 10\n/tf tf2_msgs/TFMessage 10\n");
}

TEST_F(BagTest, TopicsAreChosenByName) {
  const std::string path = written(folder_);
  EXPECT_EQ(fault_of_opening(path, "/camera/image_raw"), "");
  EXPECT_EQ(fault_of_opening(path, "camera/image_raw"), "");
  EXPECT_NE(fault_of_opening(path, "/imu").find("--topic /imu holds sensor_msgs/Imu, no images"), std::string::npos);
  EXPECT_NE(fault_of_opening(path, "/left").find("--topic /left is not there; the bag holds /camera/camera_info"),
            std::string::npos);
}

TEST_F(BagTest, ABagWithoutImagesIsSaidToBeOne) {
  BagTopics topics;
  topics.image.clear();
  EXPECT_NE(fault_of_opening(written(folder_, BagImages::kRaw, topics)).find("the bag has no images; it holds"),
            std::string::npos);
}

TEST_F(BagTest, WhatIsNoBagEndsInAClearLine) {
  const std::string path = (folder_ / "no.bag").string();
  EXPECT_EQ(fault_of_opening(path), path + ": there is no such file");
  put(path, "");
  EXPECT_EQ(fault_of_opening(path), path + ": the file is empty");
  put(path, "These are no messages, these are words.");
  EXPECT_NE(fault_of_opening(path).find(path + ": a damaged bag ("), std::string::npos);
}

TEST_F(BagTest, ABagThatWasNotClosedIsSentToReindex) {
  const std::string path = written(folder_);
  std::string bytes = bytes_of(path);
  const auto at = bytes.find("index_pos=");
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at + 10, 8, 8, '\0');
  put(path, bytes);
  EXPECT_EQ(fault_of_opening(path),
            path + ": the bag has no index, because its recording was not closed; rosbag reindex flight.bag makes one");
}

TEST_F(BagTest, ABagThatIsCutOffEndsInOneLine) {
  const std::string path = written(folder_);
  const std::string bytes = bytes_of(path);
  for (const double share : {0.01, 0.3, 0.6, 0.9, 0.999}) {
    put(path, bytes.substr(0, static_cast<std::size_t>(share * static_cast<double>(bytes.size()))));
    const std::string fault = fault_of_opening(path);
    EXPECT_NE(fault.find(path + ": "), std::string::npos) << share;
    EXPECT_EQ(fault.find('\n'), std::string::npos) << share;
  }
}

TEST_F(BagTest, DamageInsideEndsTheFramesEarlyAndSaysSo) {
  const std::string path = written(folder_);
  std::string bytes = bytes_of(path);
  // The records of the images lie in one chunk at the beginning; its inside is overwritten.
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 3), 20000, '\xff');
  put(path, bytes);
  std::string fault;
  try {
    const auto source = open_bag(path);
    while (const auto frame = source->next()) fault += frame->fault;
    fault += source->fault();
  } catch (const InputError& e) {
    fault = e.what();
  }
  EXPECT_NE(fault, "");
}

TEST_F(BagTest, NothingIsLeftOfABagThatWasNotCommitted) {
  {
    BagWriter bag(folder_ / "half.bag", BagImages::kRaw);
    bag.write_image(0.0, picture(0));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
  EXPECT_THROW(BagWriter(folder_ / "no" / "such.bag", BagImages::kRaw), OutputError);
}

}  // namespace
}  // namespace adit::io
