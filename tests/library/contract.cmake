# SPDX-License-Identifier: MIT
# What the library declares in public is the contract, no more and no less: structures with their members, functions
# with the names, types and order of their arguments. A change here is a change for every user. There are two headers to
# include: torus.glsl, and closed_form.glsl, the derivation's own steps.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/glsl_text.cmake")

set(contract [[
struct Torus { float majorRadius, float minorRadius, }
struct TorusHit { float t, vec3 position, }
bool torusIntersect(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hit)
bool torusOccluded(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax)
int torusIntersectAll(Torus torus, vec3 origin, float tMin, vec3 direction, float tMax, out TorusHit hits(4))
vec3 torusNormal(Torus torus, vec3 position)
vec2 torusUv(Torus torus, vec3 position)
vec3 torusPosition(Torus torus, vec2 uv)
void torusTangents(Torus torus, vec3 position, out vec3 dPdu, out vec3 dPdv)
float torusDistance(Torus torus, vec3 point)
float torusImplicit(Torus torus, vec3 point)
int torusSelfCheck(float one)
#define TORUS_VERSION_MAJOR
#define TORUS_VERSION_MINOR
#define TORUS_VERSION_PATCH
#define TORUS_VERSION
]])
set(closed_form [[
struct TorusReducedRay { vec3 origin, vec3 direction, float tubeRadius, float shift, float scale, }
struct TorusReducedQuartic { float alpha, float cz, float beta, }
void torusQuarticCoefficients(Torus torus, vec3 origin, vec3 direction, out float c(5))
bool torusReduceRay(Torus torus, vec3 origin, vec3 direction, out TorusReducedRay ray)
float torusBetaSum(TorusReducedRay ray)
float torusBetaProduct(TorusReducedRay ray)
TorusReducedQuartic torusAxialQuartic(TorusReducedRay ray)
TorusReducedQuartic torusRadialQuartic(TorusReducedRay ray)
int torusReducedRoots(TorusReducedQuartic quartic, out float roots(4))
int torusReducedRootsUnhalved(TorusReducedQuartic quartic, out float roots(4))
int torusClosedFormRoots(Torus torus, vec3 origin, vec3 direction, out float t(4))
]])
foreach(header IN ITEMS contract closed_form)
    string(STRIP "${${header}}" ${header})
    string(REPLACE "\n" ";" ${header} "${${header}}")
endforeach()

# Public functions and structures, wherever they stand; of the macros, those about the version.
set(declared "")
foreach(file IN LISTS library_files)
    read_code(code "${LIBRARY}/${file}")
    split_declarations(declarations "${code}")
    foreach(declaration IN LISTS declarations)
        if(declaration MATCHES "^(struct Torus.*|[A-Za-z0-9]+ torus[A-Z].*) ~$")
            set(found "${CMAKE_MATCH_1}")
            list(APPEND declared "${found}")
            if(file STREQUAL "closed_form.glsl")
                if(NOT found IN_LIST closed_form)
                    fault("${file}: not in its contract: ${found}")
                endif()
            elseif(NOT file STREQUAL "torus.glsl" OR found IN_LIST closed_form)
                fault("${file}: public, but not in torus.glsl or closed_form.glsl: ${found}")
            endif()
        endif()
    endforeach()
    string(REGEX MATCHALL "#define TORUS_VERSION[A-Z_]*" defines "${code}")
    list(APPEND declared ${defines})
endforeach()

foreach(declaration IN LISTS contract closed_form)
    if(NOT declaration IN_LIST declared)
        fault("in the contract, not declared: ${declaration}")
    endif()
endforeach()
foreach(declaration IN LISTS declared)
    if(NOT declaration IN_LIST contract AND NOT declaration IN_LIST closed_form)
        fault("declared, not in the contract: ${declaration}")
    endif()
endforeach()
finish()
