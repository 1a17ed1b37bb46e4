// The visible fraction of an environment light: of shadow rays to points of it, those that no triangle blocks, each with the
// greatest fraction of its colours that panes let pass. SUNS lights are
// suns; others take SHADOW_RAYS.
#include "lib/medium.glsl"
#include "lib/random.glsl"
#include "lib/sky.glsl"
#include "passes/visibility/bvh.glsl"
#include "shared/sky.h"

layout(binding = UNIT_SKY_SHARES) uniform sampler2DArray sky_share_table; // passes/visibility/sky_shares.frag

// Irradiance over radiance of four lights that nothing hides: as smooth as it is, between the table's normals
// it is off by no more than 5e-4 of the brightest.
vec4 sky_shares(vec3 normal, int layer) {
    vec2 place = (octahedral_encode(normal) * float(SKY_SHARES_SIZE - 1) + 0.5) / float(SKY_SHARES_SIZE);
    return textureLod(sky_share_table, vec3(place, layer), 0.0);
}

// To a sun each ray is a step of its penumbra, so that few would be seen as bands.
const int SUN_RAYS_LEAST = 16;

// Point k of so many in the light, in units of its half sides. They are stratified, and a shift of its own for each pixel and
// light turns their pattern into noise.
vec2 sky_point(int k, int count, vec2 shift) {
    return 2.0 * fract(vec2((float(k) + shift.x) / float(count), float(k) * 0.61803399 + shift.y)) - 1.0;
}

// Of the light's part above the horizon.
float sky_visibility(int i, vec3 position, vec3 normal) {
    vec2 turn = float(params.pass) * vec2(0.7548776662, 0.5698402910); // of a pass
    vec2 shift = fract(random_of(uvec3(gl_FragCoord.xy, i)) + turn);
    int rays = i < SUNS ? max(SHADOW_RAYS, SUN_RAYS_LEAST) : SHADOW_RAYS;
    float visible = 0.0, above = 0.0;
    for (int k = 0; k < rays; k++) {
        vec3 towards = sky_towards(i, sky_point(k, rays, shift));
        bool counts = dot(towards, normal) > 0.0;
        bool blocked = is_blocked_towards(position, normal, towards, counts);
        if (counts && !blocked)
            visible += max_of(medium_panes(position, towards, MEDIUM_FAR));
        above += counts ? 1.0 : 0.0;
    }
    return visible / max(above, 1.0);
}
