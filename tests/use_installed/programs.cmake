# The programs that need components; tests/use_subdirectory builds them too. With EACH_HEADER, every public header also
# proves that it is whole by itself and brings no OpenGL.
set(here ${CMAKE_CURRENT_LIST_DIR})
add_executable(components ${here}/components.cpp)
target_link_libraries(components PRIVATE mirrorball::headless mirrorball::io)
add_test(NAME components COMMAND components)

get_target_property(include mirrorball::mirrorball INTERFACE_INCLUDE_DIRECTORIES)
string(REGEX REPLACE "\\$<BUILD_INTERFACE:([^>]*)>" "\\1" include "${include}")
string(GENEX_STRIP "${include}" include)
list(GET include 0 include)
file(GLOB_RECURSE headers RELATIVE ${include} ${include}/mirrorball/*.h)
if(NOT headers)
    message(FATAL_ERROR "no headers in ${include}")
endif()
set(sources)
set(all "#pragma once\n")
foreach(header ${headers})
    string(MAKE_C_IDENTIFIER ${header} name)
    file(CONFIGURE OUTPUT headers/${name}.cpp CONTENT "#include <${header}>
// What OpenGL's headers, and the loaders in their place, define.
#if defined(GL_VERSION_1_1) || defined(GL_NO_ERROR) || defined(EGL_VERSION)
#error \"${header} brings a header of OpenGL or EGL\"
#endif
")
    list(APPEND sources ${CMAKE_CURRENT_BINARY_DIR}/headers/${name}.cpp)
    string(APPEND all "#include <${header}>\n")
endforeach()
if(EACH_HEADER)
    add_library(each_header OBJECT ${sources})
    target_link_libraries(each_header PRIVATE mirrorball::mirrorball)
endif()

# Together, they live beside another OpenGL loader, whichever comes first.
file(CONFIGURE OUTPUT all_headers.h CONTENT "${all}")
find_package(GLEW REQUIRED)
find_package(OpenGL REQUIRED) # GLEW takes the functions of OpenGL 1.1 from the library itself
add_executable(glew ${here}/glew.cpp ${here}/glew_last.cpp)
target_include_directories(glew PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
target_link_libraries(glew PRIVATE mirrorball::headless mirrorball::io GLEW::GLEW OpenGL::GL)
add_test(NAME glew COMMAND glew)
