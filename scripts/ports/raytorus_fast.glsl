// SPDX-License-Identifier: MIT
// raytorusFast: the nearest hit of a ray with a torus, in plain float32, as one function to paste. It needs GLSL 3.30 or GLSL
// ES 3.00, and no other file. Of the raytorus library it is the tier TORUS_FAST: right verdicts where no tangent is nearer
// than 1e-3 r, from up to 1000 R away, where r/R is 1e-3 to 1.5, but for a horn's and a dimple's tip; positions to 4e-6 (R + r)
// for 99 of 100 hits. A start or an end within 1.5e-6 (R + r) of the surface may count as on it.
//
// The torus has its centre at the origin and its axis along +z; R is the radius of the ring, r that of the tube. The
// direction needs no unit length, and t counts in its length. A hit has tMin <= t <= tMax; tMax may be infinite.
// Returns whether there is one; `position` is on the surface, `normal` is unit and points outwards.
bool raytorusFast(float R, float r, vec3 origin, float tMin, vec3 direction, float tMax, out float t, out vec3 position,
                  out vec3 normal) {
    t = tMax;
    position = vec3(0.0);
    normal = vec3(0.0, 0.0, 1.0);
    float size = R + r;
    float longest = max(max(abs(direction.x), abs(direction.y)), abs(direction.z));
    bool valid = r > 0.0 && R >= 0.0 && tMin <= tMax && size > 1.0e-18 && size < 1.0e18 && longest > 1.0e-18 && longest < 1.0e18;
    if (!valid) {
        return false;
    }
    // Scale by powers of two: no bit is lost.
    float unit = uintBitsToFloat(floatBitsToUint(size) & 0x7f800000u);
    float speed = uintBitsToFloat(floatBitsToUint(longest) & 0x7f800000u);
    R /= unit;
    r /= unit;
    vec3 o = origin / unit;
    vec3 d = direction / speed;
    float dd = d.x * d.x + d.y * d.y + d.z * d.z;
    float invDd = 1.0 / dd;
    // Move the origin to the foot, the point next to the centre, by a number of 12 bits: its products with the halves of d are
    // exact. The zero, which no compiler knows, keeps the two sums apart.
    uint zero = (0x7f7fffffu - floatBitsToUint(longest)) >> 31u;
    float move = -(o.x * d.x + o.y * d.y + o.z * d.z) * invDd;
    float gone = uintBitsToFloat(floatBitsToUint(move) & 0xfffff000u);
    vec3 high = uintBitsToFloat(floatBitsToUint(d) & 0xfffff000u);
    vec3 base = uintBitsToFloat(floatBitsToUint(o + gone * high) ^ zero) + gone * (d - high);
    float shift = -(base.x * d.x + base.y * d.y + base.z * d.z) * invDd;
    vec3 foot = base + shift * d;
    float foot2 = foot.x * foot.x + foot.y * foot.y + foot.z * foot.z;
    // Clip to the bounding sphere, to the planes z = -r and z = r, and to the ray.
    float chord2 = 1.00002 * ((R + r) * (R + r)) - foot2;
    if (!(chord2 > 0.0)) {
        return false;
    }
    float halfChord = sqrt(chord2 * invDd);
    float invRise = 1.0 / (abs(d.z) + 1.0e-30);
    float middle = foot.z * (d.z < 0.0 ? invRise : -invRise);
    float halfSlab = (r + 6.0e-6) * invRise;
    float enter = max(middle - halfSlab, -halfChord);
    float start = (max(tMin, -3.0e38) * (speed / unit) - gone) - shift;
    float endShift = min(tMax, 3.0e38) * (speed / unit) - gone;
    float end = min(min(middle + halfSlab, halfChord), (endShift - shift) + 1.0e-5);
    float u = max(start, enter);
    if (!(u <= end)) {
        return false;
    }
    // f(u) = (u^2 + k)^2 + (b0 + b1 u)^2 - edge^2 is 0 on the surface, and negative inside. Inside |u| < hole, where a spindle has
    // its inner sheet, all is inside.
    float k = (foot2 - R * R - r * r) * invDd;
    float twoR = 2.0 * R * invDd;
    float b0 = twoR * foot.z;
    float b1 = twoR * d.z;
    float edge = twoR * r;
    float hole = sqrt(max(-(k + twoR * R), 0.0));
    float blurOfA = 1.2e-6 * (R + r + 2.0 * max(max(abs(base.x), abs(base.y)), abs(base.z))) * invDd;
    float a = u * u + k;
    float b = b0 + u * b1;
    float f = a * a + (b * b - edge * edge);
    float h = 2.0 * u * a + b1 * b;
    bool below = (abs(f) <= blurOfA * (edge + blurOfA) ? h : f) < 0.0;
    float side = start > enter && (below || (u >= -hole && u < hole)) ? -1.0 : 1.0;
    // March to the first root of a parabola that is nowhere above f outside, or -f inside: no crossing is passed.
    float lastStep = 0.015625 * r + 1.1920929e-7;
    float reach = side < 0.0 ? 2.0 * r : 8.0;
    bool found = false;
    for (int i = 0; i < 64 && u < end && !found; ++i) {
        bool within = hole > 0.0 && u >= -hole && u < hole;
        bool late = within && side > 0.0;
        u = within && !late ? hole : u;
        reach = min(reach, late ? 0.0 : end - u);
        a = u * u + k;
        b = b0 + u * b1;
        f = side * (a * a + (b * b - edge * edge));
        h = side * (2.0 * u * a + b1 * b);
        float c = 2.0 * a + b1 * b1;
        float ahead = 2.0 * u + reach;
        float bound = side < 0.0 ? max(abs(2.0 * u), abs(ahead)) : max(max(2.0 * u, -ahead), 0.0);
        float C = side * (c + bound * bound);
        float discriminant = h * h - C * f;
        float root = sqrt(max(discriminant, 0.0));
        float x = (h < 0.0 ? f : root + h) / (h < 0.0 ? root - h : -C);
        bool none = h < 0.0 ? discriminant <= 0.0 && f > 0.0 : C >= 0.0;
        x = none ? 8.0 : x;
        float bend = abs(c) + 4.0 * (u * u + reach * reach);
        found = x <= min(lastStep, reach) && bend * x < -0.25 * h;
        x = min(found ? max(x, -lastStep) : max(x, 0.0625 * lastStep), reach);
        u += x;
        reach = max(2.0 * x, 0.0625 * lastStep);
        found = found || late;
    }
    if (!found) {
        return false;
    }
    // The last step: by (rho - R)^2 + z^2 - r^2, which keeps its digits in a thin tube.
    vec3 p = foot + u * d;
    float rho = sqrt(p.x * p.x + p.y * p.y);
    float invRho = 1.0 / max(rho, 1.0e-12);
    float q = rho - R;
    float g = side * ((q - r) * (q + r) + p.z * p.z);
    float s = side * ((p.x * d.x + p.y * d.y) * invRho * q + p.z * d.z);
    float across = (p.x * d.y - p.y * d.x) * invRho;
    float bending = side * (dd - R * (across * across * invRho));
    float step = s < 0.0 ? g / (sqrt(max(s * s - bending * g, 0.0)) - s) : 0.0;
    step = clamp(step, -0.015625 * r, 0.015625 * r);
    if (!((endShift - shift) - (u + step) >= 0.0)) {
        return false;
    }
    p += step * d;
    rho = sqrt(p.x * p.x + p.y * p.y);
    float perRho = (rho - R) / max(rho, 1.0e-12);
    position = p * unit;
    normal = normalize(vec3(p.x * perRho, p.y * perRho, p.z));
    t = clamp(((gone + shift) + (u + step)) * (unit / speed), tMin, tMax);
    return true;
}
