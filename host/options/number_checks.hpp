// SPDX-License-Identifier: MIT
// Checks of options that are numbers. The library that reads the command line takes 0x10 and 010 for other
// bases, and nan for a number within every range.
#pragma once

#include <CLI/App.hpp>
#include <cstdint>

namespace raytorus::options {

/// Decimal digits alone, without a sign or a zero in front, and within the range.
CLI::Validator wholeNumber(std::uint64_t least, std::uint64_t most);

/// A decimal number, as "-2.5" or "1e-3": finite, and within the range.
CLI::Validator decimalNumber(double least, double most);

}  // namespace raytorus::options
