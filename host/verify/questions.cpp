// SPDX-License-Identifier: MIT
#include "verify/questions.hpp"

#include <cstring>

#include "verify/trace_ray.hpp"

namespace raytorus::verify {
namespace {

// Asks one question, and puts each answer where it belongs.
template <typename Answer>
void askOne(render::Tracer& tracer, const reference::Torus& torus, const std::vector<render::TraceRay>& rays,
            std::vector<Answers>& answers, Answer Answers::*member) {
    const std::span<const float> values = tracer.trace(torus.majorRadius, torus.minorRadius, rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        std::memcpy(&(answers[i].*member), &values[i * sizeof(Answer) / sizeof(float)], sizeof(Answer));
    }
}

}  // namespace

Questions::Questions(gpu::Context& context, std::size_t capacity, const render::ShaderSource& shaders)
    : nearest(context, render::Query::Nearest, capacity, shaders),
      all(context, render::Query::All, capacity, shaders),
      any(context, render::Query::Any, capacity, shaders) {}

std::vector<Answers> Questions::ask(const reference::Torus& torus, const std::vector<reference::Ray>& rays) {
    const std::vector<render::TraceRay> input = asTraceRays(rays);
    std::vector<Answers> answers(rays.size());
    askOne(nearest, torus, input, answers, &Answers::nearest);
    askOne(all, torus, input, answers, &Answers::all);
    askOne(any, torus, input, answers, &Answers::any);
    return answers;
}

}  // namespace raytorus::verify
