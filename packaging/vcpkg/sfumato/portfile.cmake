# A port of this checkout, for use from where it lies:
#
#   vcpkg install sfumato --overlay-ports=packaging/vcpkg
#
# It has not been run: no vcpkg was at hand. docs/packaging.md says what was looked at. A port for the
# registry fetches a release in the place of the next two lines.
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

# What an unoptimised build has twice, and what belongs to shells.
file(REMOVE_RECURSE
  "${CURRENT_PACKAGES_DIR}/debug/include"
  "${CURRENT_PACKAGES_DIR}/debug/share"
  "${CURRENT_PACKAGES_DIR}/share/bash-completion"
  "${CURRENT_PACKAGES_DIR}/share/fish"
  "${CURRENT_PACKAGES_DIR}/share/man"
  "${CURRENT_PACKAGES_DIR}/share/zsh")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
