#include "adit/io/table.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

namespace {

using namespace adit::io;

TableRow found_row() {
  adit::OpenSpace o;
  o.status = adit::Status::kFound;
  o.confidence = 0.5;
  o.centroid_px = {320.25, 100.0};
  o.point = {0.25, -0.5};
  o.bearing = {std::numbers::pi / 6.0, -std::numbers::pi / 4.0};
  o.area_fraction = 0.125;
  o.atmospheric_light = 200.0;
  o.darkest_level = 3;
  o.threshold_level = 9;
  o.brightest_level = 180;
  o.clusters.count = 10;
  o.total_ns = 1500000;
  o.rule = adit::Rule::kDarkestCluster;
  o.opening_count = 1;
  o.openings[0].bearing = o.bearing;
  o.openings[0].confidence = 0.5;
  o.flags.dust = o.flags.glare = true;
  o.veil_fraction = 0.75;
  return {"a.png", 4, 1.5, o, adit::HeadingCommand{adit::HeadingState::kSteer, -0.25}, ""};
}

TEST(Table, HeaderHasThePromisedColumnsFirst) {
  EXPECT_TRUE(csv_header(false).starts_with(
      "source,frame,stamp_s,status,confidence,u_px,v_px,sx,sy,azimuth_deg,elevation_deg,area_fraction,"
      "yaw_rate_rad_s,"));
  EXPECT_EQ(csv_header(false).find("find_ms"), std::string::npos);
  EXPECT_TRUE(csv_header(true).ends_with(",find_ms\n"));
}

TEST(Table, FoundFrame) {
  EXPECT_EQ(csv_line(found_row(), false),
            "a.png,4,1.500000,found,0.5000,320.250,100.000,0.250000,-0.500000,30.0000,-45.0000,0.125000,-0.250000,"
            "steer,200.000,3,9,180,darkest_cluster,30.00 -45.00 0.50,dust+glare,0.7500,,,\n");
  EXPECT_TRUE(csv_line(found_row(), true).ends_with(",0.7500,,,,1.5000\n"));
}

TEST(Table, TheOpeningThatIsFollowedHasANumberAndABearing) {
  TableRow row = found_row();
  row.track = adit::Track{.id = 7, .bearing = {-0.5, 0.0}};
  EXPECT_TRUE(csv_line(row, false).ends_with(",0.7500,7,-28.6479,\n")) << csv_line(row, false);
}

TEST(Table, NumbersThatDoNotExistAreEmpty) {
  TableRow row = found_row();
  row.open_space->status = adit::Status::kTooDark;
  row.open_space->confidence = 0.0;
  row.command.reset();
  EXPECT_EQ(csv_line(row, false), "a.png,4,1.500000,too_dark,0.0000,,,,,,,,,,200.000,3,9,180,,,dust+glare,0.7500,,,\n");
  row.open_space->status = adit::Status::kWrongSize;
  EXPECT_EQ(csv_line(row, false), "a.png,4,1.500000,wrong_size,0.0000,,,,,,,,,,,,,,,,dust+glare,,,,\n");
  row.open_space.reset();
  row.message = "a.png: the file is empty";
  EXPECT_EQ(csv_line(row, false), "a.png,4,1.500000,unreadable,,,,,,,,,,,,,,,,,,,,,a.png: the file is empty\n");
}

TEST(Table, NoMinusZeroAndNoNan) {
  TableRow row = found_row();
  row.open_space->point.sx = -1e-9;
  row.open_space->point.sy = std::numeric_limits<double>::quiet_NaN();
  row.command->yaw_rate_rad_s = -0.0;
  EXPECT_NE(csv_line(row, false).find(",0.000000,,30.0000,"), std::string::npos) << csv_line(row, false);
  EXPECT_NE(csv_line(row, false).find(",0.000000,steer"), std::string::npos);
  EXPECT_TRUE(nlohmann::json::parse(json_line(row, false))["sy"].is_null());
}

TEST(Table, NamesAreQuotedAsRfc4180Has) {
  TableRow row = found_row();
  row.source = "a,\"b\"\n.png";
  EXPECT_TRUE(csv_line(row, false).starts_with("\"a,\"\"b\"\"\n.png\",4,"));
  EXPECT_EQ(nlohmann::json::parse(json_line(row, false))["source"], "a,\"b\"\n.png");
}

TEST(Table, JsonHasTheColumnsOfCsv) {
  const auto json = nlohmann::ordered_json::parse(json_line(found_row(), true));
  std::string keys;
  for (const auto& [key, value] : json.items()) {
    if (!keys.empty()) keys += ',';
    keys += key;
  }
  EXPECT_EQ(keys + "\n", csv_header(true));
  EXPECT_EQ(json["azimuth_deg"], 30.0);
  EXPECT_EQ(json["frame"], 4);
  EXPECT_EQ(json["status"], "found");
  EXPECT_TRUE(json["message"].is_null());
  EXPECT_TRUE(json_line(found_row(), false).ends_with("}\n"));
}

TEST(Table, NamesThatAreNotUtf8GiveJsonAllTheSame) {
  TableRow row = found_row();
  row.source = "caf\xe9.png";
  EXPECT_TRUE(nlohmann::json::accept(json_line(row, false)));
}

}  // namespace
