// SPDX-License-Identifier: MIT
// What can be wrong with a folder of goldens before anything is drawn, and the small JSON files in it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "golden/golden_set.hpp"
#include "image/image.hpp"

namespace raytorus::golden {

/// That a renewal did not come to its end; empty if there is none such.
std::string renewalFault(const Set& set);

/// A sentence each: that, if anything; truths that are missing, truncated, changed or not in the manifest;
/// scenes that have changed since their truth was made; files that no case accounts for; cases without
/// recorded bits.
std::vector<std::string> folderFaults(const Set& set);

/// Why the truth of a case is not to be compared with, by the manifest and its sidecar; empty if it is.
std::string truthFault(const Set& set, const Case& row);

/// The SHA-256 of a picture's size, channels and values: equal if and only if all bits are.
std::string pictureHash(const image::Image& picture);

/// What bits.json holds: the hash of what each case draws on devices that round as IEEE 754 says. Throws
/// Error{File} if it is missing or something else.
std::map<std::string, std::string> readBits(const Set& set);
void writeBits(const Set& set, const std::map<std::string, std::string>& bits, const std::string& reason);

}  // namespace raytorus::golden
