// SPDX-License-Identifier: MIT
// Faults that the fast tier alone shows: its last step, and where its march differs from the exact one.
#include "mutate/mutation.hpp"

namespace raytorus::mutate {
namespace {

constexpr const char* march = "torus/march.glsl";
constexpr const char* refine = "torus/refine_fast.glsl";

constexpr Mutation rows[] = {
    {"fast-past-forgotten", march, "past = !TORUS_EXACT && p.g <= 0.0", "past = false",
     "who is past a crossing by rounding goes on", Shows::InNumbers},
    {"fast-step-of-nothing", march, "crosses ? max(x, -lastStep) : max(x, leastStep)", "max(x, -lastStep)",
     "steps that rounding makes zero, for ever", Shows::InNumbers},
    {"fast-never-back", march, "crosses ? max(x, -lastStep) : max(x, leastStep)", "max(x, leastStep)",
     "a crossing that is just behind is taken for one ahead", Shows::InNumbers},
    {"fast-side-kept", refine, "march.side = -march.side", "march.side = march.side",
     "behind a crossing the march goes on as before it", Shows::InNumbers},
    {"fast-reach-kept", refine, "march.reach = torus_firstReach(line, march.side);", "",
     "behind a crossing the first parabola reaches as far as the last before it", Shows::InNumbers},
    {"fast-position-marched", refine, "position = p + x * d", "position = p",
     "the position is where the march stopped", Shows::InNumbers},
    {"fast-t-marched", refine, "crossing = march.u + x", "crossing = march.u", "t is where the march stopped",
     Shows::InNumbers},
    {"fast-slope-without-height", refine, "* invRho * q + p.z * d.z", "* invRho * q", "a term of the slope",
     Shows::InNumbers},
    {"fast-tube-cancels", refine, "(q - r) * (q + r) + p.z * p.z",
     "p.x * p.x + p.y * p.y + p.z * p.z + line.majorRadius * line.majorRadius - r * r - 2.0 * "
     "line.majorRadius * rho",
     "the same written out: in a thin tube nothing is left of it", Shows::InNumbers},
    {"fast-steps-few", refine, "#define TORUS_STEPS 64", "#define TORUS_STEPS 4",
     "what four steps have not found is not there", Shows::InNumbers},
};

}  // namespace

std::span<const Mutation> fastMutations() {
    return rows;
}

}  // namespace raytorus::mutate
