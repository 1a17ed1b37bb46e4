// Irradiance of a surface by the coefficients of the empty voxels in front of it.
#include "lib/sh.glsl"
#include "lib/volume.glsl"

layout(binding = UNIT_VOLUME_COEFFICIENTS) uniform sampler2D coefficients[COEFFICIENTS];
#if SPLIT
layout(binding = UNIT_VOLUME_RADIOSITY) uniform sampler2D radiosities;
#endif

// Coefficients of several voxels, added up by weights.
struct voxel_sum {
    vec4 coefficients[COEFFICIENTS];
    float weight;
};

void voxel_add(inout voxel_sum sum, ivec3 voxel, float weight) {
    if (weight <= 0.0 || !volume_has(vec3(voxel)) || !volume_is_read(voxel))
        return;
    ivec2 texel = volume_texel(voxel);
    for (int i = 0; i < COEFFICIENTS; i++)
        sum.coefficients[i] += weight * texelFetch(coefficients[i], texel, 0);
    sum.weight += weight;
}

vec3 voxel_irradiance(voxel_sum sum, vec3 normal) {
    vec3 irradiance = vec3(0.0);
    vec4 low = sh_cosine_low(normal);
    for (int c = 0; c < CHANNELS; c++)
        irradiance[c] = dot(sum.coefficients[c], low);
#if ORDER == 3
    vec4 high = sh_cosine_high(normal);
    for (int c = 0; c < CHANNELS; c++)
        irradiance[c] += dot(sum.coefficients[CHANNELS + c], high) +
                         sum.coefficients[2 * CHANNELS][c] * sh_cosine_last(normal);
#endif
#if CHANNELS == VOLUME_VISIBILITY
    irradiance = irradiance.xxx;
#endif
    return max(irradiance / sum.weight, 0.0);
}

voxel_sum no_voxels() {
    voxel_sum sum;
    for (int i = 0; i < COEFFICIENTS; i++)
        sum.coefficients[i] = vec4(0.0);
    sum.weight = 0.0;
    return sum;
}

// The mean normal of a voxel's surfaces as it is seen from that far off its middle: of two sides it is that which faces
// there. What is seen from both sides is turned where it clearly faces away.
vec3 normal_towards(vec4 surface, ivec2 texel, vec3 off) {
    vec3 normal = surface.xyz / surface.a;
    float behind = -0.5;
#if SPLIT
    vec4 turned = texelFetch(turned_surfaces, texel, 0), others = surface - turned;
    if (has_sides(surface) && min(turned.a, others.a) > 0.5) {
        vec3 a = turned.xyz / turned.a, b = others.xyz / others.a;
        return dot(a, off) > dot(b, off) ? a : b;
    }
    // Of one plane it is known where it lies, but not of all that shares its voxels.
    if (dot(normal, normal) > 0.9)
        behind = max(texelFetch(radiosities, texel, 0).a / surface.a - 0.25, behind);
#endif
    return BOTH_SIDES == 1 && dot(normal, off) < behind ? -normal : normal;
}

// The plane of all surfaces among eight voxels, and how far the place around which they lie is before it: voxels behind it
// are another room's. xyz: normal, not unit.
vec4 surface_of_eight(ivec3 base, vec3 around) {
    vec3 normals = vec3(0.0), middles = vec3(0.0);
    float count = 0.0;
    for (int i = 0; i < 8; i++) {
        ivec3 voxel = base + ivec3(i & 1, (i >> 1) & 1, i >> 2);
        if (volume_has(vec3(voxel)) && volume_distance(voxel) == 0) {
            vec4 surface = texelFetch(surfaces, volume_texel(voxel), 0);
            vec3 middle = vec3(voxel) + 0.5;
            normals += normal_towards(surface, volume_texel(voxel), around - middle);
            middles += middle;
            count += 1.0;
        }
    }
    return vec4(normals, dot(normals, middles / max(count, 1.0)));
}

// The eight voxels around a place, but for those behind the plane of the surface or of others between.
voxel_sum sum_of_eight(vec3 around, vec3 place, vec3 normal) {
    voxel_sum sum = no_voxels();
    vec3 base = floor(around - 0.5), part = around - 0.5 - base;
    vec4 plane = surface_of_eight(ivec3(base), around);
    for (int i = 0; i < 8; i++) {
        vec3 corner = vec3(i & 1, (i >> 1) & 1, i >> 2), middle = base + corner + 0.5;
        vec3 weights = mix(1.0 - part, part, corner);
        bool before = dot(middle - place, normal) > 0.0 && dot(middle, plane.xyz) >= plane.w;
        voxel_add(sum, ivec3(base + corner), before ? weights.x * weights.y * weights.z : 0.0);
    }
    return sum;
}

// All eight voxels around a place.
void add_eight(inout voxel_sum sum, vec3 around, float weight) {
    vec3 base = floor(around - 0.5), part = around - 0.5 - base;
    for (int i = 0; i < 8; i++) {
        vec3 corner = vec3(i & 1, (i >> 1) & 1, i >> 2), weights = mix(1.0 - part, part, corner);
        voxel_add(sum, ivec3(base + corner), weight * weights.x * weights.y * weights.z);
    }
}

// Places a voxel away along the axes from half a voxel above the surface, by their cosine [Mavridis and Papaioannou 2011,
// eq. 5], each between eight voxels, as the hardware interpolates.
voxel_sum sum_of_six(vec3 place, vec3 normal) {
    voxel_sum sum = no_voxels();
    for (int axis = 0; axis < 3; axis++) {
        vec3 off = vec3(0.0);
        off[axis] = normal[axis] < 0.0 ? -1.0 : 1.0;
        add_eight(sum, place + 0.5 * normal + off, abs(normal[axis]));
    }
    return sum;
}

// Whether the voxel there holds a surface that faces away: that of a thin wall's other side, or of another wall.
bool is_beyond_wall(vec3 place, vec3 normal) {
    if (!volume_has(place))
        return false;
    vec4 surface = texelFetch(surfaces, volume_texel(ivec3(place)), 0);
#if SPLIT
    if (has_sides(surface)) {
        vec4 turned = texelFetch(turned_surfaces, volume_texel(ivec3(place)), 0);
        return max(dot(turned.xyz, normal), dot(surface.xyz - turned.xyz, normal)) <= 0.0;
    }
#endif
    return dot(surface.xyz, normal) < 0.0;
}

// False where no voxel knows; in voxels from the corner. Where a wall is near, a voxel away from it may know.
bool volume_irradiance(vec3 place, vec3 normal, out vec3 irradiance) {
#if PUBLISHED
    voxel_sum sum = sum_of_six(place, normal);
#else
    float lift = is_beyond_wall(place + 0.75 * normal, normal) ? 0.5 : 1.5;
    vec3 around = place + lift * normal;
    voxel_sum sum = sum_of_eight(around, place, normal);
    if (sum.weight < 1e-3) {
        vec3 walls = surface_of_eight(ivec3(floor(around - 0.5)), around).xyz;
        sum = sum_of_eight(around + normalize(walls + 1e-3 * normal), place, normal);
    }
    if (sum.weight < 1e-3)
        sum = sum_of_eight(place + 2.5 * normal, place, normal);
    if (sum.weight < 1e-3)
        sum = sum_of_six(place, normal);
#endif
    irradiance = sum.weight > 0.0 ? voxel_irradiance(sum, normal) : vec3(0.0);
    return sum.weight > 0.0;
}
