// A flight in a page while it is flown: `adit fly --view`.
#pragma once

#include <string>

#include "adit/sim/flight.hpp"
#include "fly_setup.hpp"
#include "setting_changes.hpp"
#include "view_server.hpp"

namespace adit::tools {

class FlightView {
 public:
  /// Prints the address. @throws io::OutputError
  FlightView(const std::string& name, const FlySettings& settings, const sim::World& world, const ViewAddress& address);

  /// After each Flight::step().
  void add(const sim::Flight& flight);
  /// What viewers have changed since the last call goes into the flight, from its next frame on. Returns what it was.
  [[nodiscard]] std::vector<SettingChange> take_changes(sim::Flight& flight);
  /// Says how it ended and keeps the page until Ctrl-C.
  void stay(const std::string& line);

 private:
  io::Configuration flown_;
  std::vector<SettingChange> changes_;
  LiveView live_;
  ViewServer server_;
};

/// The steep triangles of a world, seen from above: walls dark, the rest clear. Pixels of 0.1 m, larger where the
/// world is wider than 4000 of them.
[[nodiscard]] LivePlan plan_of(const sim::World& world);

}  // namespace adit::tools
