# SPDX-License-Identifier: MIT
# CPack runs it before it fills the folder of the tar.
get_filename_component(folder "${CMAKE_INSTALL_PREFIX}" ABSOLUTE)
execute_process(COMMAND "${CPACK_RAYTORUS_SOURCE}/scripts/bundle" --build "${CPACK_RAYTORUS_BUILD}" --output "${folder}"
    COMMAND_ERROR_IS_FATAL ANY)
