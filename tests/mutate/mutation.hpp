// SPDX-License-Identifier: MIT
// Faults that an engineer could have put into the shaders, as changes of their text: what the tests are worth
// is how many of them they notice.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace raytorus::mutate {

/// Whether pictures can show a fault. For the numeric tests alone are: what no picture uses (surface
/// functions, trace.comp), what no scene can hold (bad input, an end of a ray that is seen), what changes
/// last bits alone, and verdicts so near to a tangent that a truth leaves them open.
enum class Shows { InPictures, InNumbers };

struct Mutation {
    const char* name = "";
    const char* file = "";     ///< in shaders/
    const char* before = "";   ///< stands in the file exactly `count` times ...
    const char* after = "";    ///< ... and each time becomes this
    const char* mistake = "";  ///< what somebody got wrong
    Shows shows = Shows::InPictures;
    int count = 1;
};

// The table, by subject.
std::span<const Mutation> shadingMutations();
std::span<const Mutation> sceneMutations();
std::span<const Mutation> solverMutations();
std::span<const Mutation> hitMutations();
std::span<const Mutation> fastMutations();
std::span<const Mutation> arithmeticMutations();
std::span<const Mutation> surfaceMutations();
std::span<const Mutation> contractMutations();

/// All of it.
std::vector<Mutation> allMutations();

/// The text with the mutation in it. Throws Error{Internal} if `before` does not stand there `count` times: a
/// row that the shaders have left behind fails, it never tests nothing.
std::string mutated(const Mutation& mutation, std::string text);

}  // namespace raytorus::mutate
