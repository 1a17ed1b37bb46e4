// Light of a patch where its surface is the one that the pixel sees, from the side that the light comes to.
#include "lib/gbuffer.glsl"
#include "shared/caustics.h"

#ifdef SPLATS
flat in float splat_radius;
#endif
flat in vec3 patch_irradiance, patch_normal, patch_middle;

layout(location = TARGET_RESULT) out vec4 light; // radiance of a white surface

const float LEAST_COSINE = 0.5;

void main() {
    surface s = gbuffer_surface(ivec2(gl_FragCoord.xy));
    bool is_same = s.present && dot(s.normal, patch_normal) > LEAST_COSINE &&
        abs(dot(s.position - patch_middle, patch_normal)) < params.reach;
#ifdef SPLATS
    is_same = is_same && (splat_radius == 0.0 || distance(s.position, patch_middle) <= splat_radius);
#endif
    light = vec4(is_same ? patch_irradiance / 3.14159265 : vec3(0.0), 0.0);
}
