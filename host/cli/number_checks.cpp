// SPDX-License-Identifier: MIT
#include "cli/number_checks.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <system_error>

#include "core/console.hpp"

namespace raytorus::cli {
namespace {

template <typename Number>
std::optional<Number> parseAll(const std::string& text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, number);
    return problem == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

}  // namespace

CLI::Validator wholeNumber(std::uint64_t least, std::uint64_t most) {
    return {[least, most](const std::string& text) -> std::string {
                const bool octal = text.size() > 1 && text.front() == '0';
                const auto number = parseAll<std::uint64_t>(text);
                return number && !octal && *number >= least && *number <= most
                           ? ""
                           : fmt::format("\"{}\" is no whole number from {} to {}", excerpt(text), least,
                                         most);
            },
            ""};
}

CLI::Validator decimalNumber(double least, double most) {
    return {[least, most](const std::string& text) -> std::string {
                const auto number = parseAll<double>(text);
                return number && *number >= least && *number <= most
                           ? ""
                           : fmt::format("\"{}\" is no number from {} to {}", excerpt(text), least, most);
            },
            ""};
}

}  // namespace raytorus::cli
