// SPDX-License-Identifier: MIT
#include "golden/golden_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/file.hpp"
#include "golden/golden_options.hpp"
#include "methods/methods.hpp"
#include "scene/json_node.hpp"

namespace raytorus::golden {
namespace {

using scene::JsonNode;

constexpr int largestSamples = 4096;

// A name becomes part of file names and of the names of tests.
std::string readName(const JsonNode& node) {
    const std::string name = node.text();
    const bool fits = !name.empty() && std::ranges::all_of(name, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
    if (!fits) {
        node.failExpecting("a name of small letters, digits and _");
    }
    return name;
}

int readSamples(const JsonNode& node) {
    const int samples = node.integer(1, largestSamples);
    const int side = static_cast<int>(std::lround(std::sqrt(samples)));
    if (side * side != samples) {
        node.failExpecting("a square number");
    }
    return side;
}

std::map<std::string, int> readMethods(const JsonNode& node) {
    node.expectObject();
    std::map<std::string, int> methods;
    for (std::size_t i = 0; i < node.value().size(); ++i) {
        const JsonNode allowed = node.child(i);
        const std::string name(allowed.key());
        if (findMethod(name) == nullptr) {
            allowed.fail(fmt::format("there is no method \"{}\" (there are {})", name, methodNames()));
        }
        methods[name] = allowed.integer(0, 1 << 30);
    }
    return methods;
}

Case readCase(const JsonNode& node) {
    node.expectKeys({"name", "catches", "samplesPerPixel", "methods"});
    Case row;
    row.name = readName(node.requiredMember("name"));
    row.catches = node.requiredMember("catches").text();
    if (const auto samples = node.member("samplesPerPixel")) {
        row.samplesPerSide = readSamples(*samples);
    }
    if (const auto methods = node.member("methods")) {
        row.methods = readMethods(*methods);
    }
    return row;
}

}  // namespace

Set::Set(std::filesystem::path goldenFolder) : root(std::move(goldenFolder)) {
    const std::string path = (root / "cases.json").string();
    const Json tree = parseStrictJson(readTextFile(path), path);
    const JsonNode top(tree, path);
    top.expectKeys({"cases"});
    const JsonNode list = top.requiredMember("cases");
    list.expectArray();
    for (std::size_t i = 0; i < list.value().size(); ++i) {
        const JsonNode node = list.child(i);
        Case row = readCase(node);
        if (std::ranges::any_of(rows, [&](const Case& other) { return other.name == row.name; })) {
            node.fail(fmt::format("there are two cases called \"{}\"", row.name));
        }
        rows.push_back(std::move(row));
    }
    if (rows.empty()) {
        list.fail("there is no case");
    }
}

const Case& Set::find(const std::string& name) const {
    const auto found = std::ranges::find(rows, name, &Case::name);
    if (found == rows.end()) {
        throw Error(ExitCode::Usage,
                    fmt::format("no golden case is called \"{}\" ({})", name, listCommand(root)));
    }
    return *found;
}

std::filesystem::path Set::scene(const Case& row) const {
    return root / "scenes" / (row.name + ".json");
}

std::filesystem::path Set::truth(const Case& row) const {
    return root / (row.name + ".exr");
}

std::filesystem::path Set::sidecar(const Case& row) const {
    return root / (row.name + ".json");
}

}  // namespace raytorus::golden
