// Which share of a sky's light a receiver sees: of ways to points of the light, those that meet nothing. A way is
// followed through what the light's map has there: where it comes from below a surface to above it, or the other way
// round, it met it, or passed its edge, which is told by places in between. What meets nothing there is followed
// through the map of the next light beyond, too: walls that a roof hides from one of them are seen by the other. Where
// the axes of both meet something, the sky begins between them or not at all, and a third map is asked.
//
// All is in a view's frame: x right, y up, z away from the light, metres; up: metres towards the light.
#include "lib/sky.glsl"
#include "shared/environment_lighting.h"
#include "visibility/sky_maps.glsl"

layout(binding = UNIT_SKY_MAPS) uniform sampler2DArray sky_maps;
layout(binding = UNIT_SKY_SHARES) uniform sampler2DArray sky_share_table; // visibility/sky_shares.frag

// Irradiance over radiance of four lights that nothing hides: as smooth as it is, between the table's normals
// it is off by no more than 5e-4 of the brightest.
vec4 sky_shares(vec3 normal, int layer) {
    vec2 place = (octahedral_encode(normal) * float(SKY_SHARES_SIZE - 1) + 0.5) / float(SKY_SHARES_SIZE);
    return textureLod(sky_share_table, vec3(place, layer), 0.0);
}

const int PLACES = 6, HALVINGS = 5;
// Between a place below a surface and one above it a way met the surface or passed its edge. It met it where heights
// there differ by no more than so many times what the way rose, and so many texels.
const float STEEPEST = 2.0, STEP = 3.0;

// Point k of so many in the light, in units of its half sides: even, and each has one across the middle, so that their mean
// is there.
vec2 sky_point(int k, int count) {
    float aside = float(k) - 0.5 * float(count - 1);
    return vec2(2.0 * aside / float(count), fract(aside * 0.61803399 + 0.5) * 2.0 - 1.0);
}

// A light's map as seen from a receiver, in texels across and metres along.
struct sky_field {
    sky_maps_of maps;
    ivec2 side;       // of a map
    vec2 texels;      // a metre
    vec2 place;       // the receiver's
    float height;     // its, over the far plane
    float rise;       // of map depth 0 over 1
    float most;       // metres from it to map depth 0
    vec4 above_plane; // over the receiver's plane, by a texel, its map depth and 1
};

// To a sun each way is a step of its penumbra, so that few would be seen as bands.
const int SUN_WAYS_LEAST = 16;

int ways_to(sky_field f) {
    return f.maps.side > 1 ? max(WAYS, SUN_WAYS_LEAST) : WAYS;
}

sky_field sky_field_of(int i, sky_view v, vec3 position, vec3 normal) {
    mat3 to_view = transpose(mat3(v.right, v.up, v.forward));
    vec3 at = to_view * (position - v.origin), across = to_view * normal;
    sky_maps_of maps = sky_maps_at(i);
    ivec2 side = textureSize(sky_maps, 0).xy;
    vec2 size = vec2(side * maps.side), texels = 0.5 * size / v.half_size, slope = across.xy / texels;
    vec2 place = at.xy * texels + 0.5 * size;
    vec4 above_plane = vec4(slope, across.z * v.far,
                            dot(slope, 0.5 - place) - across.z * at.z - params.bias / texels.x);
    return sky_field(maps, side, texels, place, at.z, v.far, at.z, above_plane);
}

// A surface's height above the receiver, and how far it lies above a place `up` above it: at most 0 where it is no
// higher above the receiver's plane than its own texels' doubt.
struct sky_surface {
    float height, cover;
};

sky_surface sky_surface_at(sky_field f, vec2 place, float up) {
    ivec2 texel = ivec2(floor(place));
    bool outside = texel != clamp(texel, ivec2(0), f.side * f.maps.side - 1);
    ivec2 map = SUNS > 0 ? ivec2(floor(place / vec2(f.side))) : ivec2(0);
    int layer = f.maps.first + map.y * f.maps.side + map.x;
    float depth = texelFetch(sky_maps, ivec3(texel - map * f.side, layer), 0).r;
    float height = outside ? -1e9 : f.height - depth * f.rise;
    bool own = dot(f.above_plane, vec4(texel, depth, 1.0)) < 0.0;
    return sky_surface(height, own ? min(height - up, 0.0) : height - up);
}

sky_surface sky_either(bool first, sky_surface a, sky_surface b) {
    return sky_surface(first ? a.height : b.height, first ? a.cover : b.cover);
}

// Whether a way from under or over the surface `begin` at the receiver's own place meets any.
bool sky_meets(sky_field f, sky_surface begin, vec2 way, float jitter) {
    sky_surface before = begin;
    float last = 0.0;
    bool met = false;
    for (int n = 1; n < PLACES && !met; n++) {
        float share = (float(n) + jitter) / float(PLACES - 1);
        float up = share * share * f.most;
        sky_surface here = sky_surface_at(f, f.place + way * f.texels * up, up), nearer = before, farther = here;
        bool from_below = before.cover > 0.0, crosses = from_below != (here.cover > 0.0);
        float low = last, high = up;
        for (int halving = crosses ? HALVINGS : 0; halving > 0; halving--) {
            float middle = 0.5 * (low + high);
            sky_surface between = sky_surface_at(f, f.place + way * f.texels * middle, middle);
            bool not_yet = (between.cover > 0.0) == from_below;
            low = not_yet ? middle : low;
            high = not_yet ? high : middle;
            nearer = sky_either(not_yet, between, nearer);
            farther = sky_either(not_yet, farther, between);
        }
        float rise = high - low;
        met = crosses && abs(farther.height - nearer.height) < STEEPEST * rise + STEP / f.texels.x ||
              from_below && nearer.cover < rise;
        before = here;
        last = up;
    }
    return met || before.cover > 0.0;
}

// As sky_meets through the map of light i, of a way that is given in the world; clear: along its axis there is nothing,
// either.
bool sky_meets_beyond(int i, vec3 position, vec3 normal, vec3 towards, float jitter, inout bool clear) {
    sky_view v = sky_view_at(i);
    sky_field f = sky_field_of(i, v, position, normal);
    sky_surface begin = sky_surface_at(f, f.place, 0.0);
    clear = clear || begin.cover <= 0.0;
    vec2 way = vec2(dot(v.right, towards), dot(v.up, towards)) / -dot(v.forward, towards);
    return sky_meets(f, begin, way, jitter);
}

float sky_visibility(int i, vec3 position, vec3 normal) {
    sky_view v = sky_view_at(i);
    sky_field f = sky_field_of(i, v, position, normal);
    sky_surface begin = sky_surface_at(f, f.place, 0.0);
    ivec4 beyond = sky_beyond(i), further = sky_further(i);
    float seen = 0.0, above = 0.0;
    int ways = ways_to(f);
    bool sun = f.maps.side > 1;
    for (int k = 0; k < ways; k++) {
        vec2 point = sky_point(k, ways), way = v.sides * point;
        vec3 towards = v.right * way.x + v.up * way.y - v.forward;
        float jitter = fract((float(k) + 0.5) * 0.75487767) - 1.0;
        int quarter = (point.x > 0.0 ? 1 : 0) + (point.y > 0.0 ? 2 : 0);
        bool counts = dot(towards, normal) > 0.0, hidden = false, clear = begin.cover <= 0.0;
        if (counts)
            hidden = sky_meets(f, begin, way, jitter);
        if (counts && !hidden && beyond[quarter] != i)
            hidden = sky_meets_beyond(beyond[quarter], position, normal, towards, jitter, clear);
        if (counts && !hidden && !clear && !sun && further[quarter] != i)
            hidden = sky_meets_beyond(further[quarter], position, normal, towards, jitter, clear);
        seen += counts && !hidden ? 1.0 : 0.0;
        above += counts ? 1.0 : 0.0;
    }
    return seen / max(above, 1.0);
}
