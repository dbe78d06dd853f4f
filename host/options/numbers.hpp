// SPDX-License-Identifier: MIT
// Numbers in the text of options and files. The whole text must be a number: "1e-3x" and "" are none. And
// checks of options: the library that reads the command line takes 0x10 and 010 for other bases, and nan for
// a number within every range.
#pragma once

#include <CLI/App.hpp>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace raytorus::options {

/// The float32 nearest to a decimal number, which may be 0; also "inf" and "nan" with an optional sign.
/// Nothing if it is no number or beyond the range of float32 (or, near zero, of double).
std::optional<float> parseFloat(std::string_view text);

/// "960x640": two whole numbers from 1 to 16384.
std::optional<std::pair<int, int>> parseSize(std::string_view text);

/// The side of a square number of samples, 1 to 64 x 64: 4 gives 2. Nothing if the number is no square.
std::optional<int> parseSquare(std::string_view text);

/// As many numbers as asked for, between commas, each as parseFloat takes it. For 1 to 3 numbers.
template <std::size_t Count>
std::optional<std::array<float, Count>> parseFloats(std::string_view text);

/// "R,r": two numbers that are finite; whether they make a torus is the torus' business.
std::optional<std::pair<float, float>> parsePair(std::string_view text);

/// Decimal digits alone, without a sign or a zero in front, and within the range.
CLI::Validator wholeNumber(std::uint64_t least, std::uint64_t most);

/// A decimal number, as "-2.5" or "1e-3": finite, and within the range.
CLI::Validator decimalNumber(double least, double most);

}  // namespace raytorus::options
