# Installs the libraries as a package: find_package(adit REQUIRED COMPONENTS core io sim c), or pkg-config.
# Each component has an export file of its own, so that a project that wants the core alone needs nothing else.
# The COMPONENT of each rule says in which Debian package it ends (cmake/packaging.cmake).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/adit)
set(pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

function(adit_install_component name header_dir pattern)
  install(TARGETS adit_${name} EXPORT adit-${name}-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT library
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT adit-${name}-targets NAMESPACE adit:: DESTINATION ${package_dir} COMPONENT development)
  install(DIRECTORY ${header_dir}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
    FILES_MATCHING PATTERN "${pattern}")
endfunction()

# A pkg-config file; paths in it follow the file wherever it is moved to.
function(adit_install_pkgconfig PC_NAME PC_DESCRIPTION PC_LIBS PC_REQUIRES PC_LIBS_PRIVATE)
  file(RELATIVE_PATH PC_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" PC_PREFIX "${PC_PREFIX}")
  configure_file(${PROJECT_SOURCE_DIR}/cmake/adit.pc.in ${CMAKE_CURRENT_BINARY_DIR}/${PC_NAME}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${PC_NAME}.pc DESTINATION ${pkgconfig_dir} COMPONENT development)
endfunction()

adit_install_component(core ${PROJECT_SOURCE_DIR}/include *.hpp)
adit_install_pkgconfig(adit-core "the C++ core: finder, camera, controller, navigator" -ladit_core "" -lstdc++)
if(TARGET adit_c)
  adit_install_component(c ${PROJECT_SOURCE_DIR}/c/include *.h)
  adit_install_pkgconfig(adit "the C interface" -ladit "" "")
endif()
if(TARGET adit_node)
  adit_install_component(node ${PROJECT_SOURCE_DIR}/node/include *.hpp)
endif()
if(TARGET adit_io)
  adit_install_component(io ${PROJECT_SOURCE_DIR}/io/include *.hpp)
  adit_install_pkgconfig(adit-io "images, videos, tables and configuration files" -ladit_io "adit-core opencv4"
    "-lyaml-cpp -ljpeg")
endif()
if(TARGET adit_sim)
  adit_install_component(sim ${PROJECT_SOURCE_DIR}/sim/include *.hpp)
endif()
if(TARGET adit_robot)
  # Its header lies among the node's.
  adit_install_component(robot ${PROJECT_SOURCE_DIR}/node/include *.hpp)
endif()
if(TARGET adit_program)
  install(TARGETS adit_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  # Man pages and completion come from the program's own command line, so it has to run here.
  if(NOT CMAKE_CROSSCOMPILING AND NOT ADIT_SANITIZE)
    set(manual_dir ${PROJECT_BINARY_DIR}/manual)
    add_custom_command(OUTPUT ${manual_dir}/adit.1
      COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual_dir} COMMAND ${CMAKE_COMMAND} -E make_directory ${manual_dir}
      COMMAND adit_program --write-manual ${manual_dir}
      COMMAND sh -c "gzip -9nkf ${manual_dir}/*.1" DEPENDS adit_program VERBATIM)
    add_custom_target(adit_manual ALL DEPENDS ${manual_dir}/adit.1)
    install(DIRECTORY ${manual_dir}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program
      FILES_MATCHING PATTERN "*.1.gz")
    install(FILES ${manual_dir}/adit.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME adit
      COMPONENT program)
  endif()
  # Where the installed program looks for them (tools/fly_setup.cpp).
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/courses/ DESTINATION ${CMAKE_INSTALL_DATADIR}/adit/courses COMPONENT program
    FILES_MATCHING PATTERN "*.yaml")
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/adit-config.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/adit-config.cmake INSTALL_DESTINATION ${package_dir})
# Before 1.0, a new minor version may change the interface.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/adit-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/adit-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/adit-config-version.cmake
  DESTINATION ${package_dir} COMPONENT development)
