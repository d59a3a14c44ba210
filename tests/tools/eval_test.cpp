#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace {

using namespace adit::testing;
using nlohmann::json;

/// Four passages (320x240, a disc at u = 100, 108, 116, 124 px), of which the third is marked beside its disc.
json draw_set(const std::filesystem::path& folder) {
  make_passages(folder, 4);
  json marks;
  marks["size"] = {320, 240};
  for (int i = 0; i < 4; ++i) {
    const int u = 100 + 8 * i;
    marks["openings"]["frame" + std::to_string(i) + ".png"] = {{u - 40, 70, u + 40, 150}};
  }
  marks["openings"]["frame2.png"] = json::parse("[[[240, 20], [300, 20], [300, 60]], [240, 180, 300, 220]]");
  marks["openings"]["frame3.png"] = "none";
  marks["places"] = {{"frame0.png", "a"}, {"frame1.png", "b"}, {"frame2.png", "c"}};
  return marks;
}

std::string write_set(const std::filesystem::path& folder, const json& marks) {
  write_text(folder / "openings.json", marks.dump());
  return folder.string();
}

std::vector<std::string> row_of(const std::string& csv, const std::string& set, const std::string& method) {
  for (auto& row : rows_of(csv))
    if (row[0] == set && row[1] == method) return row;
  return {};
}

std::string cell(const std::string& csv, const std::string& set, const std::string& method, const std::string& column) {
  const auto header = rows_of(csv).front();
  const auto row = row_of(csv, set, method);
  const auto at = static_cast<std::size_t>(std::find(header.begin(), header.end(), column) - header.begin());
  return at < row.size() ? row[at] : "no such cell";
}

TEST(Eval, DrawnSetFromEndToEnd) {
  const ScratchFolder folder;
  const std::string set = write_set(folder / "drift", draw_set(folder / "drift"));
  const Outcome outcome =
      run_adit({"eval", set, "--method", "paper", "--csv", "-", "--json", (folder / "f.json").string(), "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const auto figure = [&](const char* method, const char* column) {
    return cell(outcome.out, "drift", method, column);
  };
  EXPECT_EQ(figure("paper", "frames"), "4");
  EXPECT_EQ(figure("paper", "places"), "4");
  EXPECT_EQ(figure("paper", "open"), "3");
  EXPECT_EQ(figure("paper", "none"), "1");
  EXPECT_EQ(figure("paper", "hits"), "2") << "the disc, but for the frame that is marked elsewhere";
  EXPECT_EQ(figure("paper", "hit_rate"), "0.666667");
  EXPECT_EQ(figure("paper", "refused_none"), "0.000000");
  EXPECT_EQ(figure("paper", "error_deg"), "0.000000");
  EXPECT_EQ(figure("paper", "open_ratio"), "") << "nothing is known of ranges";
  EXPECT_EQ(figure("paper_k10", "hits"), "no such cell") << "that is what paper is anyway";
  EXPECT_EQ(figure("centre", "hits"), "0");
  EXPECT_GE(figure("paper_best_k", "hits"), "2");
  EXPECT_EQ(figure("paper_best_k", "about").substr(0, 4), "K = ");
  const json figures = json::parse(read_text(folder / "f.json"));
  const json& first = figures["sets"][0]["frames"][0];
  EXPECT_EQ(first["image"], "frame0.png");
  EXPECT_EQ(first["methods"]["paper"]["verdict"], "hit");
  EXPECT_NEAR(first["methods"]["paper"]["u_px"].get<double>(), 100.0, 5.0);
  EXPECT_EQ(figures["sets"][0]["frames"][2]["methods"]["paper"]["verdict"], "miss");
  EXPECT_EQ(figures["sets"][0]["frames"][3]["methods"]["paper"]["verdict"], "answered_none");
}

TEST(Eval, SeedRepeatsAndThreadsDoNotMatter) {
  const ScratchFolder folder;
  const std::string set = write_set(folder / "drift", draw_set(folder / "drift"));
  const auto figures = [&](const std::string& seed, const std::string& jobs) {
    return run_adit({"eval", set, "--seed", seed, "--jobs", jobs, "--csv", "-", "--quiet"}).out;
  };
  const std::string one = figures("1", "1");
  EXPECT_EQ(one, figures("1", "3"));
  EXPECT_NE(row_of(one, "drift", "random"), row_of(figures("2", "2"), "drift", "random"));
}

TEST(Eval, TableOfOthersIsAMethod) {
  const ScratchFolder folder;
  const std::string set = write_set(folder / "drift", draw_set(folder / "drift"));
  // Ours, written as a table and read again, scores as ours; one that knows the marks is right everywhere.
  ASSERT_EQ(run_adit({"run", set, "--csv", (folder / "ours.csv").string(), "--quiet"}).exit_code, 0);
  write_text(folder / "oracle.csv",
             "source,status,confidence,u_px,v_px,openings\nelsewhere/frame0.png,found,0.9,100,110,\n"
             "drift/frame1.png,found,0.9,108,110,\nframe2.png,found,0.9,270,200,27.8 -21.0 0.9; 31.0 23.0 0.8\n"
             "frame3.png,no_region,,,,\n");
  const Outcome outcome =
      run_adit({"eval", set, "--method", "paper", "--table", "ours=" + (folder / "ours.csv").string(), "--table",
                "oracle=" + (folder / "oracle.csv").string(), "--no-baselines", "--csv", "-", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(rows_of(outcome.out).size(), 4u);
  for (const char* column : {"hits", "hit_rate", "refused_none", "error_deg"})
    EXPECT_EQ(cell(outcome.out, "drift", "ours", column), cell(outcome.out, "drift", "paper", column));
  EXPECT_EQ(cell(outcome.out, "drift", "oracle", "hits"), "3");
  // At 208 px focal length the two stand for (269, 210) and (285, 16); the mark there begins at v = 20.
  EXPECT_EQ(cell(outcome.out, "drift", "oracle", "branch_recall"), "0.500000");
  EXPECT_EQ(cell(outcome.out, "drift", "oracle", "branch_precision"), "0.500000");
  EXPECT_EQ(cell(outcome.out, "drift", "oracle", "none_refused"), "1");
  EXPECT_EQ(cell(outcome.out, "drift", "oracle", "calibration_error"), "0.100000");
}

TEST(Eval, JitterOfASequence) {
  const ScratchFolder folder;
  json marks = draw_set(folder / "drift");
  for (int i = 0; i < 4; ++i) marks["places"]["frame" + std::to_string(i) + ".png"] = "one";
  const std::string set = write_set(folder / "drift", marks);
  const auto jitter = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"eval", set, "--method", "paper", "--csv", "-", "--quiet"});
    return cell(run_adit(more).out, "drift", "paper", "jitter_deg");
  };
  EXPECT_EQ(jitter({}), "");
  // 8 px a frame at a focal length of 208 px, around 0.24 off the axis: 2.1 deg.
  EXPECT_NEAR(std::stod(jitter({"--sequence"})), 2.1, 0.4);
}

TEST(Eval, SetsAreToldApartAndPutTogether) {
  const ScratchFolder folder;
  const std::string a = write_set(folder / "north", draw_set(folder / "north"));
  const std::string b = write_set(folder / "south", draw_set(folder / "south"));
  const Outcome outcome = run_adit({"eval", a, b + "/openings.json", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Outcome together = run_adit({"eval", folder.path().string(), "--quiet"});
  EXPECT_NE(together.out.find(": 8 frames of 5 places, 6 with an opening, 2 without"), std::string::npos)
      << together.out << together.err;
  for (const char* head : {"north: 4 frames of 4 places, 3 with an opening, 1 without", "south: 4 frames of 4 places",
                           "all sets: 8 frames of 5 places"})
    EXPECT_NE(outcome.out.find(head), std::string::npos) << outcome.out;
}

/// How often a text stands in another.
int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

TEST(Eval, GalleryHasEveryFrameAndAnswerAndNeedsNothingElse) {
  const ScratchFolder folder;
  json marks = draw_set(folder / "drift");
  marks["places"]["frame0.png"] = "<b>& \"x\"";
  const std::string set = write_set(folder / "drift", marks);
  ASSERT_EQ(
      run_adit({"eval", set, "--method", "paper", "--gallery", (folder / "g.html").string(), "--quiet"}).exit_code, 0);
  const std::string page = read_text(folder / "g.html");
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_EQ(count_of(page, "<figure class=\"card\""), 4);
  EXPECT_EQ(count_of(page, "href=\"data:image/jpeg;base64,/9j/"), 4) << "JPEG begins with FF D8 FF";
  EXPECT_EQ(count_of(page, "<polygon class=\"mark\""), 4);
  EXPECT_EQ(count_of(page, "<g class=\"answer m0\""), 4);
  EXPECT_EQ(count_of(page, "<svg class=\"reliability\""), 3) << "paper, paper_k10_lloyd, paper_best_k";
  // Failures first: the answer where there is no opening and the one beside it, then the hits.
  auto verdict = [&, at = std::size_t{0}]() mutable {
    at = page.find("data-v0=\"", at + 1);
    return page.substr(at + 9, page.find('"', at + 9) - at - 9);
  };
  EXPECT_EQ(verdict(), "miss");
  EXPECT_EQ(verdict(), "answered_none");
  EXPECT_EQ(verdict(), "hit");
  EXPECT_EQ(verdict(), "hit");
  // What people name cannot become part of the page, and nothing is fetched.
  EXPECT_EQ(page.find("<b>& "), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;&amp; &quot;x&quot;"), std::string::npos);
  EXPECT_NE(page.find("default-src 'none'; img-src data: ;"), std::string::npos) << "its own policy";
  EXPECT_NE(page.find("<p id=\"made\">adit "), std::string::npos);
  EXPECT_NE(page.find("All settings are the defaults."), std::string::npos);
  for (const char* outside : {"http:", "https:", "src=", "@CARDS@", "@SUMMARY@", "@METHODS@", "nan"})
    EXPECT_EQ(count_of(page, outside), 0) << outside;
  for (const char* tag : {"figure", "svg", "g", "ul", "li", "main", "select", "style", "script", "figcaption", "button",
                          "section", "details", "pre"})
    EXPECT_EQ(count_of(page, std::string("<") + tag + " ") + count_of(page, std::string("<") + tag + ">"),
              count_of(page, std::string("</") + tag + ">"))
        << tag;
}

TEST(Eval, GalleryAsAFolderHasItsPicturesBesideIt) {
  const ScratchFolder folder;
  const std::string set = write_set(folder / "drift", draw_set(folder / "drift"));
  const auto gallery = (folder / "g").string();
  ASSERT_EQ(run_adit({"eval", set, "--gallery", gallery, "--set", "finder.cluster_count=8", "--quiet"}).exit_code, 0);
  const std::string page = read_text(folder / "g/index.html");
  EXPECT_EQ(count_of(page, "href=\"thumbs/00_0000"), 4);
  EXPECT_EQ(count_of(page, "data:image"), 0);
  EXPECT_NE(page.find("img-src data: 'self' file:;"), std::string::npos);
  EXPECT_NE(page.find("<li>finder.cluster_count: 8</li>"), std::string::npos);
  EXPECT_NE(page.find(gallery), std::string::npos) << "the command";
  for (const char* name : {"00_00000.jpg", "00_00003.jpg"})
    EXPECT_TRUE(read_text(folder / "g/thumbs" / name).starts_with("\xff\xd8\xff"));
  write_text(folder / "file", "");
  EXPECT_EQ(run_adit({"eval", set, "--gallery", (folder / "file").string(), "--quiet"}).exit_code, 6);
}

TEST(Eval, OneUnreadableImageIsToldAndTheRestIsJudged) {
  const ScratchFolder folder;
  const std::string set = write_set(folder / "drift", draw_set(folder / "drift"));
  write_text(folder / "drift/frame1.png", "no picture");
  const Outcome outcome = run_adit({"eval", set, "--csv", "-", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
  EXPECT_NE(outcome.err.find("frame1.png"), std::string::npos);
  EXPECT_EQ(cell(outcome.out, "drift", "paper", "frames"), "3");
}

TEST(Eval, FaultsAreOneLineThatNamesWhatIsWrong) {
  const ScratchFolder folder;
  const json good = draw_set(folder / "set");
  const auto with = [&](const char* key, const json& value) {
    json marks = good;
    marks["openings"][key] = value;
    return marks.dump();
  };
  json large = good;
  large["size"] = {640, 480};
  const struct {
    std::string marks;
    int exit_code;
    std::string says;
  } faults[] = {
      {"{\"openings\": {", 4, "no JSON from byte"},
      {"", 4, "openings.json"},
      {"[]", 4, "there is no \"openings\""},
      {"{\"openings\": {}}", 4, "no frame is marked"},
      {with("gone.png", "none"), 4, "1 of its 5 images are not beside it, the first is gone.png"},
      {with("frame0.png", {{1, 2, 3}}), 4, "frame0.png: [1,2,3] is neither a box"},
      {with("frame0.png", {{{1, 2}, {3, 4}}}), 4, "neither a box"},
      {with("frame0.png", "nothing"), 4, "neither a list of outlines nor"},
      {large.dump(), 3, "320x240 px"},
  };
  for (const auto& fault : faults) {
    write_text(folder / "set/openings.json", fault.marks);
    const Outcome outcome = run_adit({"eval", (folder / "set").string(), "--quiet"});
    EXPECT_EQ(outcome.exit_code, fault.exit_code) << fault.says << ": " << outcome.err;
    EXPECT_NE(outcome.err.find(fault.says), std::string::npos) << fault.says << ": " << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
  }
}

TEST(Eval, WrongUsageAndMissingFiles) {
  const ScratchFolder folder;
  const std::string set = write_set(folder / "drift", draw_set(folder / "drift"));
  write_text(folder / "short.csv", "source,status\na.png,found\n");
  write_text(folder / "ragged.csv", "source,u_px,v_px\na.png,1\n");
  write_text(folder / "words.csv", "source,u_px,v_px\nframe0.png,one,2\n");
  write_text(folder / "twice.csv", "source,u_px,v_px\na/frame0.png,1,2\nb/frame0.png,1,2\n");
  std::filesystem::create_directories(folder / "empty");
  const struct {
    std::vector<std::string> arguments;
    int exit_code;
    std::string says;
  } faults[] = {
      {{}, 2, "dataset"},
      {{set, "--method", "magic"}, 2, "known are: paper, adit"},
      {{set, "--table", "short.csv"}, 2, "NAME=FILE.csv"},
      {{set, "--table", "paper=" + (folder / "words.csv").string()}, 2, "name of another method"},
      {{set, "--resamples", "1"}, 2, "--resamples"},
      {{(folder / "none").string()}, 4, "no such folder"},
      {{(folder / "empty").string()}, 4, "neither openings.json"},
      {{set, "--table", "t=" + (folder / "none.csv").string()}, 4, "none.csv"},
      {{set, "--table", "t=" + (folder / "short.csv").string()}, 4, "u_px and v_px"},
      {{set, "--table", "t=" + (folder / "ragged.csv").string()}, 4, "ragged.csv:2"},
      {{set, "--set", "omega=9"}, 3, "omega"},
      {{set, "--json", (folder / "none/f.json").string()}, 6, "f.json"},
  };
  for (const auto& fault : faults) {
    std::vector<std::string> arguments{"eval", "--quiet"};
    arguments.insert(arguments.end(), fault.arguments.begin(), fault.arguments.end());
    const Outcome outcome = run_adit(arguments);
    EXPECT_EQ(outcome.exit_code, fault.exit_code) << fault.says << ": " << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find(fault.says), std::string::npos) << outcome.err;
  }
}

// A lamp that lights the right side alone: taken out of the frames, the left side is rock as bright as the right.
TEST(Eval, JudgesByTheLampsPatternAndSoDoesExplain) {
  const ScratchFolder folder;
  const std::string set = write_set(folder / "drift", draw_set(folder / "drift"));
  const std::string lamp = (folder / "lamp.yaml").string();
  write_text(lamp, "lobe: [0, 2.5, 0, 0, 0, 0]\nframes: 1000\n");
  const std::string image = (folder / "drift" / "frame0.png").string();
  const std::string json_files[] = {(folder / "without.json").string(), (folder / "with.json").string()};
  const std::string panel_files[] = {(folder / "without.png").string(), (folder / "with.png").string()};
  std::string answers[2];
  std::string panels[2];
  for (const int with : {0, 1}) {
    const std::string& json_file = json_files[with];
    const std::string& panel = panel_files[with];
    std::vector<std::string> eval = {"eval", set, "--method", "adit", "--no-baselines", "--json", json_file, "--quiet"};
    std::vector<std::string> explain = {"explain", image, "--output", panel};
    for (auto* command : {&eval, &explain})
      if (with == 1) command->insert(command->end(), {"--lamp", lamp});
    ASSERT_EQ(run_adit(eval).exit_code, 0);
    ASSERT_EQ(run_adit(explain).exit_code, 0);
    answers[with] = read_text(json_file);
    panels[with] = read_text(panel);
  }
  EXPECT_NE(answers[0], answers[1]);
  EXPECT_NE(panels[0], panels[1]);
  const Outcome missing = run_adit({"eval", set, "--lamp", (folder / "none.yaml").string(), "--quiet"});
  EXPECT_NE(missing.exit_code, 0);
  EXPECT_NE(missing.err.find("none.yaml"), std::string::npos) << missing.err;
  EXPECT_EQ(run_adit({"explain", image, "--lamp", lamp, "--output", lamp}).exit_code, 2) << "it is read";
}

}  // namespace
