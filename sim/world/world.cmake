# Worlds: procedural courses, Gazebo worlds, bare meshes.
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(yaml-cpp REQUIRED)
target_sources(adit_sim PRIVATE
  world/axis.cpp
  world/blind_ends.cpp
  world/build_course.cpp
  world/course_check.cpp
  world/course_yaml.cpp
  world/door.cpp
  world/fitting_shapes.cpp
  world/fittings.cpp
  world/layout.cpp
  world/layout_moves.cpp
  world/layout_network.cpp
  world/layout_random.cpp
  world/layout_tiles.cpp
  world/noise.cpp
  world/passage_field.cpp
  world/rock.cpp
  world/surface_nets.cpp)
target_link_libraries(adit_sim PUBLIC Eigen3::Eigen PRIVATE TBB::tbb fmt::fmt yaml-cpp)
# Gazebo worlds and bare meshes.
find_package(assimp REQUIRED)
find_package(sdformat12 REQUIRED)
find_package(tinyxml2 REQUIRED)
target_sources(adit_sim PRIVATE
  world/mesh_checks.cpp
  world/mesh_file.cpp
  world/model_paths.cpp
  world/sdf_file.cpp
  world/shape_meshes.cpp
  world/tile_network.cpp
  world/world_file.cpp)
target_link_libraries(adit_sim PRIVATE assimp::assimp sdformat12::sdformat12 tinyxml2::tinyxml2)
