#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "adit/fields.hpp"

namespace adit {
namespace {

std::string fault_text(const auto& config) { return fault_of(config).value_or(""); }

TEST(Configuration, DefaultsAreGood) {
  EXPECT_EQ(fault_text(FinderConfig{}), "");
  EXPECT_EQ(fault_text(HeadingConfig{}), "");
}

TEST(Configuration, AFaultNamesFieldValueRangeAndWhatToDo) {
  FinderConfig finder;
  finder.omega = 1.5;
  EXPECT_EQ(fault_text(finder), "omega: 1.5 is not in [0.01, 1]; set a value in this range");
  HeadingConfig heading;
  heading.yaw_rate_max_rad_s = -0.5;
  EXPECT_EQ(fault_text(heading), "yaw_rate_max_rad_s: -0.5 rad/s is not in [0, 20] rad/s; set a value in this range");
}

TEST(Configuration, SizesAreOdd) {
  FinderConfig config;
  config.patch_size_px = 14;
  EXPECT_EQ(fault_text(config), "patch_size_px: 14 px has no middle pixel; set an odd size, for example 15");
  config.patch_size_px = 0;
  EXPECT_EQ(fault_text(config), "");
  config.structuring_element_size_vga_px = 1022;
  EXPECT_NE(fault_text(config).find("structuring_element_size_vga_px"), std::string::npos);
  config.structuring_element_size_vga_px = 0;
  EXPECT_NE(fault_text(config).find("not in [1, 1023]"), std::string::npos);
}

TEST(Configuration, UnknownChoicesAreRefused) {
  FinderConfig config;
  config.clustering = static_cast<Clustering>(7);
  EXPECT_EQ(fault_text(config), "clustering: 7 is not a known choice; set one of: exact, lloyd");
}

/// Every field in turn: both ends of its range are good, one beyond is not, and neither is what is no number.
template <class Config>
void expect_ranges_are_kept() {
  std::set<std::string> names;
  Config config;
  visit_fields(config, [&](const FieldNote& note, auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    EXPECT_TRUE(names.insert(note.name).second) << note.name;
    EXPECT_GT(std::string(note.meaning).size(), 5u) << note.name;
    EXPECT_GT(std::string(note.source).size(), 2u) << note.name;
    if constexpr (!std::is_enum_v<Value>) {
      const Value kept = value;
      for (const double end : {note.minimum, note.maximum}) {
        value = static_cast<Value>(end);
        EXPECT_EQ(fault_text(config), "") << note.name;
      }
      if constexpr (std::is_floating_point_v<Value>) {
        for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(),
                                 std::nextafter(note.maximum, 1e300), std::nextafter(note.minimum, -1e300)}) {
          value = bad;
          EXPECT_EQ(fault_text(config).find(note.name), 0u) << note.name << " " << bad;
        }
      } else {
        value = static_cast<Value>(note.minimum - 1);
        EXPECT_EQ(fault_text(config).find(note.name), 0u) << note.name;
        if (note.maximum < std::numeric_limits<Value>::max()) {
          value = static_cast<Value>(note.maximum + 1);
          EXPECT_EQ(fault_text(config).find(note.name), 0u) << note.name;
        }
      }
      value = kept;
    }
  });
}

TEST(Configuration, RangesAreKept) {
  expect_ranges_are_kept<FinderConfig>();
  expect_ranges_are_kept<HeadingConfig>();
}

TEST(Configuration, ConstructorsRefuse) {
  FinderConfig finder;
  finder.cluster_count = 1;
  try {
    OpenSpaceFinder refused(finder);
    FAIL() << "a bad configuration was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).find("cluster_count: 1 is not in [2, 32]"), 0u) << error.what();
  }
  EXPECT_THROW(HeadingController({.gain_per_s = std::nan("")}), std::invalid_argument);
}

TEST(Configuration, SizesScaleWithTheWidth) {
  EXPECT_EQ(scaled_size_px(15, 640), 15);
  EXPECT_EQ(scaled_size_px(15, 3840), 91);
  EXPECT_EQ(scaled_size_px(15, 320), 7);
  EXPECT_EQ(scaled_size_px(15, 16), 1);
  EXPECT_EQ(scaled_size_px(1, 640), 1);
  EXPECT_EQ(scaled_size_px(1023, 8192), 1023);
  for (int width = 16; width <= 8192; ++width) {
    const int size = scaled_size_px(15, width);
    EXPECT_EQ(size % 2, 1);
    EXPECT_LE(std::abs(std::max(1.0, 15.0 * width / 640.0) - size), 1.0) << width;
  }
}

}  // namespace
}  // namespace adit
