// Which share of a sky's light a receiver sees, by the light's map: of ways to points of the light, those that
// meet nothing. A way is followed through what the map has there: a place of it that lies a little below a surface
// is within a caster. Each way begins at the receiver and has places of its own, the closer the nearer to it.
//
// All is in the view's frame: x right, y up, z away from the light, metres; t: metres towards the light.
#include "lib/sky.glsl"
#include "shared/sky_light.h"
#include "visibility/sky_maps.glsl"

layout(binding = UNIT_SKY_MAPS) uniform sampler2DArray sky_maps;
layout(binding = UNIT_SKY_SHARES) uniform sampler2DArray sky_share_table; // visibility/sky_shares.frag

// Irradiance over radiance of four lights that nothing hides: as smooth as it is, between the table's normals
// it is off by no more than 5e-4 of the brightest.
vec4 sky_shares(vec3 normal, int layer) {
    vec2 place = (octahedral_encode(normal) * float(SKY_SHARES_SIZE - 1) + 0.5) / float(SKY_SHARES_SIZE);
    return textureLod(sky_share_table, vec3(place, layer), 0.0);
}

const int PLACES = 16;
// Casters are as deep as this many gaps between two places there, so that no wall is stepped over; or as far as a way
// and the map's own ray through a place stay within a texel of each other, which for a sun is all the way. Where the
// map does not know what lies below a surface, light is lost below things as thin as a table, or comes through walls
// that are seen from above: measured, both are least near this.
const float CASTER_DEPTH = 2.0;

// Point k in the light, in units of its half sides: a sequence whose every part is even.
vec2 sky_point(int k) {
    return fract(float(k) * vec2(0.75487767, 0.56984029) + 0.5) * 2.0 - 1.0;
}

// A light's map as seen from a receiver, in texels across and metres along.
struct sky_field {
    sky_maps_of maps;
    ivec2 side;       // of a map
    vec2 place;       // the receiver's
    float height;     // its, over the far plane
    float rise;       // of map depth 0 over 1
    vec4 above_plane; // over the receiver's plane, by a texel, its map depth and 1
};

// How far a surface lies above a place `up` above the receiver; 0 where it is no higher above the receiver's plane than
// its own texels' doubt.
float sky_cover(sky_field f, vec2 place, float up) {
    ivec2 texel = ivec2(floor(place));
    bool outside = texel != clamp(texel, ivec2(0), f.side * f.maps.side - 1);
    ivec2 map = SUNS > 0 ? ivec2(floor(place / vec2(f.side))) : ivec2(0);
    int layer = f.maps.first + map.y * f.maps.side + map.x;
    float depth = texelFetch(sky_maps, ivec3(texel - map * f.side, layer), 0).r;
    float cover = f.height - depth * f.rise - up;
    return outside || dot(f.above_plane, vec4(texel, depth, 1.0)) < 0.0 ? 0.0 : cover;
}

float sky_visibility(int i, vec3 position, vec3 normal) {
    sky_view v = sky_view_at(i);
    mat3 to_view = transpose(mat3(v.right, v.up, v.forward));
    vec3 at = to_view * (position - v.origin), across = to_view * normal;
    sky_maps_of maps = sky_maps_at(i);
    ivec2 side = textureSize(sky_maps, 0).xy;
    vec2 size = vec2(side * maps.side);
    vec2 texels = 0.5 * size / v.half_size; // a metre
    sky_field f = sky_field(maps, side, at.xy * texels + 0.5 * size, at.z, v.far, vec4(0.0));
    vec2 slope = across.xy / texels;
    f.above_plane = vec4(slope, across.z * v.far, dot(slope, 0.5 - f.place) - across.z * at.z - params.bias / texels.x);
    float seen = 0.0, above = 0.0, begun = sky_cover(f, f.place, 0.0); // where all ways begin
    for (int k = 0; k < WAYS; k++) {
        vec2 way = v.sides * sky_point(k);
        bool counts = dot(across.xy, way) > across.z;
        float jitter = fract(float(k) * 0.61803399) - 1.0, beside = 1.0 / (texels.x * length(way));
        bool hidden = begun > 0.0 && begun < beside;
        for (int n = 1; n < PLACES && counts && !hidden; n++) {
            float share = (float(n) + jitter) / float(PLACES - 1);
            float up = share * share * at.z;
            float cover = sky_cover(f, f.place + way * texels * up, up);
            float depth = max(CASTER_DEPTH * 2.0 * share / float(PLACES - 1) * at.z, beside);
            hidden = cover > 0.0 && cover < depth;
        }
        seen += counts && !hidden ? 1.0 : 0.0;
        above += counts ? 1.0 : 0.0;
    }
    return seen / max(above, 1.0);
}
