// Lights without maps, sampled by a tree in proportion to an estimate of their light at a point, or by flux
// (scene/lights/light_tree.h).
#include "lib/light.glsl"
#include "lib/direction.glsl"
#include "shared/light_tree.h"
#include "shared/sampled_light.h"

layout(binding = UNIT_LIGHT_NODES) uniform samplerBuffer light_nodes;
layout(binding = UNIT_SAMPLED_LIGHTS) uniform samplerBuffer sampled_lights;

int light_node_link(int node) {
    return floatBitsToInt(texelFetch(light_nodes, LIGHT_NODE_ROWS * node + 2).w);
}

// Of a node other than the root at a point of a surface, over the power of all lights, 1/m2.
float light_node_importance(int node, vec3 position, vec3 normal) {
    vec4 a = texelFetch(light_nodes, LIGHT_NODE_ROWS * node), b = texelFetch(light_nodes, LIGHT_NODE_ROWS * node + 1);
    vec4 c = texelFetch(light_nodes, LIGHT_NODE_ROWS * node + 2);
    vec3 to = a.xyz - position;
    float distance2 = dot(to, to), radius2 = a.w * a.w, inverse = inversesqrt(max(distance2, 1e-30));
    float cosines = light_node_cosines(distance2, radius2, dot(normal, to) * inverse, -dot(b.xyz, to) * inverse, b.w, c.y);
    bool reaches = distance2 * inverse - a.w <= c.z;
    return reaches ? c.x * cosines / max(max(distance2, radius2), LIGHT_DISTANCE2_MIN) : 0.0;
}

// A light at a point, by a number from 0 to 1, which becomes another one, and its probability; -1: none, which has the rest
// of the probability.
int light_tree_sample(vec3 position, vec3 normal, inout float number, out float probability) {
    int link = light_node_link(0);
    probability = 1.0;
    while (link >= 0 && probability > 0.0) {
        float first = light_node_importance(link, position, normal);
        float sum = first + light_node_importance(link + 1, position, normal);
        float share = sum > 0.0 ? first / sum : 0.0;
        bool is_first = number < share;
        float part = is_first ? share : 1.0 - share;
        number = clamp((is_first ? number : number - share) / part, 0.0, 0.99999994);
        probability = sum > 0.0 ? probability * part : 0.0;
        link = light_node_link(is_first ? link : link + 1);
    }
    return probability > 0.0 ? -1 - link : -1;
}

vec4 sampled_light_row(int i, int row) {
    return texelFetch(sampled_lights, SAMPLED_LIGHT_ROWS * i + row);
}

// A light by its flux; `number` becomes another one.
int light_by_flux(inout float number) {
    int first = 0, last = textureSize(sampled_lights) / SAMPLED_LIGHT_ROWS - 1;
    while (first < last) {
        int middle = (first + last + 1) / 2;
        bool is_after = sampled_light_row(middle, 0).w <= number;
        first = is_after ? middle : first;
        last = is_after ? last : middle - 1;
    }
    number = clamp((number - sampled_light_row(first, 0).w) / sampled_light_row(first, 1).w, 0.0, 0.99999994);
    return first;
}

// Fraction of the flux of all.
float sampled_light_flux(int i) {
    return sampled_light_row(i, 1).w;
}

// A light as a point, and its shape.
light sampled_light_at(int i, out int shape, out vec2 size) {
    vec4 a = sampled_light_row(i, 0), b = sampled_light_row(i, 1), c = sampled_light_row(i, 2);
    vec4 d = sampled_light_row(i, 3), e = sampled_light_row(i, 4), f = sampled_light_row(i, 5);
    vec4 g = sampled_light_row(i, 6);
    light l = light(a.xyz, 0.0, b.xyz, floatBitsToInt(c.w), c.xyz, 0, d.xyz, d.w, e.xyz, e.w, vec3(0.0), 1.0, 0,
                    LIGHT_SHAPE_POINT, 0.0, 0.0, 0.0, 0, 0.0, f.w, floatBitsToInt(g.x), g.y, g.z, g.w);
    shape = floatBitsToInt(f.z);
    size = f.xy;
    return l;
}

// The place of a light's shape that two numbers choose, evenly over its area (emitter_piece in scene/lights/emitter.h).
light sampled_light_piece(int i, vec2 place) {
    int shape;
    vec2 size;
    light l = sampled_light_at(i, shape, size);
    float turn = 6.28318531 * place.y, radius = 0.5 * size.x;
    if (shape == LIGHT_SHAPE_RECTANGLE)
        l.position += (place.x - 0.5) * size.x * l.right + (place.y - 0.5) * size.y * l.up;
    if (shape == LIGHT_SHAPE_TRIANGLE) {
        float root = sqrt(place.x);
        l.position += (1.0 - root) * l.right + root * place.y * l.up;
        l.right = normalize(l.right);
        l.up = cross(l.right, l.direction);
    }
    if (shape == LIGHT_SHAPE_DISK)
        l.position += disk_place(radius, l.right, l.up, place);
    if (shape == LIGHT_SHAPE_SPHERE) {
        float z = 1.0 - 2.0 * place.x, across = sqrt(max(1.0 - z * z, 0.0));
        l.direction = across * (cos(turn) * l.right + sin(turn) * l.up) + z * l.direction;
        l.right = perpendicular(l.direction);
        l.up = cross(l.right, l.direction);
        l.position += radius * l.direction;
        l.type = LIGHT_TYPE_AREA;
        l.intensity *= 4.0; // a bit of it has a quarter of the area that is seen
    }
    return l;
}

// The same towards a receiver, from which a sphere looks as a disk does; whether the light has a size.
light sampled_light_towards(int i, vec3 receiver, vec2 place, out bool is_sized) {
    int shape;
    vec2 size;
    light l = sampled_light_at(i, shape, size);
    is_sized = shape != LIGHT_SHAPE_POINT;
    if (shape != LIGHT_SHAPE_SPHERE)
        return sampled_light_piece(i, place);
    vec3 away = normalize(receiver - l.position), right = perpendicular(away);
    l.position += disk_place(0.5 * size.x, right, cross(away, right), place);
    return l;
}
