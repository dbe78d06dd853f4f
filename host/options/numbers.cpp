// SPDX-License-Identifier: MIT
#include "options/numbers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/console.hpp"
#include "core/parse_number.hpp"
#include "scene/scene.hpp"

namespace raytorus::options {
namespace {

template <typename Number>
std::optional<Number> parseWhole(std::string_view text) {
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') {  // parseNumber knows no plus
        text.remove_prefix(1);
    }
    return parseNumber<Number>(text);
}

}  // namespace

std::optional<float> parseFloat(std::string_view text) {
    if (const std::optional<float> value = parseWhole<float>(text)) {
        return value;
    }
    // A number whose nearest float32 is 0 is out of range for std::from_chars too.
    const std::optional<double> wide = parseWhole<double>(text);
    return wide && std::abs(*wide) < 1.0 ? std::optional(static_cast<float>(*wide)) : std::nullopt;
}

std::optional<std::pair<int, int>> parseSize(std::string_view text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos) {
        return std::nullopt;
    }
    const auto width = parseWhole<int>(text.substr(0, cross));
    const auto height = parseWhole<int>(text.substr(cross + 1));
    const auto fits = [](const std::optional<int>& size) {
        return size && *size >= 1 && *size <= scene::maxImageSize;
    };
    if (!fits(width) || !fits(height)) {
        return std::nullopt;
    }
    return std::pair(*width, *height);
}

std::optional<int> parseSquare(std::string_view text) {
    constexpr int maxSide = 64;
    const auto number = parseWhole<int>(text);
    for (int side = 1; number && side <= maxSide; ++side) {
        if (side * side == *number) {
            return side;
        }
    }
    return std::nullopt;
}

template <std::size_t Count>
std::optional<std::array<float, Count>> parseFloats(std::string_view text) {
    std::array<float, Count> numbers{};
    for (std::size_t i = 0; i < Count; ++i) {
        const bool last = i + 1 == Count;
        const std::size_t comma = text.find(',');
        const std::optional<float> number = parseFloat(last ? text : text.substr(0, comma));
        if (!number || (!last && comma == std::string_view::npos)) {
            return std::nullopt;
        }
        numbers[i] = *number;
        text.remove_prefix(last ? 0 : comma + 1);
    }
    return numbers;
}
template std::optional<std::array<float, 1>> parseFloats(std::string_view);
template std::optional<std::array<float, 2>> parseFloats(std::string_view);
template std::optional<std::array<float, 3>> parseFloats(std::string_view);

std::optional<std::pair<float, float>> parsePair(std::string_view text) {
    const auto numbers = parseFloats<2>(text);
    if (!numbers || !std::isfinite(numbers->front()) || !std::isfinite(numbers->back())) {
        return std::nullopt;
    }
    return std::pair(numbers->front(), numbers->back());
}

CLI::Validator wholeNumber(std::uint64_t least, std::uint64_t most) {
    return {[least, most](const std::string& text) -> std::string {
                const bool octal = text.size() > 1 && text.front() == '0';
                const auto number = parseNumber<std::uint64_t>(text);
                return number && !octal && *number >= least && *number <= most
                           ? ""
                           : fmt::format("\"{}\" is no whole number from {} to {}", excerpt(text), least,
                                         most);
            },
            ""};
}

CLI::Validator decimalNumber(double least, double most) {
    return {[least, most](const std::string& text) -> std::string {
                const auto number = parseNumber<double>(text);
                return number && *number >= least && *number <= most
                           ? ""
                           : fmt::format("\"{}\" is no number from {} to {}", excerpt(text), least, most);
            },
            ""};
}

}  // namespace raytorus::options
