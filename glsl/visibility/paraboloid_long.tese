// A corner of a piece of a long caster. Pieces of an edge span like angles from the map's centre, however near
// the edge comes to it.
#extension GL_ARB_shader_viewport_layer_array : require
#include "visibility/map_views.glsl"
#include "visibility/paraboloid_corner.glsl"

layout(triangles, equal_spacing) in;

in vec3 patch_corner[];
patch in int patch_map;
patch in vec3 patch_angles;
flat out vec3 plane;
#ifdef MASKED
in vec2 patch_uv[];
out vec2 surface_uv;
#endif

// Along an edge the spherical interpolation of directions, brought back onto it; within, a blend of the edges'.
vec3 corner_weights(vec3 t) {
    vec3 weights = t;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        float angle = (t[j] * patch_angles[k] + t[k] * patch_angles[j]) / max(t[j] + t[k], 1e-20);
        weights[i] = t[i] == 1.0 ? 1.0 : sin(t[i] * angle) / max(length(patch_corner[i]), 1e-20);
    }
    return weights / (weights.x + weights.y + weights.z);
}

void main() {
    vec3 weights = corner_weights(gl_TessCoord);
    vec3 q = mat3(patch_corner[0], patch_corner[1], patch_corner[2]) * weights;
    paraboloid_corner(map_view_at(patch_map), patch_map, q);
    plane = cross(patch_corner[1] - patch_corner[0], patch_corner[2] - patch_corner[0]);
#ifdef MASKED
    surface_uv = mat3x2(patch_uv[0], patch_uv[1], patch_uv[2]) * weights;
#endif
}
