# One static library for each folder of src/, linked only to the folders that it may use.

add_library(sfumato_flags INTERFACE)
target_compile_options(sfumato_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow
                       $<$<BOOL:${SFUMATO_WERROR}>:-Werror>)
# The same bits for any compiler and instruction set: no contraction, and no vectorising of pairs of
# rounded doubles, which g++ 12.2 gets wrong.
target_compile_options(sfumato_flags INTERFACE -ffp-contract=off -fno-math-errno)
if(NOT SFUMATO_WASM)
  # One compilation for both libraries: what the shared one does not export costs it nothing to be
  # position-independent.
  target_compile_options(sfumato_flags INTERFACE -fPIC -fvisibility=hidden
                         $<$<COMPILE_LANGUAGE:CXX>:-fvisibility-inlines-hidden>)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 warns of overlapping copies in "text" + std::string where there are none (PR 105329), and
  # of writes past a std::vector that has just grown (PR 105562).
  target_compile_options(sfumato_flags INTERFACE -fno-tree-slp-vectorize -Wno-psabi -Wno-restrict
                         -Wno-stringop-overflow)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  # std::stable_sort of g++ 12's library uses what the standard has deprecated.
  target_compile_options(sfumato_flags INTERFACE -Wno-deprecated-declarations)
endif()
if(SFUMATO_SANITIZE)
  # Sizes of objects are AddressSanitizer's affair. They and the sums of pointers are looked at in
  # each lane of a kernel: two minutes of compiling for each instruction set instead of six seconds.
  target_compile_options(sfumato_flags INTERFACE -fsanitize=${SFUMATO_SANITIZE}
                         -fno-sanitize=object-size,pointer-overflow
                         -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # Programs of 100 MB with what sanitizers add: lld links them in a fraction of the time.
  target_link_options(sfumato_flags INTERFACE -fsanitize=${SFUMATO_SANITIZE} -fuse-ld=lld)
endif()

# sfumato_precompiled_headers(NAME [HEADER...]): a target of no code that reads once what most files
# include, and the headers named. Its usage requirements and options are to be set as those of the
# targets that share it.
function(sfumato_precompiled_headers name)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${source})
  target_precompile_headers(${name} PRIVATE <algorithm> <array> <cmath> <cstdint> <functional> <map>
                            <memory> <optional> <span> <string> <string_view> <variant> <vector>
                            ${ARGN})
endfunction()

# sfumato_precompile(TARGET HEADERS): TARGET takes what HEADERS has read, where there is such a target.
function(sfumato_precompile target headers)
  if(TARGET ${headers})
    target_precompile_headers(${target} REUSE_FROM ${headers})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # The false warning of PR 105329 has these further names where std::string is precompiled.
      target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overread)
    endif()
  endif()
endfunction()

# sfumato_unity(TARGET SOURCE...): files are compiled sixteen at a time, as one. The compiler reads,
# instantiates and optimises what they include once. Kernels are long enough alone. Libraries leave out
# photos by the names of their objects, and modules of WebAssembly have other files in the place of some.
function(sfumato_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
  foreach(source ${ARGN})
    if(source MATCHES "/kernels/|/codecs/photo|_wasm\\.cpp$|/html/viewer_exact\\.cpp$")
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # It takes what a file has for itself for what a header gives to many.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# with_users_first(LIST PATTERN): moves files that match the pattern to the front of a list of files, so
# that unity compiles them together, and the templates that they share once.
function(with_users_first list pattern)
  set(users)
  foreach(source ${${list}})
    file(STRINGS ${source} uses REGEX ${pattern} LIMIT_COUNT 1)
    if(uses)
      list(APPEND users ${source})
    endif()
  endforeach()
  set(others ${${list}})
  list(REMOVE_ITEM others ${users})
  set(${list} ${users} ${others} PARENT_SCOPE)
endfunction()

# sfumato_fast_objects(NAME FROM OBJECTS): takes the kernels and what SFUMATO_FAST_SOURCES names out of the list
# FROM, for WebAssembly, and gives their objects, compiled with -O3, in the list OBJECTS.
function(sfumato_fast_objects name from objects)
  set(others ${${from}})
  set(fast)
  foreach(source ${others})
    if(source IN_LIST SFUMATO_FAST_SOURCES OR source MATCHES "/kernels/")
      list(APPEND fast ${source})
    endif()
  endforeach()
  if(fast)
    list(REMOVE_ITEM others ${fast})
    set(${from} ${others} PARENT_SCOPE)
    sfumato_object_library(sfumato_${name}_fast -O3 ${fast})
    set(${objects} $<TARGET_OBJECTS:sfumato_${name}_fast> PARENT_SCOPE)
  endif()
endfunction()

# sfumato_object_library(TARGET OPTION SOURCE...): objects of files of src/, compiled with an option of their own.
function(sfumato_object_library target option)
  add_library(${target} OBJECT ${ARGN})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${target} PRIVATE sfumato_flags)
  target_compile_options(${target} PRIVATE ${option})
  if(SFUMATO_UNITY)
    sfumato_unity(${target} ${ARGN})
  endif()
endfunction()

# sfumato_folder(NAME [COLD] [USES folder...] [PRECOMPILED headers] [TOGETHER pattern]): library
# sfumato_NAME from every .cpp in folder NAME but main.cpp, with sfumato_headers where no other headers are
# named. COLD: no loop over pixels or nodes is here, so that -O3 would only cost compiling. TOGETHER: files
# that match are compiled as one. Files that end in _avx2.cpp and _avx512.cpp are compiled for these
# instruction sets.
function(sfumato_folder name)
  cmake_parse_arguments(ARG "COLD" "PRECOMPILED;TOGETHER" "USES" ${ARGN})
  if(NOT ARG_PRECOMPILED)
    set(ARG_PRECOMPILED sfumato_headers)
  endif()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(SFUMATO_WASM)
    # No operating system and no other instruction set there; to decode pictures and to unpack gzip is
    # the host's own affair.
    list(FILTER sources EXCLUDE REGEX "/native/(atomic_file|file|folder|posix)|_avx(2|512)\\.cpp$")
    list(FILTER sources EXCLUDE REGEX "/codecs/(png_decode|jpeg|webp|photo|image_file|gunzip)")
    # NAME_wasm.cpp stands in the place of NAME.cpp.
    foreach(source ${sources})
      if(source MATCHES "^(.*)_wasm\\.cpp$")
        list(REMOVE_ITEM sources ${CMAKE_MATCH_1}.cpp)
      endif()
    endforeach()
  else()
    list(FILTER sources EXCLUDE REGEX "_wasm\\.cpp$")
  endif()
  # ThreadSanitizer sees NAME_tsan.cpp in the place of NAME.cpp.
  if(SFUMATO_SANITIZE MATCHES "thread")
    list(FILTER sources EXCLUDE REGEX "/tbb_executor\\.cpp$")
  else()
    list(FILTER sources EXCLUDE REGEX "_tsan\\.cpp$")
  endif()
  if(ARG_TOGETHER)
    with_users_first(sources ${ARG_TOGETHER})
  endif()
  set(fast_objects)
  if(SFUMATO_WASM)
    sfumato_fast_objects(${name} sources fast_objects)
  endif()
  add_library(sfumato_${name} STATIC ${sources} ${fast_objects})
  target_include_directories(sfumato_${name} PUBLIC ${PROJECT_SOURCE_DIR}/include
                             ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(sfumato_${name} PUBLIC sfumato_flags)
  if(SFUMATO_WASM)
    target_compile_options(sfumato_${name} PRIVATE -Oz)
  elseif(ARG_COLD AND NOT SFUMATO_SANITIZE)
    target_compile_options(sfumato_${name} PRIVATE $<$<CONFIG:Release>:-O2>)
  endif()
  if(SFUMATO_UNITY)
    sfumato_precompile(sfumato_${name} ${ARG_PRECOMPILED})
    sfumato_unity(sfumato_${name} ${sources})
  endif()
  if(SFUMATO_SANITIZE MATCHES "fuzzer" AND NOT name MATCHES "^(base|document|codecs|formats)$")
    # A fuzzer that is told what was compared guesses words of a grammar. Kernels would only spend
    # half of their time on it.
    target_compile_options(sfumato_${name} PRIVATE -fno-sanitize-coverage=trace-cmp)
  endif()
  foreach(folder ${ARG_USES})
    target_link_libraries(sfumato_${name} PUBLIC sfumato_${folder})
  endforeach()
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    foreach(source ${sources})
      if(source MATCHES "_avx2\\.cpp$")
        set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "-mavx2"
                                    SKIP_PRECOMPILE_HEADERS ON)
      elseif(source MATCHES "_avx512\\.cpp$")
        set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS
          "-mavx512f;-mavx512dq;-mavx512bw;-mavx512vl;-mprefer-vector-width=512"
          SKIP_PRECOMPILE_HEADERS ON)
      endif()
    endforeach()
  endif()
endfunction()
