// Many flights of the same kind: seeds shared out over all cores, a line a flight, a rate with its interval.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "adit/sim/flight_summary.hpp"
#include "exit_code.hpp"
#include "fly_bag.hpp"
#include "fly_outputs.hpp"
#include "fly_setup.hpp"
#include "parts.hpp"

namespace adit::tools {

/// How `adit fly` works, apart from what it flies.
struct FlyWork {
  std::string out;  ///< folder; "" for none
  bool film = false;
  bool sensors = false;
  std::string report;  ///< page; "" for none
  bool view = false;
  std::string view_host = "127.0.0.1";
  int view_port = 0;  ///< 0: any that is free
  BagOptions bag;
  bool quiet = false;
  std::vector<double> stills_s;
  std::vector<std::uint64_t> seeds;
  int jobs = 1;
  std::string name;               ///< of course or world
  std::optional<PartLabel> part;  ///< the seeds are those of a part (fly_parts.hpp)
};

/// A flight from take-off to its end, or to a signal.
struct Flown {
  sim::FlightSummary summary;
  SummaryContext context;
};

/// The table of flights on standard output, unless quiet; with a folder also runs.csv and runs.json in it.
void report_runs(const std::string& folder, bool quiet, const std::vector<Flown>& runs, sim::Outcome aim);

/// One flight, with everything it leaves behind.
[[nodiscard]] ExitCode fly_once(const FlyWork& work, const FlySettings& settings, const Site& site);

/// One flight for each seed; prints a table, and with a folder writes runs.csv, runs.json and a folder a seed.
[[nodiscard]] ExitCode fly_many(const FlyWork& work, const FlySettings& settings, const Site& site);

}  // namespace adit::tools
