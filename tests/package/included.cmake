# Uses the source as a part of another project's: add_subdirectory(adit).
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
set(work_dir ${build_dir}/package_test/included)
file(REMOVE_RECURSE ${work_dir})

consume(${work_dir}/plain -DADIT_SOURCE=${source_dir})
refuse_leaks(${work_dir}/plain)
foreach(unwanted IN ITEMS adit/tests adit/bench)
  if(EXISTS ${work_dir}/plain/${unwanted})
    message(FATAL_ERROR "a project that includes adit got ${unwanted} built unasked")
  endif()
endforeach()
