// `adit fly --bag`: a flight as a recording of ROS 1.
#pragma once

#include <memory>
#include <string>

#include "adit/sim/flight.hpp"

namespace adit::tools {

struct BagOptions {
  std::string file;            ///< "" for none
  std::string images = "raw";  ///< raw or jpeg
  std::string topic = "camera/image_raw";
};

class FlyBag {
 public:
  /// @throws io::OutputError, also where adit was built without bags.
  explicit FlyBag(const BagOptions& options, const sim::Flight& flight);
  ~FlyBag();

  /// After each step of the flight. Needs Flight::record_sensors(true).
  void add(const sim::Flight& flight);
  void commit();

 private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace adit::tools
