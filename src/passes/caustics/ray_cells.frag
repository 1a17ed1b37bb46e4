// Cells between four rays that end on one surface, in place of the hierarchical caustic map of [Wyman 2008] that chapter 8
// of [Dong 2011] takes. A ray gives a quarter of its flux to each of its four cells, of two triangles each. Of a cell that
// is torn its rays keep their quarters.
#include "lib/light.glsl"
#include "lib/medium.glsl"
#include "passes/caustics/rays.glsl"
#include "passes/caustics/arriving.glsl"

layout(location = 0) out vec4 first_flux; // of corners 00 10 11, W; w: 1 where the cell is whole
layout(location = 1) out vec4 second_flux; // of corners 00 11 01

const float LEAST_COSINE = 0.7; // between normals of one surface
const float MOST_RISE = 0.3;    // of one surface over another's plane, of their distance
const float MOST_STRETCH = 4.0; // over the steps beside it

vec4 end_at(ivec2 texel) {
    bool is_ray = all(greaterThanEqual(texel, ivec2(0))) && texel.x < params.side &&
        texel.y < params.side * params.chains;
    return is_ray ? texelFetch(ray_ends, texel, 0) : vec4(0.0);
}

// Whether no gap lies between the ends of a ray and the next one: a step is like the one before or the one after.
bool joins(ivec2 texel, ivec2 along) {
    vec4 before = end_at(texel - along), a = end_at(texel), b = end_at(texel + along), after = end_at(texel + 2 * along);
    float width = distance(a.xyz, b.xyz);
    float left = before.w == RAY_LANDS ? distance(before.xyz, a.xyz) : 0.0;
    float right = after.w == RAY_LANDS ? distance(b.xyz, after.xyz) : 0.0;
    vec3 normal_a = end_normal(texelFetch(ray_leaves, texel, 0));
    vec3 normal_b = end_normal(texelFetch(ray_leaves, texel + along, 0));
    vec3 step_ab = b.xyz - a.xyz;
    return width <= MOST_STRETCH * max(left, right) && dot(normal_a, normal_b) > LEAST_COSINE &&
        abs(dot(normal_a, step_ab)) <= MOST_RISE * width && abs(dot(normal_b, step_ab)) <= MOST_RISE * width;
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy), right = ivec2(1, 0), up = ivec2(0, 1);
    first_flux = second_flux = vec4(0.0);
    if (params.points_only || (texel.y + 1) % params.side == 0)
        return;
    vec4 a = end_at(texel), b = end_at(texel + right), c = end_at(texel + right + up), d = end_at(texel + up);
    bool all_land = min(min(a.w, b.w), min(c.w, d.w)) == RAY_LANDS && texel.x + 1 < params.side;
    if (!all_land)
        return;
    if (!joins(texel, right) || !joins(texel + up, right) || !joins(texel, up) || !joins(texel + right, up))
        return;
    vec3 both = 0.125 * (arriving(texel, a, 1.0) + arriving(texel + right + up, c, 1.0));
    first_flux = vec4(both + 0.25 * arriving(texel + right, b, 1.0), 1.0);
    second_flux = vec4(both + 0.25 * arriving(texel + up, d, 1.0), 1.0);
}
