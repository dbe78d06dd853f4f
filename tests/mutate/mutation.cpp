// SPDX-License-Identifier: MIT
#include "mutate/mutation.hpp"

#include <fmt/format.h>

#include <string_view>

#include "core/error.hpp"

namespace raytorus::mutate {

std::vector<Mutation> allMutations() {
    std::vector<Mutation> all;
    for (const auto part :
         {shadingMutations(), sceneMutations(), solverMutations(), hitMutations(), fastMutations(),
          arithmeticMutations(), surfaceMutations(), contractMutations()}) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

std::string mutated(const Mutation& mutation, std::string text) {
    const std::string_view before = mutation.before;
    const std::string_view after = mutation.after;
    int count = 0;
    for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at)) {
        text.replace(at, before.size(), after);
        at += after.size();
        ++count;
    }
    if (count != mutation.count) {
        throw Error(ExitCode::Internal,
                    fmt::format("mutation {}: shaders/{} has \"{}\" {} times, the table says {}",
                                mutation.name, mutation.file, before, count, mutation.count));
    }
    return text;
}

}  // namespace raytorus::mutate
