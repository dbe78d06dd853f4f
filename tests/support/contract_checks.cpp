// SPDX-License-Identifier: MIT
#include "contract_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "reference/rays.hpp"
#include "special_floats.hpp"
#include "trace/trace_ray.hpp"

namespace raytorus::test {
namespace {

using trace::Query;
using trace::TraceRay;

constexpr float largest = std::numeric_limits<float>::max();

struct BadInput {
    std::string name;
    float majorRadius = 1.0F;
    float minorRadius = 0.25F;
    TraceRay ray{{3, 0, 0}, 0, {-1, 0, 0}, 100};
    float t = 100;  // of every entry of the answer
};

std::vector<BadInput> badInputs() {
    std::vector<BadInput> list;
    const auto add = [&list](const std::string& name, auto change) {
        list.push_back({name});
        change(list.back());
    };
    for (const float bad : {nan, infinity, -infinity}) {
        add(fmt::format("majorRadius {}", bad), [bad](BadInput& b) { b.majorRadius = bad; });
        add(fmt::format("minorRadius {}", bad), [bad](BadInput& b) { b.minorRadius = bad; });
        for (int i = 0; i < 3; ++i) {
            add(fmt::format("origin[{}] {}", i, bad), [=](BadInput& b) { b.ray.origin[i] = bad; });
            add(fmt::format("direction[{}] {}", i, bad), [=](BadInput& b) { b.ray.direction[i] = bad; });
        }
    }
    add("minorRadius 0", [](BadInput& b) { b.minorRadius = 0; });
    add("minorRadius -0.25", [](BadInput& b) { b.minorRadius = -0.25F; });
    add("majorRadius -1", [](BadInput& b) { b.majorRadius = -1; });
    add("direction 0", [](BadInput& b) { b.ray.direction[0] = 0; });
    add("direction -0", [](BadInput& b) { b.ray.direction[0] = -0.0F; });
    add("tMin > tMax", [](BadInput& b) { b.ray.tMin = 101; });
    add("tMin nan", [](BadInput& b) { b.ray.tMin = nan; });
    add("tMin inf", [](BadInput& b) { b.ray.tMin = infinity; });
    add("tMin nan and tMax nan", [](BadInput& b) { b.ray.tMin = b.ray.tMax = nan, b.t = 0; });
    add("tMax nan", [](BadInput& b) { b.ray.tMax = nan, b.t = 0; });
    add("tMax -inf", [](BadInput& b) { b.ray.tMax = -infinity, b.t = 0; });
    add("tMax -largest", [](BadInput& b) { b.ray.tMax = b.t = -largest; });
    add("minorRadius -0", [](BadInput& b) { b.minorRadius = -0.0F; });
    add("minorRadius negative denormal", [](BadInput& b) { b.minorRadius = -1e-40F; });
    add("both radii infinite", [](BadInput& b) { b.majorRadius = b.minorRadius = infinity; });
    add("radii whose sum overflows", [](BadInput& b) { b.majorRadius = b.minorRadius = 0.75F * largest; });
    add("radii that cancel", [](BadInput& b) { b.majorRadius = -1, b.minorRadius = 1.25F; });
    add("origin and direction infinite",
        [](BadInput& b) { b.ray.origin[0] = -(b.ray.direction[0] = infinity); });
    add("everything nan", [](BadInput& b) {
        b = {b.name, nan, nan, {{nan, nan, nan}, nan, {nan, nan, nan}, nan}, 0};
    });
    add("everything 0", [](BadInput& b) { b = {b.name, 0, 0, {{0, 0, 0}, 0, {0, 0, 0}, 0}, 0}; });
    add("denormal torus", [](BadInput& b) { b.majorRadius = b.minorRadius = 1e-40F; });
    add("denormal direction", [](BadInput& b) { b.ray.direction[0] = -1e-40F; });
    add("huge torus", [](BadInput& b) { b.majorRadius = b.minorRadius = largest; });
    add("huge direction", [](BadInput& b) { b.ray.direction[0] = -largest; });
    for (const float size : {1e-20F, 1e20F}) {
        add(fmt::format("size {}", size), [size](BadInput& b) {
            b.majorRadius = size;
            b.minorRadius = 0.25F * size;
            b.ray.origin[0] = 3 * size;
            b.ray.tMax = b.t = infinity;
        });
    }
    for (const float length : {1e-25F, 1e25F}) {
        add(fmt::format("direction of length {}", length), [length](BadInput& b) {
            b.ray.direction[0] = -length;
            b.ray.tMax = b.t = infinity;
        });
    }
    add("t beyond float32", [](BadInput& b) {
        b.minorRadius = 15;
        b.ray = {{-0x1p120F, 0, 0}, -largest, {-0x1.3p-59F, 0, 0}, b.t = largest};
    });
    add("origin beyond", [](BadInput& b) { b.ray.origin[1] = largest; });
    return list;
}

std::vector<TraceRay> raysOf(reference::RayClass rayClass, float minorRadius) {
    reference::RayParameters parameters;
    parameters.torus = {1.0F, minorRadius};
    return trace::asTraceRays(reference::generateRays(rayClass, parameters, contractRays));
}

std::vector<TraceRay> cameraRays(float minorRadius) {
    return raysOf(reference::RayClass::camera, minorRadius);
}

bool sameBits(float a, float b) {
    return std::memcmp(&a, &b, sizeof(float)) == 0;
}

// Equal as numbers; a NaN equals nothing.
std::string differenceFrom(const std::vector<float>& expected, const std::vector<float>& actual,
                           const std::string& what) {
    if (actual == expected) {
        return "";
    }
    return fmt::format("{}: {} instead of {}", what, fmt::join(actual, " "), fmt::join(expected, " "));
}

std::string answerFault(const AnswerRays& answer, const BadInput& bad) {
    const auto answerBad = [&](Query query) {
        // The unspoilt ray's answer lies where the bad one's belongs: what is not written is not as expected.
        answer(query, {1.0F, 0.25F}, {BadInput{}.ray});
        return answer(query, {bad.majorRadius, bad.minorRadius}, {bad.ray});
    };
    std::string fault = differenceFrom({0, bad.t, 0, 0, 0, 0, 0, 0}, answerBad(Query::Nearest), bad.name);
    if (fault.empty()) {
        std::vector<float> none(17, 0.0F);
        std::fill(none.begin() + 1, none.begin() + 5, bad.t);
        fault = differenceFrom(none, answerBad(Query::All), bad.name);
    }
    return fault.empty() ? differenceFrom({0}, answerBad(Query::Any), bad.name) : fault;
}

// The exponents by which a scaled ray's lengths and its direction differ from the unscaled one's.
struct Scale {
    int size;
    int direction;

    [[nodiscard]] float t(float value) const { return std::ldexp(value, size - direction); }
};

TraceRay scaledBy(const Scale& scale, TraceRay ray) {
    for (std::size_t i = 0; i < 3; ++i) {
        ray.origin[i] = std::ldexp(ray.origin[i], scale.size);
        ray.direction[i] = std::ldexp(ray.direction[i], scale.direction);
    }
    ray.tMin = scale.t(ray.tMin);
    ray.tMax = std::min(scale.t(ray.tMax), largest);
    return ray;
}

// Whether one ray's 17 floats are those of the unscaled ray, scaled.
bool sameButForScale(const Scale& scale, const float* expected, const float* actual) {
    bool same = actual[0] == expected[0];
    for (int k = 0; same && k < static_cast<int>(expected[0]); ++k) {
        same = sameBits(actual[1 + k], scale.t(expected[1 + k]));
        for (int c = 5 + 3 * k; c < 8 + 3 * k; ++c) {
            same = same && sameBits(actual[c], std::ldexp(expected[c], scale.size));
        }
    }
    return same;
}

std::string badInputFault(const AnswerRays& answer) {
    for (const BadInput& bad : badInputs()) {
        const std::string fault = answerFault(answer, bad);
        if (!fault.empty()) {
            return fault;
        }
    }
    // The unspoilt ray hits: the misses above are not for another reason.
    return differenceFrom({1}, answer(Query::Any, {1.0F, 0.25F}, {BadInput{}.ray}), "the unspoilt ray");
}

std::string infiniteEndFault(const AnswerRays& answer) {
    for (const float tMax : {infinity, largest}) {
        const TraceRay hits{{3, 0, 0}, 0, {-1, 0, 0}, tMax};
        const TraceRay misses{{3, 0, 0}, 0, {1, 0, 0}, tMax};
        const std::vector<float> found = answer(Query::Nearest, {1.0F, 0.25F}, {hits});
        if (found[0] != 1.0F || !(std::abs(found[1] - 1.75F) <= 1e-6F)) {
            return fmt::format("tMax {}: hit {} at t {} instead of 1.75", tMax, found[0], found[1]);
        }
        const float missed = answer(Query::Nearest, {1.0F, 0.25F}, {misses})[1];
        if (missed != tMax) {
            return fmt::format("tMax {}: a miss has t {}", tMax, missed);
        }
    }
    const TraceRay bad{{3, 0, 0}, 0, {-1, 0, 0}, nan};
    const std::string fault =
        differenceFrom({0, 0, 0, 0, 0, 0, 0, 0}, answer(Query::Nearest, {1.0F, 0.25F}, {bad}), "tMax nan");
    if (!fault.empty()) {
        return fault;
    }
    const TraceRay unbounded{{3, 0, 0}, -infinity, {-1, 0, 0}, infinity};
    const float count = answer(Query::All, {1.0F, 0.25F}, {unbounded})[0];
    return count == 4.0F ? "" : fmt::format("the unbounded line has {} hits instead of 4", count);
}

std::string scalingFault(const AnswerRays& answer) {
    const std::vector<TraceRay> rays = cameraRays(0.25F);
    const std::vector<float> unscaled = answer(Query::All, {1.0F, 0.25F}, rays);
    for (const int size : {-40, -13, 1, 7, 40}) {
        for (const int direction : {-30, 0, 17}) {
            const Scale scale{size, direction};
            std::vector<TraceRay> scaled;
            std::transform(rays.begin(), rays.end(), std::back_inserter(scaled),
                           [&scale](const TraceRay& ray) { return scaledBy(scale, ray); });
            const std::vector<float> hits =
                answer(Query::All, {std::ldexp(1.0F, size), std::ldexp(0.25F, size)}, scaled);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                if (!sameButForScale(scale, &unscaled[17 * i], &hits[17 * i])) {
                    return fmt::format("ray {} changes where lengths grow by 2^{}, its direction by 2^{}", i,
                                       size, direction);
                }
            }
        }
    }
    return "";
}

std::string pastTheCountFault(const AnswerRays& answer) {
    const std::vector<TraceRay> rays = cameraRays(0.5F);
    const std::vector<float> hits = answer(Query::All, {1.0F, 0.5F}, rays);
    int partial = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const float* hit = &hits[17 * i];
        const int count = static_cast<int>(hit[0]);
        partial += count > 0 && count < 4 ? 1 : 0;
        for (int k = count; k < 4; ++k) {
            const float* position = hit + 5 + 3 * k;
            if (hit[1 + k] != rays[i].tMax || position[0] != 0 || position[1] != 0 || position[2] != 0) {
                return fmt::format("ray {}: entry {} is past its {} hits and not empty", i, k, count);
            }
        }
        for (int k = 1; k < count; ++k) {
            if (!(hit[k] <= hit[1 + k])) {
                return fmt::format("ray {}: t {} is before t {}", i, hit[k], hit[1 + k]);
            }
        }
    }
    return partial > 0 ? "" : "no ray had entries past its hits";
}

// The normal of the nearest hit, which is that of its position, outward from whichever side it is hit.
std::string hitNormalFault(const AnswerRays& answer) {
    constexpr float minorRadius = 0.25F;
    const reference::Torus torus{1.0F, minorRadius};
    // rho carries half an ulp of R, which turns the tube's radius by 2^-24 R / r.
    constexpr double rounding = 2.4e-7 * (1.0 + 1.0 / double{minorRadius});
    for (const reference::RayClass rayClass : {reference::RayClass::camera, reference::RayClass::inside}) {
        const std::vector<float> hits =
            answer(Query::Nearest, {1.0F, minorRadius}, raysOf(rayClass, minorRadius));
        for (std::size_t i = 0; i < contractRays; ++i) {
            trace::NearestHit hit;
            std::memcpy(&hit, &hits[i * trace::hitFloats(Query::Nearest)], sizeof(hit));
            if (hit.hit == 0.0F) {
                continue;
            }
            const auto exact = reference::toDouble(reference::normal(torus, reference::toQuad(hit.position)));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (!(std::abs(double{hit.normal[axis]} - exact[axis]) <= rounding)) {
                    return fmt::format("{} ray {}: the normal is {} instead of {}",
                                       reference::nameOf(rayClass), i, fmt::join(hit.normal, " "),
                                       fmt::join(exact, " "));
                }
            }
        }
    }
    return "";
}

}  // namespace

std::span<const ContractCheck> contractChecks() {
    static constexpr std::array checks = {
        ContractCheck{"bad input", badInputFault},
        ContractCheck{"infinite ends", infiniteEndFault},
        ContractCheck{"scaling by powers of two", scalingFault},
        ContractCheck{"entries past the count", pastTheCountFault},
        ContractCheck{"normals of hits", hitNormalFault},
    };
    return checks;
}

}  // namespace raytorus::test
