// What a texel of a tile gathers for, by RECEIVERS (shared/gather.h):
//     bool receiver_pixel(pattern, place, pixel)    false: for nothing
//     surface receiver_surface(pixel)
//     vec3 receiver_triangle(s, pixel)              the normal of the triangle that the surface lies on
#include "shared/gather.h"

#if RECEIVERS == RECEIVERS_ALL
// All pixels: a texel's is the one at the tile's place in the pattern.
#include "lib/gbuffer.glsl"
#include "lib/tiles.glsl"
#include "passes/gather/receiver_facet.glsl"

bool receiver_pixel(interleaving pattern, ivec2 place, out ivec2 pixel) {
    pixel = interleaved_pixel(pattern, ivec2(gl_FragCoord.xy), place);
    return true;
}

surface receiver_surface(ivec2 pixel) {
    return gbuffer_surface(pixel);
}

vec3 receiver_triangle(surface s, ivec2 pixel) {
    return facet_of(s, pixel);
}
#elif RECEIVERS == RECEIVERS_ADAPTIVE
// The pixel or the edge sample that a list has in the texel.
#include "lib/edge_sample.glsl"
#include "lib/gbuffer.glsl"
#include "passes/gather/receiver_facet.glsl"

layout(binding = UNIT_ADAPTIVE_PIXELS) uniform usampler2D adaptive_pixels;
layout(binding = UNIT_EDGE_SAMPLES) uniform usampler2D edge_samples;

flat in ivec3 list_range; // where this tile has the list, row by row: begin, end; which list it is

#ifdef SCREEN_COMPUTE
#include "passes/gather/list_rows.glsl"

// The rows that passes/gather/list_rows.vert covers.
void list_begin(ivec2 place) {
    list_range = list_range_of(place);
    ivec2 rows = list_rows(list_range);
    screen_area.yw = ivec2(screen_area.y + rows.x, rows.y - rows.x);
}
#define SCREEN_BEGIN list_begin(slot.zw)
#endif

// False outside the list.
bool receiver_pixel(interleaving pattern, ivec2 place, out ivec2 pixel) {
    ivec2 texel = ivec2(gl_FragCoord.xy), within = texel - place * pattern.tile;
    uint code = texelFetch(adaptive_pixels, texel, 0).r;
    pixel = ivec2(code & 0xffffu, code >> 16);
    int at = within.y * pattern.tile.x + within.x;
    return at >= list_range.x && at < list_range.y;
}

surface edge_sample_surface(ivec2 pixel) {
    edge_sample p = edge_sample_unpack(texelFetch(edge_samples, pixel, 0));
    vec2 ndc = (vec2(pixel) + 0.5 + p.place) / vec2(gbuffer_size()) * 2.0 - 1.0;
    return surface(true, view_position(camera, ndc, p.depth), p.normal);
}

surface receiver_surface(ivec2 pixel) {
    surface s;
    if (list_range.z == LIST_EDGE_SAMPLES)
        s = edge_sample_surface(pixel);
    else
        s = gbuffer_surface(pixel);
    return s;
}

vec3 receiver_triangle(surface s, ivec2 pixel) {
    return list_range.z == LIST_EDGE_SAMPLES ? s.normal : facet_of(s, pixel);
}
#else
// All pixels but those that lists have.
#include "lib/gbuffer.glsl"
#include "lib/tiles.glsl"
#include "passes/gather/receiver_facet.glsl"

layout(binding = UNIT_LIST_TEXELS) uniform usampler2D list_texels;

bool receiver_pixel(interleaving pattern, ivec2 place, out ivec2 pixel) {
    pixel = interleaved_pixel(pattern, ivec2(gl_FragCoord.xy), place);
    return !list_texel_has(texelFetch(list_texels, pixel, 0).r);
}

surface receiver_surface(ivec2 pixel) {
    return gbuffer_surface(pixel);
}

vec3 receiver_triangle(surface s, ivec2 pixel) {
    return facet_of_code(texelFetch(list_texels, pixel, 0).r);
}
#endif
