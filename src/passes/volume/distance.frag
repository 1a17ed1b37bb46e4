// Distance of each voxel to the nearest occupied one, by the greatest difference along an axis, an axis at a time: each
// step takes the lesser of what its neighbours along AXIS have, but at least how far off they are. The last one marks
// holes of surfaces, and what lies behind all surfaces, unless some are seen from both sides. Voxels near panes, which are in
// no voxel, have rays as those near surfaces have.
#include "lib/medium.glsl"
#include "lib/volume.glsl"

#if AXIS == 0
int nearer(ivec3 voxel) {
    return texelFetch(surfaces, volume_texel(voxel), 0).a > 0.0 ? 0 : VOLUME_DISTANCE_MAX;
}
#else
int nearer(ivec3 voxel) {
    return volume_distance(voxel);
}
#endif

#if AXIS == 2
vec4 surface_at(ivec3 voxel) {
    bool inside = all(greaterThanEqual(voxel, ivec3(0))) && all(lessThan(voxel, ivec3(params.cells)));
    return inside ? texelFetch(surfaces, volume_texel(voxel), 0) : vec4(0.0);
}

// Whether the voxel is one that points missed: between two voxels of one surface, which goes on from one to the other.
bool is_hole(ivec3 voxel) {
    for (int axis = 0; axis < 3; axis++) {
        ivec3 off = ivec3(0);
        off[axis] = 1;
        vec4 a = surface_at(voxel + off), b = surface_at(voxel - off);
        if (max(abs(a[axis]) - 0.5 * a.a, abs(b[axis]) - 0.5 * b.a) < 0.0 && dot(a.xyz, b.xyz) > 0.2 * a.a * b.a)
            return true;
    }
    return false;
}

// How far a voxel lies before a surface of another one, of its distance; at least so far is in front.
const float IN_FRONT = -0.25;

// Whether some surface within the shell's width has the voxel in front, or may have: those that face both ways.
bool is_in_front(ivec3 voxel) {
    for (int z = -VOLUME_SHELL; z <= VOLUME_SHELL; z++)
        for (int y = -VOLUME_SHELL; y <= VOLUME_SHELL; y++)
            for (int x = -VOLUME_SHELL; x <= VOLUME_SHELL; x++) {
                vec3 off = vec3(x, y, z);
                vec4 surface = surface_at(voxel - ivec3(off));
                float facing = length(surface.xyz);
                bool both_ways = facing < 0.5 * surface.a;
                if (surface.a > 0.0 && (both_ways || dot(off, surface.xyz) > IN_FRONT * facing * length(off)))
                    return true;
            }
    return false;
}

#ifdef HAS_MEDIUM
const float PANE_REACH = float(VOLUME_SHELL) + 1.5; // voxels

bool is_near_pane(ivec3 voxel) {
    vec3 middle = params.corner + params.voxel * (vec3(voxel) + 0.5);
    float reach = PANE_REACH * params.voxel;
    bool near = false;
    for (int axis = 0; axis < 3; axis++) {
        vec3 along = vec3(0.0);
        along[axis] = 1.0;
        near = near || panes_meet(middle - reach * along, along, 0.0, 2.0 * reach).nearest < 2.0 * reach;
    }
    return near;
}
#else
bool is_near_pane(ivec3 voxel) {
    return false;
}
#endif

// Near a surface, but not to be read.
bool is_idle(ivec3 voxel) {
    return PUBLISHED == 0 && (is_hole(voxel) || (BOTH_SIDES == 0 && !is_in_front(voxel)));
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
#if AXIS == 2
    if (least > 0 && least <= VOLUME_SHELL && is_idle(voxel))
        least += VOLUME_IDLE;
    if (least > VOLUME_SHELL && least < VOLUME_IDLE && is_near_pane(voxel))
        least = VOLUME_SHELL;
#endif
    result = float(least) / 255.0;
}
