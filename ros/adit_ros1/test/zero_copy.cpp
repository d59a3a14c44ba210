// Publisher and perception in one process, as in a nodelet manager: perception reads the very pixels that were
// published.
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <boost/make_shared.hpp>
#include <optional>

#include "open_space.hpp"

namespace {

constexpr std::uint32_t kWidth = 160, kHeight = 120;

sensor_msgs::ImagePtr grey_image(std::uint8_t value) {
  auto image = boost::make_shared<sensor_msgs::Image>();
  image->header.stamp = ros::Time::now();
  image->width = image->step = kWidth;
  image->height = kHeight;
  image->encoding = "mono8";
  image->data.assign(std::size_t{kWidth} * kHeight, value);
  return image;
}

/// Nothing is called but by work(): what comes between publishing and judging is up to the test.
class ZeroCopyTest : public testing::Test {
 protected:
  ZeroCopyTest() {
    nh_.setCallbackQueue(&queue_);
    private_nh_.setCallbackQueue(&queue_);
    node_ = std::make_unique<adit_ros1::OpenSpaceNode>(nh_, private_nh_, "open_space");
    images_ = nh_.advertise<sensor_msgs::Image>("image", 1);
    seen_ = nh_.subscribe<sensor_msgs::Image>("image", 1,
                                              [this](const sensor_msgs::ImageConstPtr& m) { address_ = m.get(); });
    answers_ = nh_.subscribe<adit_ros1::OpenSpace>("open_space", 1,
                                                   [this](const adit_ros1::OpenSpaceConstPtr& m) { answer_ = m; });
    while (ros::ok() && images_.getNumSubscribers() < 1) work();
  }

  void work() { queue_.callAvailable(ros::WallDuration(0.02)); }

  adit_ros1::OpenSpaceConstPtr answer() {
    answer_.reset();
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(20.0);
    while (ros::ok() && !answer_ && ros::WallTime::now() < end) work();
    return answer_;
  }

  ros::CallbackQueue queue_;
  ros::NodeHandle nh_, private_nh_{"~"};
  std::unique_ptr<adit_ros1::OpenSpaceNode> node_;
  ros::Publisher images_;
  ros::Subscriber seen_, answers_;
  const sensor_msgs::Image* address_ = nullptr;
  adit_ros1::OpenSpaceConstPtr answer_;
};

TEST_F(ZeroCopyTest, PerceptionReadsThePixelsThatWerePublished) {
  const sensor_msgs::ImagePtr white = grey_image(255);
  images_.publish(white);
  const auto of_white = answer();
  ASSERT_TRUE(of_white);
  EXPECT_EQ(of_white->status_text, "too_bright");
  EXPECT_EQ(address_, white.get());

  // Published white and made black before anybody was called: whoever has a copy still sees it white.
  const sensor_msgs::ImagePtr turned = grey_image(255);
  images_.publish(turned);
  std::fill(turned->data.begin(), turned->data.end(), std::uint8_t{0});
  const auto of_turned = answer();
  ASSERT_TRUE(of_turned);
  EXPECT_EQ(of_turned->header.stamp, turned->header.stamp);
  EXPECT_EQ(of_turned->status_text, "too_dark");
  EXPECT_EQ(address_, turned.get());
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "zero_copy");
  return RUN_ALL_TESTS();
}
