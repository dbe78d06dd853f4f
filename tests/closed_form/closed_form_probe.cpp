// SPDX-License-Identifier: MIT
#include "closed_form_probe.hpp"

#include <algorithm>
#include <cstring>

#include "closed_form_cxx.hpp"
#include "gpu/commands.hpp"
#include "gpu/pipeline.hpp"
#include "raytorus_closed_form_shaders.hpp"
#include "support/device_fixture.hpp"

namespace raytorus::test {
namespace {

static_assert(sizeof(ClosedFormQuery) == 8 * sizeof(float));
static_assert(sizeof(ClosedFormAnswer) == 32 * sizeof(float));

RootsAnswer answer(const QuarticRoots<float>& found) {
    RootsAnswer roots{static_cast<float>(found.count), {}};
    std::copy(found.roots.begin(), found.roots.end(), roots.roots);
    return roots;
}

QuarticAnswer answer(const ReducedQuartic<float>& quartic) {
    return {quartic.alpha, quartic.cz, quartic.beta};
}

}  // namespace

std::vector<ClosedFormAnswer> answersOfDevice(const std::vector<ClosedFormQuery>& queries) {
    const gpu::Buffer input =
        gpu::makeBuffer(device(), std::span<const ClosedFormQuery>(queries), gpu::BufferUse::Storage);
    const gpu::Buffer output(device(), queries.size() * sizeof(ClosedFormAnswer), gpu::BufferUse::ReadBack);
    gpu::PipelineLayoutInfo info;
    info.bindings = {{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}, {1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
    info.pushConstantBytes = sizeof(std::uint32_t);
    const gpu::ShaderModule shader(device(), closed_form_shaders::find("closed_form.comp"),
                                   "closed_form.comp");
    gpu::Pipeline pipeline = gpu::makeComputePipeline(device(), shader, info);
    pipeline.bind(0, input);
    pipeline.bind(1, output);
    const auto count = static_cast<std::uint32_t>(queries.size());
    device().submit([&](VkCommandBuffer commands) {
        pipeline.use(commands, std::as_bytes(std::span(&count, 1)));
        vkCmdDispatch(commands, (count + 63) / 64, 1, 1);
        gpu::bufferBarrier(commands, output, gpu::shaderWrite, gpu::hostRead);
    });
    std::vector<ClosedFormAnswer> answers(queries.size());
    std::memcpy(answers.data(), output.data(), answers.size() * sizeof(ClosedFormAnswer));
    return answers;
}

ClosedFormAnswer answerOfCxx(const ClosedFormQuery& query) {
    using Cxx = ClosedFormCxx<float>;
    const Triple<float> origin = std::to_array(query.origin);
    const Triple<float> direction = std::to_array(query.direction);
    const float R = query.majorRadius;
    const float r = query.minorRadius;
    ClosedFormAnswer result{};
    const std::array<float, 5> c = Cxx::quarticCoefficients(R, r, origin, direction);
    std::copy(c.begin(), c.end(), result.coefficients);
    Cxx::Ray ray;
    result.meets = Cxx::reduceRay(R, r, origin, direction, ray) ? 1.0F : 0.0F;
    result.t = answer(Cxx::closedFormRoots(R, r, origin, direction));
    result.axialQuartic = answer(Cxx::axialQuartic(ray));
    result.axial = answer(Cxx::reducedRoots(Cxx::axialQuartic(ray)));
    result.radialQuartic = answer(Cxx::radialQuartic(ray));
    result.radial = answer(Cxx::reducedRootsUnhalved(Cxx::radialQuartic(ray)));
    result.betaSum = Cxx::betaSum(ray);
    result.tubeRadius = ray.tubeRadius;
    result.shift = ray.shift;
    result.scale = ray.scale;
    result.betaProduct = Cxx::betaProduct(ray);
    return result;
}

}  // namespace raytorus::test
