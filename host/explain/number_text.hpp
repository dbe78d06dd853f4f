// SPDX-License-Identifier: MIT
// Numbers of explanations as text, and the measure of their errors.
#pragma once

#include <string>

#include "reference/real.hpp"

namespace raytorus::explain {

/// The distance of float32's neighbours at a magnitude; of denormal numbers, 2^-149.
double floatUlp(double magnitude);

/// |actual - exact| in ulp of the exact value. 0 if they are equal; otherwise infinite if the exact one is 0,
/// which has no ulp, or if one of them is no number.
double ulpError(float actual, reference::Quad exact);

/// The shortest decimal that gives the same float32; the same number in hexadecimal, which C and C++ read.
std::string decimal(float value);
std::string hexadecimal(float value);

/// 33 digits, as many as 113 bits hold, or as many as asked for. Zeros at the end are left out.
std::string decimal(reference::Quad value, int digits = 33);

/// Less than this is the exact side's own rounding: 113 bits give a double root to 57.
inline constexpr double negligible = 1e-15;

/// Two digits, as errors are told: "0.31", "1.2e-07"; "0" where negligible.
std::string roughly(double value);

/// "1 hit", "2 hits".
std::string counted(int count, const char* noun);

}  // namespace raytorus::explain
