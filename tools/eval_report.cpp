#include "eval_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

#include "version.hpp"

namespace adit::tools {
namespace {

using eval::Estimate;
using eval::Figure;
using eval::Figures;
using Json = nlohmann::ordered_json;

constexpr double kDegree = std::numbers::pi / 180.0;

std::string text_of(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

bool is_degrees(Figure figure) { return eval::to_string(figure).ends_with("_deg"); }

/// "0.25 [0.05 0.50]"
std::string cell_of(Figure figure, const Estimate& estimate) {
  if (std::isnan(estimate.value)) return "-";
  const int digits = is_degrees(figure) ? 1 : 2;
  std::string text = text_of(estimate.value, digits);
  if (estimate.interval)
    text.append(" [" + text_of(estimate.interval->low, digits) + " " + text_of(estimate.interval->high, digits) + "]");
  return text;
}

std::string counted(int count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Cells set in columns.
std::string columns_of(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line.append(widths[i] + 2 - row[i].size(), ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

bool anybody_has(const SetResult& set, Figure figure) {
  return std::any_of(set.methods.begin(), set.methods.end(),
                     [figure](const MethodResult& m) { return !std::isnan(m.figures[figure].value); });
}

std::string block_of(const SetResult& set) {
  const Figures& first = set.methods.front().figures;
  std::string text = set.name + ": " + counted(first.frames, "frame") + " of " + counted(first.places, "place") + ", " +
                     std::to_string(first.open) + " with an opening, " + std::to_string(first.none) + " without";
  if (const int rest = first.frames - first.open - first.none; rest > 0)
    text += ", " + std::to_string(rest) + " undecided";
  text += "\n";
  std::vector<std::vector<std::string>> rows{{"method", "hits"}};
  for (int i = 0; i < eval::kFigureCount; ++i)
    if (anybody_has(set, static_cast<Figure>(i))) rows[0].emplace_back(eval::to_string(static_cast<Figure>(i)));
  for (const MethodResult& m : set.methods) {
    std::vector<std::string> row{m.name + (m.about.empty() ? "" : " *"),
                                 std::to_string(m.figures.hits) + " of " + std::to_string(m.figures.open)};
    for (int i = 0; i < eval::kFigureCount; ++i)
      if (const auto figure = static_cast<Figure>(i); anybody_has(set, figure))
        row.push_back(cell_of(figure, m.figures[figure]));
    rows.push_back(std::move(row));
  }
  text += columns_of(rows);
  for (const MethodResult& m : set.methods)
    if (!m.about.empty()) text += "* " + m.name + ": " + m.about + "\n";
  return text;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result.append(c == '"' ? 2 : 1, c);
  return result + "\"";
}

std::string number_cell(double value) { return std::isnan(value) ? "" : text_of(value, 6); }

Json number_of(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const Figures& figures) {
  Json json;
  json["frames"] = figures.frames;
  json["places"] = figures.places;
  json["open"] = figures.open;
  json["none"] = figures.none;
  json["hits"] = figures.hits;
  json["none_refused"] = figures.refused_none;
  for (int i = 0; i < eval::kFigureCount; ++i) {
    const auto figure = static_cast<Figure>(i);
    const Estimate& e = figures[figure];
    Json one;
    one["value"] = number_of(e.value);
    one["low"] = e.interval ? number_of(e.interval->low) : Json(nullptr);
    one["high"] = e.interval ? number_of(e.interval->high) : Json(nullptr);
    json[std::string(eval::to_string(figure))] = one;
  }
  for (const eval::ReliabilityBin& bin : figures.reliability)
    json["reliability"].push_back({{"count", bin.count}, {"confidence", bin.confidence}, {"right", bin.right}});
  return json;
}

Json json_of(const Judged& judged) {
  const eval::FrameScore& score = judged.score;
  Json json;
  json["status"] = judged.given.status;
  json["verdict"] = eval::to_string(score.verdict);
  json["u_px"] = score.answered ? number_of(judged.given.answer.place.u_px) : Json(nullptr);
  json["v_px"] = score.answered ? number_of(judged.given.answer.place.v_px) : Json(nullptr);
  json["confidence"] = number_of(score.confidence);
  json["error_deg"] = number_of(score.error_rad / kDegree);
  json["open_ratio"] = number_of(score.open_ratio);
  if (score.branches > 0) {
    json["branches"] = score.branches;
    json["branches_found"] = score.branches_found;
  }
  return json;
}

const char* name_of(eval::Scene scene) {
  return scene == eval::Scene::kOpen ? "open" : scene == eval::Scene::kNone ? "none" : "undecided";
}

Json frames_of(const EvalWork& work, const EvalResult& result, const SetResult& set) {
  Json frames = Json::array();
  const std::size_t s = set.sets.front();
  for (std::size_t f = 0; f < result.frames[s].size(); ++f) {
    const JudgedFrame& judged = result.frames[s][f];
    if (!judged.readable) continue;
    Json frame;
    frame["image"] = work.sets[s].frames[f].name;
    frame["place"] = work.sets[s].frames[f].place;
    frame["scene"] = name_of(work.sets[s].frames[f].truth.scene);
    for (const MethodResult& m : set.methods) frame["methods"][m.name] = json_of(judged.methods[m.contender.front()]);
    frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace

std::string eval_text(const EvalWork& work, const EvalResult& result) {
  std::string text;
  for (const SetResult& set : result.sets) text += block_of(set) + "\n";
  char coverage[120];
  std::snprintf(coverage, sizeof coverage, "[low high]: %g %% interval, %d draws of places, seed %llu\n",
                100.0 * work.bootstrap.coverage, work.bootstrap.resamples,
                static_cast<unsigned long long>(work.bootstrap.seed));
  return text + coverage;
}

std::string eval_csv(const EvalWork&, const EvalResult& result) {
  std::string text = "set,method,about,frames,places,open,none,hits,none_refused";
  for (int i = 0; i < eval::kFigureCount; ++i) {
    const std::string name(eval::to_string(static_cast<Figure>(i)));
    text.append("," + name).append("," + name + "_low").append("," + name + "_high");
  }
  text += "\n";
  for (const SetResult& set : result.sets)
    for (const MethodResult& m : set.methods) {
      text += quoted(set.name) + "," + quoted(m.name) + "," + quoted(m.about);
      for (const int count :
           {m.figures.frames, m.figures.places, m.figures.open, m.figures.none, m.figures.hits, m.figures.refused_none})
        text.append(",").append(std::to_string(count));
      for (const Estimate& e : m.figures.estimates) {
        text.append(",").append(number_cell(e.value));
        text.append(",").append(e.interval ? number_cell(e.interval->low) : "");
        text.append(",").append(e.interval ? number_cell(e.interval->high) : "");
      }
      text += "\n";
    }
  return text;
}

std::string eval_json(const EvalWork& work, const EvalResult& result) {
  Json json;
  json["adit_version"] = ADIT_VERSION;
  json["bootstrap"] = {
      {"resamples", work.bootstrap.resamples}, {"seed", work.bootstrap.seed}, {"coverage", work.bootstrap.coverage}};
  json["frames_unreadable"] = result.unreadable;
  for (const SetResult& set : result.sets) {
    Json one;
    one["set"] = set.name;
    for (const MethodResult& m : set.methods) {
      Json method = json_of(m.figures);
      method["baseline"] = m.baseline;
      if (!m.about.empty()) method["about"] = m.about;
      one["methods"][m.name] = std::move(method);
    }
    if (set.sets.size() == 1) one["frames"] = frames_of(work, result, set);
    json["sets"].push_back(std::move(one));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace adit::tools
