// SPDX-License-Identifier: MIT
// The stages of the library as it stands.
#define TORUS_PRECISE
#define RAYTORUS_STAGES stages_exact
#include "stages_cxx_body.hpp"

namespace raytorus::test {

const Tier& exactTier() {
    static const Tier tier{
        "Exact", true, stages_exact::reduce, stages_exact::nearest, stages_exact::all, stages_exact::any};
    return tier;
}

}  // namespace raytorus::test
