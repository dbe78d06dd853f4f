# SPDX-License-Identifier: MIT
# Packages, by `cpack` in a build folder: two of Debian's, and a tar that is carried to other machines (docs/packages.md).
# raytorus-glsl is the components `glsl` and `languages`, raytorus the programs.
set(CPACK_PACKAGE_NAME raytorus)
set(CPACK_PACKAGE_VENDOR "The raytorus developers")
set(CPACK_PACKAGE_CONTACT "The raytorus developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION "Says where a ray meets a torus: nearest, any and all hits, right in float32 from a million radii away.")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL glsl glsl_licence programs programs_licence)
if(TARGET raytorus_languages)
    list(APPEND CPACK_COMPONENTS_ALL languages)
endif()

# Debian's packages.
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_DEBIAN_GLSL_PACKAGE_NAME raytorus-glsl)
set(CPACK_DEBIAN_GLSL_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_GLSL_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_GLSL_PACKAGE_SUGGESTS "glslang-tools, raytorus (= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_GLSL_DESCRIPTION "${PROJECT_DESCRIPTION}: the include, and the library in other languages.")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME raytorus)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
# Without a driver the programs can do nothing.
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS "mesa-vulkan-drivers | vulkan-icd")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS fonts-dejavu-core)
set(CPACK_COMPONENT_PROGRAMS_DESCRIPTION "Renders, traces, compares and explains tori with Vulkan, and judges the library.")

# Debian wants the licence of each package under this name.
raytorus_install(FILES LICENSE DESTINATION share/doc/raytorus-glsl RENAME copyright COMPONENT glsl_licence EXCLUDE_FROM_ALL)
raytorus_install(FILES LICENSE DESTINATION share/doc/raytorus RENAME copyright COMPONENT programs_licence EXCLUDE_FROM_ALL)

# The tar: scripts/bundle knows how programs are carried.
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_CURRENT_LIST_DIR}/PackageTar.cmake")
set(CPACK_RAYTORUS_SOURCE "${PROJECT_SOURCE_DIR}")
set(CPACK_RAYTORUS_BUILD "${PROJECT_BINARY_DIR}")
if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64" AND TARGET raytorus-view)
    list(APPEND CPACK_GENERATOR TGZ)
endif()

include(CPack)
foreach(package IN ITEMS glsl programs)
    cpack_add_component_group(${package})
endforeach()
cpack_add_component(glsl GROUP glsl)
cpack_add_component(glsl_licence GROUP glsl)
cpack_add_component(languages GROUP glsl)
cpack_add_component(programs GROUP programs)
cpack_add_component(programs_licence GROUP programs)
