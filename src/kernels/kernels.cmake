target_sources(adit_core PRIVATE
  structuring_element.cpp
  morphology.cpp
  element_sum.cpp
  band_pass.cpp
  band_plan.cpp
  rectangle_pass.cpp
  dark_channel.cpp
  atmospheric_light.cpp
  region.cpp
  cpu_target.cpp
  kernels/target_plain.cpp)

# One source of loops, one object for each instruction set; the right one is chosen when the program runs.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|amd64|AMD64)$")
  target_sources(adit_core PRIVATE kernels/target_sse41.cpp kernels/target_avx2.cpp kernels/target_avx512.cpp)
  target_compile_definitions(adit_core PRIVATE ADIT_TARGETS_X86)
  set_source_files_properties(kernels/target_sse41.cpp PROPERTIES COMPILE_OPTIONS "-msse4.1")
  set_source_files_properties(kernels/target_avx2.cpp PROPERTIES COMPILE_OPTIONS "-mavx2")
  set_source_files_properties(kernels/target_avx512.cpp PROPERTIES
    COMPILE_OPTIONS "-mavx512f;-mavx512bw;-mavx512vl;-mavx512dq;-mpopcnt;-mprefer-vector-width=512")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC's own AVX-512 header initialises "undefined" vectors with themselves (GCC bug 105593).
    set_property(SOURCE kernels/target_avx512.cpp APPEND PROPERTY COMPILE_OPTIONS
      -Wno-maybe-uninitialized -Wno-uninitialized)
  endif()
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
  target_sources(adit_core PRIVATE kernels/target_neon.cpp)
  target_compile_definitions(adit_core PRIVATE ADIT_TARGETS_NEON)
elseif(EMSCRIPTEN)
  target_sources(adit_core PRIVATE kernels/target_wasm.cpp)
  target_compile_definitions(adit_core PRIVATE ADIT_TARGETS_WASM)
  set_source_files_properties(kernels/target_wasm.cpp PROPERTIES COMPILE_OPTIONS "-msimd128")
endif()
