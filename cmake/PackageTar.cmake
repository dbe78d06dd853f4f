# SPDX-License-Identifier: MIT
# CPack reads it for each kind of package. A tar is the bundle, and the include and the other languages beside it.
if(CPACK_GENERATOR STREQUAL "TGZ")
    set(CPACK_PACKAGE_FILE_NAME "raytorus-${CPACK_PACKAGE_VERSION}-linux-x86_64")
    set(CPACK_MONOLITHIC_INSTALL ON)
    set(CPACK_INSTALL_SCRIPTS "${CPACK_RAYTORUS_SOURCE}/cmake/BundleForTar.cmake")
    set(CPACK_INSTALL_CMAKE_PROJECTS "${CPACK_RAYTORUS_BUILD};raytorus;glsl;/;${CPACK_RAYTORUS_BUILD};raytorus;languages;/")
endif()
