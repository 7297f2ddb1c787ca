# A port of this checkout, for use without a registry:
#
#   vcpkg install sfumato --overlay-ports=packaging/vcpkg
#
# It is untested: vcpkg was not available. docs/packaging.md says what was checked. A port for the registry
# downloads a release instead of the next two lines.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_find_acquire_program(PKGCONFIG)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    -DSFUMATO_TESTS=OFF
    -DSFUMATO_WERROR=OFF
    "-DPKG_CONFIG_EXECUTABLE=${PKGCONFIG}")
vcpkg_cmake_install()
vcpkg_copy_tools(TOOL_NAMES sfumato AUTO_CLEAN)
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/sfumato)
vcpkg_fixup_pkgconfig()

# Removes files that a debug build installs twice, and the files for shells.
file(REMOVE_RECURSE
  "${CURRENT_PACKAGES_DIR}/debug/include"
  "${CURRENT_PACKAGES_DIR}/debug/share"
  "${CURRENT_PACKAGES_DIR}/share/bash-completion"
  "${CURRENT_PACKAGES_DIR}/share/fish"
  "${CURRENT_PACKAGES_DIR}/share/man"
  "${CURRENT_PACKAGES_DIR}/share/zsh")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
