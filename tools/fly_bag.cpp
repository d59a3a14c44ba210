#include "fly_bag.hpp"

#include <opencv2/core/mat.hpp>

#include "adit/io/errors.hpp"
#ifdef ADIT_WITH_BAG
#include "adit/io/bag_file.hpp"
#endif

namespace adit::tools {

#ifdef ADIT_WITH_BAG

namespace {

std::array<double, 3> array_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

node::RobotMotion motion_of(const sim::VehicleState& v) {
  const Eigen::Quaterniond q = v.attitude();
  return {{array_of(v.place), {q.x(), q.y(), q.z(), q.w()}},
          array_of(q.conjugate() * v.velocity),
          array_of(v.angular_rate())};
}

io::BagTopics topics_of(const std::string& image) {
  io::BagTopics topics;
  topics.image = image;
  const auto slash = image.rfind('/');
  topics.camera_info = slash == std::string::npos ? "camera_info" : image.substr(0, slash) + "/camera_info";
  return topics;
}

}  // namespace

struct FlyBag::Writer {
  io::BagWriter bag;
  sim::LidarConfig lidar;
};

FlyBag::FlyBag(const BagOptions& options, const sim::Flight& flight)
    : writer_(
          new Writer{io::BagWriter(options.file, options.images == "jpeg" ? io::BagImages::kJpeg : io::BagImages::kRaw,
                                   topics_of(options.topic)),
                     flight.settings().lidar}) {}

void FlyBag::add(const sim::Flight& flight) {
  const sim::FlightRow& row = flight.row();
  io::BagWriter& bag = writer_->bag;
  bag.write_motion(row.stamp_s, motion_of(row.vehicle));
  if (row.delivery != sim::Delivery::kDropped) {
    const ImageView& view = flight.frame();
    const cv::Mat pixels(view.height, view.width, view.format == PixelFormat::kGrey8 ? CV_8UC1 : CV_8UC3,
                         const_cast<std::uint8_t*>(view.data), static_cast<std::size_t>(view.stride_bytes));
    bag.write_camera(row.stamp_s, flight.camera().model());
    bag.write_image(row.stamp_s, pixels);
  }
  const bool is_held = row.command.state == HeadingState::kHold;
  bag.write_command(row.stamp_s, is_held ? 0.0 : row.speed_scale * flight.settings().flight.speed_m_s,
                    row.command.yaw_rate_rad_s);
  if (flight.scan()) {
    const sim::Scan& scan = *flight.scan();
    const sim::LidarConfig& lidar = writer_->lidar;
    bag.write_scan({scan.stamp_s, scan.angle_min_rad, scan.angle_step_rad, 1.0 / lidar.lidar_rate_hz,
                    lidar.lidar_range_min_m, lidar.lidar_range_max_m, scan.ranges_m});
  }
  for (const sim::ImuSample& s : flight.imu_samples())
    bag.write_imu({s.stamp_s, array_of(s.angular_rate_rad_s), array_of(s.specific_force_m_s2)});
}

void FlyBag::commit() { writer_->bag.commit(); }

#else

struct FlyBag::Writer {};

FlyBag::FlyBag(const BagOptions& options, const sim::Flight&) {
  throw io::OutputError(options.file +
                        ": this adit was built without bags (librosbag-storage-dev was not there); "
                        "scripts/setup --ros bag installs it");
}
void FlyBag::add(const sim::Flight&) {}
void FlyBag::commit() {}

#endif

FlyBag::~FlyBag() = default;

}  // namespace adit::tools
