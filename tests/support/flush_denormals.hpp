// SPDX-License-Identifier: MIT
// The CPU as a GPU that flushes denormals. Empty where the processor is no x86.
#pragma once

#ifdef __SSE__
#include <xmmintrin.h>

namespace raytorus::test {

/// While it lives, this thread takes denormals for 0, as the operands and as the results of operations.
class FlushDenormals {
public:
    FlushDenormals() : saved(_mm_getcsr()) { _mm_setcsr(saved | flushResults | operandsAreZero); }
    ~FlushDenormals() { _mm_setcsr(saved); }
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
    static constexpr unsigned flushResults = 1U << 15, operandsAreZero = 1U << 6;
    unsigned saved;
};

}  // namespace raytorus::test
#endif
