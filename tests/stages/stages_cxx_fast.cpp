// SPDX-License-Identifier: MIT
// The stages of the fast tier, with no operation contracted.
#define TORUS_FAST
#define TORUS_PRECISE
#define TORUS_ROUNDED
#define RAYTORUS_STAGES stages_fast
#include "stages_cxx_body.hpp"

namespace raytorus::test {

const Tier& fastTier() {
    static const Tier tier{"Fast",           false,           stages_fast::reduce, stages_fast::nearest,
                           stages_fast::all, stages_fast::any};
    return tier;
}

}  // namespace raytorus::test
