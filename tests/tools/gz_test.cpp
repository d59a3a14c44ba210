// A publisher over Gazebo's real transport plays frames; the commands that come back are those of `adit run`.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <future>
#include <ignition/msgs.hh>
#include <ignition/transport/Node.hh>
#include <mutex>

#include "adit/io/frame_source.hpp"
#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;
using namespace std::chrono_literals;

constexpr int kFrames = 60;

/// Keeps the commands; frames go out one by one.
struct World {
  explicit World(const std::string& prefix) : images(node.Advertise<ignition::msgs::Image>(prefix + "/image")) {
    std::function<void(const ignition::msgs::Twist&)> keep = [this](const ignition::msgs::Twist& m) {
      const std::lock_guard lock(mutex);
      commands.push_back(m);
      changed.notify_all();
    };
    node.Subscribe(prefix + "/cmd_vel", keep);
  }

  void publish(const adit::io::Frame& frame) {
    const cv::Mat& pixels = frame.pixels;
    ignition::msgs::Image m;
    const auto stamp_ns = static_cast<std::int64_t>(frame.stamp_s * 1e9 + 0.5) + 1'000'000'000;
    m.mutable_header()->mutable_stamp()->set_sec(stamp_ns / 1'000'000'000);
    m.mutable_header()->mutable_stamp()->set_nsec(static_cast<std::int32_t>(stamp_ns % 1'000'000'000));
    m.set_width(static_cast<std::uint32_t>(pixels.cols));
    m.set_height(static_cast<std::uint32_t>(pixels.rows));
    m.set_step(static_cast<std::uint32_t>(pixels.cols * 3));
    m.set_pixel_format_type(ignition::msgs::BGR_INT8);
    m.set_data(pixels.data, pixels.total() * pixels.elemSize());
    images.Publish(m);
  }

  bool wait_for(std::size_t count, std::chrono::milliseconds time) {
    std::unique_lock lock(mutex);
    return changed.wait_for(lock, time, [&] { return commands.size() >= count; });
  }
  std::size_t count() {
    const std::lock_guard lock(mutex);
    return commands.size();
  }

  std::mutex mutex;
  std::condition_variable changed;
  std::vector<ignition::msgs::Twist> commands;
  ignition::transport::Node node;
  ignition::transport::Node::Publisher images;
};

std::vector<std::string> column(const std::vector<std::vector<std::string>>& rows, const std::string& name) {
  std::vector<std::string> cells;
  for (std::size_t c = 0; c < rows[0].size(); ++c)
    if (rows[0][c] == name)
      for (std::size_t r = 1; r < rows.size(); ++r) cells.push_back(rows[r][c]);
  return cells;
}

TEST(GzTest, TheCommandsThatComeBackAreThoseOfAditRun) {
  ::setenv("IGN_IP", "127.0.0.1", 1);
  const ScratchFolder folder;
  const std::string prefix = "/adit_test_" + std::to_string(::getpid());
  const std::string clip = std::string(ADIT_SOURCE_FOLDER) + "/data/clip.avi";
  const std::vector<std::string> method{"--method", "paper", "--limit", std::to_string(kFrames), "--quiet", "--csv"};

  std::vector<std::string> run{"run", clip};
  run.insert(run.end(), method.begin(), method.end());
  run.push_back((folder / "run.csv").string());
  ASSERT_EQ(run_adit(run).exit_code, 0);

  std::vector<std::string> gz{"gz", "--image", prefix + "/image", "--cmd", prefix + "/cmd_vel", "--speed", "1"};
  gz.insert(gz.end(), method.begin(), method.end());
  gz.push_back((folder / "gz.csv").string());
  World world(prefix);
  auto program = std::async(std::launch::async, [&] { return run_adit(gz); });
  const auto until = std::chrono::steady_clock::now() + 20s;
  while (!world.images.HasConnections() && std::chrono::steady_clock::now() < until) std::this_thread::sleep_for(20ms);
  ASSERT_TRUE(world.images.HasConnections()) << "adit gz did not subscribe";
  std::this_thread::sleep_for(300ms);  // discovery of the commands, the other way

  const auto sources = adit::io::open_sources({clip}, {});
  for (int i = 0; i < kFrames; ++i) {
    auto frame = sources.front()->next();
    ASSERT_TRUE(frame);
    const std::size_t before = world.count();
    world.publish(*frame);
    world.wait_for(before + 1, 2000ms);
  }
  ASSERT_EQ(program.wait_for(20s), std::future_status::ready);
  EXPECT_EQ(program.get().exit_code, 0);

  const auto expected = rows_of(read_text(folder / "run.csv")), got = rows_of(read_text(folder / "gz.csv"));
  ASSERT_EQ(expected.size(), got.size());
  for (const char* name : {"status", "sx", "sy", "azimuth_deg", "elevation_deg", "yaw_rate_rad_s", "stamp_s"})
    EXPECT_EQ(column(expected, name), column(got, name)) << name;
  // And on the wire, up to the table's digits: each command is the yaw rate of its frame or, before the first opening
  // and after the last frame, hover.
  const auto rates = column(expected, "yaw_rate_rad_s");
  ASSERT_GT(rates.size(), 0u);
  std::size_t at = 0, matched = 0;
  for (const auto& command : world.commands) {
    if (command.linear().x() == 0.0) continue;
    while (at < rates.size() && std::abs(std::stod(rates[at].empty() ? "9" : rates[at]) - command.angular().z()) > 1e-4)
      ++at;
    ASSERT_LT(at, rates.size()) << "a command that is not adit run's: " << command.angular().z();
    ++matched;
    ++at;
  }
  EXPECT_GE(matched, static_cast<std::size_t>(kFrames - 3));
}

}  // namespace
