# The steps that both package tests are made of.
set(consumer_dir ${CMAKE_CURRENT_LIST_DIR}/consumer)

# run(COMMAND...): stops the test, with the output, when the command fails. The output is in run_output.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed: ${command}\n${output}")
  endif()
  set(run_output "${output}" PARENT_SCOPE)
endfunction()

# consume(DIR ARGUMENT...): configures, builds and runs the consumer in DIR.
function(consume dir)
  run(${CMAKE_COMMAND} -S ${consumer_dir} -B ${dir} -G ${generator} -DCMAKE_CXX_COMPILER=${compiler}
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DADIT_VERSION_WANTED=${version} ${ARGN})
  run(${CMAKE_COMMAND} --build ${dir} --parallel 2)
  run(${dir}/consumer)
  if(NOT run_output MATCHES "adit says: no_contrast")
    message(FATAL_ERROR "a frame of one grey value must be answered no_contrast, not: ${run_output}")
  endif()
endfunction()

# refuse_leaks(DIR): the consumer's own source was compiled with no flag that it did not ask for.
function(refuse_leaks dir)
  file(READ ${dir}/compile_commands.json commands)
  string(JSON last LENGTH "${commands}")
  math(EXPR last "${last} - 1")
  foreach(index RANGE ${last})
    string(JSON file GET "${commands}" ${index} file)
    string(JSON command GET "${commands}" ${index} command)
    if(file MATCHES "consumer/[a-z_]+\\.cpp$" AND command MATCHES " (-W[a-z]|-O|-f|-march|-m[a-z]|-DNDEBUG)")
      message(FATAL_ERROR "a flag of adit's reached the consumer: ${command}")
    endif()
  endforeach()
  file(STRINGS ${dir}/CMakeCache.txt build_type REGEX "^CMAKE_BUILD_TYPE:[A-Z]+=.+")
  if(build_type)
    message(FATAL_ERROR "a build type was forced on the consumer: ${build_type}")
  endif()
endfunction()
