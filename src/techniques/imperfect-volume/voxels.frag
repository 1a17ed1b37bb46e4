// The first occupied voxel before the camera at each pixel: its radiosity times irradiance_scale; 0 where there is none.
#include "lib/gbuffer.glsl"
#include "lib/volume.glsl"
#include "passes/volume/ray_radiance.glsl"

layout(location = TARGET_RESULT) out vec4 result;

const float BEYOND = 1e-3; // into the next voxel

float least(vec3 v) {
    return min(v.x, min(v.y, v.z));
}

void main() {
    vec2 ndc = gl_FragCoord.xy / vec2(gbuffer_size()) * 2.0 - 1.0;
    vec3 eye = volume_place(view_position_at(camera, ndc, 0.0));
    vec3 direction = normalize(volume_place(view_position_at(camera, ndc, 1.0)) - eye);
    direction = mix(direction, vec3(1e-6), lessThan(abs(direction), vec3(1e-6)));
    bvec3 rises = greaterThan(direction, vec3(0.0));
    vec3 entries = (mix(params.cells, vec3(0.0), rises) - eye) / direction;
    float end = least((mix(vec3(0.0), params.cells, rises) - eye) / direction) - BEYOND;
    float t = max(-least(-entries), 0.0) + BEYOND;
    result = vec4(0.0);
    while (t < end) {
        vec3 place = eye + t * direction;
        int away = volume_distance(ivec3(place));
        // The camera may be as near to a surface as to lie in its voxel.
        if (away == 0 && ivec3(place) != ivec3(floor(eye))) {
            result = vec4(leaving(ivec3(place), direction) * 3.1415927, 1.0);
            return;
        }
        float side = least((floor(place) + mix(vec3(0.0), vec3(1.0), rises) - place) / direction);
        t += max(side, float(away - 1)) + BEYOND;
    }
}
