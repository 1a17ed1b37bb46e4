// Smooth surfaces as rays meet them: material and shading normal of a triangle.
#include "shared/smooth.h"

layout(binding = UNIT_TRIANGLE_ROWS) uniform usamplerBuffer triangle_rows;
layout(binding = UNIT_SMOOTH_MATERIALS) uniform samplerBuffer smooth_materials;
layout(binding = UNIT_CORNERS) uniform usamplerBuffer corners;
layout(binding = UNIT_CORNER_POSITIONS) uniform samplerBuffer corner_positions;
layout(binding = UNIT_CORNER_NORMALS) uniform isamplerBuffer corner_normals;

struct smooth_material {
    vec3 base, absorption; // absorption in 1/m
    int kind;              // SMOOTH_IS_...
    float refraction;      // index
    float passes;          // share of the light that enters and is not scattered
    bool thin;
    bool two_sided; // a mirror that reflects from behind, too
};

// 0: the surface is not smooth.
int smooth_row(int triangle) {
    return triangle < 0 ? 0 : int(texelFetch(triangle_rows, triangle).r);
}

smooth_material smooth_material_at(int row) {
    int texel = (row - 1) * SMOOTH_TEXELS;
    vec4 a = texelFetch(smooth_materials, texel), b = texelFetch(smooth_materials, texel + 1);
    vec4 c = texelFetch(smooth_materials, texel + 2);
    return smooth_material(a.rgb, b.rgb, int(a.a), b.a, c.x, c.y > 0.0, c.z > 0.0);
}

// At a point of the triangle, on the side of `facing`.
vec3 smooth_normal(int triangle, vec3 at, vec3 facing) {
    ivec3 vertices;
    vec3 place[3], normal[3];
    for (int i = 0; i < 3; i++) {
        int vertex = int(texelFetch(corners, 3 * triangle + i).r);
        place[i] = texelFetch(corner_positions, vertex).xyz;
        normal[i] = vec3(texelFetch(corner_normals, vertex).xyz);
    }
    vec3 across = cross(place[1] - place[0], place[2] - place[0]);
    float u = dot(cross(place[1] - at, place[2] - at), across), v = dot(cross(place[2] - at, place[0] - at), across);
    float w = dot(across, across) - u - v;
    vec3 n = normalize(u * normal[0] + v * normal[1] + w * normal[2]);
    return dot(n, facing) < 0.0 ? -n : n;
}
