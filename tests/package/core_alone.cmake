# cmake -D… -P core_alone.cmake: the core builds where GLM and libepoxy are and nothing else is, and needs nothing else
# at run time. Variables: how.cmake.
include(${CMAKE_CURRENT_LIST_DIR}/how.cmake)

set(nothingElse -DMIRRORBALL_STB_INCLUDE_DIR=MIRRORBALL_STB_INCLUDE_DIR-NOTFOUND)
foreach(package assimp CLI11 embree glfw3)
    list(APPEND nothingElse -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
# pkg-config sees GLM and libepoxy only, the latter without what its own file names for static linking.
file(REMOVE_RECURSE ${WORK})
file(WRITE ${WORK}/pkgconfig/epoxy.pc "Name: epoxy\nDescription: epoxy\nVersion: 1.5\nLibs: -lepoxy\n")
set(ENV{PKG_CONFIG_LIBDIR} ${WORK}/pkgconfig)

execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build ${common} -DBUILD_SHARED_LIBS=ON ${nothingElse}
    OUTPUT_VARIABLE summary COMMAND_ERROR_IS_FATAL ANY)
message("${summary}")
foreach(line "headless, [^:]*: off, for want of EGL" "io, [^:]*: off, for want of OpenEXR" "programs: off, for want of"
        "Tests: off, for want of")
    if(NOT summary MATCHES "${line}")
        message(FATAL_ERROR "the summary does not say \"${line}\"")
    endif()
endforeach()
run(${CMAKE_COMMAND} --build ${WORK}/build)

execute_process(COMMAND readelf -d ${WORK}/build/src/libmirrorball.so OUTPUT_VARIABLE dynamic
                COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "Shared library: [^\n]+" needed "${dynamic}")
set(others ${needed})
list(FILTER others EXCLUDE REGEX "\\[(libepoxy|libstdc\\+\\+|libm|libgcc_s|libc|ld-linux[^.]*)\\.so")
if(NOT needed OR others)
    message(FATAL_ERROR "libmirrorball.so needs ${needed}")
endif()
