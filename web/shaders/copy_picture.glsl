// SPDX-License-Identifier: MIT
// The eye stands where y = 0, because a torus is one of revolution: `turn` turns its paint.
// The plane through the centre is `extent` high and low, so the torus keeps its size from any distance. A float32 direction
// has steps of 6e-8: from beyond 1e5 they show, because a ray here has no better length than 1.
vec3 picture(vec2 place, float pixel, float elevation, float turn) {
    Torus torus = Torus(1.0, MINOR_RADIUS);
    vec3 back = vec3(cos(elevation), 0.0, sin(elevation));
    vec3 upwards = vec3(-back.z, 0.0, back.x);
    vec3 direction = normalize((place.x * vec3(0.0, 1.0, 0.0) + place.y * upwards) / DISTANCE - back);
    TorusHit hit;
    vec3 light = shadeBackground(0.5);
    if (torusIntersect(torus, DISTANCE * back, 0.0, direction, 1.0e9, hit)) {
        light = shadeHit(1.0, MINOR_RADIUS, hit.position, torusNormal(torus, hit.position), direction, turn, pixel);
    }
    return shadeDisplay(light);
}
