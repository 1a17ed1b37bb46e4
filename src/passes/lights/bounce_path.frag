// Path (x, y) begins with a share of a VPL's light, walks on and leaves its flux at one of its surfaces. Or it tries several
// walks and leaves the flux of all at one surface of one. Of row 0, which leaves VPLs, one more ray tells where the light
// goes from there.
#include "lib/gbuffer.glsl"
#include "lib/vpl_texels.glsl"
#include "passes/lights/light_walk.glsl"
#include "shared/bounce.h"
#include "shared/light_walk.h"

layout(binding = UNIT_PATH_NUMBERS) uniform sampler2D path_numbers;

layout(location = TARGET_BOUNCE_POSITION) out vec4 position; // A: the normal, packed
layout(location = TARGET_BOUNCE_NORMAL) out vec4 normal;
layout(location = TARGET_BOUNCE_FLUX) out vec4 flux;
layout(location = TARGET_BOUNCE_NEXT) out vec4 next; // A: how far from there, -1: it meets nothing

const float NOWHERE = 1e6; // of the radius: where paths are that leave nothing

vec2 number_at(ivec2 path, int number) {
    int numbers = BOUNCE_NUMBER_RAYS + min(params.bounces, WALK_SURE);
    return texelFetch(path_numbers, ivec2(path.x, numbers * path.y + number), 0).rg;
}

int try_number = 0;

// Other numbers in each pass and with each seed, as the even ones are.
uvec2 chance_of(ivec2 path) {
    uint number = floatBitsToUint(number_at(path, BOUNCE_NUMBER_CHOICE).x);
    return uvec2((path.x * BOUNCE_ROWS + path.y) * BOUNCE_TRIES + try_number, number);
}

// Each try's even numbers are those of the path, shifted.
vec2 walk_number(int ray) {
    ivec2 path = ivec2(gl_FragCoord.xy);
    if (ray >= WALK_SURE)
        return random_of(uvec3(~ray, chance_of(path)));
    vec2 number = number_at(path, BOUNCE_NUMBER_RAYS + ray);
    return try_number == 0 ? number : fract(number + float(try_number) * vec2(0.7548776662, 0.5698402910));
}

#ifdef SEEN
// Surfaces that light walks to count for more where pixels of the picture face them, unblocked. A path leaves its flux there
// rather than outdoors [Talbot et al. 2005]. Light that no pixel of the few sees is left as well, less often.
const int WALK_PIXELS = 4;
const float WALK_SEEN = 6.0; // weight of a surface that all face, over one that none does

float walk_weight(vec3 position, vec3 normal) {
    vec2 shift = random_of(floatBitsToUint(position));
    float seen = 0.0;
    for (int i = 0; i < WALK_PIXELS; i++) {
        surface s = seen_pixel(i, shift);
        vec3 apart = s.position - position;
        bool faces = s.present && dot(apart, normal) > 0.0 && dot(apart, s.normal) < 0.0;
        vec3 end = faces ? s.position : position; // no way, no ray
        seen += faces && !is_blocked(position, normal, end) ? 1.0 : 0.0;
    }
    return 1.0 + (WALK_SEEN - 1.0) * seen / float(WALK_PIXELS);
}
#else
float walk_weight(vec3 position, vec3 normal) {
    return 1.0;
}
#endif

void main() {
    ivec2 path = ivec2(gl_FragCoord.xy);
    int i = BOUNCE_ROWS * path.x + path.y;
    vec2 choice = number_at(path, BOUNCE_NUMBER_CHOICE);
    float vpls_per_try = float(params.vpls) / float(BOUNCE_ROWS * params.later * params.tries);
    walk_end end = WALK_BEGIN;
    for (try_number = 0; try_number < params.tries; try_number++) {
        float start = (float(i * params.tries + try_number) + choice.x) * vpls_per_try;
        vpl light = vpl_at(min(int(start), params.vpls - 1));
        walk w = walk(light.position + params.start * light.normal, light.normal, light.flux * vpls_per_try,
                      light.reach > 0.0);
        walk_on(w, params.bounces, path.y == 0, chance_of(path), choice.y, end);
    }
    bool left = end.flux != vec3(0.0);
    // No packed normal is a float that is not a number.
    float code = uintBitsToFloat(packSnorm4x8(vec4(end.normal, 0.5)));
    position = left ? vec4(end.position, code) : vec4(vec3(NOWHERE * params.radius), 0.0);
    normal = vec4(end.normal, 2.0);
    flux = vec4(walk_flux(end), 0.0);
    next = end.next;
}
