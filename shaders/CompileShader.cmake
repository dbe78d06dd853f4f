# SPDX-License-Identifier: MIT
#
# raytorus_compile_shaders(<target> NAMESPACE <namespace> SOURCES <file>... [METHOD <file>]
#                          [DEFINES <name>...])
#
# Compiles GLSL entry points to SPIR-V and embeds them: <target> is a static library whose header, <target>.hpp,
# declares <namespace>::find(name), with the file's name as it stands in SOURCES, without its folder. The modules lie
# beside it in the build folder as <file>.spv. METHOD lets another file than the library answer their rays, if
# they include method.glsl. A change to an included file rebuilds exactly the shaders that include it.
include_guard()

function(raytorus_compile_shaders target)
    cmake_parse_arguments(ARG "" "NAMESPACE;METHOD" "SOURCES;DEFINES" ${ARGN})
    find_package(Vulkan REQUIRED COMPONENTS glslangValidator)  # imported targets belong to the calling folder
    set(embed "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/EmbedSpirv.cmake")
    set(folder "${CMAKE_CURRENT_BINARY_DIR}/${target}")
    file(MAKE_DIRECTORY "${folder}")
    set(options "-I${PROJECT_SOURCE_DIR}/shaders")
    foreach(name IN LISTS ARG_DEFINES)
        list(APPEND options "-D${name}")
    endforeach()
    if(ARG_METHOD)
        cmake_path(ABSOLUTE_PATH ARG_METHOD OUTPUT_VARIABLE path)
        cmake_path(GET path PARENT_PATH include)
        cmake_path(GET path FILENAME name)
        file(CONFIGURE OUTPUT "${folder}/other_method.glsl" CONTENT "#include \"${name}\"\n")
        list(APPEND options "-I${folder}" "-I${include}" -DOTHER_METHOD)
    endif()
    set(modules "")
    foreach(source IN LISTS ARG_SOURCES)
        cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE path)
        cmake_path(GET source FILENAME name)
        set(module "${folder}/${name}.spv")
        add_custom_command(OUTPUT "${module}"
            COMMAND Vulkan::glslangValidator --quiet --target-env vulkan1.3 ${options}
                    --depfile "${module}.d" -o "${module}" "${path}"
            DEPENDS "${path}" DEPFILE "${module}.d" VERBATIM COMMENT "Compiling shader ${name}")
        list(APPEND modules "${module}")
    endforeach()
    add_custom_command(OUTPUT "${folder}/${target}.cpp" "${folder}/${target}.hpp"
        COMMAND "${CMAKE_COMMAND}" "-DMODULES=${modules}" "-DOUTPUT=${folder}/${target}" "-DNAMESPACE=${ARG_NAMESPACE}"
                -P "${embed}"
        DEPENDS ${modules} "${embed}" VERBATIM COMMENT "Embedding ${target}")
    add_library(${target} STATIC "${folder}/${target}.cpp" "${folder}/${target}.hpp")
    target_include_directories(${target} PUBLIC "${folder}")
    target_compile_features(${target} PUBLIC cxx_std_20)
endfunction()
