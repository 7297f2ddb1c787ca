# sfumato::sfumato, the whole library as one archive, and what `cmake --install` puts where.
# Afterwards another project says find_package(sfumato) and links sfumato::sfumato.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(library_folders base document codecs curves formats picture import mesh gather raster solve display
    export gpu api lint options output)
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
  PRIVATE pugixml::pugixml PkgConfig::SPNG PkgConfig::WEBP ZLIB::ZLIB JPEG::JPEG
  ${CMAKE_DL_LIBS})
if(SFUMATO_SANITIZE)
  target_link_options(sfumato_library INTERFACE -fsanitize=${SFUMATO_SANITIZE})
endif()

install(TARGETS sfumato RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS sfumato_library EXPORT sfumato ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/sfumato DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN *.hpp)

install(FILES ${PROJECT_SOURCE_DIR}/docs/man/sfumato.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_SOURCE_DIR}/completions/sfumato.bash RENAME sfumato
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${PROJECT_SOURCE_DIR}/completions/_sfumato
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${PROJECT_SOURCE_DIR}/completions/sfumato.fish
        DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/sfumato)
install(EXPORT sfumato NAMESPACE sfumato:: FILE sfumatoTargets.cmake DESTINATION ${package_folder})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/sfumatoConfig.cmake.in
  ${PROJECT_BINARY_DIR}/sfumatoConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/sfumatoConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/sfumatoConfig.cmake
        ${PROJECT_BINARY_DIR}/sfumatoConfigVersion.cmake DESTINATION ${package_folder})
