// SPDX-License-Identifier: MIT
// What became of the mutations, and whether that is good enough.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "mutate/mutation.hpp"

namespace raytorus::mutate {

/// What a suite of tests made of a mutation.
struct SuiteVerdict {
    bool asked = false;                 ///< false where it has nothing to say: see Shows and Mutant::changes
    std::optional<std::string> caught;  ///< by which case or check; nothing: the mutation survived
};

struct Outcome {
    Mutation mutation;
    SuiteVerdict goldens;             ///< by their truths
    std::optional<std::string> bits;  ///< the golden case in which a CPU driver drew other bits than before
    SuiteVerdict numbers;

    [[nodiscard]] bool caught() const { return goldens.caught || numbers.caught; }
};

struct Totals {
    int all = 0;
    int caught = 0;  ///< by any suite
    int caughtByNumbers = 0;
    int inPictures = 0;  ///< mutations that pictures can show
    int caughtByGoldens = 0;
    int caughtByBits = 0;  ///< of those in pictures; told, not counted for the threshold

    /// The threshold: the goldens alone catch 95 of 100 that they can, and nothing survives both suites.
    [[nodiscard]] bool thresholdHeld() const {
        return caught == all && 100 * caughtByGoldens >= 95 * inPictures;
    }
};

Totals totalsOf(std::span<const Outcome> outcomes);

/// For people: the head of a table, a row of it, and a sentence below it.
std::string headText();
std::string rowText(const Outcome& outcome);
std::string totalsText(const Totals& totals);
/// All of it as a table for docs/testing.md.
std::string outcomesMarkdown(std::span<const Outcome> outcomes);
std::string outcomesJson(std::span<const Outcome> outcomes);

}  // namespace raytorus::mutate
