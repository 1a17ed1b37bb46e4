// How much of path i's light goes to what the camera sees, as a patch sends it and as it does; and how much in all. A ray from
// the eye tells, as what is seen may be thinner than a pixel, and the light may have come from behind it.
#include "visibility/triangle_tree.glsl"
#include "lights/bounce_paths.glsl"
#include "lib/camera.glsl"

layout(binding = UNIT_PATH_AREAS) uniform sampler2D path_areas; // and powers

layout(location = TARGET_RESULT) out vec4 seen_and_all;

bool is_seen(vec3 from, vec3 to) {
    const float SAME = 1e-3; // of the distance
    vec4 clip = camera.world_to_clip * vec4(to, 1.0);
    vec2 ndc = clip.xy / clip.w;
    vec3 eye = view_position_at(camera, ndc, 0.0);
    float apart = distance(eye, to);
    bool shown = clip.w > 0.0 && all(lessThan(abs(ndc), vec2(1.0))) && apart > 0.0;
    tree_hit hit = tree_meet(eye, (to - eye) / max(apart, 1e-30), shown);
    return shown && hit.triangle >= 0 && abs(hit.distance - apart) < SAME * apart && dot(from - to, hit.normal) > 0.0;
}

void main() {
    int i = int(gl_FragCoord.x);
    vec2 powers = texelFetch(path_areas, ivec2(i, 0), 0).yz;
    bool seen = powers.y > 0.0 && is_seen(path_position(i), path_next(i).xyz);
    seen_and_all = vec4(seen ? powers : vec2(0.0), powers);
}
