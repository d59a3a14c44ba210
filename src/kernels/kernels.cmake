target_sources(adit_core PRIVATE
  structuring_element.cpp
  morphology.cpp
  dark_channel.cpp
  atmospheric_light.cpp
  region.cpp)
