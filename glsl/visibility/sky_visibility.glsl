// Which share of a sky's light a receiver sees, by the light's map: percentage-closer soft shadows [Fernando
// 2005] with the light's own shape. What hides it is sought along ways to points of it; then the share of
// such ways that are free at that distance is what is seen.
//
// All is in the view's frame: x right, y up, z away from the light, metres; t: metres towards the light.
#include "lib/sky.glsl"
#include "shared/sky_light.h"

layout(binding = UNIT_SKY_MAPS) uniform sampler2DArray sky_maps;
layout(binding = UNIT_SKY_SHARES) uniform sampler2DArray sky_share_table; // visibility/sky_shares.frag

// Irradiance over radiance of four lights that nothing hides: as smooth as it is, between the table's normals
// it is off by no more than 5e-4 of the brightest.
vec4 sky_shares(vec3 normal, int layer) {
    vec2 place = (octahedral_encode(normal) * float(SKY_SHARES_SIZE - 1) + 0.5) / float(SKY_SHARES_SIZE);
    return textureLod(sky_share_table, vec3(place, layer), 0.0);
}

const float KERNEL_MIN = 0.75; // of a texel's width, from the middle: a smaller one would show steps

struct sky_receiver {
    vec3 position, normal;
    vec2 texel; // metres
    mat2 inverse_sides;
};

// Point k in the light, in units of its half sides: a sequence whose every part is even.
vec2 sky_point(int k) {
    return fract(float(k) * vec2(0.75487767, 0.56984029) + 0.5) * 2.0 - 1.0;
}

// What lies in the texel that shows a place, relative to the receiver; its z is t. 0 where it hides nothing:
// behind the receiver, or not above its plane.
vec3 sky_blocker(int i, sky_view v, sky_receiver x, vec2 aside) {
    ivec2 size = textureSize(sky_maps, 0).xy;
    ivec2 texel = ivec2(floor(((x.position.xy + aside) / v.half_size * 0.5 + 0.5) * vec2(size)));
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, size)))
        return vec3(0.0);
    float depth = texelFetch(sky_maps, ivec3(texel, i), 0).r * v.far;
    vec2 center = ((vec2(texel) + 0.5) / vec2(size) * 2.0 - 1.0) * v.half_size;
    vec3 there = vec3(center - x.position.xy, x.position.z - depth);
    float height = dot(x.normal, vec3(there.xy, -there.z));
    return there.z > 0.0 && height > params.bias * x.texel.x ? there : vec3(0.0);
}

// Whether the way past it comes from the light, given a texel's doubt.
bool sky_hides(sky_receiver x, sky_view v, vec3 blocker) {
    vec2 p = x.inverse_sides * (blocker.xy / blocker.z);
    vec2 doubt = 0.5 * max(x.texel.x, x.texel.y) / (blocker.z * vec2(length(v.sides[0]), length(v.sides[1])));
    return all(lessThanEqual(abs(p), 1.0 + doubt));
}

float sky_visibility(int i, vec3 position, vec3 normal) {
    sky_view v = sky_view_at(i);
    mat3 to_view = transpose(mat3(v.right, v.up, v.forward));
    sky_receiver x;
    x.position = to_view * (position - v.origin);
    x.normal = to_view * normal;
    x.texel = 2.0 * v.half_size / vec2(textureSize(sky_maps, 0).xy);
    x.inverse_sides = inverse(v.sides);
    float sum = 0.0, count = 0.0;
    for (int k = 0; k < SEARCH_TAPS; k++) {
        float share = (float(k) + 0.5) / float(SEARCH_TAPS);
        vec3 blocker = sky_blocker(i, v, x, v.sides * sky_point(k) * (share * share * x.position.z));
        bool hides = blocker.z > 0.0 && sky_hides(x, v, blocker);
        sum += hides ? blocker.z : 0.0;
        count += hides ? 1.0 : 0.0;
    }
    float t = sum / max(count, 1.0);
    vec2 kernel = t * vec2(length(v.sides[0]), length(v.sides[1]));
    vec2 widen = max(vec2(1.0), KERNEL_MIN * max(x.texel.x, x.texel.y) / max(kernel, vec2(1e-20)));
    float blocked = 0.0, free = 0.0;
    // As a count and not a branch: a software rasteriser leaves a loop that no pixel is in.
    int taps = count > 0.0 ? FILTER_TAPS : 0;
    for (int k = 0; k < taps; k++) {
        vec3 blocker = sky_blocker(i, v, x, v.sides * (sky_point(k) * widen) * t);
        if (blocker.z <= 0.0)
            free += 1.0;
        else if (sky_hides(x, v, blocker))
            blocked += 1.0;
    }
    return taps == 0 ? 1.0 : free / max(free + blocked, 1.0);
}
