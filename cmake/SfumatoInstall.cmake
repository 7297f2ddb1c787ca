# sfumato::sfumato, the whole library as one archive; sfumato::c, the C interface as a shared library; and
# the places where `cmake --install` puts files. Another project then uses find_package(sfumato) and links
# one of them, or asks pkg-config for the C interface.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(library_folders)
foreach(folder ${source_folders})
  if(NOT "command" IN_LIST sfumato_${folder}_options)
    list(APPEND library_folders ${folder})
  endif()
endforeach()
add_library(sfumato_library STATIC)
add_library(sfumato::sfumato ALIAS sfumato_library)
set_target_properties(sfumato_library PROPERTIES
  OUTPUT_NAME sfumato EXPORT_NAME sfumato LINKER_LANGUAGE CXX)
foreach(folder ${library_folders})
  target_sources(sfumato_library PRIVATE $<TARGET_OBJECTS:sfumato_${folder}>)
endforeach()
target_compile_features(sfumato_library INTERFACE cxx_std_20)
target_include_directories(sfumato_library INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(sfumato_library PUBLIC TBB::tbb
  PRIVATE pugixml::pugixml PkgConfig::SPNG PkgConfig::WEBP PkgConfig::LCMS PkgConfig::EPOXY ZLIB::ZLIB JPEG::JPEG
  ${CMAKE_DL_LIBS})
# The value of SFUMATO_ABI in sfumato.h.
set(sfumato_abi 1)
# sfumato_shared(NAME [EXCLUDE_FROM_ALL]): the C interface as a shared library. It exports only the
# interface's symbols, under the version node of their ABI.
set(exports ${PROJECT_SOURCE_DIR}/src/capi/exports.map)
function(sfumato_shared name)
  add_library(${name} SHARED ${ARGN})
  set_target_properties(${name} PROPERTIES OUTPUT_NAME sfumato LINKER_LANGUAGE CXX
    VERSION ${sfumato_abi}.${PROJECT_VERSION} SOVERSION ${sfumato_abi} LINK_DEPENDS ${exports})
  foreach(folder ${library_folders})
    # Callers supply pixels and the CPU draws, so the reader of photos, the GPU's code and their libraries
    # are not needed.
    target_sources(${name} PRIVATE
      $<FILTER:$<TARGET_OBJECTS:sfumato_${folder}>,EXCLUDE,/codecs/photo/|/sfumato_gpu>)
  endforeach()
  target_link_libraries(${name} PRIVATE TBB::tbb pugixml::pugixml PkgConfig::SPNG PkgConfig::WEBP
    ZLIB::ZLIB JPEG::JPEG)
  target_link_options(${name} PRIVATE -Wl,--version-script=${exports} -Wl,--gc-sections
    -Wl,--as-needed -Wl,--exclude-libs,ALL)
  if(SFUMATO_SANITIZE)
    target_link_options(${name} PUBLIC -fsanitize=${SFUMATO_SANITIZE})
  else()
    target_link_options(${name} PRIVATE -Wl,-z,defs)  # sanitizers leave some symbols to the program
  endif()
endfunction()
sfumato_shared(sfumato_c)
add_library(sfumato::c ALIAS sfumato_c)
set_target_properties(sfumato_c PROPERTIES EXPORT_NAME c)
target_include_directories(sfumato_c INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
# The shared library for packages of other languages. It finds the libraries that it needs beside it before
# anywhere else.
sfumato_shared(sfumato_carried EXCLUDE_FROM_ALL)
set_target_properties(sfumato_carried PROPERTIES BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH "$ORIGIN"
  LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/carried)
target_link_options(sfumato_carried PRIVATE -Wl,--disable-new-dtags)

if(SFUMATO_SANITIZE)
  target_link_options(sfumato_library INTERFACE -fsanitize=${SFUMATO_SANITIZE})
endif()

# Components, for packages that contain parts (docs/packaging.md): runtime is the command, capi the C
# interface and its shared library, cxx the rest of the library, doc the documents. Without a component
# everything except the documents is installed. cxx needs capi, whose CMake configuration loads both.
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/sfumato)
install(TARGETS sfumato RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
install(TARGETS sfumato_library EXPORT sfumato
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT cxx)
install(TARGETS sfumato_c EXPORT sfumato_c LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT capi)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/sfumato DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        COMPONENT cxx FILES_MATCHING PATTERN *.hpp)
install(FILES ${PROJECT_SOURCE_DIR}/include/sfumato/sfumato.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sfumato COMPONENT capi)
# From the file's folder to the prefix, which `cmake --install --prefix` may change.
file(RELATIVE_PATH sfumato_prefix_of_pc "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
configure_file(${PROJECT_SOURCE_DIR}/cmake/sfumato.pc.in ${PROJECT_BINARY_DIR}/sfumato.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/sfumato.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT capi)

install(FILES ${PROJECT_SOURCE_DIR}/docs/man/sfumato.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
        COMPONENT runtime)
install(FILES ${PROJECT_SOURCE_DIR}/completions/sfumato.bash RENAME sfumato
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT runtime)
install(FILES ${PROJECT_SOURCE_DIR}/completions/_sfumato
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT runtime)
install(FILES ${PROJECT_SOURCE_DIR}/completions/sfumato.fish
        DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT runtime)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT doc EXCLUDE_FROM_ALL FILES_MATCHING PATTERN *.md PATTERN figures EXCLUDE
        PATTERN gallery EXCLUDE PATTERN images EXCLUDE PATTERN man EXCLUDE PATTERN tutorial EXCLUDE)

# The output of `make editor`; `sfumato edit` serves it.
install(FILES ${PROJECT_SOURCE_DIR}/build/editor.html OPTIONAL
        DESTINATION ${CMAKE_INSTALL_DATADIR}/sfumato COMPONENT runtime)

install(EXPORT sfumato NAMESPACE sfumato:: FILE sfumatoTargets.cmake DESTINATION ${package_folder}
        COMPONENT cxx)
install(EXPORT sfumato_c NAMESPACE sfumato:: FILE sfumatoCTargets.cmake
        DESTINATION ${package_folder} COMPONENT capi)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/sfumatoConfig.cmake.in
  ${PROJECT_BINARY_DIR}/sfumatoConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/sfumatoConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/sfumatoConfig.cmake
        ${PROJECT_BINARY_DIR}/sfumatoConfigVersion.cmake DESTINATION ${package_folder}
        COMPONENT capi)
