// SPDX-License-Identifier: MIT
// The library's GLSL as C++, stage by stage, for both tiers: what its private structures hold is copied out
// by name, so that a test knows no layout. There is one compilation of the body for each tier.
#pragma once

#include <array>
#include <memory>

#include "reference/torus_reference.hpp"
#include "trace/tracer.hpp"

namespace raytorus::test {

using FloatVec3 = std::array<float, 3>;

/// What torus_reduce and torus_clip make of a ray: torus_Line, by its names.
struct LineStage {
    bool meets;
    float majorRadius, minorRadius;
    FloatVec3 base, baseLow;
    float baseShift, shift;
    FloatVec3 direction, foot;
    float length2, farthest;
    float lower, upper;
    bool fromStart;
    float tPerU, uPerT, unit;
};

/// Where the march is: torus_March.
struct MarchStage {
    float u, side, reach;
    bool searching, refines, certain, known;
    float f, h;
};

/// The parabola g + 2 s x + C x^2 of the next step: torus_Parabola.
struct ParabolaStage {
    float g, s, C;
};

/// A refinement's result, and the hit that is made of it: torus_Crossing and TorusHit.
struct CrossingStage {
    bool found;
    float t;
    FloatVec3 position;
};

/// A point of the line by sums of two floats, and G there: torus_Point. The fast tier has none.
struct PointStage {
    FloatVec3 high, low;
    float shift, shiftLow;
    float tube;
};

/// One ray's way through the solver. Each function calls the one of the library that it is named after.
class StagedRay {
public:
    StagedRay() = default;
    StagedRay(const StagedRay&) = delete;
    StagedRay& operator=(const StagedRay&) = delete;
    virtual ~StagedRay() = default;

    [[nodiscard]] virtual LineStage line() const = 0;
    virtual bool clip(float tMin, float tMax) = 0;
    virtual void startMarch() = 0;
    /// Puts a march at any place of the line, after startMarch. `due` says that a refinement is.
    virtual void place(float u, float side, float reach, bool due) = 0;
    [[nodiscard]] virtual MarchStage march() const = 0;
    [[nodiscard]] virtual ParabolaStage parabola() const = 0;
    [[nodiscard]] virtual float blur() const = 0;
    virtual void search(int steps) = 0;
    virtual CrossingStage refine() = 0;
    [[nodiscard]] virtual PointStage pointAt(float u) const = 0;
};

struct Tier {
    const char* name;
    bool exact;
    std::unique_ptr<StagedRay> (*reduce)(const reference::Torus&, const reference::Ray&);
    /// The three queries. Outputs are NaN before the call: what is not written shows.
    trace::NearestHit (*nearest)(float majorRadius, float minorRadius, const trace::TraceRay&);
    trace::AllHits (*all)(float majorRadius, float minorRadius, const trace::TraceRay&);
    bool (*any)(float majorRadius, float minorRadius, const trace::TraceRay&);
};

const Tier& exactTier();
const Tier& fastTier();

}  // namespace raytorus::test
