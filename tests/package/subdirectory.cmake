# cmake -D… -P subdirectory.cmake: a project that carries mirrorball in a folder. Variables: how.cmake.
include(${CMAKE_CURRENT_LIST_DIR}/how.cmake)
set(build ${WORK}/build)
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/use_subdirectory -B ${build} ${common} -DMIRRORBALL_SOURCE=${SOURCE})
run(${CMAKE_COMMAND} --build ${build})
run(${CMAKE_CTEST_COMMAND} --test-dir ${build} --output-on-failure)
