// The report of a flight while it is flown: `adit fly --report`.
#pragma once

#include <filesystem>
#include <string>

#include "adit/sim/flight.hpp"
#include "report.hpp"

namespace adit::tools {

class FlightReport {
 public:
  FlightReport(const sim::Flight& flight, ReportOrigin origin);

  /// After each Flight::step().
  void add(const sim::Flight& flight);
  /// After Flight::change(): pictures are explained by what judges from now on.
  void use(const sim::Flight& flight);
  /// @param summary  as summary_json() has it. @throws io::OutputError
  void write(const std::filesystem::path& path, const sim::Flight& flight, const std::string& title,
             const std::string& summary);

  /// The pictures alone, for `adit report` of the flight's folder. @throws io::OutputError
  void keep(const std::filesystem::path& flight_folder) const;

 private:
  Report report_;
  OpenSpaceFinder explainer_;  ///< the flight's own finder makes no pictures
};

}  // namespace adit::tools
