# mirrorball_component(<name>): what every component's library mirrorball_<name> has in common.
function(mirrorball_component name)
    set(target mirrorball_${name})
    add_library(mirrorball::${name} ALIAS ${target})
    target_link_libraries(${target} PUBLIC mirrorball::mirrorball PRIVATE $<BUILD_INTERFACE:mirrorball_flags>)
    target_compile_definitions(${target} PRIVATE MIRRORBALL_BUILDING)
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name}
        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON POSITION_INDEPENDENT_CODE ON
        VERSION ${PROJECT_VERSION} SOVERSION 0)
endfunction()
