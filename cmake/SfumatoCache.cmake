# Compiles through ccache. A file that was compiled before is not compiled again, in any clone of this
# project on the same machine, because paths below the checkout are relative for the cache and in the
# compiler's output. A launcher that the user has chosen is kept. CCACHE_DISABLE=1 in the environment
# compiles without ccache.
if(NOT SFUMATO_CCACHE OR CMAKE_CXX_COMPILER_LAUNCHER)
  return()
endif()
find_program(SFUMATO_CCACHE_PROGRAM ccache)
if(NOT SFUMATO_CCACHE_PROGRAM)
  return()
endif()
# ccache's manual requires pch_defines and time_macros with precompiled headers. The headers' times differ
# from clone to clone; their bytes do not.
set(launcher ${CMAKE_COMMAND} -E env
  CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
  CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
  ${SFUMATO_CCACHE_PROGRAM})
# ccache fails if it may not write its folder, for example for a user without a home.
set(probe ${PROJECT_BINARY_DIR}/CMakeFiles/ccache_probe)
file(WRITE ${probe}.cpp "int probe;\n")
execute_process(COMMAND ${launcher} ${CMAKE_CXX_COMPILER} -c ${probe}.cpp -o ${probe}.o
                RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
if(NOT status EQUAL 0)
  message(STATUS "ccache does not work here: compiling without it")
  return()
endif()
foreach(language C CXX)
  set(CMAKE_${language}_COMPILER_LAUNCHER ${launcher})
endforeach()
add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}=.)
