// Distance of each voxel to the nearest occupied one, by the greatest difference along an axis, an axis at a time: each
// step takes the lesser of what its neighbours along AXIS have, but at least how far off they are. The last one marks
// what lies behind all surfaces, unless some surfaces are seen from both sides.
#include "lib/volume.glsl"

#if AXIS == 0
layout(binding = UNIT_VOLUME_SURFACES) uniform sampler2D surfaces;

int nearer(ivec3 voxel) {
    return texelFetch(surfaces, volume_texel(voxel), 0).a > 0.0 ? 0 : VOLUME_DISTANCE_MAX;
}
#else
#include "lib/volume_distances.glsl"

int nearer(ivec3 voxel) {
    return volume_distance(voxel);
}
#endif

#if AXIS == 2
layout(binding = UNIT_VOLUME_SURFACES) uniform sampler2D surfaces;

// How far a voxel lies before a surface of another one, of its distance; at least so far is in front.
const float IN_FRONT = -0.25;

// Whether some surface within the shell's width has the voxel in front, or may have: those that face both ways.
bool is_in_front(ivec3 voxel) {
    ivec3 from = max(voxel - VOLUME_SHELL, ivec3(0)), to = min(voxel + VOLUME_SHELL, ivec3(params.cells) - 1);
    for (int z = from.z; z <= to.z; z++)
        for (int y = from.y; y <= to.y; y++)
            for (int x = from.x; x <= to.x; x++) {
                ivec3 other = ivec3(x, y, z);
                vec4 surface = texelFetch(surfaces, volume_texel(other), 0);
                if (surface.a == 0.0)
                    continue;
                vec3 off = vec3(voxel - other);
                float facing = length(surface.xyz);
                if (facing < 0.5 * surface.a || dot(off, surface.xyz) > IN_FRONT * facing * length(off))
                    return true;
            }
    return false;
}
#endif

layout(location = TARGET_RESULT) out float result;

void main() {
    ivec3 voxel = volume_voxel(ivec2(gl_FragCoord.xy));
    result = float(VOLUME_DISTANCE_MAX) / 255.0;
    int last = int(params.cells[AXIS]) - 1, least = VOLUME_DISTANCE_MAX;
    if (voxel.z >= int(params.cells.z))
        return;
    for (int off = max(-voxel[AXIS], 1 - VOLUME_DISTANCE_MAX); off < min(last - voxel[AXIS] + 1, VOLUME_DISTANCE_MAX); off++) {
        ivec3 other = voxel;
        other[AXIS] += off;
        least = min(least, max(nearer(other), abs(off)));
    }
#if AXIS == 2 && !BOTH_SIDES
    if (least > 0 && least <= VOLUME_SHELL && !is_in_front(voxel))
        least += VOLUME_BEHIND;
#endif
    result = float(least) / 255.0;
}
