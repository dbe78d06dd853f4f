// SPDX-License-Identifier: MIT
// The zero of a function between two points where it differs in sign.
//
// Regula falsi with the weights of Anderson and Björck ("A new high order method of regula falsi type", BIT
// 13, 1973), every fourth step a bisection, so that the bracket halves whatever the function. The first step
// is one: at an end where the function only touches zero its sign is noise, and regula falsi would stay
// there.
#pragma once

#include "reference/real.hpp"

namespace raytorus::reference {

// Ends when the bracket is no longer than `enough`. Never by small steps: from an end where the function all
// but vanishes regula falsi creeps, however far away the zero is.
template <class Real, class Function>
Real bracketedRoot(const Function& f, Real low, Real atLow, Real high, Real atHigh, Real enough) {
    const bool highNegative = atHigh < Real(0);
    const Real half(0.5);
    const Real leastStep = enough * half;
    // At most 4 * mantissaBits steps: bisection alone would have ended after as many of its own.
    for (int step = 1; step < 4 * mantissaBits<Real> && high - low > enough; ++step) {
        const bool bisect = step % 4 == 1;
        Real x = bisect ? (low + high) * half : low + (high - low) * (atLow / (atLow - atHigh));
        // Stepping over the zero closes the bracket once an end is next to it.
        if (x < low + leastStep) x = low + leastStep;
        if (x > high - leastStep) x = high - leastStep;
        const Real value = f(x);
        if (value == Real(0)) return x;
        const bool replacesHigh = (value < Real(0)) == highNegative;
        Real& replaced = replacesHigh ? atHigh : atLow;
        Real& kept = replacesHigh ? atLow : atHigh;
        if (!bisect && replaced != Real(0)) {
            const Real weight = Real(1) - value / replaced;
            kept = kept * (weight > Real(0) ? weight : half);
        }
        replaced = value;
        (replacesHigh ? high : low) = x;
    }
    return (low + high) * half;
}

}  // namespace raytorus::reference
