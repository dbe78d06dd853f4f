# SPDX-License-Identifier: MIT
# GLSL as text, for what no compiler tells.

# read_code(<variable> <file>): the text without comments. Lines keep their numbers.
function(read_code variable file)
    file(READ "${file}" code)
    string(REGEX REPLACE "//[^\n]*" "" code "${code}")
    set(${variable} "${code}" PARENT_SCOPE)
endfunction()

# line_of(<variable> <code> <text>): the number of the line where the text first stands.
function(line_of variable code text)
    string(FIND "${code}" "${text}" at)
    string(SUBSTRING "${code}" 0 ${at} before)
    string(REGEX REPLACE "[^\n]+" "" before "${before}")
    string(LENGTH "${before}" line)
    math(EXPR line "${line} + 1")
    set(${variable} ${line} PARENT_SCOPE)
endfunction()

# split_declarations(<variable> <code>): the declarations at file scope as a list of one-line texts, function bodies as
# " ~", members of structures kept, their ; as a comma: "struct Torus { float r, } ~", "float f(float x) ~", "int i ~".
function(split_declarations variable code)
    string(REGEX REPLACE "\\\\\n" " " code "${code}")
    string(REGEX REPLACE "(^|\n)[ \t]*#[^\n]*" "\n" code "${code}")
    string(REGEX REPLACE "[ \t\n]+" " " code "${code}")
    while(code MATCHES "struct ([A-Za-z0-9_]+) {([^{}]*)} ?;")
        set(whole "${CMAKE_MATCH_0}")
        string(REPLACE ";" "," members "${CMAKE_MATCH_2}")
        string(REPLACE "${whole}" "struct ${CMAKE_MATCH_1} <${members}> ~" code "${code}")
    endwhile()
    while(code MATCHES "{[^{}]*}")
        string(REGEX REPLACE "{[^{}]*}" "~" code "${code}")
    endwhile()
    string(REPLACE ";" " ~" code "${code}")
    string(REPLACE "<" "{" code "${code}")
    string(REPLACE ">" "}" code "${code}")
    string(REPLACE "[" "(" code "${code}")  # brackets would glue the elements of a list
    string(REPLACE "]" ")" code "${code}")
    string(REGEX REPLACE " *~ *" " ~;" code "${code}")
    set(declarations "")
    foreach(declaration IN LISTS code)
        string(STRIP "${declaration}" declaration)
        if(NOT declaration STREQUAL "")
            list(APPEND declarations "${declaration}")
        endif()
    endforeach()
    set(${variable} "${declarations}" PARENT_SCOPE)
endfunction()
