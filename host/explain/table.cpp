// SPDX-License-Identifier: MIT
#include "explain/table.hpp"

namespace raytorus::explain {
namespace {

// A row takes its two values in the same way from the steps of both sides.
class Rows {
public:
    explicit Rows(const Explanation& explanation) : e(&explanation) {}

    // Coefficients need no reduced ray.
    template <class Of>
    Rows& always(const char* name, const char* equation, Of of) {
        rows.push_back({name, name, equation, of(e->shader), of(e->exact)});
        return *this;
    }
    template <class Of>
    Rows& reduced(const char* name, const char* key, const char* equation, Of of) {
        rows.push_back({name, key, equation,
                        e->shader.reduced ? std::optional<float>(of(e->shader)) : std::nullopt,
                        e->exact.reduced ? std::optional<Quad>(of(e->exact)) : std::nullopt});
        return *this;
    }
    template <class Of>
    Rows& reduced(const char* name, const char* equation, Of of) {
        return reduced(name, name, equation, of);
    }

    std::vector<Row> rows;

private:
    const Explanation* e;
};

std::vector<Row> coefficients(const Explanation& e) {
    return Rows(e)
        .always("c0", "7", [](const auto& s) { return s.coefficients[0]; })
        .always("c1", "7", [](const auto& s) { return s.coefficients[1]; })
        .always("c2", "7", [](const auto& s) { return s.coefficients[2]; })
        .always("c3", "7", [](const auto& s) { return s.coefficients[3]; })
        .always("c4", "7", [](const auto& s) { return s.coefficients[4]; })
        .rows;
}

std::vector<Row> reducedRay(const Explanation& e) {
    return Rows(e)
        .reduced("a", "8", [](const auto& s) { return s.origin[0]; })
        .reduced("b", "8", [](const auto& s) { return s.origin[1]; })
        .reduced("c", "8", [](const auto& s) { return s.origin[2]; })
        .reduced("x", "8", [](const auto& s) { return s.direction[0]; })
        .reduced("y", "8", [](const auto& s) { return s.direction[1]; })
        .reduced("z", "8", [](const auto& s) { return s.direction[2]; })
        .reduced("w", "8", [](const auto& s) { return s.tubeRadius; })
        .reduced("shift", "8", [](const auto& s) { return s.shift; })
        .reduced("scale", "8", [](const auto& s) { return s.scale; })
        .rows;
}

std::vector<Row> reducedQuartic(const Explanation& e) {
    return Rows(e)
        .reduced("alpha", "10", [](const auto& s) { return s.alpha; })
        .reduced("alpha, radial", "alphaRadial", "13", [](const auto& s) { return s.alphaRadial; })
        .reduced("cz", "9", [](const auto& s) { return s.cz; })
        .reduced("cz, radial", "czRadial", "13", [](const auto& s) { return s.czRadial; })
        .reduced("beta", "12", [](const auto& s) { return s.beta; })
        .reduced("beta, as a sum", "betaSum", "11", [](const auto& s) { return s.betaSum; })
        .rows;
}

std::vector<Row> resolvent(const Explanation& e) {
    std::vector<Row> rows = Rows(e)
                                .reduced("gamma", "15", [](const auto& s) { return s.gamma; })
                                .reduced("delta", "15", [](const auto& s) { return s.delta; })
                                .reduced("epsilon", "17", [](const auto& s) { return s.epsilon; })
                                .rows;
    rows.push_back({"zeta", "zeta", "18", e.shader.reduced ? e.shader.zeta : std::nullopt, e.exact.zeta});
    const std::vector<Row> rest = Rows(e)
                                      .reduced("y", "18, 21", [](const auto& s) { return s.y; })
                                      .reduced("S", "20", [](const auto& s) { return s.S; })
                                      .rows;
    rows.insert(rows.end(), rest.begin(), rest.end());
    return rows;
}

}  // namespace

std::vector<Section> sectionsOf(const Explanation& e) {
    if (!e.faults.empty()) {
        return {};
    }
    std::vector<Section> sections{{"quartic in t", "quartic", coefficients(e)}};
    if (e.exact.reduced || e.shader.reduced) {
        sections.push_back({"reduced ray", "reducedRay", reducedRay(e)});
        sections.push_back({"reduced quartic", "reducedQuartic", reducedQuartic(e)});
        sections.push_back({"resolvent", "resolvent", resolvent(e)});
    }
    return sections;
}

}  // namespace raytorus::explain
