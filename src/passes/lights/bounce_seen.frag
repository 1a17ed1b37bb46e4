// How much of path i's light goes to what the camera sees, as a patch sends it and as it does; and how much in all. A ray from
// the eye tells, as what is seen may be thinner than a pixel, and the light may have come from behind it.
#include "passes/visibility/bvh.glsl"
#include "passes/lights/bounce_paths.glsl"
#include "passes/gather/vpl_terms.glsl"
#include "lib/gbuffer.glsl"

layout(location = TARGET_RESULT) out vec4 seen_and_all;

bool is_seen(vec3 from, vec3 to) {
    const float SAME = 1e-3; // of the distance
    vec4 clip = camera.world_to_clip * vec4(to, 1.0);
    vec2 ndc = clip.xy / clip.w;
    vec3 eye = view_position_at(camera, ndc, 0.0);
    float apart = distance(eye, to);
    bool shown = clip.w > 0.0 && all(lessThan(abs(ndc), vec2(1.0))) && apart > 0.0;
    bvh_hit hit = bvh_meet(eye, (to - eye) / max(apart, 1e-30), shown);
    return shown && hit.triangle >= 0 && abs(hit.distance - apart) < SAME * apart && dot(from - to, hit.normal) > 0.0;
}

// How much arrives as a patch sends it, and as the path does.
vec2 arriving(int i) {
    float apart = path_next(i).w, arrives = apart >= 0.0 ? path_power(i) : 0.0;
    return arrives > 0.0 ? vec2(arrives * patch_share(apart * apart, path_area(i)), arrives) : vec2(0.0);
}

void main() {
    int i = int(gl_FragCoord.x);
    vec2 powers = arriving(i);
    bool seen = powers.y > 0.0 && is_seen(path_position(i), path_next(i).xyz);
    seen_and_all = vec4(seen ? powers : vec2(0.0), powers);
}
