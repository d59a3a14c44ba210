target_sources(adit_core PRIVATE
  camera.cpp
  chain.cpp
  distortion.cpp
  faults.cpp
  finder.cpp
  heading.cpp
  image.cpp
  kmeans_exact.cpp
  kmeans_lloyd.cpp
  names.cpp
  scattering_depth.cpp
  stage_images.cpp)
