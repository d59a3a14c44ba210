target_sources(adit_core PRIVATE
  adit_chain.cpp
  camera.cpp
  cell_filters.cpp
  chain.cpp
  distortion.cpp
  enclosure.cpp
  faults.cpp
  finder.cpp
  heading.cpp
  image.cpp
  kmeans_exact.cpp
  kmeans_lloyd.cpp
  names.cpp
  opening_search.cpp
  reduced_frame.cpp
  scattering_depth.cpp
  stage_images.cpp)
