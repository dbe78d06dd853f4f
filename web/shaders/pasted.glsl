// SPDX-License-Identifier: MIT
// The quartic in world space, by its formula, in float32: what is pasted from shader to shader. Beside it stands the library.
// Ferrari's factoring by a root of the resolvent cubic; where that divides by nearly nothing, the reversed polynomial.
float pastedCubeRoot(float x) {
    return sign(x) * pow(abs(x), 1.0 / 3.0);
}

// The largest real root of y^3 + p y + q.
float pastedCubic(float p, float q) {
    float third = -p / 3.0;
    float h = -0.5 * q;
    float discriminant = h * h - third * third * third;
    if (discriminant < 0.0) {
        float root = sqrt(third);
        return 2.0 * root * cos(acos(clamp(h / (root * third), -1.0, 1.0)) / 3.0);
    }
    float root = sqrt(discriminant);
    return pastedCubeRoot(h + root) + pastedCubeRoot(h - root);
}

// p, q, s of y^4 + p y^2 + q y + s with y = t + c.w / 4, of t^4 + c.w t^3 + c.z t^2 + c.y t + c.x.
vec3 pastedDepress(vec4 c) {
    float a = 0.25 * c.w;
    return vec3(c.z - 6.0 * a * a, c.y - 2.0 * a * c.z + 8.0 * a * a * a, c.x - a * c.y + a * a * c.z - 3.0 * a * a * a * a);
}

float pastedNearer(float nearest, float t) {
    return t > 0.0 && (nearest < 0.0 || t < nearest) ? t : nearest;
}

// The nearest t > 0 along a unit direction, or -1.
float pastedTorus(vec3 o, vec3 d, float R, float r) {
    float n = dot(o, d);
    float m = dot(o, o);
    if (n * n - m + (R + r) * (R + r) < 0.0) {
        return -1.0;
    }
    float k = 0.5 * (m - R * R - r * r);
    vec4 c = vec4(4.0 * (k * k + R * R * (o.z * o.z - r * r)), 8.0 * (n * k + R * R * o.z * d.z), 4.0 * (n * n + k + R * R * d.z * d.z),
                  4.0 * n);
    vec3 f = pastedDepress(c);
    bool reversed = abs(f.y) < 0.01;
    if (reversed) {
        c = vec4(1.0, c.wzy) / c.x;
        f = pastedDepress(c);
    }
    float w = pastedCubic(-f.x * f.x / 3.0 - 4.0 * f.z, -2.0 * f.x * f.x * f.x / 27.0 + 8.0 * f.x * f.z / 3.0 - f.y * f.y) -
              2.0 * f.x / 3.0;
    if (!(w > 0.0)) {
        return -1.0;
    }
    float a = sqrt(w);
    float nearest = -1.0;
    for (int i = 0; i < 2; ++i) {
        float side = i == 0 ? 0.5 : -0.5;
        float discriminant = -0.25 * w - 0.5 * f.x + side * f.y / a;
        if (discriminant >= 0.0) {
            float root = sqrt(discriminant);
            float low = -side * a - root - 0.25 * c.w;
            float high = -side * a + root - 0.25 * c.w;
            nearest = pastedNearer(nearest, reversed ? 1.0 / low : low);
            nearest = pastedNearer(nearest, reversed ? 1.0 / high : high);
        }
    }
    return nearest;
}

vec3 pastedNormal(vec3 p, float R, float r) {
    return normalize(p * (dot(p, p) - r * r - R * R * vec3(1.0, 1.0, -1.0)));
}
