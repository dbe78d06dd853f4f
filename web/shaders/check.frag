// SPDX-License-Identifier: MIT
// Whether this device and its compiler keep the roundings that the exact tier rests on.
uniform float one;
out uvec4 result;

void main() {
    result = uvec4(uint(torusSelfCheck(one)));
}
