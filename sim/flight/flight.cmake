# Vehicle, loop, truth, the sensors for the map.
target_sources(adit_sim PRIVATE
  flight/bend_count.cpp
  flight/random.cpp
  flight/flight.cpp
  flight/flight_summary.cpp
  flight/lidar.cpp
  flight/network.cpp
  flight/occupancy.cpp
  flight/rendered_eye.cpp
  flight/truth.cpp
  flight/vehicle.cpp
  flight/viewpoints.cpp)
