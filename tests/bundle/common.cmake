# SPDX-License-Identifier: MIT
# For the scripts beside, which try what scripts/bundle makes: programs run as on a foreign machine.
include("${CMAKE_CURRENT_LIST_DIR}/../library/common.cmake")

# Nothing of this environment but what tells the Vulkan loader of drivers.
set(clean env -i PATH=/usr/bin:/bin "HOME=${SCRATCH}" "TMPDIR=${SCRATCH}")
foreach(variable IN ITEMS VK_DRIVER_FILES VK_ICD_FILENAMES)
    if(DEFINED ENV{${variable}})
        list(APPEND clean "${variable}=$ENV{${variable}}")
    endif()
endforeach()

# started(<exit code> <what it must say> <command...>): in the folder ${where}. What it said is left in said.
function(started code words)
    execute_process(COMMAND ${clean} ${ARGN} WORKING_DIRECTORY "${where}"
        RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(NOT result STREQUAL code OR NOT said MATCHES "${words}")
        string(REPLACE ";" " " command "${ARGN}")
        fault("${command}: result ${result}, not ${code} with \"${words}\"\n${said}")
    endif()
    set(said "${said}" PARENT_SCOPE)
endfunction()

# holds(<JSON> <value> <path...>): a fault unless the JSON has this value there.
function(holds json value)
    string(JSON found ERROR_VARIABLE problem GET "${json}" ${ARGN})
    if(problem OR NOT found MATCHES "^${value}$")
        fault("the JSON's ${ARGN} is \"${found}\", not \"${value}\"")
    endif()
endfunction()
