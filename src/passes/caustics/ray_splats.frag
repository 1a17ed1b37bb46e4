// What is left of each ray's flux for a round splat: a quarter for each of its cells that is torn.
#include "lib/light.glsl"
#include "lib/medium.glsl"
#include "passes/caustics/rays.glsl"
#include "passes/caustics/arriving.glsl"

layout(binding = UNIT_PATCHES) uniform sampler2D whole_cells;

layout(location = TARGET_RESULT) out vec4 splat; // W; w: radius, m

const float MOST_WIDE = 4.0; // of what is near

float torn(ivec2 texel) {
    bool is_cell = texel.x >= 0 && texel.y >= 0;
    return is_cell ? 1.0 - texelFetch(whole_cells, texel, 0).w : 1.0;
}

// How far the nearer one of two rays beside it ends on the same surface, metres; 0: none does.
float step_of(ivec2 texel, ivec2 along, vec3 place, vec3 normal) {
    float nearest = 1e30;
    for (int sign = -1; sign <= 1; sign += 2) {
        ivec2 other = texel + sign * along;
        bool is_ray = all(greaterThanEqual(other, ivec2(0))) && other.x < params.side &&
            other.y < params.side * params.chains;
        vec4 end = is_ray ? texelFetch(ray_ends, other, 0) : vec4(0.0);
        float away = distance(end.xyz, place);
        bool is_same = end.w == RAY_LANDS && abs(dot(end.xyz - place, normal)) < 0.1 * away;
        nearest = is_same ? min(nearest, away) : nearest;
    }
    return nearest < 1e30 ? nearest : 0.0;
}

// Of a spot as large as a cell between rays.
float cell_radius(ivec2 texel, vec3 place, vec3 normal) {
    float x = step_of(texel, ivec2(1, 0), place, normal), y = step_of(texel, ivec2(0, 1), place, normal);
    float area = x > 0.0 && y > 0.0 ? x * y : max(x, y) * max(x, y);
    return sqrt(area / 3.14159265);
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec4 end = texelFetch(ray_ends, texel, 0);
    splat = vec4(0.0);
    if (end.w != RAY_LANDS)
        return;
    float left = 0.25 * (torn(texel) + torn(texel - ivec2(1, 0)) + torn(texel - ivec2(0, 1)) + torn(texel - ivec2(1)));
    if (left == 0.0)
        return;
    float metres = distance(texelFetch(ray_leaves, texel, 0).xyz, end.xyz);
    float spread = sqrt(params.measure) * (params.is_disk ? 1.0 : texelFetch(ray_fluxes, texel, 0).w + metres);
    float wide = cell_radius(texel, end.xyz, end_normal(texelFetch(ray_leaves, texel, 0)));
    spread = max(spread, params.points_only ? 0.0 : min(wide, MOST_WIDE * params.reach));
    splat = vec4(arriving(texel, end, left), spread);
}
