// What arrives at a voxel's middle from all around, as spherical harmonics: the mean over rays [Mavridis and
// Papaioannou 2011, eq. 3]. Rays leap over voxels that are known to be empty and so meet what steps of a voxel meet.
#include "lib/random.glsl"
#include "lib/sh.glsl"
#include "lib/volume.glsl"
#if CHANNELS == VOLUME_RADIANCE
#include "passes/volume/ray_radiance.glsl"
#else
// Rays of ambient occlusion: 1 where nothing is met, or what panes let pass.
#include "lib/medium.glsl"

#define gathered float[1]

gathered ray_end(ivec3 voxel, bool met, vec3 origin, vec3 direction, float metres) {
    return float[1](met ? 0.0 : dot(medium_panes(origin, direction, metres), vec3(1.0 / 3.0)));
}
#endif

layout(location = 0) out vec4 coefficients[COEFFICIENTS];

const float FIRST_STEP = 0.8660254; // half of a voxel's diagonal

#if PUBLISHED
// Random in each of as many slices as there are rays.
vec3 ray_direction(ivec3 voxel, int ray) {
    vec2 place = fract(random_of(uvec3(voxel.xy, voxel.z * 8192 + ray)) + params.turn);
    float z = 1.0 - 2.0 * (float(ray) + place.x) / float(params.rays), turn = 6.2831853 * place.y;
    return vec3(sqrt(max(1.0 - z * z, 0.0)) * vec2(cos(turn), sin(turn)), z);
}
#else
// The rays of 3 x 3 x 3 voxels share out the sphere between them: passes/volume/smooth.frag takes their mean.
const int SETS = 27;

vec2 set_of(ivec3 voxel) {
    ivec3 place = voxel % 3;
    int set = place.x + 3 * place.y + 9 * place.z;
    // 8 and 27 have no common divisor: neighbours are far apart on the axis.
    return fract(vec2((float(set * 8 % SETS) + 0.5) / float(SETS), float(set) * 0.5698403) + params.turn);
}

// Spherical Fibonacci points, other ones in each voxel of a set but the same in each frame.
vec3 ray_direction(ivec3 voxel, int ray) {
    vec2 shift = set_of(voxel);
    float z = 1.0 - 2.0 * (float(ray) + shift.x) / float(params.rays);
    float turn = 6.2831853 * fract(float(ray) * 0.6180340 + shift.y), r = sqrt(max(1.0 - z * z, 0.0));
    return vec3(r * cos(turn), r * sin(turn), z);
}
#endif

// How far it is to where the ray leaves the volume.
float way_out(vec3 start, vec3 direction) {
    vec3 to_side = mix(start, params.cells - start, greaterThan(direction, vec3(0.0)));
    vec3 ways = to_side / max(abs(direction), vec3(1e-6));
    return min(ways.x, min(ways.y, ways.z)) - 1e-3;
}

void main() {
    ivec3 voxel = volume_voxel(ivec2(gl_FragCoord.xy));
    for (int i = 0; i < COEFFICIENTS; i++)
        coefficients[i] = vec4(0.0);
    if (voxel.z >= int(params.cells.z) || !volume_is_read(voxel))
        return;
    vec3 start = vec3(voxel) + 0.5;
    for (int ray = 0; ray < params.rays; ray++) {
        vec3 direction = ray_direction(voxel, ray);
        float t = FIRST_STEP, end = min(params.distance, way_out(start, direction));
        int away = 1;
        ivec3 at = voxel;
        while (t <= end) {
            at = ivec3(start + direction * t);
            away = volume_distance(at);
            if (away == 0)
                break;
            t += float(away);
        }
        vec3 origin = params.corner + params.voxel * start;
        gathered light = ray_end(at, away == 0, origin, direction, min(t, end) * params.voxel);
        vec4 low = sh_low(direction);
        for (int c = 0; c < CHANNELS; c++)
            coefficients[c] += light[c] * low;
#if ORDER == 3
        vec4 high = sh_high(direction);
        float last = sh_last(direction);
        for (int c = 0; c < CHANNELS; c++) {
            coefficients[CHANNELS + c] += light[c] * high;
            coefficients[2 * CHANNELS][c] += light[c] * last;
        }
#endif
    }
    for (int i = 0; i < COEFFICIENTS; i++)
        coefficients[i] *= 12.5663706 / float(params.rays);
}
