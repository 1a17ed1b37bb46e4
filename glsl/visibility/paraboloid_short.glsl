// Where the pixel's true direction meets a short triangle. Between its projected corners the rasteriser draws it
// straight, which it is not in this projection; but what it interpolates linearly, the local position, stays in the
// triangle's plane.

in vec3 local; // a point of the triangle's plane, in the map's frame
#ifdef MASKED
in vec2 surface_uv;
#endif

vec3 caster_normal() {
    return cross(dFdx(local), dFdy(local));
}

// 0: below the map's plane.
float caster_steps(vec4 way) {
    vec3 normal = caster_normal();
    return way.z > 0.0 ? dot(normal, local) / dot(normal, way.xyz) : 0.0;
}

#ifdef MASKED
vec2 caster_uv(vec4 way) {
    return surface_uv;
}
#endif
