// The nearest pane before what a pixel sees that reflects diffusely to the camera, as a surface of a G-buffer. It lies a
// little above the pane, which else would dim its own light.
#include "lib/medium.glsl"
#include "lib/direction.glsl"
#include "lib/gbuffer.glsl"
#include "shared/show_panes.h"

layout(location = TARGET_GBUFFER_NORMAL) out vec2 normal_code;
layout(location = TARGET_GBUFFER_ALBEDO) out vec4 albedo_root;
#ifdef HAS_SPECULAR
layout(location = TARGET_GBUFFER_SPECULAR) out vec4 specular_code;
#endif

void main() {
    sight ray = sight_of(ivec2(gl_FragCoord.xy));
    panes_met met = panes_meet(ray.origin, ray.direction, 0.0, ray.ray_length);
    vec3 albedo = vec3(0.0);
    pane p;
    for (int layer = 0; layer < PANE_LAYERS && met.nearest < ray.ray_length; layer++) {
        p = pane_at(met.texel);
        albedo = pane_albedo(p, ray.direction);
        if (albedo != vec3(0.0))
            break;
        met = panes_meet(ray.origin, ray.direction, met.nearest * (1.0 + PANE_EDGE), ray.ray_length);
    }
    if (albedo == vec3(0.0))
        discard;
    vec3 normal = dot(p.normal, ray.direction) < 0.0 ? p.normal : -p.normal;
    vec3 place = ray.origin + met.nearest * ray.direction + panes_clearance() * normal;
    vec4 clip = camera.world_to_clip * vec4(place, 1.0);
    gl_FragDepth = clip.z / clip.w;
    normal_code = octahedral_encode(normal);
    albedo_root = vec4(sqrt(albedo), 1.0);
#ifdef HAS_SPECULAR
    specular_code = vec4(0.0);
#endif
}
