// SPDX-License-Identifier: MIT
// What host and explain.comp exchange: one ray in, everything that the shaders make of it out. The structures hold 32-bit
// numbers and arrays of them alone: std430 and C++ agree on those.
#ifndef RAYTORUS_EXPLAIN_IO_H
#define RAYTORUS_EXPLAIN_IO_H

#ifdef __cplusplus
namespace raytorus::explain_io {
#endif

#define EXPLAIN_BINDING_QUERY 0
#define EXPLAIN_BINDING_ANSWER 1

struct ExplainQuery {
    float majorRadius;
    float minorRadius;
    float origin[3];
    float tMin;
    float direction[3];
    float tMax;
};

struct ExplainHit {
    float t;
    float position[3];
    float normal[3];
    float uv[2];
};

struct ExplainAnswer {
    int found;  // torusIntersect
    ExplainHit nearest;
    int occluded;  // torusOccluded
    int count;     // torusIntersectAll
    ExplainHit hits[4];

    // closed_form.glsl, step by step. From `origin` on all is 0 where `meets` is.
    float coefficients[5];  // torusQuarticCoefficients
    int meets;              // torusReduceRay, and what it reduces to
    float origin[3];
    float direction[3];
    float tubeRadius;
    float shift;
    float scale;
    float alpha;  // torusAxialQuartic
    float cz;
    float beta;
    float alphaRadial;  // torusRadialQuartic
    float czRadial;
    float betaSum;  // torusBetaSum
    float gamma;    // torus_resolvent
    float delta;
    float epsilon;
    float zeta;         // 0 for epsilon < 0
    float y;            // torus_resolventRoot
    float innerSquare;  // of the inner root S: y - 4 alpha / 3
    int rootCount;      // torusClosedFormRoots
    float roots[4];     // t of the ray as given
};

#ifdef __cplusplus
}  // namespace raytorus::explain_io
#endif

#endif
