# Installs the package, moves it elsewhere, and uses it from a project that only says find_package(adit).
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
set(work_dir ${build_dir}/package_test/installed)
file(REMOVE_RECURSE ${work_dir})

run(${CMAKE_COMMAND} --install ${build_dir} --prefix ${work_dir}/staged)
file(RENAME ${work_dir}/staged ${work_dir}/moved)

file(GLOB_RECURSE package_files ${work_dir}/moved/*.cmake)
foreach(package_file IN LISTS package_files)
  file(STRINGS ${package_file} traces REGEX "${source_dir}|${build_dir}|${work_dir}")
  if(traces)
    message(FATAL_ERROR "${package_file} names the machine it was built on: ${traces}")
  endif()
endforeach()

set(at -DCMAKE_PREFIX_PATH=${work_dir}/moved)
consume(${work_dir}/plain ${at})
refuse_leaks(${work_dir}/plain)
# The headers are clean under a strict project's flags.
set(strict "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror")
consume(${work_dir}/strict ${at} ${strict})
if(with_io)
  consume(${work_dir}/with_io ${at} -DWITH_IO=ON "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror")
  run(${work_dir}/moved/bin/adit --version)
endif()

# A component that does not exist is refused, not passed over.
execute_process(COMMAND ${CMAKE_COMMAND} -S ${consumer_dir} -B ${work_dir}/refused -G ${generator} ${at}
  -DCMAKE_CXX_COMPILER=${compiler} -DADIT_VERSION_WANTED=${version} -DEXTRA_COMPONENT=nonsense
  RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE error)
if(result EQUAL 0 OR NOT error MATCHES "without the component.*nonsense")
  message(FATAL_ERROR "an unknown component was accepted: ${error}")
endif()
