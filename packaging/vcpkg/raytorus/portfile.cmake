# SPDX-License-Identifier: MIT
# The include, from the sources beside this file: text, the same for every triplet.
set(VCPKG_BUILD_TYPE release)
set(VCPKG_POLICY_EMPTY_INCLUDE_FOLDER enabled)

vcpkg_cmake_configure(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/source" OPTIONS -DRAYTORUS_BUILD_HOST=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH share/cmake/raytorus)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/share/cmake")
vcpkg_fixup_pkgconfig()
vcpkg_install_copyright(FILE_LIST "${CMAKE_CURRENT_LIST_DIR}/source/LICENSE")
