// SPDX-License-Identifier: MIT
#include "options/number_checks.hpp"

#include <fmt/format.h>

#include <string>

#include "core/console.hpp"
#include "core/parse_number.hpp"

namespace raytorus::options {

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
