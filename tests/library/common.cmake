# SPDX-License-Identifier: MIT
# For the scripts beside, which hold the library folder to its promise: what they check, how they report.
#
#     cmake -DSCRATCH=<folder> [-DLIBRARY=<folder>] -P <script>
#
# SCRATCH is the script's own folder: it is emptied first. LIBRARY is the folder to check instead of shaders/torus.
cmake_minimum_required(VERSION 3.25)
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
if(NOT DEFINED LIBRARY)
    set(LIBRARY "${root}/shaders/torus")
endif()
if(NOT DEFINED SCRATCH)
    message(FATAL_ERROR "Say where to write: cmake -DSCRATCH=<folder> -P ${CMAKE_SCRIPT_MODE_FILE}")
endif()
file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")
file(GLOB library_files LIST_DIRECTORIES false RELATIVE "${LIBRARY}" "${LIBRARY}/*.glsl")
if(NOT library_files)
    message(FATAL_ERROR "There is no library in ${LIBRARY}.")
endif()

function(fault text)
    message("${text}")
    set_property(GLOBAL APPEND PROPERTY faults "x")
endfunction()

# Ends a script: fails if there was a fault.
function(finish)
    get_property(faults GLOBAL PROPERTY faults)
    list(LENGTH faults count)
    if(count)
        message(FATAL_ERROR "Faults above: ${count}")
    endif()
endfunction()

function(require_tool variable name package)
    find_program(${variable} ${name})
    if(NOT ${variable})
        message(FATAL_ERROR "${name} is missing (Debian package ${package}).")
    endif()
endfunction()

# compile(<spv> <source> arguments...): one glslangValidator command with nothing but the library on its include path;
# a fault unless it succeeds and says nothing.
function(compile module source)
    require_tool(glslang glslangValidator glslang-tools)
    execute_process(COMMAND "${glslang}" --quiet "-I${LIBRARY}" ${ARGN} -o "${module}" "${source}"
        RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(NOT result EQUAL 0 OR NOT said STREQUAL "")
        fault("${source}: ${ARGN}: result ${result}\n${said}")
    endif()
endfunction()

# validate(<spv> <environment>): a fault unless spirv-val accepts the module.
function(validate module environment)
    require_tool(spirv_val spirv-val spirv-tools)
    execute_process(COMMAND "${spirv_val}" --target-env ${environment} "${module}"
        RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(NOT result EQUAL 0)
        fault("${module}: not valid for ${environment}\n${said}")
    endif()
endfunction()

# disassemble(<file> <spv>)
function(disassemble file module)
    require_tool(spirv_dis spirv-dis spirv-tools)
    execute_process(COMMAND "${spirv_dis}" --raw-id --no-indent --no-header --no-color -o "${file}" "${module}"
        COMMAND_ERROR_IS_FATAL ANY)
endfunction()
