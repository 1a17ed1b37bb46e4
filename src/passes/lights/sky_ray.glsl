// The VPL of a sky's light sample: what a ray meets from one of its many directions. One direction for all its VPLs would be
// luck where its light comes through a window.
#include "passes/visibility/bvh.glsl"
#include "passes/lights/sky_pieces.glsl"
#include "passes/lights/light_end.glsl"
#include "passes/lights/vpl_lobe.glsl"
#include "lib/lattice.glsl"
#include "lib/light.glsl"
#include "lib/vpl_rows.glsl"

// Multiples of the golden ratio are even however few there are, and unlike the numbers of places.
int sky_piece_of(int number) {
    return int(uint(number) * LATTICE_GOLDEN >> SKY_PIECE_SHIFT);
}

vpl vpl_by_sky_ray(int index, int number, float measure, vec2 place) {
    int piece = sky_piece_of(number);
    vec4 origin = sky_piece_row(index, piece, 0);
    vec4 right = sky_piece_row(index, piece, 1), up = sky_piece_row(index, piece, 2);
    vec2 at = 2.0 * fract(place + vec2(right.w, up.w)) - 1.0;
    vec3 from = origin.xyz + at.x * right.xyz + at.y * up.xyz;
    vec3 direction = normalize(cross(up.xyz, right.xyz));
    vec3 albedo, arrives;
    vec4 specular;
    float away;
    surface s = light_end(from, direction, floatBitsToUint(place) + uint(number), albedo, specular, arrives, away);
    if (!s.present)
        return vpl_even(from, -direction, 0.0, vec3(0.0), 0.0);
    float area = origin.w * measure, cosine = dot(s.normal, -direction);
    vec3 power = sky_piece_row(index, piece, 3).xyz * area * arrives;
    vpl v = vpl_even(s.position, s.normal, area / max(cosine, VPL_COSINE_MIN), albedo * power, 0.0);
    take_lobe(v, specular, albedo, -direction, cosine, 0.0);
    return v;
}
