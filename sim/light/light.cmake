# Rays, lamps, dust, sensor. Embree 4 where it is, else 3.
find_package(TBB REQUIRED)
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3.8 REQUIRED)
endif()
find_package(JPEG REQUIRED)
target_sources(adit_sim PRIVATE
  light/scene.cpp
  light/contact.cpp
  light/triangle_table.cpp
  light/lamp_lobe.cpp
  light/lamp_parallax.cpp
  light/dust.cpp
  light/virtual_lights.cpp
  light/foreign_lamps.cpp
  light/mesh_tree.cpp
  light/shadows.cpp
  light/light_pass.cpp
  light/lens_pass.cpp
  light/dirt_pass.cpp
  light/grains.cpp
  light/renderer.cpp
  light/rigs.cpp
  light/shade_dispatch.cpp
  sensor/exposure.cpp
  sensor/sensor_tables.cpp
  sensor/sensor_pass.cpp
  sensor/jpeg_pass.cpp)
target_link_libraries(adit_sim PRIVATE embree TBB::tbb JPEG::JPEG)

# The shading loops, once per kind of CPU. No fused multiply-add and no approximate division: the same bits on each.
# -Wno-psabi: vectors wider than the target's go by value between functions of one file only.
function(adit_shade_target name)
  add_library(adit_shade_${name} OBJECT ${CMAKE_CURRENT_SOURCE_DIR}/light/shade_kernels.cpp)
  target_link_libraries(adit_shade_${name} PRIVATE adit_options)
  target_compile_definitions(adit_shade_${name} PRIVATE ADIT_SHADE_TARGET=${name})
  set_target_properties(adit_shade_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(adit_shade_${name} PRIVATE -O3 -fno-math-errno -fno-trapping-math -Wno-psabi ${ARGN})
  target_sources(adit_sim PRIVATE $<TARGET_OBJECTS:adit_shade_${name}>)
endfunction()
adit_shade_target(plain)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  adit_shade_target(avx2 -mavx2 -mtune=haswell)
  adit_shade_target(avx512 -mavx512f -mavx512dq -mavx512vl -mavx512bw -mtune=skylake-avx512 -mprefer-vector-width=512
                    -Wno-uninitialized)  # GCC 12's own avx512fintrin.h sets it off
  target_compile_definitions(adit_sim PRIVATE ADIT_SHADE_X86)
endif()
