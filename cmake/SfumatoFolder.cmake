# Builds one static library for each folder of src/, linked only to the folders that it may use.

add_library(sfumato_flags INTERFACE)
target_compile_options(sfumato_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow
                       $<$<BOOL:${SFUMATO_WERROR}>:-Werror>)
# Gives the same bits with any compiler and instruction set: no contraction, and no vectorising of pairs of
# rounded doubles, which g++ 12.2 gets wrong.
target_compile_options(sfumato_flags INTERFACE -ffp-contract=off -fno-math-errno)
if(NOT SFUMATO_WASM)
  # Compiles once for both libraries; position-independent code costs nothing for functions that the shared
  # library does not export.
  target_compile_options(sfumato_flags INTERFACE -fPIC -fvisibility=hidden
                         $<$<COMPILE_LANGUAGE:CXX>:-fvisibility-inlines-hidden>)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 warns falsely of overlapping copies in "text" + std::string (PR 105329), and of writes past a
  # std::vector that has just grown (PR 105562).
  # Collecting garbage after each 512 MB instead of 128 MB saves a tenth of the compile time.
  target_compile_options(sfumato_flags INTERFACE -fno-tree-slp-vectorize -Wno-psabi -Wno-restrict
                         -Wno-stringop-overflow --param=ggc-min-heapsize=524288)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  # std::stable_sort of g++ 12's library uses deprecated functions of the standard.
  target_compile_options(sfumato_flags INTERFACE -Wno-deprecated-declarations)
endif()
if(SFUMATO_SANITIZE)
  # AddressSanitizer checks the sizes of objects. UBSan's checks of sizes and of pointer sums in each lane
  # of a kernel cost two minutes of compiling for each instruction set instead of six seconds.
  target_compile_options(sfumato_flags INTERFACE -fsanitize=${SFUMATO_SANITIZE}
                         -fno-sanitize=object-size,pointer-overflow
                         -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # Sanitizers make programs of 100 MB, which lld links in a fraction of the time.
  target_link_options(sfumato_flags INTERFACE -fsanitize=${SFUMATO_SANITIZE} -fuse-ld=lld)
endif()

# Options for code that runs once: optimising it takes longer than running it. g++ restores options from a
# precompiled header, so each set of options needs its own header.
set(sfumato_cold_options $<$<CONFIG:Release>:-O1>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # At -O1, g++ 12 warns of uninitialised values of an empty std::variant or std::optional.
  list(APPEND sfumato_cold_options -Wno-maybe-uninitialized)
endif()

# sfumato_precompiled_headers(NAME [HEADER...]): a target without code that reads, once, the headers that
# most files include and the headers given here. Set the same usage requirements and options for it as for
# the targets that share it.
function(sfumato_precompiled_headers name)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${source})
  target_precompile_headers(${name} PRIVATE <algorithm> <array> <cmath> <cstdint> <functional> <map>
                            <memory> <optional> <span> <string> <string_view> <variant> <vector>
                            ${ARGN})
endfunction()

# sfumato_precompile(TARGET HEADERS): lets TARGET reuse the headers of HEADERS, if that target exists.
function(sfumato_precompile target headers)
  if(TARGET ${headers})
    target_precompile_headers(${target} REUSE_FROM ${headers})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # With a precompiled std::string, the false warning of PR 105329 has these further names.
      target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overread)
    endif()
  endif()
endfunction()

# sfumato_unity(TARGET SOURCE...): compiles thirty-two files at a time as one, so that the compiler reads,
# instantiates and optimises their headers once. Kernels are long enough to compile alone. Photos are
# excluded because libraries leave out their objects by name, and WebAssembly modules replace some files.
function(sfumato_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 32)
  foreach(source ${ARGN})
    if(source MATCHES "/kernels/|/codecs/photo/|_wasm\\.cpp$|/(viewer_exact|solution_film)\\.cpp$")
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # g++ mistakes a file's private names for names of a header.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# with_users_first(LIST PATTERN): moves files that match the pattern to the front of a list, so that a unity
# build compiles them together, and the templates that they share only once.
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

# sfumato_fast_objects(NAME FROM OBJECTS): for WebAssembly, removes the kernels and the files of
# SFUMATO_FAST_SOURCES from the list FROM, compiles them with -O3, and returns their objects in the list
# OBJECTS.
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

# sfumato_object_library(TARGET OPTION SOURCE...): objects of files of src/, compiled with an additional
# option.
function(sfumato_object_library target option)
  add_library(${target} OBJECT ${ARGN})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${target} PRIVATE sfumato_flags)
  target_compile_options(${target} PRIVATE ${option})
  if(SFUMATO_UNITY)
    sfumato_unity(${target} ${ARGN})
  endif()
endfunction()

# sfumato_read_folders(FOLDERS): reads scripts/folder-order.txt. Returns the folders of src/ that this build
# has in the list FOLDERS, in their order, and in sfumato_FOLDER_uses and sfumato_FOLDER_options the line of
# each. Fails if a folder uses one that is not above it.
function(sfumato_read_folders folders)
  set(order ${PROJECT_SOURCE_DIR}/scripts/folder-order.txt)
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${order})
  set(found)
  file(STRINGS ${order} lines REGEX "^[a-z]+( |:|$)")
  foreach(line ${lines})
    if(NOT line MATCHES "^([a-z]+)( \\(([a-z ]+)\\))?:([a-z/ ]*)$")
      message(FATAL_ERROR "${order}: write \"folder (options): folder folder\" instead of \"${line}\"")
    endif()
    set(name ${CMAKE_MATCH_1})
    separate_arguments(options UNIX_COMMAND "${CMAKE_MATCH_3}")
    separate_arguments(uses UNIX_COMMAND "${CMAKE_MATCH_4}")
    list(FILTER uses EXCLUDE REGEX "/")
    if(SFUMATO_WASM AND "native" IN_LIST options)
      continue()
    endif()
    foreach(other ${uses})
      if(NOT other IN_LIST found)
        message(FATAL_ERROR "${order}: ${name} uses ${other}, which is not above it")
      endif()
    endforeach()
    list(APPEND found ${name})
    set(sfumato_${name}_uses ${uses} PARENT_SCOPE)
    set(sfumato_${name}_options ${options} PARENT_SCOPE)
  endforeach()
  set(${folders} ${found} PARENT_SCOPE)
endfunction()

# sfumato_isa_copies(LIST): replaces each NAME_isa.cpp of a list by NAME_base.cpp, NAME_avx2.cpp and
# NAME_avx512.cpp, which include it and have the options of these instruction sets. Processors other than x86
# have NAME_base.cpp alone.
function(sfumato_isa_copies list)
  set(isas base)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND isas avx2 avx512)
  endif()
  set(avx2_options -mavx2)
  set(avx512_options -mavx512f -mavx512dq -mavx512bw -mavx512vl -mprefer-vector-width=512)
  foreach(source ${${list}})
    file(RELATIVE_PATH path ${CMAKE_CURRENT_SOURCE_DIR} ${source})
    if(path MATCHES "^(.*)_isa\\.cpp$")
      set(name ${CMAKE_MATCH_1})
      list(REMOVE_ITEM ${list} ${source})
      foreach(isa ${isas})
        set(copy ${CMAKE_CURRENT_BINARY_DIR}/isa/${name}_${isa}.cpp)
        file(CONFIGURE OUTPUT ${copy} CONTENT "#include \"${name}_isa.cpp\"\n")
        if(${isa}_options)
          set_source_files_properties(${copy} PROPERTIES COMPILE_OPTIONS "${${isa}_options}"
                                      SKIP_PRECOMPILE_HEADERS ON)
        endif()
        list(APPEND ${list} ${copy})
      endforeach()
    endif()
  endforeach()
  set(${list} ${${list}} PARENT_SCOPE)
endfunction()

# sfumato_folder(NAME): builds library sfumato_NAME from every .cpp in folder NAME except main.cpp, with the
# uses and options of sfumato_read_folders(). Files that match the pattern sfumato_NAME_together, if it is set,
# are compiled as one. NAME_isa.cpp is compiled for each instruction set.
function(sfumato_folder name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(SFUMATO_WASM)
    # WebAssembly has no operating system and no other instruction set. The host decodes pictures and
    # unpacks gzip.
    list(FILTER sources EXCLUDE REGEX "/native/(atomic_file|file|folder|posix)")
    list(FILTER sources EXCLUDE REGEX "/codecs/(png/png_decode|jpeg/|webp/|photo/|image_file|gunzip)")
    # NAME_wasm.cpp replaces NAME.cpp.
    foreach(source ${sources})
      if(source MATCHES "^(.*)_wasm\\.cpp$")
        list(REMOVE_ITEM sources ${CMAKE_MATCH_1}.cpp)
      endif()
    endforeach()
  else()
    list(FILTER sources EXCLUDE REGEX "_wasm\\.cpp$")
  endif()
  # Under ThreadSanitizer, NAME_tsan.cpp replaces NAME.cpp.
  if(SFUMATO_SANITIZE MATCHES "thread")
    list(FILTER sources EXCLUDE REGEX "/tbb_executor\\.cpp$")
  else()
    list(FILTER sources EXCLUDE REGEX "_tsan\\.cpp$")
  endif()
  sfumato_isa_copies(sources)
  if(sfumato_${name}_together)
    with_users_first(sources ${sfumato_${name}_together})
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
  endif()
  set(headers sfumato_headers)
  if("cold" IN_LIST sfumato_${name}_options AND NOT SFUMATO_WASM)
    target_compile_options(sfumato_${name} PRIVATE ${sfumato_cold_options})
    set(headers sfumato_cold_headers)
  endif()
  if(SFUMATO_UNITY)
    sfumato_precompile(sfumato_${name} ${headers})
    sfumato_unity(sfumato_${name} ${sources})
  endif()
  if(SFUMATO_SANITIZE MATCHES "fuzzer" AND NOT "grammar" IN_LIST sfumato_${name}_options)
    # Traced comparisons help a fuzzer to guess words of a grammar. In kernels they would only take half of
    # the time.
    target_compile_options(sfumato_${name} PRIVATE -fno-sanitize-coverage=trace-cmp)
  endif()
  foreach(folder ${sfumato_${name}_uses})
    target_link_libraries(sfumato_${name} PUBLIC sfumato_${folder})
  endforeach()
endfunction()
