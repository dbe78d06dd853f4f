// SPDX-License-Identifier: MIT
// Texts of options that several commands have. What is wrong with one is an Error{Usage}.
#pragma once

#include <string>
#include <utility>

#include "reference/rays.hpp"
#include "render/route.hpp"

namespace raytorus::options {

/// Throws Error{Usage} if the output is the file that is read: a slip must not cost it.
void refuseToOverwrite(const char* option, const std::string& output, const std::string& input);

/// Throws Error{Usage} if two outputs are one file, for then one of them is lost.
void refuseSameFile(const char* option, const std::string& output, const char* other,
                    const std::string& otherOutput);

/// --size: "960x640".
std::pair<int, int> sizeOption(const std::string& text);

/// --route: fragment or compute.
render::Route routeOption(const std::string& text);

/// --spp: a square number of samples, up to mostPerSide squared. Returns its root.
int samplesOption(const std::string& text, int mostPerSide);

/// Throws Error{Usage} for a torus beyond what the library answers for. One that is none has to be told apart
/// before.
void requireTorusInRange(const char* option, const reference::Torus& torus, const std::string& text);

/// --replay: ten numbers, as raytorus-verify prints them.
reference::TorusAndRay replayOption(const std::string& text);

}  // namespace raytorus::options
