# Rays, lamps, dust, sensor. Embree 4 where it is, else 3.
find_package(TBB REQUIRED)
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3.8 REQUIRED)
endif()
target_sources(adit_sim PRIVATE
  light/scene.cpp
  light/contact.cpp)
target_link_libraries(adit_sim PRIVATE embree TBB::tbb)
