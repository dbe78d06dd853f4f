# SPDX-License-Identifier: MIT
# Each file of the folder keeps the rules that let it be included anywhere, alone or twice, and said in other languages.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/glsl_text.cmake")

# forbid(<file> <code> <what> <regular expression>): a fault at the first match in the code, as a whole word.
function(forbid file code what expression)
    if(code MATCHES "(^|[^A-Za-z0-9_])(${expression})([^A-Za-z0-9_]|$)")
        line_of(line "${code}" "${CMAKE_MATCH_0}")
        string(STRIP "${CMAKE_MATCH_2}" found)
        fault("${file}:${line}: ${what}: ${found}")
    endif()
endfunction()

# Words that C++, HLSL or their platform headers have taken; a name like these breaks there.
set(taken "near|far|half|fixed|small|interface|min16float|min10float|min16int|min12int|min16uint|asm|auto|class|delete|\
new|operator|private|protected|public|template|this|typename|union|register|pass|technique|sampler|texture|vector|\
matrix|string|typedef|static|inline|namespace|using|M_PI|NAN|INFINITY|NULL|TRUE|FALSE")

foreach(file IN LISTS library_files)
    file(READ "${LIBRARY}/${file}" text)
    read_code(code "${LIBRARY}/${file}")
    if(NOT text MATCHES "^(//[^\n]*\n)?(//[^\n]*\n)?// SPDX-License-Identifier: MIT\n")
        fault("${file}:1: no \"SPDX-License-Identifier: MIT\" at the head")
    endif()
    string(TOUPPER "${file}" guard)
    string(REGEX REPLACE "[^A-Z0-9]" "_" guard "${guard}")
    if(NOT guard MATCHES "^TORUS_")
        set(guard "TORUS_${guard}")
    endif()
    if(NOT code MATCHES "^[ \n]*#ifndef ${guard}\n#define ${guard}\n.*\n#endif\n+$")
        fault("${file}:1: no include guard ${guard} around everything")
    endif()

    string(REGEX MATCHALL "#[ \t]*include[^\n]*" includes "${code}")
    foreach(include IN LISTS includes)
        if(NOT include MATCHES "^#include \"([a-z_]+[.]glsl)\" *$" OR NOT EXISTS "${LIBRARY}/${CMAKE_MATCH_1}")
            line_of(line "${code}" "${include}")
            fault("${file}:${line}: not a file of the folder: ${include}")
        endif()
    endforeach()
    string(REGEX REPLACE "#[ \t]*include[^\n]*" "" code "${code}")

    forbid("${file}" "${code}" "the including shader's business" "# *version|# *extension|# *pragma")
    forbid("${file}" "${code}" "no interface in the library"
        "layout|binding|uniform|buffer|shared|attribute|varying|push_constant|gl_[A-Za-z]+")
    forbid("${file}" "${code}" "belongs to users" "struct +Ray")
    if(file STREQUAL "language.glsl")
        # It asks for the version and says how precise ES is, which no other file does.
        string(REGEX REPLACE "__VERSION__|precision highp (float|int);" "" code "${code}")
    endif()
    forbid("${file}" "${code}" "reserved identifier" "[A-Za-z0-9_]*__[A-Za-z0-9_]*|__(LINE|FILE|VERSION)__")
    forbid("${file}" "${code}" "swizzle" "[A-Za-z0-9_]*[.]([xyzw][xyzw]+|[rgba][rgba]+|[stpq][stpq]+)")
    forbid("${file}" "${code}" "array constructor" "[a-z0-9]+\\[[0-9]*\\] *\\(")
    forbid("${file}" "${code}" "taken in another language" "${taken}")
    forbid("${file}" "${code}" "block comment" "/[*]")

    split_declarations(declarations "${code}")
    foreach(declaration IN LISTS declarations)
        if(NOT declaration MATCHES "^(struct [A-Za-z_]+ {.*}|[A-Za-z0-9_]+ [A-Za-z0-9_]+ ?\\(.*\\)) ~$")
            fault("${file}: at file scope, but neither function nor structure: ${declaration}")
        endif()
    endforeach()
endforeach()
finish()

foreach(file IN LISTS library_files)
    foreach(times IN ITEMS once twice)
        string(REPLACE ".glsl" "_${times}.comp" name "${file}")
        set(include "#include \"${file}\"\n")
        if(times STREQUAL "twice")
            string(APPEND include "${include}")
        endif()
        file(WRITE "${SCRATCH}/${name}" "#version 450\n#extension GL_GOOGLE_include_directive : require\n"
            "${include}void main() {}\n")
        compile("${SCRATCH}/${name}.spv" "${SCRATCH}/${name}" --keep-uncalled --target-env vulkan1.1)
    endforeach()
endforeach()
finish()
