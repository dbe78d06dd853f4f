# SPDX-License-Identifier: MIT
# Proves the checks beside alive: each is run on a copy of the library with one thing broken, and has to say so.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
cmake_path(GET LIBRARY PARENT_PATH shaders)
set(count 0)

# run_broken(<script> <what it must say> -D...): in a process of its own.
function(run_broken script expected)
    execute_process(COMMAND "${CMAKE_COMMAND}" "-DSCRATCH=${SCRATCH}/${count}/scratch" ${ARGN}
            -P "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${script}.cmake"
        RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
    string(REGEX REPLACE "[ \n]+" " " said "${said}")
    if(result EQUAL 0 OR NOT said MATCHES "${expected}")
        fault("${script}.cmake on ${SCRATCH}/${count}: result ${result}, does not say \"${expected}\"\n${said}")
    endif()
endfunction()

# replace(<file> <old> <new>)
function(replace file old new)
    file(READ "${file}" text)
    string(REPLACE "${old}" "${new}" changed "${text}")
    if(changed STREQUAL text)
        fault("${file}: nothing to break, no \"${old}\"")
    endif()
    file(WRITE "${file}" "${changed}")
endfunction()

# breaks(<script> <what it must say> <file> <old> <new>): in a copy of the library.
function(breaks script expected file old new)
    math(EXPR count "${count} + 1")
    set(count ${count} PARENT_SCOPE)
    file(COPY "${LIBRARY}" DESTINATION "${SCRATCH}/${count}/shaders")
    replace("${SCRATCH}/${count}/shaders/torus/${file}" "${old}" "${new}")
    run_broken(${script} "${expected}" "-DLIBRARY=${SCRATCH}/${count}/shaders/torus")
endfunction()

# adds(<script> <what it must say> <code>): code at the head of a file that everything includes.
set(guard "#define TORUS_DOUBLE_FLOAT_GLSL\n")
function(adds script expected code)
    breaks(${script} "${expected}" double_float.glsl "${guard}" "${guard}${code}\n")
    set(count ${count} PARENT_SCOPE)
endfunction()

adds(alone "Could not process include directive for header name: ../scene_io.h" "#include \"../scene_io.h\"")
adds(alone "WARNING: .*GL_NONE_such" "#extension GL_NONE_such : enable")

breaks(files "double_float.glsl:1: no include guard TORUS_DOUBLE_FLOAT_GLSL" double_float.glsl
    "_DOUBLE_FLOAT_GLSL" "_D_GLSL")
breaks(files "ray.glsl:1: no \"SPDX" ray.glsl "SPDX" "XPDS")
breaks(files "ray_once.comp: .*torus/ray.glsl:[0-9]+: '[A-Za-z_]+' : (undeclared|no matching)"
    ray.glsl "#include \"double_float.glsl\"" "")
adds(files "double_float.glsl:7: not a file of the folder: #include \"scene_io.h\"" "#include \"scene_io.h\"")
adds(files "the including shader's business: #extension" "#extension GL_EXT_control_flow_attributes : require")
adds(files "no interface in the library: uniform" "uniform float torus_parameter;")
adds(files "neither function nor structure: const float torus_pi = 3.14" "const float torus_pi = 3.14;")
adds(files "neither function nor structure: float torus_state" "float torus_state;")
adds(files "belongs to users: struct Ray" "struct Ray { vec3 origin; };")
adds(files "reserved identifier: torus__twice" "float torus__twice(float x) { return x; }")
adds(files "double_float.glsl:8: swizzle: v.xy" "\nvec2 torus_first(vec3 v) { return v.xy; }")
adds(files "taken in another language: far" "float torus_one(float far) { return far; }")

adds(names "function wrongName" "float wrongName() { return 1.0; }")
adds(names "structure Helper" "struct Helper { float x; }; Helper torus_help() { return Helper(1.0); }")
adds(names "function torus_invPowerOfTwo: overloaded" "vec2 torus_invPowerOfTwo(vec2 v) { return v; }")
adds(names "#define PRECISE: does not begin" "#define PRECISE")
adds(names "variable torus_state: global" "float torus_state; float torus_get() { return torus_state; }")

set(sum "float error = (a - (sum - bInSum)) + (b - bInSum)")
breaks(operations "double_float.glsl:[0-9]+: hits: FAdd is not precise" double_float.glsl
    "TORUS_PRECISE ${sum}" "${sum}")
breaks(operations "double_float.glsl:[0-9]+: hits uses Fma" double_float.glsl "${sum}"
    "float error = fma(a, b, sum)")
breaks(operations "double_float.glsl:[0-9]+: hits uses OpDot" double_float.glsl "${sum}"
    "float error = dot(vec2(a), vec2(b))")
breaks(operations "double_float.glsl:[0-9]+: hits uses Length" double_float.glsl "${sum}"
    "float error = length(vec2(a, b))")
breaks(operations "circle.glsl:[0-9]+: surface uses Atan2" circle.glsl "float turn = q * p"
    "float turn = atan(y, x)")
breaks(operations "circle.glsl:[0-9]+: surface uses Sin" circle.glsl "float a2 = a * a" "float a2 = sin(a)")

breaks(operations "closed_form.glsl:[0-9]+: closed_form uses Cos" closed_form.glsl "cosine = 2.0 * k * k - 1.0"
    "cosine = cos(acos(k))")
breaks(operations "closed_form.glsl:[0-9]+: closed_form: FMul is not precise" closed_form.glsl
    "TORUS_PRECISE float cosine = " "float cosine = ")

breaks(equations "closed_form.glsl: cites equation 99 of docs/math.md" closed_form.glsl "eq. 23)" "eq. 99)")
breaks(equations "closed_form.glsl: mentions math.md [0-9]+ times" closed_form.glsl "math.md, eq. 23)" "math.md, 23)")
breaks(equations "no function torusBetaSum" closed_form.glsl "float torusBetaSum(" "float torusBetaSums(")

breaks(version "torus.glsl says 9.1.0" torus.glsl "VERSION_MAJOR 0" "VERSION_MAJOR 9")
breaks(version "TORUS_VERSION_REQUIRED [0-9]+: result 0" torus.glsl "#error" "//")

breaks(contract "not declared: float torusDistance" torus.glsl "torusDistance(Torus torus, vec3 point)"
    "torusDistance(vec3 point, Torus torus)")
breaks(contract "not in the contract: struct TorusHit" torus.glsl "    vec3 position;"
    "    vec3 position; vec3 normal;")
breaks(contract "not in the contract: float torusArea" torus.glsl "// The nearest hit."
    "float torusArea() { return 1.0; }")
adds(contract "double_float.glsl: public, but not in torus.glsl" "float torusArea() { return 1.0; }")
breaks(contract "in the contract, not declared: float torusBetaSum.TorusReducedRay ray" closed_form.glsl
    "float torusBetaSum(TorusReducedRay ray)" "float torusBetaSum(TorusReducedRay line)")
breaks(contract "closed_form.glsl: not in its contract: float torusArea" closed_form.glsl
    "// A ray brought to R = 1" "float torusArea() { return 1.0; }\n// A ray brought to R = 1")

# What belongs to the folder above, and to the examples.
function(copy_shaders)
    math(EXPR count "${count} + 1")
    set(count ${count} PARENT_SCOPE)
    file(COPY "${shaders}" DESTINATION "${SCRATCH}/${count}")
    file(COPY "${root}/examples" "${root}/README.md" DESTINATION "${SCRATCH}/${count}")
    set(LIBRARY "${SCRATCH}/${count}/shaders/torus" PARENT_SCOPE)
    set(copy "${SCRATCH}/${count}" PARENT_SCOPE)
endfunction()

copy_shaders()
replace("${copy}/shaders/CompileShader.cmake" "DEPFILE \"\${module}.d\"" "")
run_broken(rebuild "own.glsl changed: compiles \"\" instead of" "-DLIBRARY=${LIBRARY}" "-DGENERATOR=${GENERATOR}")
copy_shaders()
replace("${copy}/shaders/CompileShader.cmake" "--depfile" "--no-such-option")
run_broken(rebuild "from nothing: the build fails" "-DLIBRARY=${LIBRARY}" "-DGENERATOR=${GENERATOR}")

foreach(change IN ITEMS "tag{7}|tag{8}|equation 8 stands where 7 should"
        "Identities.ZetaSolvesTheCubic|Identities.ZetaSolvesIt|no test Identities.ZetaSolvesIt")
    string(REPLACE "|" ";" change "${change}")
    list(GET change 0 old)
    list(GET change 1 new)
    list(GET change 2 expected)
    math(EXPR count "${count} + 1")
    file(COPY "${root}/docs/math.md" DESTINATION "${SCRATCH}/${count}")
    replace("${SCRATCH}/${count}/math.md" "${old}" "${new}")
    run_broken(equations "${expected}" "-DMATH=${SCRATCH}/${count}/math.md")
endforeach()

copy_shaders()
replace("${copy}/examples/first_hit.frag" "Torus(1.0, 0.4)" "Torus(1.0)")
run_broken(examples_commands "first_hit.frag -o first_hit.frag.spv: result 2" "-DEXAMPLES=${copy}/examples")
copy_shaders()
file(WRITE "${copy}/examples/extra.comp" "")
run_broken(examples_commands "no command for examples/extra.comp" "-DEXAMPLES=${copy}/examples")
copy_shaders()
replace("${copy}/README.md" "```glsl\n" "```glsl\n\n")
run_broken(examples_readme "does not show" "-DREADME=${copy}/README.md")
copy_shaders()
replace("${copy}/examples/cmake_project/CMakeLists.txt" "find_package(raytorus 0.1 REQUIRED)" "")
run_broken(examples_cmake_project "with_installation/build" "-DEXAMPLES=${copy}/examples" "-DGENERATOR=${GENERATOR}")
copy_shaders()
replace("${copy}/examples/cmake_project/depth.comp" "TORUS_VERSION_REQUIRED 100" "TORUS_VERSION_REQUIRED 990000")
run_broken(examples_cmake_project "the library is older" "-DEXAMPLES=${copy}/examples" "-DGENERATOR=${GENERATOR}")
finish()
