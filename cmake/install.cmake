# Installs the libraries as a package: find_package(adit REQUIRED COMPONENTS core io sim).
# Each component has an export file of its own, so that a project that wants the core alone needs nothing else.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/adit)

function(adit_install_component name header_dir)
  install(TARGETS adit_${name} EXPORT adit-${name}-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT adit-${name}-targets NAMESPACE adit:: DESTINATION ${package_dir})
  install(DIRECTORY ${header_dir}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
endfunction()

adit_install_component(core ${PROJECT_SOURCE_DIR}/include)
foreach(component IN ITEMS node io sim)
  if(TARGET adit_${component})
    get_target_property(kind adit_${component} TYPE)
    if(NOT kind STREQUAL "INTERFACE_LIBRARY")
      adit_install_component(${component} ${PROJECT_SOURCE_DIR}/${component}/include)
    endif()
  endif()
endforeach()
if(TARGET adit_program)
  install(TARGETS adit_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/adit-config.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/adit-config.cmake INSTALL_DESTINATION ${package_dir})
# Before 1.0, a new minor version may change the interface.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/adit-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/adit-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/adit-config-version.cmake
  DESTINATION ${package_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
