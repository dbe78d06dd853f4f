// SPDX-License-Identifier: MIT
// The ray through a sample of the picture, and what either method says of it.
uniform Torus torus;
uniform vec3 eye;
uniform vec2 columns;            // of sample columns: the first's place beside the axis of view, and the step to the next
uniform highp sampler2D rows;    // of sample rows, from below: x and z of the direction, and what a column is multiplied by
uniform uint zero;               // 0, which no compiler knows

const float rayEnd = 1.0e9;

struct Answer {
    bool found;
    float t;
    vec3 position;
    vec3 normal;
};

// Its length is that at which float32 holds its slope best, so it is not 1: see rows.js.
vec3 rayDirection(ivec2 at) {
    vec3 row = texelFetch(rows, ivec2(0, at.y), 0).xyz;
    float y = row.z * (columns.x + float(at.x) * columns.y);
    // The rounded product, and not its factors, is the ray: an exclusive or keeps a compiler from moving them on.
    return vec3(row.x, uintBitsToFloat(floatBitsToUint(y) ^ zero), row.y);
}

Answer libraryAnswer(vec3 direction) {
    TorusHit hit;
    bool found = torusIntersect(torus, eye, 0.0, direction, rayEnd, hit);
    return Answer(found, hit.t, hit.position, found ? torusNormal(torus, hit.position) : vec3(0.0));
}

Answer pastedAnswer(vec3 direction) {
    float size = length(direction);
    float t = pastedTorus(eye, direction / size, torus.majorRadius, torus.minorRadius);
    bool found = t > 0.0;
    vec3 position = found ? eye + t * (direction / size) : vec3(0.0);
    return Answer(found, found ? t / size : rayEnd, position,
                  found ? pastedNormal(position, torus.majorRadius, torus.minorRadius) : vec3(0.0));
}
