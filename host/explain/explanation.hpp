// SPDX-License-Identifier: MIT
// Everything there is to say about one ray and one torus: what the shaders compute, step by step, and the
// truth beside it. Numbers in the brackets are those of the equations in docs/math.md.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reference/torus_reference.hpp"

namespace raytorus::explain {

using reference::Quad;
using reference::Vec3;

/// Which formula finds the roots of the reduced quartic.
enum class RootCase {
    None,         ///< there is no reduced quartic
    Biquadratic,  ///< cz = 0 (or S = 0): a quadratic in t^2 (23)
    FourOrNone,   ///< epsilon < 0 (21)
    Two,          ///< epsilon > 0 (18)
    Multiple,     ///< epsilon = 0: a double root (18)
    Triple,       ///< zeta = 0: three roots are one, y = 0 (18)
};

/// The derivation with its numbers: float as the shaders compute them, Quad exact.
template <class Number>
struct Steps {
    std::array<Number, 5> coefficients{};  ///< c0 to c4 (7)

    bool reduced = false;                ///< the rest has values: R > 0, and for float torusReduceRay is true
    Vec3<Number> origin{};               ///< (a, b, c) (8)
    Vec3<Number> direction{};            ///< (x, y, z) (8)
    Number tubeRadius{};                 ///< w = r / R
    Number shift{}, scale{};             ///< t = shift + scale t' (8)
    Number alpha{}, cz{}, beta{};        ///< (10), (9), (12)
    Number alphaRadial{}, czRadial{};    ///< (13)
    Number betaSum{};                    ///< (11)
    Number gamma{}, delta{}, epsilon{};  ///< (15), (17)
    std::optional<Number> zeta;          ///< (18); complex for epsilon < 0
    Number y{};                          ///< (18), (21)
    Number S{};                          ///< (20)
    RootCase rootCase = RootCase::None;
};

/// A hit as torusIntersect and torusIntersectAll answer it, with torusNormal and torusUv of its position.
struct ShaderHit {
    float t = 0.0F;
    Vec3<float> position{};
    Vec3<float> normal{};
    std::array<float, 2> uv{};
};

enum class Sheet {
    Outer,  ///< the surface
    Inner,  ///< of a spindle: a root of the quartic, but no hit
};

/// Where a root lies on the ray.
enum class RootPlace { Before, Within, Beyond };

/// A real root of the quartic, on the whole line.
struct TrueRoot {
    Quad t{};
    Vec3<Quad> position{};
    Sheet sheet = Sheet::Outer;
    bool entering = false;  ///< the solid of an outer sheet
    RootPlace place = RootPlace::Within;
    Vec3<Quad> normal{};
    std::array<Quad, 2> uv{};
    std::optional<std::size_t> hit;         ///< of Explanation::hits
    std::optional<std::size_t> closedForm;  ///< of Explanation::closedForm

    [[nodiscard]] bool isHit() const { return sheet == Sheet::Outer && place == RootPlace::Within; }
};

/// How a list of answers stands to the truth. Errors are the largest of those that have a true root.
struct AnswerErrors {
    bool answers = true;  ///< false: it does not deal with such a torus
    int expected = 0;
    int found = 0;
    double t = 0.0;         ///< see tError
    double position = 0.0;  ///< in R + r

    [[nodiscard]] bool rightCount() const { return expected == found; }
};

struct Explanation {
    reference::Torus torus{};
    reference::Ray ray{};
    std::vector<std::string> faults;  ///< what is wrong with the input, by the contract of torus.glsl
    std::vector<std::string> notes;   ///< what is special about it

    Steps<float> shader;
    Steps<Quad> exact;

    std::vector<TrueRoot> roots;  ///< ascending
    /// In r, see reference::BasicIntersections.
    double clearance = 0.0, startClearance = 0.0, stopClearance = 0.0;
    bool startsInside = false;

    std::optional<ShaderHit> nearest;  ///< torusIntersect
    bool occluded = false;             ///< torusOccluded
    std::vector<ShaderHit> hits;       ///< torusIntersectAll
    std::vector<float> closedForm;     ///< t of torusClosedFormRoots

    bool agree = true;         ///< the three functions do
    AnswerErrors library;      ///< torusIntersectAll
    AnswerErrors closedForms;  ///< torusClosedFormRoots
    std::string conclusion;
};

/// The size of what is intersected, R + r, in lengths of the direction.
double sizeInT(const reference::Torus& torus, const reference::Ray& ray);

/// In ulp of t, or of (R + r) / 16 if t is shorter than that: the same measure as raytorus-verify's.
double tError(const Explanation& e, const TrueRoot& root, float t);

/// In R + r: of a hit, and of the point that a t stands for.
double positionError(const Explanation& e, const TrueRoot& root, const Vec3<float>& position);
double positionError(const Explanation& e, const TrueRoot& root, float t);

/// |normal - true normal|.
double normalError(const TrueRoot& root, const ShaderHit& hit);

/// The larger of the two, in turns.
double uvError(const TrueRoot& root, const ShaderHit& hit);

/// Has no true root this answer of torusIntersectAll, or of the closed form?
bool isInvented(const Explanation& e, std::size_t hit);
bool isInventedByClosedForm(const Explanation& e, std::size_t root);

/// Which answer belongs to which root where one side has fewer: for each entry of the shorter list its place
/// in the longer one. Both ascend and so do the places, and the sum of the differences is the smallest. For
/// lists of a few entries.
std::vector<std::size_t> matched(const std::vector<Quad>& shorter, const std::vector<Quad>& longer);

/// "ring", "horn", "spindle" or "sphere".
const char* shapeOf(const reference::Torus& torus);

/// "epsilon < 0: four real roots or none (21)"
const char* describe(RootCase rootCase);

}  // namespace raytorus::explain
