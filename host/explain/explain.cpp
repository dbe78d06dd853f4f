// SPDX-License-Identifier: MIT
#include "explain/explain.hpp"

#include <algorithm>

#include "explain/conclusion.hpp"
#include "explain/exact.hpp"
#include "explain/notes.hpp"
#include "explain/query_device.hpp"

namespace raytorus::explain {
namespace {

// Gives each answer its true root, or each root its answer if there are fewer of those.
template <class Assign>
void match(const std::vector<TrueRoot*>& roots, const std::vector<float>& answers, Assign assign) {
    std::vector<Quad> exact, found(answers.begin(), answers.end());
    for (const TrueRoot* root : roots) {
        exact.push_back(root->t);
    }
    const bool fewerAnswers = found.size() < exact.size();
    const std::vector<std::size_t> places = fewerAnswers ? matched(found, exact) : matched(exact, found);
    for (std::size_t i = 0; i < places.size(); ++i) {
        fewerAnswers ? assign(*roots[places[i]], i) : assign(*roots[i], places[i]);
    }
}

void judgeLibrary(Explanation& e) {
    std::vector<TrueRoot*> roots;
    for (TrueRoot& root : e.roots) {
        if (root.isHit()) {
            roots.push_back(&root);
        }
    }
    std::vector<float> answers;
    for (const ShaderHit& hit : e.hits) {
        answers.push_back(hit.t);
    }
    e.library.expected = static_cast<int>(roots.size());
    e.library.found = static_cast<int>(answers.size());
    match(roots, answers, [&e](TrueRoot& root, std::size_t i) {
        root.hit = i;
        e.library.t = std::max(e.library.t, tError(e, root, e.hits[i].t));
        e.library.position = std::max(e.library.position, positionError(e, root, e.hits[i].position));
    });
    const bool some = !e.hits.empty();
    e.agree = e.nearest.has_value() == some && e.occluded == some &&
              (!some || (e.nearest->t == e.hits[0].t && e.nearest->position == e.hits[0].position));
}

void judgeClosedForm(Explanation& e) {
    e.closedForms.answers = e.exact.reduced && e.exact.tubeRadius <= 100;  // TORUS_CLOSED_FORM_WIDEST
    if (!e.closedForms.answers) {
        return;
    }
    std::vector<TrueRoot*> roots;
    for (TrueRoot& root : e.roots) {
        roots.push_back(&root);
    }
    e.closedForms.expected = static_cast<int>(roots.size());
    e.closedForms.found = static_cast<int>(e.closedForm.size());
    match(roots, e.closedForm, [&e](TrueRoot& root, std::size_t i) {
        root.closedForm = i;
        e.closedForms.t = std::max(e.closedForms.t, tError(e, root, e.closedForm[i]));
        e.closedForms.position = std::max(e.closedForms.position, positionError(e, root, e.closedForm[i]));
    });
}

}  // namespace

Explanation explain(gpu::Context& context, const reference::Torus& torus, const reference::Ray& ray,
                    const trace::ShaderSource& shaders) {
    Explanation e;
    e.torus = torus;
    e.ray = ray;
    e.faults = faultsOf(torus, ray);
    queryDevice(context, shaders, e);
    if (e.faults.empty()) {
        const reference::Intersections truth = reference::intersect(torus, ray);
        e.startsInside = truth.startsInside;
        e.clearance = truth.clearance;
        e.startClearance = truth.startClearance;
        e.stopClearance = truth.stopClearance;
        e.exact = exactSteps(torus, ray);
        e.roots = trueRoots(torus, ray, e.exact);
        e.notes = notesOf(e);
    }
    judgeLibrary(e);
    judgeClosedForm(e);
    e.conclusion = conclusionOf(e);
    return e;
}

}  // namespace raytorus::explain
