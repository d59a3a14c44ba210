# Debian packages by cpack: libadit0 (the C interface), libadit-dev (headers and C++ libraries), adit (the program),
# python3-adit (where ADIT_PYTHON is on). `cpack -G DEB` in the build folder; scripts/checks/deb.sh does all of it.
set(CPACK_GENERATOR "DEB;TGZ")
set(CPACK_PACKAGE_NAME adit)
set(CPACK_PACKAGE_VENDOR "The adit authors")
set(CPACK_PACKAGE_CONTACT "The adit authors <adit@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Where the open space is, in the dark, from one camera")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/c)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(all library development program)
if(ADIT_PYTHON)
  list(APPEND all python)
endif()
set(CPACK_COMPONENTS_ALL ${all})

# adit_package(COMPONENT NAME SECTION DEPENDS SUMMARY DESCRIPTION): one binary package.
function(adit_package component name section depends summary description)
  string(TOUPPER ${component} key)
  set(CPACK_COMPONENT_${key}_GROUP ${component} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_COMPONENT_${key}_DESCRIPTION "${summary}\n${description}" PARENT_SCOPE)
  # What Debian wants of every package: whose it is, and what changed.
  install(FILES ${PROJECT_SOURCE_DIR}/packaging/copyright DESTINATION share/doc/${name} COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/changelog.Debian.gz DESTINATION share/doc/${name} COMPONENT ${component})
  if(EXISTS ${PROJECT_SOURCE_DIR}/packaging/${name}.lintian-overrides)
    install(FILES ${PROJECT_SOURCE_DIR}/packaging/${name}.lintian-overrides DESTINATION share/lintian/overrides
      RENAME ${name} COMPONENT ${component})
  endif()
endfunction()

# The changelog of the package; the project's own is CHANGELOG.md. A fixed date: the same sources give the same bytes.
file(WRITE ${PROJECT_BINARY_DIR}/changelog.Debian
  "adit (${PROJECT_VERSION}-1) unstable; urgency=medium\n\n  * Version ${PROJECT_VERSION}; see CHANGELOG.md.\n\n"
  " -- ${CPACK_PACKAGE_CONTACT}  Sun, 01 Nov 2026 00:00:00 +0000\n")
execute_process(COMMAND gzip -9nf ${PROJECT_BINARY_DIR}/changelog.Debian RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(STATUS "gzip is not there: no packages")
  return()
endif()

set(about
"A flying robot in a tunnel has one camera and its own lamp. adit tells it
where the open space is, and says so when there is none.")
adit_package(library libadit0 libs "" "open space in dark tunnels from one camera - C library"
  "${about}\n\nThis package holds the shared library with the C interface.")
adit_package(development libadit-dev libdevel "libadit0 (= ${PROJECT_VERSION}-1)"
  "open space in dark tunnels from one camera - development files"
  "${about}\n\nThis package holds the headers of the C and C++ interfaces, the C++ libraries\nand the files for CMake and pkg-config.")
adit_package(program adit science "" "open space in dark tunnels from one camera - program"
  "${about}\n\nThis package holds the program: it judges pictures and videos, compares\nmethods on marked frames, and flies tunnels in simulation.")
adit_package(python python3-adit python "python3-numpy, python3 (>= 3.11), python3 (<< 3.12)"
  "open space in dark tunnels from one camera - Python module"
  "${about}\n\nThis package holds the module for Python 3.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "libopencv-dev, libyaml-cpp-dev, libembree-dev, libassimp-dev")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "gnuplot-nox")
# ldconfig, without a script: the trigger that Debian's own libraries use.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/triggers)
# What the interpreter compiles beside the module is made and removed with the package.
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/python/postinst
  ${PROJECT_SOURCE_DIR}/packaging/python/prerm)
include(CPack)
