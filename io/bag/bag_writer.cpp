// Flights as bags.
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <cstring>
#include <opencv2/imgcodecs.hpp>

#include "adit/io/bag_file.hpp"
#include "adit/io/errors.hpp"
#include "adit/io/output_file.hpp"
#include "adit/node/message_fields.hpp"

namespace adit::io {
namespace {

constexpr const char* kOpticalFrame = "camera_optical";
constexpr const char* kBody = "base_link";
constexpr int kJpegQuality = 90;

ros::Time time_of(double stamp_s) { return ros::Time(1.0 + stamp_s); }

template <class Message>
Message stamped(double stamp_s, const char* frame_id) {
  Message m;
  m.header.stamp = time_of(stamp_s);
  m.header.frame_id = frame_id;
  return m;
}

}  // namespace

struct BagWriter::File {
  PendingFile pending;
  BagImages images;
  BagTopics topics;
  rosbag::Bag bag;

  template <class Work>
  void with_faults(const Work& work) const {
    try {
      work();
    } catch (const rosbag::BagException& e) {
      throw OutputError(pending.final_path().string() + ": cannot be written: " + e.what());
    }
  }

  template <class Message>
  void write(const std::string& topic, double stamp_s, const Message& message) {
    if (topic.empty()) return;
    with_faults([&] { bag.write(topic.front() == '/' ? topic : "/" + topic, time_of(stamp_s), message); });
  }
};

BagWriter::BagWriter(const std::filesystem::path& path, BagImages images, const BagTopics& topics)
    : file_(new File{PendingFile(path), images, topics, {}}) {
  file_->with_faults([&] { file_->bag.open(file_->pending.temporary_path().string(), rosbag::bagmode::Write); });
}

BagWriter::~BagWriter() = default;

void BagWriter::write_image(double stamp_s, const cv::Mat& pixels) {
  if (file_->images == BagImages::kJpeg) {
    auto m = stamped<sensor_msgs::CompressedImage>(stamp_s, kOpticalFrame);
    m.format = "jpeg";
    cv::imencode(".jpg", pixels, m.data, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
    if (!file_->topics.image.empty()) file_->write(file_->topics.image + "/compressed", stamp_s, m);
    return;
  }
  auto m = stamped<sensor_msgs::Image>(stamp_s, kOpticalFrame);
  m.width = static_cast<std::uint32_t>(pixels.cols);
  m.height = static_cast<std::uint32_t>(pixels.rows);
  m.encoding = pixels.channels() == 1 ? "mono8" : "bgr8";
  m.step = m.width * static_cast<std::uint32_t>(pixels.channels());
  m.data.resize(std::size_t{m.step} * m.height);
  for (int v = 0; v < pixels.rows; ++v)
    std::memcpy(m.data.data() + std::size_t{m.step} * static_cast<std::size_t>(v), pixels.ptr(v), m.step);
  file_->write(file_->topics.image, stamp_s, m);
}

void BagWriter::write_camera(double stamp_s, const CameraModel& camera) {
  auto m = stamped<sensor_msgs::CameraInfo>(stamp_s, kOpticalFrame);
  node::fill_camera_info(m, camera);
  file_->write(file_->topics.camera_info, stamp_s, m);
}

void BagWriter::write_motion(double stamp_s, const node::RobotMotion& motion) {
  auto odometry = stamped<nav_msgs::Odometry>(stamp_s, "odom");
  odometry.child_frame_id = kBody;
  node::fill_vector(odometry.pose.pose.position, motion.in_world.place_m);
  node::fill_quaternion(odometry.pose.pose.orientation, motion.in_world.rotation);
  node::fill_vector(odometry.twist.twist.linear, motion.velocity_m_s);
  node::fill_vector(odometry.twist.twist.angular, motion.angular_rate_rad_s);
  file_->write(file_->topics.odom, stamp_s, odometry);
  tf2_msgs::TFMessage transforms;
  transforms.transforms.push_back(stamped<geometry_msgs::TransformStamped>(stamp_s, "odom"));
  transforms.transforms[0].child_frame_id = kBody;
  node::fill_vector(transforms.transforms[0].transform.translation, motion.in_world.place_m);
  node::fill_quaternion(transforms.transforms[0].transform.rotation, motion.in_world.rotation);
  file_->write(file_->topics.tf, stamp_s, transforms);
}

void BagWriter::write_imu(const node::ImuReading& reading) {
  auto m = stamped<sensor_msgs::Imu>(reading.stamp_s, kBody);
  m.orientation_covariance[0] = -1.0;  // not given
  node::fill_vector(m.angular_velocity, reading.angular_rate_rad_s);
  node::fill_vector(m.linear_acceleration, reading.specific_force_m_s2);
  file_->write(file_->topics.imu, reading.stamp_s, m);
}

void BagWriter::write_scan(const node::ScanReading& scan) {
  auto m = stamped<sensor_msgs::LaserScan>(scan.stamp_s, kBody);
  m.angle_min = static_cast<float>(scan.angle_min_rad);
  m.angle_increment = static_cast<float>(scan.angle_step_rad);
  m.angle_max =
      static_cast<float>(scan.angle_min_rad + scan.angle_step_rad * (static_cast<double>(scan.ranges_m.size()) - 1.0));
  m.scan_time = static_cast<float>(scan.interval_s);
  m.range_min = static_cast<float>(scan.range_min_m);
  m.range_max = static_cast<float>(scan.range_max_m);
  m.ranges = scan.ranges_m;
  file_->write(file_->topics.scan, scan.stamp_s, m);
}

void BagWriter::write_command(double stamp_s, double forward_m_s, double yaw_rate_rad_s) {
  geometry_msgs::Twist m;
  m.linear.x = forward_m_s;
  m.angular.z = yaw_rate_rad_s;
  file_->write(file_->topics.cmd_vel, stamp_s, m);
}

void BagWriter::commit() {
  file_->with_faults([&] { file_->bag.close(); });
  file_->pending.commit();
}

}  // namespace adit::io
