#include "open_space.hpp"

#include <stdexcept>

#include "adit/io/topic_pictures.hpp"
#include "names.hpp"
#include "pictures.hpp"

namespace adit_ros1 {
namespace {

constexpr double kReportEach_s = 1.0;
constexpr double kComplainEach_s = 5.0;

}  // namespace

OpenSpaceNode::OpenSpaceNode(ros::NodeHandle nh, ros::NodeHandle private_nh, const std::string& name)
    : nh_(nh),
      private_nh_(private_nh),
      launch_(launch_parameters<adit::node::PerceptionLaunch>(private_nh)),
      parameters_(private_nh, fields()),
      updater_(nh, private_nh, name),
      transport_(nh) {
  const auto beside = [&](const char* topic) { return name_beside(private_nh, topic); };
  open_space_ = nh_.advertise<adit_ros1::OpenSpace>(beside("open_space"), 1);
  heading_ = nh_.advertise<geometry_msgs::TwistStamped>(beside("heading"), 1);
  direction_ = nh_.advertise<geometry_msgs::PoseStamped>(beside("direction"), 1);
  scattering_depth_ = nh_.advertise<sensor_msgs::Image>(beside("scattering_depth"), 1);
  overlay_ = nh_.advertise<sensor_msgs::Image>(beside("overlay"), 1);
  camera_info_ = nh_.subscribe<sensor_msgs::CameraInfo>(
      beside("camera_info"), 1,
      [this](const sensor_msgs::CameraInfoConstPtr& info) { perception_.take(camera_info_of(*info)); });
  imu_ = nh_.subscribe<sensor_msgs::Imu>(beside("imu"), 10, [this](const sensor_msgs::ImuConstPtr& imu) {
    perception_.take_yaw_rate(imu->angular_velocity.z, time_of(imu->header.stamp));
  });
  updater_.setHardwareID("none");
  updater_.add("open space", [this](diagnostic_updater::DiagnosticStatusWrapper& status) {
    fill(status, perception_.diagnosis(time_of(ros::Time::now())));
    status.add("overlays made", overlays_made_);
    status.add("scattering depths made", scattering_depths_made_);
    status.add("arrows made", arrows_made_);
  });
  report_ = nh_.createWallTimer(ros::WallDuration(kReportEach_s),
                                [this](const ros::WallTimerEvent&) { updater_.force_update(); });
  subscribe();
}

FieldServer::Fields OpenSpaceNode::fields() {
  return {
      [this] { return perception_.parameters(); },
      [this](const std::string& name, const adit::node::ParameterValue& value) { return perception_.set(name, value); },
      [this] { perception_.apply(); }};
}

/// Compressed images are read here: no plugin has to be there for it. Every other transport is image_transport's.
void OpenSpaceNode::subscribe() {
  const auto no_delay = ros::TransportHints().tcpNoDelay();
  if (launch_.image_transport == "compressed") {
    compressed_ = nh_.subscribe(nh_.resolveName(name_beside(private_nh_, "image")) + "/compressed", 1,
                                &OpenSpaceNode::take_compressed, this, no_delay);
    return;
  }
  image_ = transport_.subscribe(name_beside(private_nh_, "image"), 1, &OpenSpaceNode::take_image, this,
                                image_transport::TransportHints(launch_.image_transport, no_delay, private_nh_));
}

void OpenSpaceNode::take_image(const sensor_msgs::ImageConstPtr& image) {
  judge(borrowed(*image), image->header.frame_id);
}

void OpenSpaceNode::take_compressed(const sensor_msgs::CompressedImageConstPtr& image) {
  const cv::Mat pixels = decoded(*image);
  if (pixels.empty()) {
    const std::string fault = "image/compressed: the bytes are no picture (format '" + image->format + "')";
    ROS_WARN_THROTTLE(kComplainEach_s, "%s", fault.c_str());
    perception_.take_unreadable(fault, time_of(ros::Time::now()));
    return;
  }
  const sensor_msgs::ImagePtr raw = image_of(pixels);
  raw->header = image->header;
  judge(borrowed(*raw), raw->header.frame_id);
}

void OpenSpaceNode::judge(const adit::node::ImageMessage& message, const std::string& frame_id) {
  const adit::node::ImageAnswer answer = perception_.take(message, time_of(ros::Time::now()));
  if (!answer.fault.empty()) ROS_WARN_THROTTLE(kComplainEach_s, "image: %s", answer.fault.c_str());
  if (!answer.sighting) return;
  publish(*answer.sighting, frame_id);
  perception_.sent(answer.sighting->stamp_ns, time_of(ros::Time::now()));
  publish_pictures(message, *answer.sighting, frame_id);
}

void OpenSpaceNode::publish(const adit::node::Sighting& sighting, const std::string& frame_id) {
  open_space_.publish(boost::make_shared<adit_ros1::OpenSpace>(open_space_of(sighting, frame_id)));
  heading_.publish(boost::make_shared<geometry_msgs::TwistStamped>(heading_of(sighting, launch_.body_frame)));
  if (!sighting.open_space.found() || direction_.getNumSubscribers() == 0) return;
  ++arrows_made_;
  direction_.publish(direction_of(sighting, frame_id));
}

void OpenSpaceNode::publish_pictures(const adit::node::ImageMessage& message, const adit::node::Sighting& sighting,
                                     const std::string& frame_id) {
  const adit::FinderConfig& finder = perception_.finder_config();
  const auto publish = [&](ros::Publisher& publisher, const sensor_msgs::ImagePtr& picture, std::int64_t& made) {
    ++made;
    picture->header.stamp = time_of(sighting.stamp_ns);
    picture->header.frame_id = frame_id;
    publisher.publish(picture);
  };
  if (overlay_.getNumSubscribers() > 0)
    publish(overlay_,
            image_of(adit::io::overlay_of(view_of(message).view, sighting.open_space, sighting.heading,
                                          finder.grey16_depth_bits)),
            overlays_made_);
  if (scattering_depth_.getNumSubscribers() == 0) return;
  if (const auto stages = perception_.explain(message))
    publish(scattering_depth_, image_of(adit::io::scattering_depth_levels(*stages, finder)), scattering_depths_made_);
}

}  // namespace adit_ros1
