// Where a ray first meets what a light shines on, by the light's reflective shadow map.
#include "lib/rsm.glsl"

const int MARCH_STEPS = 32;
const int MARCH_HALVINGS = 6;
// A ray has met a surface where it comes to lie behind one within so many of the map's texels: else it has passed
// behind an edge.
const float MARCH_THICKNESS = 2.0;
const float MARCH_COSINE_MIN = 0.1; // of surfaces that the light grazes
const float MARCH_COSINE_RIM = 0.3;

// What a light's map has where a point lies.
struct march_look {
    float behind;  // how far the point lies behind what is there, along the view's axis, metres
    int view_index;
    ivec2 texel;
};

march_look march_look_at(light l, vec3 position) {
    march_look look = march_look(1e30, light_view_index(l, position - l.position), ivec2(0));
    light_view v = light_view_at(look.view_index);
    vec4 clip = v.view.world_to_clip * vec4(position, 1.0);
    vec2 ndc = clip.xy / clip.w;
    if (clip.w <= 0.0 || any(greaterThanEqual(abs(ndc), vec2(1.0))))
        return look; // in the dark
    look.texel = ivec2((ndc * 0.5 + 0.5) * vec2(rsm_size(v.kind)));
    float depth = rsm_depth(v, look.texel);
    look.behind = depth > 0.0 ? dot(position - v.view.origin, normalize(v.view.forward)) -
                                    view_linear_depth(v.view, depth) * length(v.view.forward)
                              : -1e30;
    return look;
}

// How wide a texel of the view is where the point lies, metres.
float march_texel(light_view v, vec3 position) {
    float depth = v.view.orthographic ? 1.0 : dot(position - v.view.origin, v.view.forward);
    return 2.0 * length(v.view.right) * depth / float(rsm_size(v.kind).x);
}

struct march_hit {
    bool found;
    bool in_light; // all of the ray was: nothing hides its end
    surface end;
    light_view seen_by;
    ivec2 texel;
    float cosine; // of the light there
};

// Whether the ray goes through the surface that the look's texel has, and not past its edge.
bool march_meets(march_look look, vec3 position, inout march_hit hit) {
    hit.seen_by = light_view_at(look.view_index);
    hit.texel = look.texel;
    hit.end = rsm_surface(hit.seen_by, look.texel);
    view v = hit.seen_by.view;
    vec3 seen_along = v.orthographic ? v.forward : position - v.origin;
    hit.cosine = abs(dot(hit.end.normal, normalize(seen_along)));
    hit.found = hit.end.present && abs(look.behind) * max(hit.cosine, MARCH_COSINE_MIN) < MARCH_THICKNESS * march_texel(hit.seen_by, position);
    return hit.found;
}

// Equal parts as the light sees the ray, but shorter where it begins.
float march_distance(float part, float farthest, float from, float to) {
    part *= sqrt(part);
    return farthest * part * from / mix(to, from, part);
}

// The farthest, metres: where the ray leaves the scene. jitter: where steps begin, of [0, 1).
march_hit light_march(light l, vec3 origin, vec3 direction, float farthest, float jitter) {
    bool directional = l.type == LIGHT_TYPE_DIRECTIONAL;
    float from = directional ? 1.0 : distance(origin, l.position);
    float to = directional ? 1.0 : distance(origin + farthest * direction, l.position);
    bool was_behind = march_look_at(l, origin).behind > 0.0;
    float last = 0.0;
    march_hit hit;
    hit.found = false;
    hit.in_light = !was_behind;
    for (int i = 0; i < MARCH_STEPS; i++) {
        float next = march_distance((float(i) + jitter + 1e-3) / float(MARCH_STEPS), farthest, from, to);
        bool is_behind = march_look_at(l, origin + next * direction).behind > 0.0;
        if (is_behind != was_behind) {
            float near = last, far = next;
            for (int j = 0; j < MARCH_HALVINGS; j++) {
                float middle = 0.5 * (near + far);
                bool there = march_look_at(l, origin + middle * direction).behind > 0.0;
                near = there == was_behind ? middle : near;
                far = there == was_behind ? far : middle;
            }
            vec3 position = origin + (is_behind ? far : near) * direction;
            if (march_meets(march_look_at(l, position), position, hit)) {
                float along = dot(hit.end.normal, direction);
                hit.found = is_behind && along < 0.0;
                // Out of what it was in, through its lit side: that has hidden all beyond. Light grazes rims, which a
                // ray may pass as near.
                if (hit.found || !is_behind && along > 0.0 && hit.cosine > MARCH_COSINE_RIM)
                    return hit;
            }
            hit.found = false;
        }
        hit.in_light = hit.in_light && !is_behind;
        was_behind = is_behind;
        last = next;
    }
    return hit;
}
