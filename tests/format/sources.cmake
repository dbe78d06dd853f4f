# SPDX-License-Identifier: MIT
# raytorus_sources(<variable> <folders> <patterns>): the absolute paths of the project's own files, build folders left out.
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)

function(raytorus_sources variable folders patterns)
    set(globs "")
    foreach(folder IN LISTS folders)
        foreach(pattern IN LISTS patterns)
            list(APPEND globs "${root}/${folder}/${pattern}")
        endforeach()
    endforeach()
    file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE "${root}" ${globs})
    list(FILTER files EXCLUDE REGEX "/(build[^/]*|__pycache__)/")
    list(TRANSFORM files PREPEND "${root}/")
    if(NOT files)
        message(FATAL_ERROR "There is nothing to check in ${folders}.")
    endif()
    set(${variable} "${files}" PARENT_SCOPE)
endfunction()
