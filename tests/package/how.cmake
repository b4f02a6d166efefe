# How the package tests build: SOURCE is this checkout, WORK a folder of the test's own; COMPILER FLAGS LAUNCHER
# BUILD_TYPE GENERATOR LIBDIR are as in this build. Nothing is optimised: that it builds and runs is all that is asked.
string(TOUPPER "${BUILD_TYPE}" upperType)
set(common -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS}
    -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DCMAKE_BUILD_TYPE=${BUILD_TYPE} -DCMAKE_CXX_FLAGS_${upperType}=-O0)

function(run)
    string(JOIN " " line ${ARGN})
    message("$ ${line}")
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
