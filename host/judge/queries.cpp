// SPDX-License-Identifier: MIT
#include "judge/queries.hpp"

#include <cstring>

#include "trace/trace_ray.hpp"

namespace raytorus::judge {
namespace {

// Answers one query, and puts each answer where it belongs.
template <typename Answer>
void answerOne(trace::Tracer& tracer, const reference::Torus& torus, const std::vector<trace::TraceRay>& rays,
               std::vector<Answers>& answers, Answer Answers::*member) {
    const std::span<const float> values = tracer.trace(torus, rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        std::memcpy(&(answers[i].*member), &values[i * sizeof(Answer) / sizeof(float)], sizeof(Answer));
    }
}

}  // namespace

Queries::Queries(gpu::Context& context, std::size_t capacity, const trace::ShaderSource& shaders)
    : nearest(context, trace::Query::Nearest, capacity, shaders),
      all(context, trace::Query::All, capacity, shaders),
      any(context, trace::Query::Any, capacity, shaders) {}

std::vector<Answers> Queries::answer(const reference::Torus& torus, const std::vector<reference::Ray>& rays) {
    const std::vector<trace::TraceRay> input = trace::asTraceRays(rays);
    std::vector<Answers> answers(rays.size());
    answerOne(nearest, torus, input, answers, &Answers::nearest);
    answerOne(all, torus, input, answers, &Answers::all);
    answerOne(any, torus, input, answers, &Answers::any);
    return answers;
}

}  // namespace raytorus::judge
