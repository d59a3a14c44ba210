#include "adit/node/perception.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "adit/node/settings.hpp"
#include "frames.hpp"

namespace adit::node {
namespace {

constexpr Time_ns kBegin_ns = 1'700'000'000 * kSecond_ns;
constexpr Time_ns kFrame_ns = kSecond_ns / 30;

PerceptionSettings settings_of(Method method) {
  PerceptionSettings settings;
  settings.navigator.finder.method = method;
  return settings;
}

ImageMessage message_of(const test::Frame& frame, Time_ns stamp_ns) {
  ImageMessage m;
  m.stamp_ns = stamp_ns;
  m.width = static_cast<std::uint32_t>(frame.width);
  m.height = static_cast<std::uint32_t>(frame.height);
  m.encoding = "mono8";
  m.step = m.width;
  m.data = frame.bytes.data();
  m.size = frame.bytes.size();
  return m;
}

/// Opening on the right or left; the noise is new in each frame.
test::Frame tunnel(double u_px, int number, int width = 160) {
  test::Tunnel t;
  t.width = width;
  t.height = width * 3 / 4;
  t.u_px = u_px;
  t.seed = static_cast<unsigned>(number + 1);
  return test::tunnel(t);
}

/// So many frames at 30 Hz; the last answer.
ImageAnswer play(Perception& perception, double u_px, int count, int first = 0, int width = 160) {
  ImageAnswer answer;
  for (int i = first; i < first + count; ++i) {
    const test::Frame frame = tunnel(u_px, i, width);
    const Time_ns stamp_ns = kBegin_ns + i * kFrame_ns;
    answer = perception.take(message_of(frame, stamp_ns), stamp_ns + 1'000'000);
  }
  return answer;
}

CameraInfoMessage camera_info(std::uint32_t width) {
  CameraInfoMessage m;
  m.width = width;
  m.height = width * 3 / 4;
  m.matrix = {0.8 * width, 0, 0.5 * width, 0, 0.8 * width, 0.375 * width, 0, 0, 1};
  return m;
}

std::string value_of(const Diagnosis& d, const std::string& key) {
  for (const auto& [name, value] : d.values)
    if (name == key) return value;
  return "(absent)";
}

TEST(PerceptionTest, RightInTheImageIsANegativeYawRate) {
  for (const Method method : {Method::kPaper, Method::kAdit}) {
    PerceptionSettings settings = settings_of(method);
    settings.node.pilot = Pilot::kPublished;
    Perception right(settings), left(settings);
    const ImageAnswer to_right = play(right, 120.0, 10), to_left = play(left, 40.0, 10);
    ASSERT_TRUE(to_right.sighting && to_left.sighting);
    ASSERT_EQ(to_right.sighting->open_space.status, Status::kFound) << to_string(method);
    ASSERT_EQ(to_left.sighting->open_space.status, Status::kFound) << to_string(method);
    EXPECT_GT(to_right.sighting->open_space.bearing.azimuth_rad, 0.1);
    EXPECT_LT(to_right.sighting->heading.yaw_rate_rad_s, -0.05) << "REP 103: clockwise is negative";
    EXPECT_LT(to_left.sighting->open_space.bearing.azimuth_rad, -0.1);
    EXPECT_GT(to_left.sighting->heading.yaw_rate_rad_s, 0.05);
    EXPECT_EQ(to_right.sighting->forward_m_s, settings.node.speed_m_s);
  }
}

/// Heading after frames that show the same way ahead while a gyroscope tells of a turn, each time so long before the
/// image.
double steered_with_gyroscope(double yaw_rate_rad_s, Time_ns before_ns, std::string& used) {
  Perception perception(settings_of(Method::kAdit));
  double yaw_rate = 0.0;
  for (int i = 0; i < 20; ++i) {
    const test::Frame frame = tunnel(100.0, i);
    const Time_ns stamp_ns = kBegin_ns + i * kFrame_ns;
    perception.take_yaw_rate(yaw_rate_rad_s, stamp_ns - before_ns);
    yaw_rate = perception.take(message_of(frame, stamp_ns), stamp_ns).sighting->heading.yaw_rate_rad_s;
  }
  used = value_of(perception.diagnosis(kBegin_ns + kSecond_ns), "images with a yaw rate");
  return yaw_rate;
}

TEST(PerceptionTest, AYawRateIsUsedWhereItIsOfTheImage) {
  std::string used;
  const double at_rest = steered_with_gyroscope(0.0, 0, used);
  EXPECT_NE(steered_with_gyroscope(1.0, 0, used), at_rest) << "what was seen before has moved to the right";
  EXPECT_EQ(used, "20");
  Perception without(settings_of(Method::kAdit));
  const double unaided = play(without, 100.0, 20).sighting->heading.yaw_rate_rad_s;
  EXPECT_EQ(steered_with_gyroscope(1.0, kSecond_ns, used), unaided) << "of another motion: as if there were none";
  EXPECT_EQ(used, "0");
}

TEST(PerceptionTest, ARecordingIsNotTakenToGoWhereTheCommandsSendIt) {
  const auto steered = [](bool is_steered, bool has_gyroscope) {
    PerceptionSettings settings = settings_of(Method::kAdit);
    settings.node.is_steered = is_steered;
    settings.node.speed_m_s = 0.0;  // the turn alone
    Perception perception(settings);
    double yaw_rate = 0.0;
    for (int i = 0; i < 20; ++i) {
      const test::Frame frame = tunnel(120.0, i);
      const Time_ns stamp_ns = kBegin_ns + i * kFrame_ns;
      if (has_gyroscope) perception.take_yaw_rate(0.0, stamp_ns);
      yaw_rate = perception.take(message_of(frame, stamp_ns), stamp_ns).sighting->heading.yaw_rate_rad_s;
    }
    return yaw_rate;
  };
  EXPECT_EQ(steered(false, false), steered(true, true)) << "as if a gyroscope said that it stands";
  EXPECT_NE(steered(false, false), steered(true, false)) << "who is steered turns as it is told";
}

TEST(PerceptionTest, TellsHowLongTheImagesTakeToCome) {
  Perception perception(settings_of(Method::kPaper));
  EXPECT_EQ(value_of(perception.diagnosis(kBegin_ns), "arrival p50 (ms)"), "-");
  (void)play(perception, 100.0, 3);
  EXPECT_EQ(value_of(perception.diagnosis(kBegin_ns), "arrival p50 (ms)"), "1.000");
}

TEST(PerceptionTest, TheAnswerIsThatOfTheFinder) {
  Perception perception(settings_of(Method::kPaper));
  OpenSpaceFinder finder(settings_of(Method::kPaper).navigator.finder);
  const test::Frame frame = tunnel(100.0, 0);
  const ImageAnswer answer = perception.take(message_of(frame, kBegin_ns), kBegin_ns);
  ASSERT_TRUE(answer.sighting);
  EXPECT_EQ(answer.sighting->open_space.point.sx, finder.find(frame.view()).point.sx);
  EXPECT_EQ(answer.sighting->stamp_ns, kBegin_ns);
}

TEST(PerceptionTest, ACameraThatRepeatsItselfUnderNewStampsIsFrozen) {
  for (const Method method : {Method::kPaper, Method::kAdit}) {
    Perception perception(settings_of(method));
    (void)play(perception, 100.0, 5);
    const test::Frame same = tunnel(100.0, 99);
    ImageAnswer answer;
    for (int i = 5; i < 30; ++i)
      answer = perception.take(message_of(same, kBegin_ns + i * kFrame_ns), kBegin_ns + i * kFrame_ns);
    ASSERT_TRUE(answer.sighting);
    EXPECT_EQ(answer.sighting->open_space.status, Status::kFrozenFrame);
    EXPECT_EQ(answer.sighting->forward_m_s, 0.0) << "half a second and more without anything new";
    EXPECT_EQ(answer.sighting->heading.yaw_rate_rad_s, 0.0);
    const Diagnosis d = perception.diagnosis(kBegin_ns + 30 * kFrame_ns);
    EXPECT_EQ(d.level, Level::kError);
    EXPECT_NE(d.message.find("frozen"), std::string::npos);
  }
}

TEST(PerceptionTest, DuplicatesAndFramesOutOfOrderAreCountedAndNotAnswered) {
  Perception perception(settings_of(Method::kPaper));
  (void)play(perception, 100.0, 5);
  const test::Frame frame = tunnel(100.0, 7);
  const ImageAnswer duplicate = perception.take(message_of(frame, kBegin_ns + 4 * kFrame_ns), kBegin_ns + kSecond_ns);
  EXPECT_FALSE(duplicate.sighting);
  EXPECT_EQ(duplicate.fault, "stamp: duplicate: the image is not used");
  EXPECT_FALSE(perception.take(message_of(frame, kBegin_ns + 3 * kFrame_ns), kBegin_ns + kSecond_ns).sighting);
  EXPECT_EQ(perception.stamps().count(StampVerdict::kDuplicate), 1);
  EXPECT_EQ(perception.stamps().count(StampVerdict::kReordered), 1);
  EXPECT_TRUE(play(perception, 100.0, 1, 5).sighting) << "the stream goes on";
}

TEST(PerceptionTest, ABagThatLoopsSteersFromRateZero) {
  PerceptionSettings settings = settings_of(Method::kPaper);
  settings.node.pilot = Pilot::kPublished;
  Perception perception(settings);
  EXPECT_NE(play(perception, 120.0, 60).sighting->heading.yaw_rate_rad_s, 0.0);
  const ImageAnswer again = play(perception, 120.0, 1);
  ASSERT_TRUE(again.sighting);
  EXPECT_EQ(again.sighting->heading.yaw_rate_rad_s, 0.0);
  EXPECT_EQ(perception.stamps().count(StampVerdict::kRestarted), 1);
}

TEST(PerceptionTest, ImagesWithoutAStampAreTakenForNew) {
  Perception perception(settings_of(Method::kPaper));
  const test::Frame frame = tunnel(100.0, 0);
  const ImageAnswer answer = perception.take(message_of(frame, 0), kBegin_ns);
  ASSERT_TRUE(answer.sighting);
  EXPECT_EQ(answer.sighting->stamp_ns, kBegin_ns);
}

TEST(PerceptionTest, UnknownEncodingsAreNamedCountedAndSurvived) {
  Perception perception(settings_of(Method::kPaper));
  const test::Frame frame = tunnel(100.0, 0);
  ImageMessage m = message_of(frame, kBegin_ns);
  m.encoding = "yuv422";
  const ImageAnswer answer = perception.take(m, kBegin_ns);
  EXPECT_FALSE(answer.sighting);
  EXPECT_NE(answer.fault.find("yuv422"), std::string::npos);
  const Diagnosis d = perception.diagnosis(kBegin_ns);
  EXPECT_GE(d.level, Level::kWarn);
  EXPECT_NE(d.message.find("yuv422"), std::string::npos);
  EXPECT_EQ(value_of(d, "encodings unknown"), "1");
  EXPECT_TRUE(play(perception, 100.0, 1, 1).sighting);
  EXPECT_EQ(perception.unusable_images(), 1);
}

TEST(PerceptionTest, AChangeOfResolutionIsSurvivedAndCounted) {
  Perception perception(settings_of(Method::kPaper));
  (void)play(perception, 100.0, 5);
  const ImageAnswer answer = play(perception, 200.0, 5, 5, 320);
  ASSERT_TRUE(answer.sighting);
  EXPECT_EQ(answer.sighting->open_space.status, Status::kFound);
  EXPECT_EQ(perception.size_changes(), 1);
}

TEST(PerceptionTest, AResolutionThatTheCalibrationDoesNotKnowIsNotSteeredBy) {
  Perception perception(settings_of(Method::kPaper));
  perception.take(camera_info(160));
  ASSERT_EQ(play(perception, 100.0, 5).sighting->open_space.status, Status::kFound);
  const ImageAnswer answer = play(perception, 200.0, 20, 5, 320);
  ASSERT_TRUE(answer.sighting);
  EXPECT_EQ(answer.sighting->open_space.status, Status::kWrongSize);
  EXPECT_EQ(answer.sighting->forward_m_s, 0.0);
  EXPECT_EQ(answer.fault,
            "camera_info: it is of 160 x 120 px, the image of 320 x 240 px; calibrate at the size that is used");
  EXPECT_EQ(perception.diagnosis(kBegin_ns + kSecond_ns).level, Level::kError);
  perception.take(camera_info(320));
  EXPECT_EQ(play(perception, 200.0, 1, 25, 320).sighting->open_space.status, Status::kFound);
}

TEST(PerceptionTest, WhatIsNoPictureOrNoCalibrationIsCounted) {
  Perception perception(settings_of(Method::kPaper));
  perception.take(camera_info(160));
  CameraInfoMessage broken = camera_info(160);
  broken.matrix[0] = -1.0;
  perception.take(broken);
  (void)play(perception, 100.0, 2);
  perception.take_unreadable("image/compressed: the bytes are no picture (format 'jpeg')", kBegin_ns + 2 * kFrame_ns);
  const Diagnosis d = perception.diagnosis(kBegin_ns + 2 * kFrame_ns);
  const auto value = [&](const std::string& key) {
    for (const auto& [name, text] : d.values) {
      if (name == key) return text;
    }
    return std::string("missing");
  };
  EXPECT_EQ(d.level, Level::kWarn);
  EXPECT_EQ(value("images"), "3");
  EXPECT_EQ(value("images unusable"), "1");
  EXPECT_EQ(value("camera_infos"), "2");
  EXPECT_EQ(value("camera_infos unusable"), "1");
  EXPECT_EQ(perception.unusable_images(), 1);
  (void)play(perception, 100.0, 1, 3);  // the next good one is judged as if nothing had been
  EXPECT_EQ(perception.unusable_images(), 1);
}

TEST(PerceptionTest, WithoutCameraInfoALensIsAssumedAndThatIsSaid) {
  Perception perception(settings_of(Method::kPaper));
  (void)play(perception, 100.0, 2);
  Diagnosis d = perception.diagnosis(kBegin_ns + kFrame_ns);
  EXPECT_EQ(d.level, Level::kWarn);
  EXPECT_EQ(d.message, "no camera_info has come; the lens is taken for 75 deg wide (assumed_hfov_deg)");
  CameraInfoMessage zeros = camera_info(160);
  zeros.matrix = {};
  perception.take(zeros);
  d = perception.diagnosis(kBegin_ns + kFrame_ns);
  EXPECT_NE(d.message.find("not calibrated"), std::string::npos);
  perception.take(camera_info(160));
  EXPECT_EQ(perception.diagnosis(kBegin_ns + kFrame_ns).level, Level::kOk);
}

TEST(PerceptionTest, ABrokenCameraInfoDoesNotReplaceAGoodOne) {
  Perception perception(settings_of(Method::kPaper));
  perception.take(camera_info(160));
  CameraInfoMessage broken = camera_info(160);
  broken.distortion_model = "thin_prism";
  broken.distortion = {0.1};
  perception.take(broken);
  ASSERT_TRUE(perception.camera());
  EXPECT_EQ(perception.camera()->width, 160);
  (void)play(perception, 100.0, 1);
  EXPECT_NE(perception.diagnosis(kBegin_ns).message.find("thin_prism"), std::string::npos);
}

TEST(PerceptionTest, ACameraInfoWithEachImageDoesNotDisturbSteering) {
  PerceptionSettings settings = settings_of(Method::kPaper);
  settings.node.pilot = Pilot::kPublished;
  Perception perception(settings);
  for (int i = 0; i < 30; ++i) {
    perception.take(camera_info(160));
    (void)play(perception, 120.0, 1, i);
  }
  EXPECT_LT(play(perception, 120.0, 1, 30).sighting->heading.yaw_rate_rad_s, -0.05);
}

TEST(PerceptionTest, NoImagesAreAnErrorThatSaysWhereToLook) {
  Perception perception(settings_of(Method::kPaper));
  EXPECT_EQ(perception.diagnosis(kBegin_ns).level, Level::kError);
  (void)play(perception, 100.0, 1);
  EXPECT_EQ(perception.diagnosis(kBegin_ns + kSecond_ns).level, Level::kWarn);
  EXPECT_EQ(perception.diagnosis(kBegin_ns + 6 * kSecond_ns).level, Level::kError);
}

TEST(PerceptionTest, SettingsChangeInFlight) {
  Perception perception(settings_of(Method::kPaper));
  (void)play(perception, 100.0, 5);
  PerceptionSettings settings = perception.settings();
  settings.navigator.finder.method = Method::kAdit;
  perception.configure(settings);
  EXPECT_TRUE(play(perception, 100.0, 1, 5).sighting);
  EXPECT_EQ(value_of(perception.diagnosis(kBegin_ns), "method"), "adit");
  settings.navigator.finder.omega = 7.0;
  EXPECT_THROW(perception.configure(settings), std::invalid_argument);
  EXPECT_EQ(perception.settings().navigator.finder.omega, FinderConfig().omega);
  EXPECT_TRUE(play(perception, 100.0, 1, 6).sighting);
}

TEST(PerceptionTest, StagesAreMadeOnRequest) {
  Perception perception(settings_of(Method::kPaper));
  const test::Frame frame = tunnel(100.0, 0);
  const auto stages = perception.explain(message_of(frame, kBegin_ns));
  ASSERT_TRUE(stages);
  EXPECT_EQ(stages->width, 160);
  EXPECT_EQ(stages->closing.size(), 160u * 120u);
}

TEST(PerceptionTest, LatencyIsOfTheStamp) {
  Perception perception(settings_of(Method::kPaper));
  perception.sent(kBegin_ns, kBegin_ns + 4'000'000);
  EXPECT_DOUBLE_EQ(perception.latency().figures().p50_s, 0.004);
}

}  // namespace
}  // namespace adit::node
