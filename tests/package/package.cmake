# cmake -D… -P package.cmake: installs mirrorball as KIND (static or shared) into an empty prefix below WORK, and builds
# and runs programs against it by find_package and by pkg-config. BUILD is this build and BUILD_KIND its kind; how.cmake
# has the other variables.
include(${CMAKE_CURRENT_LIST_DIR}/how.cmake)

set(prefix ${WORK}/prefix)
set(shared OFF)
set(eachHeader ON) # once is enough: the headers are the same
if(KIND STREQUAL shared)
    set(shared ON)
    set(eachHeader OFF)
endif()
file(REMOVE_RECURSE ${prefix} ${WORK}/use_installed)

# ---- Install ---------------------------------------------------------------------------------------
if(NOT KIND STREQUAL BUILD_KIND)
    set(BUILD ${WORK}/build)
    run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} ${common} -DBUILD_SHARED_LIBS=${shared} -DMIRRORBALL_EXAMPLES=OFF
        -DMIRRORBALL_TESTS=OFF)
    run(${CMAKE_COMMAND} --build ${BUILD})
endif()
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})

# ---- find_package ----------------------------------------------------------------------------------
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/use_installed -B ${WORK}/use_installed ${common} -DCMAKE_PREFIX_PATH=${prefix}
    -DEACH_HEADER=${eachHeader})
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
