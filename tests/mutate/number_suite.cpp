// SPDX-License-Identifier: MIT
#include "mutate/number_suite.hpp"

#include <fmt/format.h>

#include <array>

#include "render/renderer.hpp"
#include "scene/scene_json.hpp"
#include "support/contract_checks.hpp"
#include "support/hit_match.hpp"
#include "support/picture_checks.hpp"
#include "support/special_lines.hpp"
#include "support/surface_checks.hpp"
#include "verify/thresholds.hpp"
#include "verify/verifier.hpp"

namespace raytorus::mutate {
namespace {

std::optional<std::string> caughtByContract(gpu::Context& context, const trace::ShaderSource& shaders) {
    std::array tracers = {trace::Tracer(context, trace::Query::Nearest, test::contractRays, shaders),
                          trace::Tracer(context, trace::Query::All, test::contractRays, shaders),
                          trace::Tracer(context, trace::Query::Any, test::contractRays, shaders)};
    const test::AnswerRays answer = [&tracers](trace::Query query, const reference::Torus& torus,
                                               const std::vector<trace::TraceRay>& rays) {
        const std::span<const float> values = tracers.at(static_cast<std::size_t>(query)).trace(torus, rays);
        return std::vector<float>(values.begin(), values.end());
    };
    for (const test::ContractCheck& check : test::contractChecks()) {
        const std::string fault = check.fault(answer);
        if (!fault.empty()) {
            return fmt::format("{}: {}", check.name, fault);
        }
    }
    return std::nullopt;
}

std::optional<std::string> caughtBySpecialLines(gpu::Context& context, const trace::ShaderSource& shaders) {
    constexpr std::size_t capacity = 4096;
    judge::Queries queries(context, capacity, shaders);
    for (const test::SpecialLinesOf& kind : test::allSpecialLines()) {
        for (const test::SpecialLines& lines : kind.lines()) {
            const std::vector<judge::Answers> answers = queries.answer(lines.torus, lines.rays);
            for (std::size_t i = 0; i < answers.size(); ++i) {
                const std::string fault = test::mismatch(lines.torus, lines.rays[i], answers[i]);
                if (!fault.empty()) {
                    return fmt::format("{}: {}", kind.name, fault);
                }
            }
        }
    }
    return std::nullopt;
}

std::optional<std::string> caughtBySurface(gpu::Context& context, const trace::ShaderSource& shaders) {
    test::SurfaceProbe probe(context, shaders);
    const test::AskSurface ask = [&probe](const std::vector<test::SurfacePoint>& points) {
        return probe.ask(points);
    };
    for (const test::SurfaceCheck& check : test::surfaceChecks()) {
        const std::string fault = check.fault(ask);
        if (!fault.empty()) {
            return fmt::format("{}: {}", check.name, fault);
        }
    }
    return std::nullopt;
}

// Every class on very thin, ordinary, fat and spindle tori, from near and far.
std::vector<verify::RayGroup> groups() {
    verify::RayGroupChoice choice;
    choice.radii = {0.001F, 0.01F, 0.25F, 0.9F, 1.0F, 1.5F};
    choice.distances = {3.0, 100.0};
    std::vector<verify::RayGroup> groups = verify::chooseRayGroups(choice);
    // Tubes as thin as the rounding of their place.
    groups.push_back({reference::RayClass::camera, 1e-7F, 3.0});
    groups.push_back({reference::RayClass::topCircle, 1e-7F, 3.0, 1e-5, 1e-4});
    groups.push_back({reference::RayClass::dimpleCone, 1.5F, 10.0, 1e-6, 1e-5});
    for (const float radius : {0.01F, 0.5F}) {
        groups.push_back({reference::RayClass::camera, radius, 1e4});
        groups.push_back({reference::RayClass::camera, radius, 1e6});
    }
    // Where the moment of an origin is rounded by as much as the torus is long.
    groups.push_back({reference::RayClass::equatorial, 0.9F, 1e8});
    groups.push_back({reference::RayClass::segment, 0.9F, 1e8});
    return groups;
}

std::optional<std::string> caughtByRays(gpu::Context& context, const trace::ShaderSource& shaders,
                                        const RayChoice& rays, reference::Tier tier) {
    verify::Verifier verifier(context, shaders, 1);  // mutants already run side by side
    for (const verify::RayGroup& group : groups()) {
        if (tier == reference::Tier::Fast && group.distance > 1000.0) {
            continue;  // the fast tier promises little there
        }
        // Where some rays may be wrong, many show that no more are; and the hundredth part of many is many.
        const bool many = group.rayClass == reference::RayClass::dimpleCone ||
                          (group.passesByMargin() && group.minorRadius < 1e-5F) ||
                          (tier == reference::Tier::Fast && group.rayClass == reference::RayClass::inside);
        const std::uint64_t count = rays.perGroup * (many ? 40 : 1);
        const std::vector<std::string> exceeded =
            verify::exceededThresholds(group, verifier.verify(group, rays.seed, count), tier);
        if (!exceeded.empty()) {
            return exceeded.front();
        }
    }
    return std::nullopt;
}

// From far away, where a position that is not the library's is furthest off.
std::optional<std::string> caughtByPositions(gpu::Context& context, const trace::ShaderSource& shaders) {
    const scene::Scene scene =
        scene::readScene(std::filesystem::path(RAYTORUS_SOURCE_DIR) / "golden" / "scenes" / "far_1e5.json");
    render::RenderOptions options;
    options.shaders = shaders;
    const std::string fault = test::offTheTori(render::render(context, scene, options).picture, scene);
    return fault.empty() ? std::nullopt : std::optional("positions of a picture: " + fault);
}

}  // namespace

std::optional<std::string> caughtByNumbers(gpu::Context& context, const Mutant& mutant, const RayChoice& rays,
                                           const Asked& asked) {
    const trace::ShaderSource& shaders = mutant.shaders();
    std::optional<std::string> caught;
    if (asked.rays) {
        caught = caughtByContract(context, shaders);
    }
    if (!caught && asked.rays) {
        caught = caughtByRays(context, shaders, rays, reference::Tier::Exact);
    }
    if (!caught && asked.rays) {
        caught = caughtBySpecialLines(context, shaders);
    }
    if (!caught && asked.fastRays) {
        caught = caughtByRays(context, mutant.fastShaders(), rays, reference::Tier::Fast);
        caught = caught ? std::optional("fast " + *caught) : std::nullopt;
    }
    if (!caught && asked.surface) {
        caught = caughtBySurface(context, shaders);
    }
    if (!caught && asked.pictures) {
        caught = caughtByPositions(context, shaders);
    }
    return caught;
}

}  // namespace raytorus::mutate
