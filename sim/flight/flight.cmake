# Vehicle, loop, truth, the sensors for the map.
target_sources(adit_sim PRIVATE
  flight/random.cpp
  flight/vehicle.cpp)
