// Soft shadows of one light by its own shape: its map is searched along ways to points of it [Fernando 2005]. Where
// something is in front, the share of ways that are free is found by rays, or by the map at one distance.
//
// All places are relative to the light's (a sun's: to its view's origin). t is how far along a way from the
// receiver to the light: a share of it, or of a sun metres.
#include "lib/gbuffer.glsl"
#include "lib/unshadowed.glsl"
#include "passes/visibility/direct_light.glsl"
#include "shared/maps.h"

layout(std140, binding = BLOCK_LOOKUP) uniform lookup_uniforms {
    lookup_params lookup;
};

layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray depth_maps;

const bool IS_SUN = PROJECTION == PROJECTION_ORTHOGRAPHIC;
const float OFFSET = 1.0 / 6.0; // of what a receiver is lifted by where no plane is compared

// As a receiver sees the light.
struct shape {
    vec3 right, up; // half sides, or the radius both ways; of a sun tangents
    vec3 front;     // unit
    bool is_round;
};

struct place {
    vec3 position, normal;
    vec3 toward;    // ways go to points of the shape less this
    float distance; // along the shape's front; of a sun 1, which t is over
};

// A texel of the light's maps: the surface that it shows, on the line from the light through its middle.
struct map_texel {
    bool is_empty;
    vec3 surface, line; // line: unit, from the light
    float depth;        // of the surface along the line
    float width;        // of the texel, at the surface
};

shape shape_of(light l, vec3 position) {
    float least = IS_SUN ? 1e-6 : 1e-6 * length(position);
    vec2 sides = max(0.5 * vec2(l.width, l.height > 0.0 ? l.height : l.width), least);
    vec3 right = l.right, up = l.up, front = l.direction;
    if (IS_SUN)
        sides = tan(sides);
    if (l.type == LIGHT_TYPE_POINT) {
        front = normalize(position);
        right = normalize(abs(front.y) < 0.9 ? cross(front, vec3(0.0, 1.0, 0.0)) : cross(front, vec3(1.0, 0.0, 0.0)));
        up = cross(right, front);
    }
    return shape(right * sides.x, up * sides.y, front, l.shape != LIGHT_SHAPE_RECTANGLE);
}

// Point i of n in the shape, in units of its half sides: a sequence whose every part is even.
vec2 shape_point(shape s, int i) {
    vec2 p = fract(float(i) * vec2(0.75487767, 0.56984029) + 0.5);
    float turn = 6.28318531 * p.y;
    return s.is_round ? sqrt(p.x) * vec2(cos(turn), sin(turn)) : p * 2.0 - 1.0;
}

vec3 on_way(shape s, place x, vec2 p, float t) {
    return x.position + t * (p.x * s.right + p.y * s.up - x.toward);
}

// The texel that shows a place.
map_texel texel_at(light l, vec3 at) {
    light_view v = light_view_at(light_view_index(l, at));
    vec2 half_size = vec2(length(v.view.right), length(v.view.up));
    float along = dot(at, v.view.forward);
    vec2 ndc = vec2(dot(at, v.view.right), dot(at, v.view.up)) / (half_size * half_size * (IS_SUN ? 1.0 : along));
    ivec2 size = textureSize(depth_maps, 0).xy;
    ivec2 texel_index = clamp(ivec2((ndc * 0.5 + 0.5) * vec2(size)), ivec2(0), size - 1);
    float stored = texelFetch(depth_maps, ivec3(texel_index, v.layer), 0).r;
    vec2 center = (vec2(texel_index) + 0.5) / vec2(size) * 2.0 - 1.0;
    vec3 aside = center.x * v.view.right + center.y * v.view.up;
    map_texel found;
    found.is_empty = stored <= 0.0;
    float depth = found.is_empty ? 1e30 : view_linear_depth(v.view, stored);
    vec3 ray = IS_SUN ? v.view.forward : v.view.forward + aside;
    found.line = normalize(ray);
    found.depth = depth * length(ray);
    found.surface = IS_SUN ? aside + depth * ray : depth * ray;
    found.width = 2.0 * half_size.x / float(size.x) * (IS_SUN ? 1.0 : depth);
    return found;
}

// Where the receiver's plane, met on the texel's line, is nearer than the receiver, that is compared: it does
// not shadow itself however it is tilted. Where it is farther, the receiver is: in a corner the plane goes on
// behind the other wall.
bool is_blocked(place x, map_texel found) {
    if (found.is_empty)
        return false;
    float facing = dot(x.normal, found.line);
    vec3 from = IS_SUN ? x.position - (found.surface - found.line * found.depth) : x.position;
    float away = IS_SUN ? dot(x.position, found.line) : length(x.position);
    float plane = facing < -1e-3 ? dot(x.normal, from) / facing : away;
    return found.depth < clamp(plane, 0.5 * away, away) * (1.0 - lookup.map_bias);
}

// Whether a way past the texel's surface comes from the light, given a texel's doubt.
bool hides(shape s, place x, map_texel found, float t) {
    vec3 from = (found.surface - x.position) / t + x.toward;
    vec2 p = vec2(dot(from, s.right) / dot(s.right, s.right), dot(from, s.up) / dot(s.up, s.up));
    vec2 doubt = found.width / (t * vec2(length(s.right), length(s.up)));
    vec2 inside = max(abs(p) - doubt, 0.0);
    return s.is_round ? dot(inside, inside) <= 1.0 : max(inside.x, inside.y) <= 1.0;
}

// How far along a way from the light the surface of a texel that is blocked lies; 0 where no way does.
float hidden_at(shape s, place x, map_texel found) {
    float t = dot(x.position - found.surface, s.front) / x.distance;
    return t > 0.0 && hides(s, x, found, t) ? t : 0.0;
}

struct casters {
    float mean; // t of what hides the light; 0 where nothing does
    bool any;   // something is in front
};

casters search(light l, shape s, place x, float reach) {
    float sum = 0.0, count = 0.0;
    bool any = false;
    for (int i = 0; i < SEARCH_TAPS; i++) {
        float t = reach * (float(i) + 0.5) / float(SEARCH_TAPS);
        map_texel found = texel_at(l, on_way(s, x, shape_point(s, i), t));
        bool blocked = is_blocked(x, found);
        t = blocked ? hidden_at(s, x, found) : 0.0;
        sum += t;
        count += t > 0.0 ? 1.0 : 0.0;
        any = any || blocked;
    }
    return casters(sum / max(count, 1.0), any);
}

#if SHADOW_RAYS > 0
// The share of a light that is free, by shadow rays to points of it wherever its map has something in front.
#include "passes/visibility/bvh.glsl"

// First of all go to the light's rim, where shadows begin and end, and halfway to it: where they agree there are no more.
const int FIRST_RAYS = SHADOW_RAYS < 16 ? SHADOW_RAYS : 16;

vec2 first_point(shape s, int i) {
    float turn = 6.28318531 * float(i) / float(FIRST_RAYS);
    vec2 p = vec2(cos(turn), sin(turn));
    return (i % 2 == 0 ? 1.0 : 0.5) * (s.is_round ? p : p / max(abs(p.x), abs(p.y)));
}

// Where rays begin: a little towards the camera, since rasterisers round corners of triangles to parts of a pixel. A
// pixel's centre may lie that far past an edge, behind the wall beside, where all light would be hidden.
vec3 before_surface(surface at) {
    const float ROUNDED = 1.0 / 128.0; // of a pixel
    float pixel = view_height(camera, gbuffer_depth(ivec2(gl_FragCoord.xy))) / float(gbuffer_size().y);
    vec3 direction = normalize(camera.orthographic ? camera.forward : at.position - camera.origin);
    return at.position - direction * (ROUNDED * pixel / max(-dot(direction, at.normal), 0.1));
}

bool is_hidden(vec3 origin, vec3 way, bool asks) {
    return bvh_meets_any(bvh_ray_along(origin, way, IS_SUN ? BVH_FAR : 1.0 - bvh_clearance() / length(way)), asks);
}

// Adds what a point of the light gives if it is free, and if all are.
void ask(light l, vec3 origin, shape s, place x, vec2 point, inout vec2 free_of_all) {
    vec3 end = on_way(s, x, point, 1.0), toward = end - x.position;
    float away2 = dot(toward, toward), faces = max(dot(toward, x.normal), 0.0);
    float gives = IS_SUN ? faces : faces * abs(dot(toward, s.front)) / (away2 * away2);
    bool asks = gives > 0.0;
    bool hidden = is_hidden(origin, IS_SUN ? toward : l.position + end - origin, asks);
    free_of_all += asks ? vec2(hidden ? 0.0 : gives, gives) : vec2(0.0);
}

float free_share(surface at, light l, shape s, place x, casters c, float texel_width) {
    vec2 first = vec2(0.0), all = vec2(0.0);
    vec3 origin = before_surface(at) + bvh_clearance() * at.normal;
    int first_count = l.width > 0.0 ? FIRST_RAYS : 1;
    for (int i = 0; i < (c.any ? first_count : 0); i++)
        ask(l, origin, s, x, first_point(s, i), first);
    bool differ = first.x > 0.0 && first.x < first.y;
    for (int i = 0; i < (differ ? SHADOW_RAYS : 0); i++)
        ask(l, origin, s, x, shape_point(s, i), all);
    first = differ ? all : first;
    return c.any ? (first.y > 0.0 ? first.x / first.y : 0.0) : 1.0;
}
#else
// The share of a light that is free, by its map at one distance, that of what hides it on the mean.
const float KERNEL_MIN = 0.75; // of a texel's width, from the middle: a smaller one would show steps

float free_share(surface at, light l, shape s, place x, casters c, float texel_width) {
    float t = c.mean, width = texel_width * (IS_SUN ? 1.0 : 1.0 - t), blocked = 0.0, free = 0.0;
    vec2 widen = max(vec2(1.0), KERNEL_MIN * width / (max(t, 1e-6) * vec2(length(s.right), length(s.up))));
    // What is in front and yet hides nothing, as a thing close to the light, tells nothing of what is behind it.
    // As a count and not a branch: a software rasteriser leaves a loop that no pixel is in after one step.
    for (int i = 0; i < (t > 0.0 ? FILTER_TAPS : 0); i++) {
        map_texel found = texel_at(l, on_way(s, x, shape_point(s, i) * widen, t));
        if (!is_blocked(x, found))
            free += 1.0;
        else if (hidden_at(s, x, found) > 0.0)
            blocked += 1.0;
    }
    return t > 0.0 ? free / max(free + blocked, 1.0) : 1.0;
}
#endif

place place_of(surface at, light l, shape s, vec3 position) {
    place x;
    x.position = position;
    x.normal = at.normal;
    x.toward = IS_SUN ? s.front : position;
    x.distance = IS_SUN ? 1.0 : max(dot(position, s.front), 1e-3 * length(position));
    return x;
}

float arriving(surface at, light l, vec3 direction) {
    light_view v = light_view_at(light_view_index(l, direction));
    vec3 position = at.position - v.view.origin;
    float depth = dot(position, v.view.forward);
    float texel_width = 2.0 * length(v.view.right) / lookup.map_size * (IS_SUN ? 1.0 : depth);
    position += at.normal * (OFFSET * lookup.bias * texel_width);
    shape s = shape_of(l, position);
    place x = place_of(at, l, s, position);
    float reach = (1.0 - NEAREST) * (IS_SUN ? depth : 1.0);
    casters c = search(l, s, x, reach);
    return free_share(at, l, s, x, c, texel_width);
}
