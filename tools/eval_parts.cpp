#include "eval_parts.hpp"

#include <nlohmann/json.hpp>

#include "adit/fields.hpp"
#include "adit/io/errors.hpp"
#include "progress.hpp"

namespace adit::tools {
namespace {

using Json = nlohmann::json;

/// Calls visit(name, number) for the numbers of a score.
template <class Score, class Visitor>
void visit_numbers(Score& s, const Visitor& visit) {
  visit("confidence", s.confidence);
  visit("azimuth_rad", s.azimuth_rad);
  visit("open_ratio", s.open_ratio);
  visit("error_rad", s.error_rad);
  visit("deepest_error_rad", s.deepest_error_rad);
  visit("passage_error_rad", s.passage_error_rad);
}

template <class Score, class Visitor>
void visit_counts(Score& s, const Visitor& visit) {
  visit("branches", s.branches);
  visit("branches_found", s.branches_found);
  visit("named", s.named);
  visit("named_right", s.named_right);
}

// JSON's numbers come back to the last bit; NaN is null there.
double number_of(const Json& json) { return json.is_null() ? eval::kUnknown : json.get<double>(); }

Json json_of(const Judged& judged) {
  const eval::Answer& answer = judged.given.answer;
  Json json{{"status", judged.given.status},
            {"found", answer.found},
            {"place", {answer.place.u_px, answer.place.v_px}},
            {"given_confidence", answer.confidence},
            {"openings", Json::array()},
            {"verdict", static_cast<int>(judged.score.verdict)},
            {"answered", judged.score.answered}};
  for (const Pixel& p : answer.openings) json["openings"].push_back({p.u_px, p.v_px});
  visit_numbers(judged.score, [&json](const char* name, double value) { json[name] = value; });
  visit_counts(judged.score, [&json](const char* name, int value) { json[name] = value; });
  return json;
}

Judged judged_of(const Json& json) {
  Judged judged;
  eval::Answer& answer = judged.given.answer;
  judged.given.status = json.at("status");
  answer.found = json.at("found");
  answer.place = {number_of(json.at("place").at(0)), number_of(json.at("place").at(1))};
  answer.confidence = number_of(json.at("given_confidence"));
  for (const Json& p : json.at("openings")) answer.openings.push_back({number_of(p.at(0)), number_of(p.at(1))});
  judged.score.verdict = static_cast<eval::Verdict>(json.at("verdict").get<int>());
  judged.score.answered = json.at("answered");
  visit_numbers(judged.score, [&json](const char* name, double& value) { value = number_of(json.at(name)); });
  visit_counts(judged.score, [&json](const char* name, int& value) { value = json.at(name); });
  return judged;
}

Json json_of(const JudgedFrame& judged, const EvalFrame& frame) {
  Json json{{"readable", judged.readable},
            {"fault", judged.fault},
            {"width", judged.width},
            {"height", judged.height},
            {"scene", static_cast<int>(frame.truth.scene)},
            {"methods", Json::array()}};
  for (const Judged& method : judged.methods) json["methods"].push_back(json_of(method));
  return json;
}

std::int64_t frames_of(const EvalWork& work) {
  std::int64_t total = 0;
  for (const EvalSet& set : work.sets) total += static_cast<std::int64_t>(set.frames.size());
  return total;
}

}  // namespace

std::vector<std::string> arguments_of(const CLI::App& subcommand) {
  std::vector<std::string> arguments;
  for (const CLI::Option* option : subcommand.get_options()) {
    if (option->count() == 0 || option->check_lname("shard")) continue;
    if (option->get_expected_max() == 0) {  // a flag
      arguments.push_back(option->get_name());
      continue;
    }
    for (const std::string& value : option->results()) {
      if (!option->get_positional()) arguments.push_back(option->get_name());
      arguments.push_back(value);
    }
  }
  return arguments;
}

PartLabel eval_label(const EvalWork& work, const std::vector<std::string>& arguments) {
  Fingerprint fingerprint;
  visit_fields(work.finder, [&fingerprint](const FieldNote&, const auto& value) {
    fingerprint.add(std::to_string(static_cast<double>(value)));  // enumerations too
  });
  for (const EvalSet& set : work.sets)
    for (const EvalFrame& frame : set.frames) {
      fingerprint.add(frame.name);
      fingerprint.add(frame.place);
      for (const eval::Outline& outline : frame.truth.outlines)
        fingerprint.add_bytes(outline.corners.data(), outline.corners.size() * sizeof(Pixel));
    }
  return {"eval", work.shard, frames_of(work), fingerprint.text(), "", Json(arguments).dump()};
}

void write_eval_part(const std::filesystem::path& whole, const PartLabel& label, const EvalWork& work,
                     const EvalResult& result) {
  PartFile part(whole, label);
  std::int64_t item = 0;
  for (std::size_t s = 0; s < work.sets.size(); ++s)
    for (std::size_t f = 0; f < work.sets[s].frames.size(); ++f)
      if (work.shard.has(item++, label.items))
        part.write(json_of(result.frames[s][f], work.sets[s].frames[f]).dump() + "\n");
  part.commit();
}

void take_eval_parts(EvalWork& work, EvalResult& result) {
  const std::string& name = work.parts.front().path.string();
  if (eval_label(work, {}).fingerprint != work.parts.front().label.fingerprint)
    throw io::InputError(name + ": the sets or settings are no longer those that were judged; run the shards again");
  std::vector<std::string> lines;
  for (const Part& part : work.parts)
    for (std::string& line : part.lines()) lines.push_back(std::move(line));
  if (static_cast<std::int64_t>(lines.size()) != frames_of(work))
    throw io::InputError(name + ": the parts hold " + std::to_string(lines.size()) + " frames, but the sets have " +
                         std::to_string(frames_of(work)) + " now; were frames added or taken away?");
  std::size_t at = 0;
  try {
    for (EvalSet& set : work.sets) {
      std::vector<JudgedFrame>& frames = result.frames.emplace_back();
      for (EvalFrame& frame : set.frames) {
        const Json json = Json::parse(lines[at++]);
        JudgedFrame judged;
        judged.readable = json.at("readable");
        judged.fault = json.at("fault");
        judged.width = json.at("width");
        judged.height = json.at("height");
        for (const Json& method : json.at("methods")) judged.methods.push_back(judged_of(method));
        frame.truth.scene = static_cast<eval::Scene>(json.at("scene").get<int>());
        if (!judged.fault.empty()) {
          ++result.unreadable;
          print_line("adit: " + judged.fault);
        }
        frames.push_back(std::move(judged));
      }
    }
  } catch (const nlohmann::json::exception& e) {
    throw io::InputError(name + ": not the frames that this adit writes: " + e.what());
  }
}

}  // namespace adit::tools
