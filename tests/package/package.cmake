# cmake -D… -P package.cmake: installs mirrorball as KIND (static or shared) into an empty prefix below WORK, and builds
# and runs programs against it in every way that the README promises. The rest of the variables say how:
# SOURCE BUILD (this build) BUILD_KIND (its kind) COMPILER FLAGS LAUNCHER BUILD_TYPE GENERATOR LIBDIR
function(run)
    string(JOIN " " line ${ARGN})
    message("$ ${line}")
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(prefix ${WORK}/prefix)
set(common -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS}
    -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DCMAKE_BUILD_TYPE=${BUILD_TYPE})
set(shared OFF)
if(KIND STREQUAL shared)
    set(shared ON)
endif()
file(REMOVE_RECURSE ${prefix} ${WORK}/use_installed ${WORK}/use_subdirectory)

# ---- Install ---------------------------------------------------------------------------------------
if(NOT KIND STREQUAL BUILD_KIND)
    set(BUILD ${WORK}/build)
    run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} ${common} -DBUILD_SHARED_LIBS=${shared} -DMIRRORBALL_EXAMPLES=OFF
        -DMIRRORBALL_TESTS=OFF)
    run(${CMAKE_COMMAND} --build ${BUILD})
endif()
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})

# ---- find_package ----------------------------------------------------------------------------------
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/use_installed -B ${WORK}/use_installed ${common} -DCMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${WORK}/use_installed)
run(${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/use_installed --output-on-failure)

# ---- pkg-config and a bare compiler ----------------------------------------------------------------
set(ENV{PKG_CONFIG_PATH} ${prefix}/${LIBDIR}/pkgconfig)
set(ENV{LD_LIBRARY_PATH} ${prefix}/${LIBDIR})
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
foreach(program core components)
    set(packages mirrorball)
    if(program STREQUAL components)
        set(packages mirrorball-headless mirrorball-io)
    endif()
    execute_process(COMMAND pkg-config --cflags --libs ${packages} OUTPUT_VARIABLE options COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(options UNIX_COMMAND "${options}")
    run(${COMPILER} -std=c++20 ${flags} ${SOURCE}/tests/use_installed/${program}.cpp -o ${WORK}/${program} ${options})
    run(${CMAKE_COMMAND} -E chdir ${WORK} ${WORK}/${program})
endforeach()

# ---- What a shared library shows -------------------------------------------------------------------
if(shared)
    foreach(library mirrorball mirrorball_headless mirrorball_io)
        execute_process(COMMAND nm -DC --defined-only --format=posix ${prefix}/${LIBDIR}/lib${library}.so
                        OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
        string(REGEX MATCHALL "[^\n]+" symbols "${symbols}")
        set(own ${symbols})
        list(FILTER own INCLUDE REGEX "^(typeinfo for |typeinfo name for |vtable for )?mirrorball::")
        if(NOT own)
            message(FATAL_ERROR "lib${library}.so shows nothing")
        endif()
        list(REMOVE_ITEM symbols ${own})
        if(symbols)
            message(FATAL_ERROR "lib${library}.so shows what is not mirrorball's: ${symbols}")
        endif()
    endforeach()
endif()

# ---- add_subdirectory ------------------------------------------------------------------------------
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/use_subdirectory -B ${WORK}/use_subdirectory ${common}
    -DBUILD_SHARED_LIBS=${shared} -DMIRRORBALL_SOURCE=${SOURCE})
run(${CMAKE_COMMAND} --build ${WORK}/use_subdirectory)
run(${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/use_subdirectory --output-on-failure)
