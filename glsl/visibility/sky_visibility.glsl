// Which share of a sky's light a receiver sees, by the light's map: of ways to points of the light, those that
// meet nothing. A way is followed through what the map has there: a place of it that lies a little below a surface
// is within a caster. Each way has places of its own, the closer the nearer to the receiver.
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

const int PLACES = 8;
// Casters are as deep as this many gaps between two places there, so that no wall is stepped over. Where the map
// does not know what lies below a surface, light is lost below things as thin as a table, or comes through walls
// that are seen from above: measured, both are least near this.
const float CASTER_DEPTH = 2.0;

struct sky_receiver {
    vec3 position, normal;
    vec2 texel; // metres
};

// Point k in the light, in units of its half sides: a sequence whose every part is even.
vec2 sky_point(int k) {
    return fract(float(k) * vec2(0.75487767, 0.56984029) + 0.5) * 2.0 - 1.0;
}

// How far a surface lies above a place, which is relative to the receiver, its z metres towards the light; 0 where
// it is no higher above the receiver's plane than its own texels' doubt.
float sky_cover(int i, sky_view v, sky_receiver x, vec3 place) {
    ivec2 size = textureSize(sky_maps, 0).xy;
    ivec2 texel = ivec2(floor(((x.position.xy + place.xy) / v.half_size * 0.5 + 0.5) * vec2(size)));
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, size)))
        return 0.0;
    float depth = texelFetch(sky_maps, ivec3(texel, i), 0).r * v.far;
    vec2 center = ((vec2(texel) + 0.5) / vec2(size) * 2.0 - 1.0) * v.half_size;
    vec3 there = vec3(center - x.position.xy, x.position.z - depth);
    float height = dot(x.normal, vec3(there.xy, -there.z));
    return height > params.bias * x.texel.x ? there.z - place.z : 0.0;
}

float sky_visibility(int i, vec3 position, vec3 normal) {
    sky_view v = sky_view_at(i);
    mat3 to_view = transpose(mat3(v.right, v.up, v.forward));
    sky_receiver x;
    x.position = to_view * (position - v.origin);
    x.normal = to_view * normal;
    x.texel = 2.0 * v.half_size / vec2(textureSize(sky_maps, 0).xy);
    float seen = 0.0, above = 0.0;
    for (int k = 0; k < WAYS; k++) {
        vec3 way = vec3(v.sides * sky_point(k), 1.0);
        bool counts = dot(x.normal, vec3(way.xy, -1.0)) > 0.0;
        bool hidden = false;
        float jitter = fract(float(k) * 0.61803399);
        for (int n = 0; n < PLACES && !hidden; n++) {
            float share = (float(n) + jitter) / float(PLACES);
            float cover = sky_cover(i, v, x, way * (share * share * x.position.z));
            float depth = CASTER_DEPTH * 2.0 * share / float(PLACES) * x.position.z;
            hidden = cover > 0.0 && cover < depth;
        }
        seen += counts && !hidden ? 1.0 : 0.0;
        above += counts ? 1.0 : 0.0;
    }
    return seen / max(above, 1.0);
}
