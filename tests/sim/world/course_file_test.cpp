// Course files: what is read, and that mistakes are named with file and line.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "adit/sim/course.hpp"
#include "adit/sim/course_fields.hpp"
#include "adit/sim/flight_fields.hpp"
#include "adit/sim/rig_fields.hpp"
#include "adit/sim/world_error.hpp"

namespace adit::sim {
namespace {

std::string written(const std::string& text) {
  const std::string path = ::testing::TempDir() + "/course.yaml";
  std::ofstream(path) << text;
  return path;
}

std::string error_of(const std::string& text) {
  try {
    (void)read_course(written(text));
  } catch (const WorldError& error) {
    return error.what();
  }
  return "";
}

constexpr const char* kPassages = "passages:\n  - {to: a, end: mouth, moves: [{straight_m: 10}]}\n";

/// docs/simulation.md promises it.
template <class Config>
void expect_sources() {
  Config config;
  visit_fields(config, [](const FieldNote& note, const auto&) {
    EXPECT_GT(std::string(note.source).size(), 2u) << note.name << " has no source";
  });
}

TEST(Fields, EachHasASource) {
  expect_sources<CourseConfig>();
  expect_sources<RenderConfig>();
  expect_sources<SensorConfig>();
  expect_sources<VehicleConfig>();
  expect_sources<FlightConfig>();
}

TEST(CourseFile, ReadsFieldsAndMoves) {
  const CourseConfig config = read_course(written(std::string("width_m: 6.5\nseed: 7\n") + kPassages));
  EXPECT_EQ(config.width_m, 6.5);
  EXPECT_EQ(config.seed, 7);
  EXPECT_EQ(config.name, "course");
  ASSERT_EQ(config.passages.size(), 1u);
  EXPECT_EQ(config.passages[0].end, NodeKind::kMouth);
  ASSERT_EQ(config.passages[0].moves.size(), 1u);
  EXPECT_EQ(config.passages[0].moves[0].straight_m, 10.0);
}

TEST(CourseFile, UnknownKeyIsNamedWithLineAndKnownKeys) {
  const std::string error = error_of("width_m: 5\nwidht_m: 6\n");
  EXPECT_NE(error.find("course.yaml:2: unknown key 'widht_m'"), std::string::npos) << error;
  EXPECT_NE(error.find("width_m"), std::string::npos) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos) << error;
}

TEST(CourseFile, MistakesAreOneClearLine) {
  for (const auto& [text, word] : std::vector<std::pair<std::string, std::string>>{
           {"width_m: wide\n", "width_m is 'wide'"},
           {std::string("width_m: 400\n") + kPassages, "width_m is 400"},
           {std::string("seed: 1.5\n") + kPassages, "seed"},
           {"layout: spiral\n", "layout is 'spiral'"},
           {"layout: moves\n", "no passages"},
           {"passages: 5\n", "passages is a list"},
           {"passages:\n  - {to: a, moves: [{straight_m: 10, turn_deg: 5}]}\n", "not both"},
           {"passages:\n  - {to: a, moves: [{turn_deg: 5}]}\n", "radius_m"},
           {"a: [1, 2\n", "course.yaml:"},
           {"- 1\n", "map"},
           {"", "map"},
           {std::string("cell_m: .nan\n") + kPassages, "cell_m"}}) {
    const std::string error = error_of(text);
    EXPECT_NE(error.find(word), std::string::npos) << text << " gave: " << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
  EXPECT_THROW((void)read_course("no/such/file.yaml"), WorldError);
}

TEST(CourseFile, EveryShippedCourseIsGood) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ADIT_COURSES)) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_NO_THROW({
      CourseConfig config = read_course(entry.path().string());
      EXPECT_FALSE(config.about.empty()) << entry.path();
      EXPECT_EQ(config.name, entry.path().stem());
    });
    ++count;
  }
  EXPECT_GE(count, 2);
}

}  // namespace
}  // namespace adit::sim
