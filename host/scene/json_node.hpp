// SPDX-License-Identifier: MIT
// A value in a JSON tree together with the way to it, so that each fault names its place. Reads typed values.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "core/strict_json.hpp"

namespace raytorus::scene {

/// Refers to the tree, the source's name and its parent: none of them may go before it does.
/// Each reading function throws Error with ExitCode::Scene if the value is not what it reads.
class JsonNode {
public:
    JsonNode(const Json& root, std::string_view sourceName) : value_(&root), sourceName_(sourceName) {}

    [[nodiscard]] const Json& value() const { return *value_; }
    [[nodiscard]] std::string_view key() const { return key_; }

    /// The value must be an object, without keys other than these.
    void expectKeys(std::initializer_list<std::string_view> known) const;
    void expectObject() const;
    void expectArray() const;

    [[nodiscard]] std::optional<JsonNode> member(std::string_view key) const;
    [[nodiscard]] JsonNode requiredMember(std::string_view key) const;
    /// Of an array or an object, in the order of the file.
    [[nodiscard]] JsonNode child(std::size_t index) const;

    [[nodiscard]] std::string text() const;
    [[nodiscard]] int integer(int minimum, int maximum) const;
    [[nodiscard]] double number() const;
    [[nodiscard]] double positiveNumber() const;
    [[nodiscard]] double nonNegativeNumber() const;
    [[nodiscard]] glm::dvec3 vector() const;
    /// A vector long enough for its direction to survive in float32.
    [[nodiscard]] glm::dvec3 direction() const;
    /// Linear RGB, each >= 0.
    [[nodiscard]] glm::dvec3 light() const;
    /// Linear RGB, each in [0,1].
    [[nodiscard]] glm::dvec3 reflectance() const;

    /// "source: /pointer: fault"
    [[noreturn]] void fail(const std::string& fault) const;
    /// "source: /pointer: -0.1 is not a positive number"
    [[noreturn]] void failExpecting(const std::string& expectation) const;

private:
    JsonNode(const JsonNode& parent, const Json& value)
        : value_(&value), sourceName_(parent.sourceName_), parent_(&parent) {}

    [[nodiscard]] std::string pointer() const;

    const Json* value_;
    std::string_view sourceName_;
    const JsonNode* parent_ = nullptr;
    std::string_view key_ = {};  ///< where the parent is an object
    std::size_t index_ = 0;      ///< where the parent is an array
};

}  // namespace raytorus::scene
