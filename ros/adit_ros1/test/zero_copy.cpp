// Perception reads the very pixels that were published: as a node in the publisher's process, and as the nodelet that a
// manager's loader has loaded from its plugin.
#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <boost/make_shared.hpp>
#include <future>
#include <optional>
#include <thread>

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

/// The nodelet manager is this loader and no more; it calls nodelets on threads of its own.
class NodeletTest : public testing::Test {
 protected:
  NodeletTest() {
    ros::param::set("/zero_copy_nodelet/method", "paper");
    is_loaded_ = loader_.load("/zero_copy_nodelet", "adit_ros1/OpenSpace",
                              {{ros::names::resolve("image"), ros::names::resolve("managed/image")},
                               {ros::names::resolve("open_space"), ros::names::resolve("managed/open_space")}},
                              {});
    images_ = nh_.advertise<sensor_msgs::Image>("managed/image", 1);
    answers_ = nh_.subscribe<adit_ros1::OpenSpace>("managed/open_space", 10,
                                                   [this](const adit_ros1::OpenSpaceConstPtr& m) { answer_ = m; });
  }

  template <class Condition>
  bool wait(Condition condition) {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(20.0);
    while (ros::ok() && !condition() && ros::WallTime::now() < end) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.002));
    }
    return condition();
  }

  adit_ros1::OpenSpaceConstPtr answer(const ros::Time& stamp) {
    wait([&] { return answer_ && answer_->header.stamp == stamp; });
    return answer_ && answer_->header.stamp == stamp ? answer_ : nullptr;
  }

  ros::NodeHandle nh_;
  nodelet::Loader loader_{false};
  bool is_loaded_ = false;
  ros::Publisher images_;
  ros::Subscriber answers_;
  adit_ros1::OpenSpaceConstPtr answer_;
};

TEST_F(NodeletTest, TheLoadedNodeletHoldsTheMessageThatWasPublished) {
  ASSERT_TRUE(is_loaded_);
  ASSERT_TRUE(wait([&] { return images_.getNumSubscribers() > 0 && answers_.getNumPublishers() > 0; }));
  // Whoever takes a copy takes it within publish(), and the message dies with us. The nodelet may be done with it
  // before we let go of it: then it is tried again.
  const auto here = std::this_thread::get_id();
  for (int i = 0; i < 200; ++i) {
    std::promise<std::pair<const sensor_msgs::Image*, std::thread::id>> released;
    auto end = released.get_future();
    sensor_msgs::ImagePtr image(new sensor_msgs::Image(*grey_image(255)), [&](sensor_msgs::Image* p) {
      released.set_value({p, std::this_thread::get_id()});
      delete p;
    });
    const sensor_msgs::Image* address = image.get();
    const ros::Time stamp = image->header.stamp;
    images_.publish(image);
    image.reset();
    const auto judged = answer(stamp);
    ASSERT_TRUE(judged);
    EXPECT_EQ(judged->status_text, "too_bright");
    const auto [last, thread] = end.get();
    ASSERT_EQ(last, address);
    if (thread != here) return;  // the nodelet's thread was the last to hold that very address
  }
  FAIL() << "the message never left this thread: the nodelet gets copies";
}

TEST_F(NodeletTest, TheLoadedNodeletReadsThePixelsThatWerePublished) {
  ASSERT_TRUE(is_loaded_);
  ASSERT_TRUE(wait([&] { return images_.getNumSubscribers() > 0 && answers_.getNumPublishers() > 0; }));
  // Made black right after it was published white; where the nodelet was quicker it is tried again.
  for (int i = 0; i < 200; ++i) {
    const sensor_msgs::ImagePtr image = grey_image(255);
    images_.publish(image);
    std::fill(image->data.begin(), image->data.end(), std::uint8_t{0});
    const auto judged = answer(image->header.stamp);
    ASSERT_TRUE(judged);
    if (judged->status_text == "too_dark") return;
  }
  FAIL() << "what is done to the pixels after publishing is never seen: the nodelet gets copies";
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "zero_copy");
  return RUN_ALL_TESTS();
}
