// SPDX-License-Identifier: MIT
// The surface functions of the library, asked of the device point by point through probe.comp.
#pragma once

#include <vector>

#include "gpu/context.hpp"
#include "gpu/pipeline.hpp"
#include "trace/shader_source.hpp"

namespace raytorus::test {

/// What the functions are asked about, as probe.comp reads it.
struct SurfacePoint {
    float majorRadius;
    float minorRadius;
    float point[3];
    float uv[2];
    float unused = 0.0F;
};

/// Every function's answer: torusPosition is asked about uv, the others about the point.
struct SurfaceAnswer {
    float normal[3];
    float uv[2];
    float position[3];
    float dPdu[3];
    float dPdv[3];
    float distance;
    float implicit;
    float unused[4];
};

/// Asks one probe.comp: the built-in one, or another.
class SurfaceProbe {
public:
    explicit SurfaceProbe(gpu::Context& context);
    SurfaceProbe(gpu::Context& context, const trace::ShaderSource& shaders);

    std::vector<SurfaceAnswer> ask(const std::vector<SurfacePoint>& points);

private:
    gpu::Context* context;
    gpu::Pipeline pipeline;
};

}  // namespace raytorus::test
