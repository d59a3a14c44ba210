#include "fly_parts.hpp"

#include <nlohmann/json.hpp>

#include "adit/io/errors.hpp"

namespace adit::tools {
namespace {

/// Calls visit(name, number) for the figures of a flight that the table of flights is made of.
template <class Summary, class Visitor>
void visit_figures(Summary& s, const Visitor& visit) {
  visit("duration_s", s.duration_s);
  visit("distance_m", s.distance_m);
  visit("progress_m", s.progress_m);
  visit("side_clearance_min_m", s.side_clearance_min_m);
  visit("clearance_min_m", s.clearance_min_m);
  visit("heading_error_passage_median_deg", s.heading_error_passage_deg.median);
  visit("heading_error_passage_p95_deg", s.heading_error_passage_deg.p95);
  visit("heading_error_deepest_median_deg", s.heading_error_deepest_deg.median);
  visit("heading_error_deepest_p95_deg", s.heading_error_deepest_deg.p95);
  visit("sx_jitter", s.sx_jitter);
  visit("found_fraction", s.found_fraction);
}

// JSON's numbers come back to the last bit; NaN is null there.
std::string line_of(const Flown& flown) {
  nlohmann::ordered_json json;
  json["seed"] = flown.summary.seed;
  json["outcome"] = static_cast<int>(flown.summary.outcome);
  visit_figures(flown.summary, [&json](const char* name, double value) { json[name] = value; });
  json["bends"] = flown.summary.bends;
  json["false_stops"] = flown.summary.false_stops;
  json["missed_stops"] = flown.summary.missed_stops;
  json["world"] = flown.context.world;
  json["method"] = flown.context.method;
  json["lamp"] = flown.context.lamp;
  json["speed_m_s"] = flown.context.speed_m_s;
  json["dust_1_m"] = flown.context.dust_1_m;
  return json.dump() + "\n";
}

Flown flown_of(const std::string& line) {
  const auto json = nlohmann::json::parse(line);
  Flown flown;
  flown.summary.seed = json.at("seed");
  flown.summary.outcome = static_cast<sim::Outcome>(json.at("outcome").get<int>());
  visit_figures(flown.summary, [&json](const char* name, double& value) {
    value = json.at(name).is_null() ? sim::kUnknown : json.at(name).get<double>();
  });
  flown.summary.bends = json.value("bends", 0);  // parts of older programs have none
  flown.summary.false_stops = json.at("false_stops");
  flown.summary.missed_stops = json.at("missed_stops");
  flown.context.world = json.at("world");
  flown.context.method = json.at("method");
  flown.context.lamp = json.at("lamp");
  flown.context.speed_m_s = json.at("speed_m_s");
  flown.context.dust_1_m = json.at("dust_1_m");
  return flown;
}

}  // namespace

PartLabel fly_label(const Shard& shard, const std::vector<std::uint64_t>& seeds, FlySettings settings,
                    const FlyOptions& options, const Site& site) {
  Fingerprint fingerprint;
  fingerprint.add(sections_of(settings).to_yaml());
  fingerprint.add(options.course);
  fingerprint.add(options.world_file);
  fingerprint.add(settings.rig.name);
  for (const double value : options.start) fingerprint.add_bytes(&value, sizeof value);
  fingerprint.add_bytes(seeds.data(), seeds.size() * sizeof seeds.front());
  // The rock itself: a world file may have changed under its name.
  const auto& vertices = site.world.mesh.vertices;
  if (!vertices.empty()) fingerprint.add_bytes(vertices.data(), vertices.size() * sizeof vertices.front());
  return {"fly", shard, static_cast<std::int64_t>(seeds.size()), fingerprint.text(), "", ""};
}

void write_fly_part(const std::filesystem::path& folder, const PartLabel& label, const std::vector<Flown>& runs,
                    sim::Outcome aim) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw io::OutputError(folder.string() + ": the folder cannot be made: " + error.message());
  PartLabel whole = label;
  whole.head = std::to_string(static_cast<int>(aim));
  PartFile part(folder / "runs", whole);
  for (const Flown& run : runs) part.write(line_of(run));
  part.commit();
}

void join_flights(const std::filesystem::path& folder, const std::vector<Part>& parts, bool quiet) {
  std::vector<Flown> runs;
  try {
    for (const Part& part : parts)
      for (const std::string& line : part.lines()) runs.push_back(flown_of(line));
    report_runs(folder.string(), quiet, runs, static_cast<sim::Outcome>(std::stoi(parts.front().label.head)));
  } catch (const nlohmann::json::exception& e) {
    throw io::InputError(parts.front().path.string() + ": not the flights that this adit writes: " + e.what());
  }
}

}  // namespace adit::tools
