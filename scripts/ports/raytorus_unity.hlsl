// SPDX-License-Identifier: MIT
// For Unity's Shader Graph: a Custom Function node with this file as its source and RaytorusIntersect as its name. Keep
// raytorus.hlsl beside it. Ports, in this order, all Float or Vector3; Hit is 1 or 0.
#ifndef RAYTORUS_UNITY_HLSL
#define RAYTORUS_UNITY_HLSL

#include "raytorus.hlsl"

void RaytorusIntersect_float(float MajorRadius, float MinorRadius, float3 Origin, float3 Direction, out float Hit, out float Distance,
                             out float3 Position, out float3 Normal) {
    Torus torus = torus_makeTorus(MajorRadius, MinorRadius);
    TorusHit hit;
    bool found = torusIntersect(torus, Origin, 0.0, Direction, 3.0e38, hit);
    Hit = found ? 1.0 : 0.0;
    Distance = hit.t;
    Position = hit.position;
    Normal = torusNormal(torus, hit.position);
}

#endif
