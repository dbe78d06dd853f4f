# SPDX-License-Identifier: MIT
# Whatever decides a hit uses + - * / sqrt, comparisons, min, max, abs, clamp and bit patterns only, each operation
# `precise`; the surface functions use floor beside these. Read from the SPIR-V.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")

# Of an instruction, what GLSL calls it: anything that is not named here is a fault.
set(arithmetic "FAdd|FSub|FMul|FDiv|VectorTimesScalar")
# Negation rounds nothing, nor does a division of bit patterns.
set(harmless "FNegate|\
F(Ord|Unord)[A-Za-z]+|Logical[A-Za-z]+|Select|Phi|Label|Function|FunctionParameter|FunctionCall|Load|\
AccessChain|Variable|Composite[A-Za-z]+|Bitcast|Bitwise[A-Za-z]+|IAdd|ISub|UDiv|IEqual|INotEqual|[SU](Less|Greater)Than(Equal)?|\
Constant[A-Za-z]*|Type[A-Za-z]+|String|ExtInstImport")

# check(<name> <extended instructions allowed> <functions that must be in it> <statements of main>)
function(check name allowed functions statements)
    set(shader "${SCRATCH}/${name}.comp")
    file(WRITE "${shader}" "#version 450\n#extension GL_GOOGLE_include_directive : require\n#include \"closed_form.glsl\"
layout(set = 0, binding = 0, std430) buffer Values { float f[16]; int i; vec3 v; };
void main() {
    Torus torus = Torus(f[0], f[1]);\n${statements}}\n")
    compile("${shader}.spv" "${shader}" -g --target-env vulkan1.1)
    disassemble("${shader}.txt" "${shader}.spv")
    file(STRINGS "${shader}.txt" lines REGEX "^(OpLine|OpDecorate|OpName|%[0-9]+ =) ")
    set(count 0)
    set(place "${shader}")
    foreach(line IN LISTS lines)
        if(line MATCHES "^OpLine %([0-9]+) ([0-9]+)")
            set(place "${file_${CMAKE_MATCH_1}}:${CMAKE_MATCH_2}")
        elseif(line MATCHES "^OpDecorate %([0-9]+) NoContraction")
            set(precise_${CMAKE_MATCH_1} TRUE)
        elseif(line MATCHES "^OpName %[0-9]+ \"(torus[A-Za-z]+)\\(")
            list(REMOVE_ITEM functions "${CMAKE_MATCH_1}")
        elseif(line MATCHES "^%([0-9]+) = OpString \"(.*)\"")
            cmake_path(GET CMAKE_MATCH_2 FILENAME file_${CMAKE_MATCH_1})
        elseif(line MATCHES "^%[0-9]+ = OpExtInst %[0-9]+ %[0-9]+ ([A-Za-z0-9]+)")
            set(instruction "${CMAKE_MATCH_1}")
            if(NOT instruction MATCHES "^(${allowed})$")
                fault("${place}: ${name} uses ${instruction}")
            endif()
        elseif(line MATCHES "^%([0-9]+) = Op(${arithmetic}) ")
            math(EXPR count "${count} + 1")
            if(NOT precise_${CMAKE_MATCH_1})
                fault("${place}: ${name}: ${CMAKE_MATCH_2} is not precise")
            endif()
        elseif(NOT line MATCHES "^%[0-9]+ = Op(${harmless})( |$)" AND line MATCHES "^%[0-9]+ = (Op[A-Za-z]+)")
            fault("${place}: ${name} uses ${CMAKE_MATCH_1}")
        endif()
    endforeach()
    if(functions OR count LESS 30)
        fault("${shader}.txt: ${count} operations, without ${functions}: this is not the library")
    endif()
endfunction()

set(decides "Sqrt|FAbs|FMin|FMax|FClamp|UMin|UMax")
check(hits "${decides}" "torusIntersect;torusOccluded;torusIntersectAll" "    TorusHit hit;
    TorusHit hits[4];
    vec3 origin = vec3(f[2], f[3], f[4]);
    vec3 direction = vec3(f[5], f[6], f[7]);
    bool found = torusIntersect(torus, origin, f[8], direction, f[9], hit);
    bool any = torusOccluded(torus, origin, f[8], direction, f[9]);
    i = torusIntersectAll(torus, origin, f[8], direction, f[9], hits);
    f[0] = found && any ? hit.t : hits[0].t;
")
check(surface "${decides}|Floor"
    "torusNormal;torusUv;torusPosition;torusTangents;torusDistance;torusImplicit" "    vec3 dPdu;
    vec3 dPdv;
    v = torusNormal(torus, v);
    vec2 uv = torusUv(torus, v);
    v = torusPosition(torus, uv);
    torusTangents(torus, v, dPdu, dPdv);
    f[0] = torusDistance(torus, dPdu);
    f[1] = torusImplicit(torus, dPdv);
")
check(closed_form "${decides}" "torusQuarticCoefficients;torusClosedFormRoots;torusReducedRootsUnhalved;torusBetaSum"
    "    vec3 origin = vec3(f[2], f[3], f[4]);
    vec3 direction = vec3(f[5], f[6], f[7]);
    float c[5];
    float roots[4];
    torusQuarticCoefficients(torus, origin, direction, c);
    f[0] = c[0];
    f[3] = c[4];
    i = torusClosedFormRoots(torus, origin, direction, roots);
    f[1] = roots[3];
    TorusReducedRay ray;
    if (torusReduceRay(torus, origin, direction, ray)) {
        i = torusReducedRootsUnhalved(torusRadialQuartic(ray), roots);
        f[2] = torusBetaSum(ray);
        f[4] = roots[3];
    }
")
finish()
