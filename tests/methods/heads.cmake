# SPDX-License-Identifier: MIT
# MethodFiles.cmake in a project of its own: a file in the folder is a method, its head is its row, and a head that says
# too little ends the configuration with a sentence that names the file.
#
#     cmake -DSCRATCH=<folder> [-DGENERATOR=<generator>] -P heads.cmake
cmake_minimum_required(VERSION 3.25)
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
file(REMOVE_RECURSE "${SCRATCH}")
set(generator "")
if(DEFINED GENERATOR)
    set(generator -G "${GENERATOR}")
endif()
file(WRITE "${SCRATCH}/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)\nproject(scratch LANGUAGES NONE)
function(raytorus_compile_shaders target)
    add_library(\${target} INTERFACE)
endfunction()
include(\"${root}/host/methods/MethodFiles.cmake\")
raytorus_embed_methods(found KIND \${KIND} FOLDER \"\${CMAKE_CURRENT_SOURCE_DIR}/files\" SOURCES trace.comp)\n")

# configure(<kind> <head>): with one file, half_way.glsl, whose first lines are the licence's and these.
function(configure kind head)
    file(WRITE "${SCRATCH}/files/half_way.glsl" "// SPDX-License-Identifier: MIT\n${head}\nvoid nothing() {}\n")
    execute_process(COMMAND "${CMAKE_COMMAND}" -S "${SCRATCH}" -B "${SCRATCH}/build" ${generator} -DKIND=${kind}
        OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
    # CMake breaks lines where it likes.
    string(REGEX REPLACE "[ \n]+" " " said "${said}")
    set(said "${said}" PARENT_SCOPE)
    set(result "${result}" PARENT_SCOPE)
endfunction()

# expect_row(<kind> <row> <head>)
function(expect_row kind row head)
    configure(${kind} "${head}")
    if(NOT result EQUAL 0)
        message(SEND_ERROR "a good head does not configure: ${head}\n${said}")
        return()
    endif()
    file(READ "${SCRATCH}/build/found/found.hpp" header)
    string(FIND "${header}" "{${row}, half_way::find}," at)
    if(at EQUAL -1)
        message(SEND_ERROR "no row {${row}, ...} from: ${head}\n${header}")
    endif()
endfunction()

# expect_refusal(<kind> <sentence> <head>)
function(expect_refusal kind sentence head)
    configure(${kind} "${head}")
    string(FIND "${said}" "/files/half_way.glsl: ${sentence}" at)
    if(result EQUAL 0 OR at EQUAL -1)
        message(SEND_ERROR "not refused with \"${sentence}\": ${head}\nresult ${result}: ${said}")
    endif()
endfunction()

set(method "// Method: halving; to the last bit.\n")
expect_row(Method [["half-way", "halving; to the last bit", 2.5e-3, false]] "${method}// Tolerance: 2.5e-3 (R + r).\n")
expect_row(Method [["half-way", "halving; to the last bit", 4e-7, true]]
    "${method}// Tolerance: 4e-7 (R + r).\n// Needs: float64.\n")
expect_row(Baseline [["half-way", "nothing at all", INFINITY, false]] "// Baseline: nothing at all.\n")
expect_row(Baseline [["half-way", "nothing at all", INFINITY, true]] "// Baseline: nothing at all.\n// Needs: float64.\n")

set(tolerance "// Tolerance: 4e-7 (R + r).\n")
set(second [[the second line of this file has to be "// Method: <what it does, for tables>."]])
expect_refusal(Method "${second}" "")
expect_refusal(Method "${second}" "// Halving.\n${tolerance}")
expect_refusal(Method "${second}" "// Baseline: halving.\n${tolerance}")
expect_refusal(Method "${second}" "// Method: halving\n${tolerance}")
expect_refusal(Method "${second}" "// Method: \"halving\".\n${tolerance}")
set(third [[the third line of this file has to be "// Tolerance: <number> (R + r).", the number as 4e-7]])
expect_refusal(Method "${third}" "${method}")
expect_refusal(Method "${third}" "${method}// Tolerance: small.\n")
expect_refusal(Method "${third}" "${method}// Tolerance: 4e-7 r.\n")
expect_refusal(Method [[of needs there is one, "// Needs: float64."]] "${method}${tolerance}// Needs: a miracle.\n")
