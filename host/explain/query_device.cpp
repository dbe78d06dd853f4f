// SPDX-License-Identifier: MIT
#include "explain/query_device.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "explain_io.h"
#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/pipeline.hpp"

namespace raytorus::explain {
namespace {

using explain_io::ExplainAnswer;
using explain_io::ExplainHit;
using explain_io::ExplainQuery;

ExplainQuery queryOf(const reference::Torus& torus, const reference::Ray& ray) {
    ExplainQuery query{torus.majorRadius, torus.minorRadius, {}, ray.tMin, {}, ray.tMax};
    std::copy(std::begin(ray.origin), std::end(ray.origin), query.origin);
    std::copy(std::begin(ray.direction), std::end(ray.direction), query.direction);
    return query;
}

ExplainAnswer answerOf(gpu::Context& context, const trace::ShaderSource& shaders, const ExplainQuery& query) {
    const gpu::Buffer input = gpu::makeBuffer(context, std::span(&query, 1), gpu::BufferUse::Storage);
    const ExplainAnswer nothing{};
    const gpu::Buffer output = gpu::makeBuffer(context, std::span(&nothing, 1), gpu::BufferUse::ReadBack);
    gpu::PipelineLayoutInfo info;
    info.bindings = {{EXPLAIN_BINDING_QUERY, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
                     {EXPLAIN_BINDING_ANSWER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
    const gpu::ShaderModule shader(context, shaders.load("explain.comp"), "explain.comp");
    gpu::Pipeline pipeline = gpu::makeComputePipeline(context, shader, info);
    pipeline.bind(EXPLAIN_BINDING_QUERY, input);
    pipeline.bind(EXPLAIN_BINDING_ANSWER, output);
    context.submit([&](VkCommandBuffer commands) {
        pipeline.use(commands);
        vkCmdDispatch(commands, 1, 1, 1);
        gpu::bufferBarrier(commands, output, gpu::shaderWrite, gpu::hostRead);
    });
    ExplainAnswer answer{};
    std::memcpy(&answer, output.data(), sizeof(answer));
    return answer;
}

ShaderHit hitOf(const ExplainHit& hit) {
    return {hit.t, std::to_array(hit.position), std::to_array(hit.normal), std::to_array(hit.uv)};
}

// As torus_resolventRoot and torus_pairs decide.
RootCase caseOf(const ExplainAnswer& answer) {
    if (answer.meets == 0) {
        return RootCase::None;
    }
    if (answer.cz == 0.0F || !(answer.innerSquare > 0.0F)) {
        return RootCase::Biquadratic;
    }
    if (answer.epsilon < 0.0F) {
        return RootCase::FourOrNone;
    }
    if (answer.zeta == 0.0F) {
        return RootCase::Triple;
    }
    return answer.epsilon > 0.0F ? RootCase::Two : RootCase::Multiple;
}

Steps<float> stepsOf(const ExplainAnswer& answer) {
    Steps<float> steps;
    steps.coefficients = std::to_array(answer.coefficients);
    steps.reduced = answer.meets != 0;
    steps.origin = std::to_array(answer.origin);
    steps.direction = std::to_array(answer.direction);
    steps.tubeRadius = answer.tubeRadius;
    steps.shift = answer.shift;
    steps.scale = answer.scale;
    steps.alpha = answer.alpha;
    steps.cz = answer.cz;
    steps.beta = answer.beta;
    steps.alphaRadial = answer.alphaRadial;
    steps.czRadial = answer.czRadial;
    steps.betaSum = answer.betaSum;
    steps.gamma = answer.gamma;
    steps.delta = answer.delta;
    steps.epsilon = answer.epsilon;
    if (!(answer.epsilon < 0.0F)) {
        steps.zeta = answer.zeta;
    }
    steps.y = answer.y;
    steps.S = std::sqrt(std::max(answer.innerSquare, 0.0F));
    steps.rootCase = caseOf(answer);
    return steps;
}

}  // namespace

void queryDevice(gpu::Context& context, const trace::ShaderSource& shaders, Explanation& explanation) {
    const ExplainAnswer answer = answerOf(context, shaders, queryOf(explanation.torus, explanation.ray));
    explanation.shader = stepsOf(answer);
    if (answer.found != 0) {
        explanation.nearest = hitOf(answer.nearest);
    }
    explanation.occluded = answer.occluded != 0;
    std::transform(answer.hits, answer.hits + std::clamp(answer.count, 0, 4),
                   std::back_inserter(explanation.hits), hitOf);
    explanation.closedForm.assign(answer.roots, answer.roots + std::clamp(answer.rootCount, 0, 4));
}

}  // namespace raytorus::explain
