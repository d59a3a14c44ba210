// Recordings of ROS 1. C++17, as the sources behind it: see adit/node/parameters.hpp. Built where rosbag_storage is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adit/camera.hpp"
#include "adit/io/frame_source.hpp"
#include "adit/node/robot_readings.hpp"

namespace adit::io {

/// One topic of a bag.
struct BagTopic {
  std::string name;
  std::string type;  ///< "sensor_msgs/Image"
  std::int64_t messages = 0;
};

/// All topics, by name. @throws InputError: no bag, damaged, or without an index because its recording was not closed.
[[nodiscard]] std::vector<BagTopic> topics_of_bag(const std::filesystem::path& bag);

/// The images of one topic, sensor_msgs/Image or CompressedImage, in the order of their recording. Stamps are those of
/// the headers (of the recording where a header has none), counted from the first image.
/// @param topic  empty: the only image topic that there is.
/// @throws InputError as topics_of_bag, and when the topic is not there, is no image, or has to be chosen.
[[nodiscard]] std::unique_ptr<FrameSource> open_bag(const std::filesystem::path& bag, const std::string& topic = "");

/// The calibration that was recorded beside the images: camera_info in the same namespace. Nothing where there is none
/// or the camera was never calibrated. @throws InputError as open_bag, and when the calibration is broken.
[[nodiscard]] std::optional<CameraModel> camera_of_bag(const std::filesystem::path& bag, const std::string& topic = "");

enum class BagImages : std::uint8_t { kRaw, kJpeg };

/// Topics of a written bag; empty: not written.
struct BagTopics {
  std::string image = "camera/image_raw";
  std::string camera_info = "camera/camera_info";
  std::string odom = "odom";
  std::string tf = "/tf";
  std::string imu = "imu";
  std::string scan = "scan";
  std::string cmd_vel = "cmd_vel";
};

/// A bag that appears under its name only when it is whole. Stamps count from one second on: 0 is no time in ROS.
class BagWriter {
 public:
  /// @throws OutputError
  BagWriter(const std::filesystem::path& path, BagImages images, const BagTopics& topics = {});
  ~BagWriter();

  /// @param pixels  8-bit grey or BGR.
  void write_image(double stamp_s, const cv::Mat& pixels);
  void write_camera(double stamp_s, const CameraModel& camera);
  /// Odometry and the transform odom -> base_link.
  void write_motion(double stamp_s, const node::RobotMotion& motion);
  void write_imu(const node::ImuReading& reading);
  void write_scan(const node::ScanReading& scan);
  /// geometry_msgs/Twist, body frame; yaw rate positive to the left.
  void write_command(double stamp_s, double forward_m_s, double yaw_rate_rad_s);
  /// @throws OutputError
  void commit();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace adit::io
