# Which parts are built. Each is on where its packages are found; the summary says what a missing one switches off.
# The core needs GLM and libepoxy and nothing else.
find_package(PkgConfig REQUIRED)
find_package(glm REQUIRED)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)

# mirrorball_missing(<list> <name> <found>): notes the name in the list unless it was found.
function(mirrorball_missing list name found)
    if(NOT found)
        set(${list} ${${list}} ${name} PARENT_SCOPE)
    endif()
endfunction()

# mirrorball_part(<option> <what for> <missing>…): the option, on by default unless something is missing.
function(mirrorball_part option purpose)
    set(missing ${ARGN})
    set(default ON)
    if(missing)
        set(default OFF)
    endif()
    option(${option} "${purpose}" ${default})
    if(${option})
        set(line "on")
    elseif(missing)
        list(JOIN missing ", " names)
        set(line "off, for want of ${names}")
    else()
        set(line "off")
    endif()
    set_property(GLOBAL APPEND PROPERTY mirrorball_summary "  ${purpose}: ${line}")
endfunction()

# ---- Components ------------------------------------------------------------------------------------
pkg_check_modules(egl QUIET IMPORTED_TARGET egl)
mirrorball_missing(headlessMissing EGL "${egl_FOUND}")
mirrorball_part(MIRRORBALL_HEADLESS "Component headless, contexts without a window" ${headlessMissing})

pkg_check_modules(OpenEXR QUIET IMPORTED_TARGET OpenEXR>=3)
find_path(MIRRORBALL_STB_INCLUDE_DIR stb_image.h PATH_SUFFIXES stb)
mirrorball_missing(ioMissing OpenEXR "${OpenEXR_FOUND}")
mirrorball_missing(ioMissing stb "${MIRRORBALL_STB_INCLUDE_DIR}")
mirrorball_part(MIRRORBALL_IO "Component io, PNG, JPEG, HDR and EXR files" ${ioMissing})

# ---- Programs and tests: only where this is the project itself -------------------------------------
if(PROJECT_IS_TOP_LEVEL)
    mirrorball_missing(examplesMissing "component headless" "${MIRRORBALL_HEADLESS}")
    mirrorball_missing(examplesMissing "component io" "${MIRRORBALL_IO}")
    foreach(package assimp CLI11 embree glfw3)
        find_package(${package} CONFIG QUIET)
        mirrorball_missing(examplesMissing ${package} "${${package}_FOUND}")
    endforeach()
    mirrorball_part(MIRRORBALL_EXAMPLES "Example programs" ${examplesMissing})

    pkg_check_modules(mpfr QUIET IMPORTED_TARGET mpfr)
    pkg_check_modules(glew QUIET glew)
    find_program(MIRRORBALL_GLSLANG_VALIDATOR glslangValidator)
    mirrorball_missing(testsMissing "the example programs" "${MIRRORBALL_EXAMPLES}")
    mirrorball_missing(testsMissing MPFR "${mpfr_FOUND}")
    mirrorball_missing(testsMissing GLEW "${glew_FOUND}")
    mirrorball_missing(testsMissing glslangValidator "${MIRRORBALL_GLSLANG_VALIDATOR}")
    mirrorball_part(MIRRORBALL_TESTS "Tests" ${testsMissing})
    option(MIRRORBALL_LONG_TESTS "Tests that take minutes each, too" OFF)
endif()

option(MIRRORBALL_WERROR "Warnings are errors" OFF)
option(MIRRORBALL_INSTALL "Install rules" ${PROJECT_IS_TOP_LEVEL})
option(BUILD_SHARED_LIBS "Build shared libraries" OFF)

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

get_property(summary GLOBAL PROPERTY mirrorball_summary)
list(JOIN summary "\n" summary)
message(STATUS "mirrorball ${PROJECT_VERSION}\n${summary}")
