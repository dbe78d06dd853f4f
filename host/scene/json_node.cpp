// SPDX-License-Identifier: MIT
// Typed values out of a JSON tree, and the sentences about those that are wrong.
#include "scene/json_node.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "core/suggestion.hpp"

namespace raytorus::scene {
namespace {

template <class Predicate>
bool isVector(const Json& value, Predicate accepts) {
    return value.is_array() && value.size() == 3 && std::ranges::all_of(value, [&](const Json& component) {
               return component.is_number() && accepts(component.get<double>());
           });
}

glm::dvec3 toVector(const Json& value) {
    return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

}  // namespace

void JsonNode::expectObject() const {
    if (!value_->is_object()) {
        failExpecting("an object");
    }
}

void JsonNode::expectKeys(std::initializer_list<std::string_view> known) const {
    expectObject();
    for (const auto& [key, value] : value_->get_ref<const Json::object_t&>()) {
        if (std::ranges::find(known, key) == known.end()) {
            std::string hint = suggestion(key, std::vector<std::string>(known.begin(), known.end()));
            if (hint.empty()) {
                hint = fmt::format("; the keys here are {}", fmt::join(known, ", "));
            }
            JsonNode node(*this, value);
            node.key_ = key;
            node.fail("unknown key" + hint);
        }
    }
}

void JsonNode::expectArray() const {
    if (!value_->is_array()) {
        failExpecting("an array");
    }
}

std::optional<JsonNode> JsonNode::member(std::string_view key) const {
    for (const auto& [name, value] : value_->get_ref<const Json::object_t&>()) {
        if (name == key) {
            JsonNode node(*this, value);
            node.key_ = name;
            return node;
        }
    }
    return std::nullopt;
}

JsonNode JsonNode::requiredMember(std::string_view key) const {
    if (const std::optional<JsonNode> found = member(key)) {
        return *found;
    }
    fail(fmt::format("the key '{}' is missing", key));
}

JsonNode JsonNode::child(std::size_t index) const {
    if (value_->is_object()) {
        const auto& [key, value] = value_->get_ref<const Json::object_t&>().data()[index];
        JsonNode node(*this, value);
        node.key_ = key;
        return node;
    }
    JsonNode node(*this, (*value_)[index]);
    node.index_ = index;
    return node;
}

std::string JsonNode::text() const {
    if (!value_->is_string()) {
        failExpecting("a string");
    }
    return value_->get<std::string>();
}

int JsonNode::integer(int minimum, int maximum) const {
    // 12.0 is an integer too: JSON, and so its schemas, know only numbers.
    const double number =
        value_->is_number() ? value_->get<double>() : std::numeric_limits<double>::quiet_NaN();
    if (!(number >= minimum && number <= maximum && number == std::trunc(number))) {
        failExpecting(fmt::format("an integer from {} to {}", minimum, maximum));
    }
    return static_cast<int>(number);
}

double JsonNode::number() const {
    if (!value_->is_number()) {
        failExpecting("a number");
    }
    return value_->get<double>();
}

double JsonNode::positiveNumber() const {
    if (!value_->is_number() || !(value_->get<double>() > 0.0)) {
        failExpecting("a positive number");
    }
    return value_->get<double>();
}

double JsonNode::nonNegativeNumber() const {
    if (!value_->is_number() || !(value_->get<double>() >= 0.0)) {
        failExpecting("a number that is not negative");
    }
    return value_->get<double>();
}

glm::dvec3 JsonNode::vector() const {
    if (!isVector(*value_, [](double) { return true; })) {
        failExpecting("an array of three numbers");
    }
    return toVector(*value_);
}

glm::dvec3 JsonNode::direction() const {
    const glm::dvec3 result = vector();
    if (!(glm::length(result) >= static_cast<double>(std::numeric_limits<float>::min()))) {
        fail("the vector is zero, and so has no direction");
    }
    return result;
}

glm::dvec3 JsonNode::light() const {
    if (!isVector(*value_, [](double component) { return component >= 0.0; })) {
        failExpecting("an array of three numbers that are not negative");
    }
    return toVector(*value_);
}

glm::dvec3 JsonNode::reflectance() const {
    if (!isVector(*value_, [](double component) { return component >= 0.0 && component <= 1.0; })) {
        failExpecting("an array of three numbers from 0 to 1");
    }
    return toVector(*value_);
}

void JsonNode::fail(const std::string& fault) const {
    failAt(sourceName_, pointer(), fault);
}

void JsonNode::failExpecting(const std::string& expectation) const {
    fail(fmt::format("{} is not {}", describe(*value_), expectation));
}

std::string JsonNode::pointer() const {
    if (parent_ == nullptr) {
        return "";
    }
    return parent_->pointer() +
           (parent_->value_->is_object() ? pointerPart(key_) : fmt::format("/{}", index_));
}

}  // namespace raytorus::scene
