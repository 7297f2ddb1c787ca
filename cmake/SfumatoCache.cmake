# Compiles through ccache, so that a file that was compiled before is not compiled again, in any clone of
# this project on the same machine: paths below the checkout are relative for the cache and in what the
# compiler writes. A launcher that the user has chosen stays. CCACHE_DISABLE=1 in the environment
# compiles without.
if(NOT SFUMATO_CCACHE OR CMAKE_CXX_COMPILER_LAUNCHER)
  return()
endif()
find_program(SFUMATO_CCACHE_PROGRAM ccache)
if(NOT SFUMATO_CCACHE_PROGRAM)
  return()
endif()
# pch_defines and time_macros are what ccache's manual asks for with precompiled headers. Their times
# differ from clone to clone; their bytes do not.
set(cache_settings
  CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
  CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime)
foreach(language C CXX)
  set(CMAKE_${language}_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env ${cache_settings} ${SFUMATO_CCACHE_PROGRAM})
endforeach()
add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}=.)
