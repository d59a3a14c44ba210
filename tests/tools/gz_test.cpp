// A publisher over Gazebo's real transport plays frames and their calibration; the commands that come back are those of
// `adit run`, for the published chain and for adit with its navigator; and hover where no frame comes.
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

// A lens that no frame of this size is taken to have by itself, so that it shows whether the calibration arrived.
constexpr int kWidth = 320, kHeight = 240;
constexpr double kFocal_px = 200.0, kMiddleX_px = 150.0, kMiddleY_px = 125.0;
constexpr double kDistortion[] = {-0.1, 0.02, 0.001, -0.001, 0.0};

std::string calibration_file() {
  return "image_width: 320\nimage_height: 240\ncamera_matrix: {rows: 3, cols: 3, data: [200, 0, 150, 0, 200, 125, 0, "
         "0, 1]}\n"
         "distortion_model: plumb_bob\ndistortion_coefficients: {rows: 1, cols: 5, data: [-0.1, 0.02, 0.001, -0.001, "
         "0]}\n";
}

bool is_hover(const ignition::msgs::Twist& m) {
  return m.linear().x() == 0.0 && m.linear().y() == 0.0 && m.linear().z() == 0.0 && m.angular().z() == 0.0;
}

/// Keeps the commands; frames go out one by one.
struct World {
  explicit World(const std::string& prefix)
      : images(node.Advertise<ignition::msgs::Image>(prefix + "/image")),
        camera_infos(node.Advertise<ignition::msgs::CameraInfo>(prefix + "/camera_info")) {
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

  /// The lens of kCalibration, as Gazebo's camera tells it.
  void publish_calibration() {
    ignition::msgs::CameraInfo m;
    m.set_width(kWidth);
    m.set_height(kHeight);
    for (const double k : kDistortion) m.mutable_distortion()->add_k(k);
    for (const double k : {kFocal_px, 0.0, kMiddleX_px, 0.0, kFocal_px, kMiddleY_px, 0.0, 0.0, 1.0})
      m.mutable_intrinsics()->add_k(k);
    camera_infos.Publish(m);
  }

  bool wait_for_hover(std::size_t from, std::chrono::milliseconds time) {
    std::unique_lock lock(mutex);
    return changed.wait_for(lock, time, [&] {
      for (std::size_t i = from; i < commands.size(); ++i)
        if (is_hover(commands[i])) return true;
      return false;
    });
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
  ignition::transport::Node::Publisher images, camera_infos;
};

std::vector<std::string> column(const std::vector<std::vector<std::string>>& rows, const std::string& name) {
  std::vector<std::string> cells;
  for (std::size_t c = 0; c < rows[0].size(); ++c)
    if (rows[0][c] == name)
      for (std::size_t r = 1; r < rows.size(); ++r) cells.push_back(rows[r][c]);
  return cells;
}

class GzTest : public testing::TestWithParam<const char*> {};

TEST_P(GzTest, TheCommandsThatComeBackAreThoseOfAditRun) {
  ::setenv("IGN_IP", "127.0.0.1", 1);
  const ScratchFolder folder;
  const std::string prefix = "/adit_test_" + std::to_string(::getpid()) + "_" + GetParam();
  const std::string clip = std::string(ADIT_SOURCE_FOLDER) + "/data/clip.avi";
  write_text(folder / "lens.yaml", calibration_file());
  const std::vector<std::string> method{"--method", GetParam(), "--limit", std::to_string(kFrames), "--quiet", "--csv"};

  std::vector<std::string> run{"run", clip, "--camera", (folder / "lens.yaml").string()};
  run.insert(run.end(), method.begin(), method.end());
  run.push_back((folder / "run.csv").string());
  ASSERT_EQ(run_adit(run).exit_code, 0);

  std::vector<std::string> gz{"gz",      "--image", prefix + "/image", "--cmd", prefix + "/cmd_vel",
                              "--speed", "0.5",     "--recorded"};
  gz.insert(gz.end(), method.begin(), method.end());
  gz.push_back((folder / "gz.csv").string());
  World world(prefix);
  auto program = std::async(std::launch::async, [&] { return run_adit(gz); });
  const auto until = std::chrono::steady_clock::now() + 20s;
  while (!(world.images.HasConnections() && world.camera_infos.HasConnections()) &&
         std::chrono::steady_clock::now() < until)
    std::this_thread::sleep_for(20ms);
  ASSERT_TRUE(world.images.HasConnections()) << "adit gz did not subscribe";
  ASSERT_TRUE(world.camera_infos.HasConnections()) << "adit gz did not subscribe to the calibration beside the images";
  for (int i = 0; i < 5; ++i) {  // discovery of the commands, the other way; and the calibration before the first image
    world.publish_calibration();
    std::this_thread::sleep_for(60ms);
  }

  const auto sources = adit::io::open_sources({clip}, {});
  for (int i = 0; i < kFrames; ++i) {
    auto frame = sources.front()->next();
    ASSERT_TRUE(frame);
    ASSERT_EQ(frame->pixels.cols, kWidth);
    ASSERT_EQ(frame->pixels.rows, kHeight);
    const std::size_t before = world.count();
    if (i + 1 == kFrames) {
      // The camera falls silent: half a second later it hovers, and goes on when an image comes.
      const auto silent = std::chrono::steady_clock::now();
      ASSERT_TRUE(world.wait_for_hover(before, 10s)) << "no hover without images";
      EXPECT_GT(std::chrono::steady_clock::now() - silent, 300ms);
    }
    world.publish(*frame);
    world.wait_for(before + 1, 2000ms);
  }
  ASSERT_EQ(program.wait_for(20s), std::future_status::ready);
  EXPECT_EQ(program.get().exit_code, 0);

  const auto expected = rows_of(read_text(folder / "run.csv")), got = rows_of(read_text(folder / "gz.csv"));
  ASSERT_EQ(expected.size(), got.size());
  for (const char* name : {"status", "sx", "sy", "azimuth_deg", "elevation_deg", "yaw_rate_rad_s", "stamp_s"})
    EXPECT_EQ(column(expected, name), column(got, name)) << name;
  // And on the wire, up to the table's digits: each command is the yaw rate of its frame or, before the first opening,
  // where no frame came and after the last, hover.
  const auto rates = column(expected, "yaw_rate_rad_s");
  ASSERT_GT(rates.size(), 0u);
  std::size_t at = 0, matched = 0;
  const std::lock_guard lock(world.mutex);
  for (const auto& command : world.commands) {
    if (is_hover(command)) continue;
    while (at < rates.size() && std::abs(std::stod(rates[at].empty() ? "9" : rates[at]) - command.angular().z()) > 1e-4)
      ++at;
    ASSERT_LT(at, rates.size()) << "a command that is not adit run's: " << command.angular().z();
    ++matched;
    ++at;
  }
  EXPECT_GE(matched, static_cast<std::size_t>(kFrames - 3));
  EXPECT_TRUE(is_hover(world.commands.back())) << "the last word is to hover";
}

INSTANTIATE_TEST_SUITE_P(EachMethod, GzTest, testing::Values("paper", "adit"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
