# What `cmake --install` puts where: headers, libraries, the CMake package and pkg-config files.
include(CMakePackageConfigHelpers)

set(packageDir ${CMAKE_INSTALL_LIBDIR}/cmake/mirrorball)
set(components)
foreach(component headless io)
    if(TARGET mirrorball_${component})
        list(APPEND components ${component})
    else()
        list(APPEND headersLeftOut PATTERN ${component} EXCLUDE)
    endif()
endforeach()
install(DIRECTORY include/mirrorball DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h"
        ${headersLeftOut})

install(TARGETS mirrorball EXPORT mirrorballTargets)
install(EXPORT mirrorballTargets NAMESPACE mirrorball:: DESTINATION ${packageDir})
foreach(component ${components})
    install(TARGETS mirrorball_${component} EXPORT mirrorball-${component}Targets)
    install(EXPORT mirrorball-${component}Targets NAMESPACE mirrorball:: DESTINATION ${packageDir})
endforeach()

# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/mirrorballConfigVersion.cmake COMPATIBILITY SameMinorVersion)
configure_package_config_file(cmake/mirrorballConfig.cmake.in ${PROJECT_BINARY_DIR}/mirrorballConfig.cmake
                              INSTALL_DESTINATION ${packageDir})
install(FILES ${PROJECT_BINARY_DIR}/mirrorballConfig.cmake ${PROJECT_BINARY_DIR}/mirrorballConfigVersion.cmake
        DESTINATION ${packageDir})

install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# A static library hands its own dependencies on to whoever links it.
set(glmRequirement "")
pkg_check_modules(glmPackage QUIET glm)
if(glmPackage_FOUND)
    set(glmRequirement glm)
endif()
if(BUILD_SHARED_LIBS)
    set(definitions -DMIRRORBALL_SHARED)
else()
    set(epoxyRequirement epoxy)
    set(headlessRequirement egl)
    set(ioRequirement OpenEXR)
endif()
file(RELATIVE_PATH prefixFromPkgConfig /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
function(mirrorball_pkg_config name library description)
    list(JOIN ARGN ", " requirements)
    configure_file(cmake/mirrorball.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()
mirrorball_pkg_config(mirrorball mirrorball "${PROJECT_DESCRIPTION}" ${glmRequirement} ${epoxyRequirement})
foreach(component ${components})
    mirrorball_pkg_config(mirrorball-${component} mirrorball_${component} "Component ${component} of mirrorball"
        "mirrorball = ${PROJECT_VERSION}" ${${component}Requirement})
endforeach()
