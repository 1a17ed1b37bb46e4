// Where the pixel's true direction meets a long triangle, of which a polygon around its bent image is drawn.

flat in vec3 plane;     // 1 / r in a direction is their product
flat in vec4 limits[3]; // of the edges
#ifdef MASKED
flat in vec3 uv_slopes[2];
#endif

vec3 caster_normal() {
    return plane;
}

// 0: beside the triangle, or below the map's plane.
float caster_steps(vec4 way) {
    float inside = min(min(dot(limits[0], way), dot(limits[1], way)), dot(limits[2], way));
    return min(inside, way.z - PARABOLOID_LOWEST * way.w) > 0.0 ? 1.0 / dot(plane, way.xyz) : 0.0;
}

#ifdef MASKED
vec2 caster_uv(vec4 way) {
    return vec2(dot(uv_slopes[0], way.xyz), dot(uv_slopes[1], way.xyz)) / dot(plane, way.xyz);
}
#endif
