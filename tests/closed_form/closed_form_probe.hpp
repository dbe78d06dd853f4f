// SPDX-License-Identifier: MIT
// The functions of closed_form.glsl, ray by ray: by the device through closed_form.comp, and by the
// same text as C++.
#pragma once

#include <vector>

namespace raytorus::test {

/// A ray and its torus, as closed_form.comp reads them.
struct ClosedFormQuery {
    float majorRadius;
    float minorRadius;
    float origin[3];
    float direction[3];
};

struct RootsAnswer {
    float count;
    float roots[4];
};

struct QuarticAnswer {
    float alpha;
    float cz;
    float beta;
};

/// Every function's answer.
struct ClosedFormAnswer {
    float coefficients[5];
    float meets;
    RootsAnswer t;
    QuarticAnswer axialQuartic;
    RootsAnswer axial;
    QuarticAnswer radialQuartic;
    RootsAnswer radial;
    float betaSum;
    float tubeRadius;
    float shift;
    float scale;
    float betaProduct;
};

std::vector<ClosedFormAnswer> answersOfDevice(const std::vector<ClosedFormQuery>& queries);
ClosedFormAnswer answerOfCxx(const ClosedFormQuery& query);

}  // namespace raytorus::test
