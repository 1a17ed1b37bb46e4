// Voxels whose surfaces face several ways, as those of a thin wall, have two sides: their turned points and the others
// (passes/volume/point_sums.glsl).
layout(binding = UNIT_VOLUME_SURFACES) uniform sampler2D surfaces;
#if SPLIT
layout(binding = UNIT_VOLUME_TURNED_SURFACES) uniform sampler2D turned_surfaces;
#endif

// Below this part of their number normals show several ways.
const float FACING = 0.5;

bool has_sides(vec4 surface) {
    return dot(surface.xyz, surface.xyz) < FACING * FACING * surface.a * surface.a;
}
