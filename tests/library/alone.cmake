# SPDX-License-Identifier: MIT
# The folder needs nothing outside itself: copied to an empty place, a user's shader compiles with one plain command,
# for every stage, Vulkan version and GLSL version promised, without a warning, to valid SPIR-V.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")

file(COPY "${LIBRARY}/" DESTINATION "${SCRATCH}/include")
set(LIBRARY "${SCRATCH}/include")
file(READ "${CMAKE_CURRENT_LIST_DIR}/all_functions.glsl.in" functions)

set(comp_head "layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) buffer Values { vec4 values[]; };")
set(comp_main "vec4 v = values[gl_GlobalInvocationID.x]; values[0] = allFunctions(v.xyz, v.www);")
set(frag_head "layout(location = 0) out vec4 color;")
set(frag_main "color = allFunctions(gl_FragCoord.xyz, vec3(0.0, 0.0, 1.0));")
set(rint_head "#extension GL_EXT_ray_tracing : require")
set(rint_main "vec4 v = allFunctions(gl_ObjectRayOriginEXT, gl_ObjectRayDirectionEXT);
    reportIntersectionEXT(v.w + gl_RayTminEXT + gl_RayTmaxEXT, 0u);")

# check(<stage> <GLSL version> <Vulkan version>)
function(check stage version vulkan)
    set(shader "${SCRATCH}/user_${version}_${vulkan}.${stage}")
    file(WRITE "${shader}" "#version ${version}\n#extension GL_GOOGLE_include_directive : require\n"
        "${${stage}_head}\n${functions}\nvoid main() {\n    ${${stage}_main}\n}\n")
    compile("${shader}.spv" "${shader}" --target-env vulkan${vulkan})
    if(EXISTS "${shader}.spv")
        validate("${shader}.spv" vulkan${vulkan})
    endif()
endfunction()

foreach(vulkan IN ITEMS 1.0 1.1 1.3)
    foreach(version IN ITEMS 450 460)
        check(comp ${version} ${vulkan})
        check(frag ${version} ${vulkan})
    endforeach()
endforeach()
check(rint 460 1.2)
check(rint 460 1.3)
finish()
