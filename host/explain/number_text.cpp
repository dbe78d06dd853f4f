// SPDX-License-Identifier: MIT
#include "explain/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace raytorus::explain {

using reference::Quad;

double floatUlp(double magnitude) {
    constexpr int mantissa = std::numeric_limits<float>::digits;
    const int smallest = std::numeric_limits<float>::min_exponent - 1;
    const int exponent = magnitude > 0.0 ? std::max(std::ilogb(magnitude), smallest) : smallest;
    return std::ldexp(1.0, exponent - (mantissa - 1));
}

double ulpError(float actual, Quad exact) {
    if (Quad(actual) == exact) {
        return 0.0;
    }
    if (exact == 0 || !std::isfinite(actual) || !reference::isFinite(exact)) {
        return std::numeric_limits<double>::infinity();
    }
    const double ulp = floatUlp(std::abs(reference::toDouble(exact)));
    return reference::toDouble(reference::magnitude(Quad(actual) - exact)) / ulp;
}

std::string decimal(float value) {
    return fmt::format("{}", value);
}

std::string hexadecimal(float value) {
    return std::isfinite(value) ? fmt::format("{:a}", value) : decimal(value);
}

std::string decimal(Quad value, int digits) {
    std::array<char, 64> text{};
    quadmath_snprintf(text.data(), text.size(), "%.*Qg", digits, value == 0 ? Quad(0) : value);  // no -0
    return text.data();
}

std::string roughly(double value) {
    return fmt::format("{:.2g}", value < negligible ? 0.0 : value);
}

std::string counted(int count, const char* noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace raytorus::explain
