// SPDX-License-Identifier: MIT
// A folder of golden pictures and its table, cases.json. Beside it lie, for each case,
//   scenes/<name>.json   the scene, with the size of the picture
//   <name>.exr           its truth, by the reference
//   <name>.json          where the truth comes from, and why
// and for all of them manifest.json, the SHA-256 of each truth, and bits.json, that of what is drawn.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace raytorus::golden {

struct Case {
    std::string name;
    std::string catches;     ///< what it is there to catch
    int samplesPerSide = 1;  ///< n x n rays a pixel
    /// Other methods that draw the case too, and in how many pixels each may be off by more than the truth
    /// allows.
    std::map<std::string, int> methods;
};

class Set {
public:
    /// Reads cases.json. Throws Error{File} if there is none, Error{Scene} that names the place of a fault in
    /// it.
    explicit Set(std::filesystem::path goldenFolder);

    [[nodiscard]] const std::vector<Case>& cases() const { return rows; }
    /// Throws Error{Usage} if there is no such case.
    [[nodiscard]] const Case& find(const std::string& name) const;

    [[nodiscard]] const std::filesystem::path& folder() const { return root; }
    [[nodiscard]] std::filesystem::path scene(const Case& row) const;
    [[nodiscard]] std::filesystem::path truth(const Case& row) const;
    [[nodiscard]] std::filesystem::path sidecar(const Case& row) const;
    [[nodiscard]] std::filesystem::path manifest() const { return root / "manifest.json"; }
    [[nodiscard]] std::filesystem::path bits() const { return root / "bits.json"; }

private:
    std::filesystem::path root;
    std::vector<Case> rows;
};

}  // namespace raytorus::golden
