// SPDX-License-Identifier: MIT
#include "explain/conclusion.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "explain/notes.hpp"
#include "explain/number_text.hpp"
#include "reference/promise.hpp"

namespace raytorus::explain {
namespace {

bool isGross(const Explanation& e) {
    const double size = double{e.torus.majorRadius} + double{e.torus.minorRadius};
    return !(e.library.position * size <= reference::grossError(e.torus));
}

bool isTouch(const Explanation& e) {
    return e.agree && reference::differByTouches(e.clearance, e.library.expected, e.library.found);
}

// Is what differs no more than the hits at the ends of the ray that the contract leaves open?
bool isLeftOpen(const Explanation& e) {
    const double margin = reference::clearEndMargin(e.torus);
    const int open = (e.startClearance < margin ? 1 : 0) + (e.stopClearance < margin ? 1 : 0);
    return open > 0 && std::abs(e.library.expected - e.library.found) <= open;
}

// "misses both roots", "misses 2 of 4 hits", "invents 1 hit".
std::string wrongCount(const AnswerErrors& list, const char* noun) {
    const int missed = list.expected - list.found;
    if (missed < 0) {
        return fmt::format("invents {}", counted(-missed, noun));
    }
    if (missed < list.expected) {
        return fmt::format("misses {} of {}", missed, counted(list.expected, noun));
    }
    return missed == 1   ? fmt::format("misses the {}", noun)
           : missed == 2 ? fmt::format("misses both {}s", noun)
                         : fmt::format("misses all {}", counted(missed, noun));
}

std::string errors(const AnswerErrors& list) {
    return fmt::format("t off by at most {} ulp, positions by {} (R + r)", roughly(list.t),
                       roughly(list.position));
}

std::string ofLibrary(const Explanation& e) {
    if (!e.library.rightCount() && isTouch(e) && isRight(e)) {
        return "the library keeps its contract: where a ray touches the surface, it has both hits or neither";
    }
    if ((!e.library.rightCount() || !e.agree) && isRight(e)) {
        return "the library keeps its contract: at an end of the ray, where a hit may go either way, answers "
               "differ";
    }
    if (!e.library.rightCount()) {
        return fmt::format("the library {}", wrongCount(e.library, "hit"));
    }
    if (!e.agree) {
        return "torusIntersect, torusOccluded and torusIntersectAll disagree";
    }
    if (e.hits.empty()) {
        return "the library is right: no hit";
    }
    return fmt::format("the library is {} {}, {}",
                       isGross(e) ? "wrong: of its" : "right:", counted(e.library.found, "hit"),
                       errors(e.library));
}

std::string ofClosedForm(const Explanation& e) {
    if (!e.closedForms.answers) {
        return "the closed form does not answer";
    }
    if (!e.closedForms.rightCount()) {
        return fmt::format("the closed form {}", wrongCount(e.closedForms, "root"));
    }
    if (e.closedForm.empty()) {
        return "the closed form finds no root";
    }
    return fmt::format("the closed form finds {}, {}", counted(e.closedForms.found, "root"),
                       errors(e.closedForms));
}

}  // namespace

bool isRight(const Explanation& e) {
    const bool counts =
        (e.library.rightCount() && e.agree) || (e.faults.empty() && (isLeftOpen(e) || isTouch(e)));
    return counts && (e.hits.empty() || !isGross(e));
}

std::string conclusionOf(const Explanation& e) {
    if (!e.faults.empty()) {
        return isRight(e) ? "the library is right: no hit for bad input"
                          : "the library is wrong: a hit for bad input";
    }
    std::string sentence = fmt::format("{}; {}", ofLibrary(e), ofClosedForm(e));
    if (e.clearance < reference::clearMargin) {
        sentence += e.clearance < negligible
                        ? ": the line is a tangent"
                        : fmt::format(": the line passes within {} r of a tangent", roughly(e.clearance));
    }
    return sentence;
}

}  // namespace raytorus::explain
