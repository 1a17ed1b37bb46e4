// How light that paths leave is shared out to the VPLs around it, of a pool of them: by nearness and like normals, as values
// between scattered points are found [Shepard 1968].
#include "passes/lights/bounce_paths.glsl"

// First and past the last of VPL i's.
ivec2 pool_of(int i) {
    int first = i / BOUNCE_POOL * BOUNCE_POOL;
    return ivec2(first, min(first + BOUNCE_POOL, params.later));
}

// The share that is lost: as that of a VPL so far away that it is too far, over the scene's radius.
const float LOST = 1.0;
const float TOO_FAR = 0.25;
const float OFF_PLANE = 30.0;

// Of light that one leaves to the other, before all and what is lost are made one. What lies off the plane of both is
// farther: a table's top gives the floor below nothing. A chord of what is bent evenly lies in it.
float share_between(path_end a, path_end b) {
    const float AT_LEAST = 2.5e-4; // of what is too far, squared
    vec3 apart = a.position - b.position;
    float like = max(dot(a.normal, b.normal), 0.0), far = TOO_FAR * params.radius;
    float off = OFF_PLANE * dot(apart, a.normal + b.normal);
    float distance2 = (dot(apart, apart) + off * off) / (far * far) + AT_LEAST;
    return like * like / (distance2 * distance2 * distance2);
}
