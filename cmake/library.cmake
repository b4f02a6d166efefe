# mirrorball_library(<target>): what the core and every component have in common.
function(mirrorball_library target)
    target_compile_definitions(${target} PRIVATE MIRRORBALL_BUILDING)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:mirrorball_flags>)
    set_target_properties(${target} PROPERTIES
        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON POSITION_INDEPENDENT_CODE ON
        VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
    if(BUILD_SHARED_LIBS AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
        set(map ${PROJECT_SOURCE_DIR}/cmake/exports.map)
        target_link_options(${target} PRIVATE LINKER:--version-script=${map})
        set_target_properties(${target} PROPERTIES LINK_DEPENDS ${map})
    endif()
endfunction()

# mirrorball_component(<name>): the library mirrorball_<name> as mirrorball::<name>.
function(mirrorball_component name)
    set(target mirrorball_${name})
    mirrorball_library(${target})
    add_library(mirrorball::${name} ALIAS ${target})
    target_link_libraries(${target} PUBLIC mirrorball::mirrorball)
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
endfunction()
