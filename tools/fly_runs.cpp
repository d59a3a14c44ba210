#include "fly_runs.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <future>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "adit/io/errors.hpp"
#include "adit/sim/flight_summary.hpp"
#include "adit/sim/rendered_eye.hpp"
#include "fly_figures.hpp"
#include "fly_outputs.hpp"
#include "fly_parts.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "report_flight.hpp"
#ifdef ADIT_WITH_HTTP
#include "view_flight.hpp"
#endif
#include "worker_pool.hpp"

namespace adit::tools {
namespace {

using Clock = std::chrono::steady_clock;

SummaryContext context_of(const FlyWork& work, const FlySettings& s) {
  return {work.name,
          std::string(to_string(s.flight.finder.method)),
          s.rig.name,
          s.flight.flight.speed_m_s,
          static_cast<double>(s.rig.dust.extinction_1_m),
          false,
          0.0,
          {}};
}

std::string shown(double value, const char* format) {
  if (!std::isfinite(value)) return "-";
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

template <class OnFrame>
Flown fly(const FlyWork& work, const FlySettings& settings, sim::Flight& flight, const OnFrame& on_frame) {
  const auto begin = Clock::now();
  sim::FlightTally tally;
  Flown flown{{}, context_of(work, settings)};
  while (!is_interrupted() && flight.step()) {
    tally.add(flight.row());
    on_frame();
  }
  flown.summary = tally.of(flight);
  flown.context.interrupted = !flight.outcome().has_value();
  flown.context.real_time_factor =
      flight.time_s() / std::max(1e-9, std::chrono::duration<double>(Clock::now() - begin).count());
  return flown;
}

std::string title_of(const Flown& flown) {
  const sim::FlightSummary& s = flown.summary;
  return flown.context.world + ", " + flown.context.method + ", " + shown(flown.context.speed_m_s, "%.2g m/s") + ", " +
         flown.context.lamp +
         (flown.context.dust_1_m > 0.0 ? ", dust " + shown(flown.context.dust_1_m, "%.3g 1/m") : "") + ", seed " +
         std::to_string(s.seed) + ": " +
         (flown.context.interrupted ? "interrupted" : std::string(to_string(s.outcome))) + " after " +
         shown(s.distance_m, "%.0f m") + ", " + shown(s.duration_s, "%.0f s");
}

void print_flight(const Flown& flown) {
  const sim::FlightSummary& s = flown.summary;
  std::printf("%s\n", title_of(flown).c_str());
  if (!s.reason.empty()) std::printf("  %s\n", s.reason.c_str());
  std::printf("  side clearance %s m at least, %s m median; %s m over all directions\n",
              shown(s.side_clearance_min_m, "%.2f").c_str(), shown(s.side_clearance_median_m, "%.2f").c_str(),
              shown(s.clearance_min_m, "%.2f").c_str());
  std::printf("  heading error to the passage ahead %s deg median, %s deg 95th percentile; to the deepest %s, %s\n",
              shown(s.heading_error_passage_deg.median, "%.1f").c_str(),
              shown(s.heading_error_passage_deg.p95, "%.1f").c_str(),
              shown(s.heading_error_deepest_deg.median, "%.1f").c_str(),
              shown(s.heading_error_deepest_deg.p95, "%.1f").c_str());
  std::printf("  found %s of the frames, jitter of sx %s, %d false stops, %d missed stops; %s times real time\n",
              shown(s.found_fraction, "%.3f").c_str(), shown(s.sx_jitter, "%.3f").c_str(), s.false_stops,
              s.missed_stops, shown(flown.context.real_time_factor, "%.2f").c_str());
  if (const std::string note = note_of(flown.context.changes); !note.empty()) std::printf("  %s\n", note.c_str());
}

constexpr const char* kRunsHeader =
    "seed,outcome,duration_s,distance_m,progress_m,side_clearance_min_m,clearance_min_m,"
    "heading_error_passage_median_deg,heading_error_passage_p95_deg,heading_error_deepest_median_deg,"
    "heading_error_deepest_p95_deg,sx_jitter,found_fraction,false_stops,missed_stops,bends\n";

std::string cell(double value, const char* format) { return std::isfinite(value) ? shown(value, format) : ""; }

std::string runs_line(const sim::FlightSummary& s) {
  std::string line = std::to_string(s.seed);
  line.append(",").append(to_string(s.outcome));
  for (const double value :
       {s.duration_s, s.distance_m, s.progress_m, s.side_clearance_min_m, s.clearance_min_m,
        s.heading_error_passage_deg.median, s.heading_error_passage_deg.p95, s.heading_error_deepest_deg.median,
        s.heading_error_deepest_deg.p95, s.sx_jitter, s.found_fraction})
    line.append(",").append(cell(value, "%.4f"));
  return line + "," + std::to_string(s.false_stops) + "," + std::to_string(s.missed_stops) + "," +
         std::to_string(s.bends) + "\n";
}

/// The middle of what is known.
double median_of(const std::vector<Flown>& runs, double (*value)(const sim::FlightSummary&)) {
  std::vector<double> values;
  for (const Flown& run : runs)
    if (const double v = value(run.summary); std::isfinite(v)) values.push_back(v);
  return sim::spread_of(std::move(values)).median;
}

/// What a flight in this world has to come to: the goal; where there is none and no other way either, a stop before the
/// end of the drift; else to be flying when the time is over.
sim::Outcome aim_of(const sim::World& world) {
  const auto has = [&world](sim::NodeKind kind) {
    return std::any_of(world.nodes.begin(), world.nodes.end(), [kind](const sim::Node& n) { return n.kind == kind; });
  };
  if (has(sim::NodeKind::kGoal)) return sim::Outcome::kGoal;
  if (has(sim::NodeKind::kDeadEnd) && !has(sim::NodeKind::kJunction)) return sim::Outcome::kStopped;
  return sim::Outcome::kTimeout;
}

/// At a dead end it is as good to turn round and come out.
bool is_success(sim::Outcome outcome, sim::Outcome aim) {
  return outcome == aim || (aim == sim::Outcome::kStopped && outcome == sim::Outcome::kReturned);
}

std::string runs_json(const std::vector<Flown>& runs, const sim::Rate& rate, sim::Outcome aim) {
  nlohmann::ordered_json json;
  const SummaryContext& context = runs.front().context;
  json["world"] = context.world;
  json["method"] = context.method;
  json["lamp"] = context.lamp;
  json["speed_m_s"] = context.speed_m_s;
  json["dust_1_m"] = context.dust_1_m;
  json["runs"] = rate.trials;
  json["success_is"] = std::string(to_string(aim));
  json["successes"] = rate.successes;
  json["success_rate"] = rate.rate;
  json["success_rate_low"] = rate.low;
  json["success_rate_high"] = rate.high;
  for (const sim::Outcome outcome : {sim::Outcome::kGoal, sim::Outcome::kCollided, sim::Outcome::kStopped,
                                     sim::Outcome::kStuck, sim::Outcome::kReturned, sim::Outcome::kTimeout})
    json["outcomes"][std::string(to_string(outcome))] =
        std::count_if(runs.begin(), runs.end(), [outcome](const Flown& run) { return run.summary.outcome == outcome; });
  const auto median = [&](const char* name, double (*value)(const sim::FlightSummary&)) {
    const double v = median_of(runs, value);
    json["median"][name] = std::isfinite(v) ? nlohmann::ordered_json(v) : nlohmann::ordered_json();
  };
  using S = sim::FlightSummary;
  median("duration_s", [](const S& s) { return s.duration_s; });
  median("distance_m", [](const S& s) { return s.distance_m; });
  median("progress_m", [](const S& s) { return s.progress_m; });
  median("side_clearance_min_m", [](const S& s) { return s.side_clearance_min_m; });
  median("clearance_min_m", [](const S& s) { return s.clearance_min_m; });
  median("heading_error_passage_median_deg", [](const S& s) { return s.heading_error_passage_deg.median; });
  median("heading_error_passage_p95_deg", [](const S& s) { return s.heading_error_passage_deg.p95; });
  median("heading_error_deepest_median_deg", [](const S& s) { return s.heading_error_deepest_deg.median; });
  median("heading_error_deepest_p95_deg", [](const S& s) { return s.heading_error_deepest_deg.p95; });
  median("sx_jitter", [](const S& s) { return s.sx_jitter; });
  median("found_fraction", [](const S& s) { return s.found_fraction; });
  median("bends", [](const S& s) { return static_cast<double>(s.bends); });
  median("false_stops", [](const S& s) { return static_cast<double>(s.false_stops); });
  median("missed_stops", [](const S& s) { return static_cast<double>(s.missed_stops); });
  return json.dump(2) + "\n";
}

void print_table(const std::vector<Flown>& runs, const sim::Rate& rate, sim::Outcome aim) {
  std::printf("%6s  %-9s %8s %9s %9s %9s %9s %9s %7s\n", "seed", "outcome", "time s", "way m", "side m", "passage°",
              "deepest°", "jitter sx", "found");
  for (const Flown& run : runs) {
    const sim::FlightSummary& s = run.summary;
    std::printf("%6llu  %-9s %8s %9s %9s %8s %8s %9s %7s\n", static_cast<unsigned long long>(s.seed),
                std::string(to_string(s.outcome)).c_str(), shown(s.duration_s, "%.1f").c_str(),
                shown(s.distance_m, "%.1f").c_str(), shown(s.side_clearance_min_m, "%.2f").c_str(),
                shown(s.heading_error_passage_deg.median, "%.1f").c_str(),
                shown(s.heading_error_deepest_deg.median, "%.1f").c_str(), shown(s.sx_jitter, "%.3f").c_str(),
                shown(s.found_fraction, "%.3f").c_str());
  }
  const char* success = aim == sim::Outcome::kGoal      ? "reached the goal"
                        : aim == sim::Outcome::kStopped ? "stopped before the end of the drift, or came out again"
                                                        : "were flying when the time was over";
  std::printf("%d of %d %s: %.0f %% (95 %% interval %.0f to %.0f %%)\n", rate.successes, rate.trials, success,
              100.0 * rate.rate, 100.0 * rate.low, 100.0 * rate.high);
}

sim::FlightSettings seeded(const FlySettings& settings, std::uint64_t seed) {
  sim::FlightSettings flight = settings.flight;
  flight.seed = seed;
  return flight;
}

/// What flies, for the report and for those who want to fly it again.
ReportOrigin made_by(const FlySettings& settings) {
  FlySettings now = settings, usual;
  return origin_now(sections_of(now).to_yaml(), sections_of(usual).to_yaml());
}

/// What the constructors refuse is a fault of the settings.
template <class Work>
auto with_config_faults(const Work& work) {
  try {
    return work();
  } catch (const std::invalid_argument& e) {
    throw io::ConfigError(e.what());
  }
}

}  // namespace

void report_runs(const std::string& folder, bool quiet, const std::vector<Flown>& runs, sim::Outcome aim) {
  if (runs.empty()) return;
  const auto successes =
      std::count_if(runs.begin(), runs.end(), [aim](const Flown& run) { return is_success(run.summary.outcome, aim); });
  const sim::Rate rate = sim::wilson_rate(static_cast<int>(successes), static_cast<int>(runs.size()));
  if (!folder.empty()) {
    std::string table = kRunsHeader;
    for (const Flown& run : runs) table += runs_line(run.summary);
    io::write_file(std::filesystem::path(folder) / "runs.csv", table);
    io::write_file(std::filesystem::path(folder) / "runs.json", runs_json(runs, rate, aim));
  }
  if (!quiet) print_table(runs, rate, aim);
}

ExitCode fly_once(const FlyWork& work, const FlySettings& settings, const Site& site) {
  return with_config_faults([&] {
    sim::RenderedEye eye(site.world, settings.rig, settings.render, site.scene);
    sim::Flight flight(seeded(settings, work.seeds.front()), site.world, *site.scene, eye);
    flight.record_sensors(work.sensors || !work.bag.file.empty());
    std::optional<FlyBag> bag;
    if (!work.bag.file.empty()) bag.emplace(work.bag, flight);
    std::optional<FlyOutputs> outputs;
    if (!work.out.empty()) outputs.emplace(work.out, flight, work.film, work.sensors, work.stills_s);
    const ReportOrigin origin = made_by(settings);
    std::optional<FlightReport> report;
    if (!work.report.empty() || work.film) report.emplace(flight, origin);
#ifdef ADIT_WITH_HTTP
    std::unique_ptr<FlightView> view;
    if (work.view)
      view = std::make_unique<FlightView>(work.name, settings, site.world, ViewAddress{work.view_host, work.view_port});
#endif
    const auto frames =
        static_cast<std::int64_t>(std::ceil(settings.flight.flight.time_max_s * settings.flight.flight.camera_rate_hz));
    Progress progress(frames, "frames", work.quiet);
    std::vector<SettingChange> changes;
    Flown flown = fly(work, settings, flight, [&] {
      if (outputs) outputs->add(flight);
      if (bag) bag->add(flight);
      if (report) report->add(flight);
#ifdef ADIT_WITH_HTTP
      if (view) {
        view->add(flight);
        const auto now = view->take_changes(flight);
        if (!now.empty() && outputs) outputs->use(flight);
        if (!now.empty() && report) report->use(flight);
        changes.insert(changes.end(), now.begin(), now.end());
      }
#endif
      progress.show(flight.row().frame + 1);
    });
    progress.clear();
    flown.context.changes = std::move(changes);
    if (bag) bag->commit();
    if (outputs) {
      outputs->commit(flight, summary_json(flown.summary, flown.context));
      write_origin(work.out, origin);
      if (report && work.film) report->keep(work.out);
      if (flown.summary.frames > 1)
        if (const auto why = draw_figures(work.out, {title_of(flown)}, flight.map().picture()); !why.empty())
          print_line("adit: no figures: " + why);
    }
    if (!work.report.empty())
      report->write(work.report, flight, title_of(flown), summary_json(flown.summary, flown.context));
    if (!work.quiet) print_flight(flown);
#ifdef ADIT_WITH_HTTP
    if (view) view->stay(title_of(flown));
#endif
    return flown.context.interrupted ? kInterrupted : kSuccess;
  });
}

ExitCode fly_many(const FlyWork& work, const FlySettings& settings, const Site& site) {
  return with_config_faults([&] {
    FlySettings each = settings;
    each.render.threads = 1;
    const ReportOrigin origin = made_by(each);
    std::vector<std::optional<Flown>> results(work.seeds.size());
    Progress progress(static_cast<std::int64_t>(work.seeds.size()), "flights", work.quiet);
    std::mutex mutex;
    std::int64_t done = 0;
    {
      WorkerPool pool(work.jobs);
      std::vector<std::future<void>> flights;
      for (std::size_t i = 0; i < work.seeds.size(); ++i)
        flights.push_back(pool.submit([&, i](int) {
          if (is_interrupted()) return;
          sim::RenderedEye eye(site.world, each.rig, each.render, site.scene);
          sim::Flight flight(seeded(each, work.seeds[i]), site.world, *site.scene, eye);
          std::optional<FlyOutputs> outputs;
          if (!work.out.empty())
            outputs.emplace(std::filesystem::path(work.out) / ("seed_" + std::to_string(work.seeds[i])), flight,
                            work.film, work.sensors, work.stills_s);
          Flown flown = fly(work, each, flight, [&] {
            if (outputs) outputs->add(flight);
          });
          if (flown.context.interrupted) return;  // half a flight is no result
          if (outputs) {
            outputs->commit(flight, summary_json(flown.summary, flown.context));
            write_origin(std::filesystem::path(work.out) / ("seed_" + std::to_string(work.seeds[i])), origin);
          }
          const std::lock_guard lock(mutex);
          results[i] = std::move(flown);
          progress.show(++done);
        }));
      for (auto& flight : flights) flight.get();
    }
    progress.clear();
    std::vector<Flown> runs;
    for (auto& result : results)
      if (result) runs.push_back(std::move(*result));
    if (work.part) {
      if (is_interrupted()) {
        print_line("adit: interrupted; half a part is none, run --shard " + work.part->shard.text() + " again");
        return kInterrupted;
      }
      write_fly_part(work.out, *work.part, runs, aim_of(site.world));
      return kSuccess;
    }
    if (runs.empty() && !is_interrupted()) return kUnexpected;
    if (!runs.empty()) report_runs(work.out, work.quiet, runs, aim_of(site.world));
    if (!is_interrupted()) return kSuccess;
    print_line("adit: interrupted after " + std::to_string(runs.size()) + " of " + std::to_string(work.seeds.size()) +
               " flights; " + (runs.empty() ? "half a flight is no result" : "what was written is whole"));
    return kInterrupted;
  });
}

}  // namespace adit::tools
