// SPDX-License-Identifier: MIT
// A torus and a ray as ten hexadecimal floats, exact both ways.
#include <cstdio>
#include <cstdlib>

#include "reference/rays.hpp"

namespace raytorus::reference {

std::string hexFloats(const Torus& torus, const Ray& ray) {
    char text[400];  // ten numbers of at most 24 characters each
    std::snprintf(text, sizeof text, "%a %a  %a %a %a %a  %a %a %a %a", double{torus.majorRadius},
                  double{torus.minorRadius}, double{ray.origin[0]}, double{ray.origin[1]},
                  double{ray.origin[2]}, double{ray.tMin}, double{ray.direction[0]}, double{ray.direction[1]},
                  double{ray.direction[2]}, double{ray.tMax});
    return text;
}

std::optional<TorusAndRay> parseHexFloats(const std::string& text) {
    TorusAndRay parsed{};
    float* const numbers[10] = {&parsed.torus.majorRadius, &parsed.torus.minorRadius,
                                &parsed.ray.origin[0],     &parsed.ray.origin[1],
                                &parsed.ray.origin[2],     &parsed.ray.tMin,
                                &parsed.ray.direction[0],  &parsed.ray.direction[1],
                                &parsed.ray.direction[2],  &parsed.ray.tMax};
    const char* next = text.c_str();
    for (float* number : numbers) {
        char* end = nullptr;
        *number = std::strtof(next, &end);
        if (end == next) return std::nullopt;
        next = end;
    }
    while (*next == ' ' || *next == '\n')
        ++next;
    if (*next != '\0') return std::nullopt;
    return parsed;
}

}  // namespace raytorus::reference
