// What the VALs do at each pixel, each taken for one light in its centre: the strongest one's colour,
// and which share of the light of all of them arrives.
#include "lib/vpl_rows.glsl"
#include "lib/gbuffer.glsl"
#include "passes/visibility/visibility.glsl"

layout(binding = UNIT_VAL_FLUX) uniform sampler2D val_fluxes;

layout(location = TARGET_RESULT) out vec4 strongest_and_share;

// Irradiance from VAL k where nothing is between: the form factor of a disk of its area, facing the
// surface.
float unshadowed(int k, surface s) {
    vec3 to_val = map_view_at(k).center - s.position, flux = texelFetch(val_fluxes, ivec2(k, 0), 0).rgb;
    float distance2 = dot(to_val, to_val), extent = map_view_at(k).extent;
    float cosines = max(dot(s.normal, to_val), 0.0) * max(-dot(map_view_at(k).axis, to_val), 0.0);
    return dot(flux, vec3(1.0)) * cosines / max(distance2 * (distance2 + extent * extent / 3.14159265), 1e-30);
}

void main() {
    strongest_and_share = vec4(0.0);
    surface s = gbuffer_surface(ivec2(gl_FragCoord.xy));
    if (!s.present)
        return;
    float most = 0.0, sum = 0.0, arriving = 0.0;
    for (int k = 0; k < textureSize(val_fluxes, 0).x; k++) {
        float light = unshadowed(k, s);
        if (light <= 0.0)
            continue;
        float visible = light * visibility(k, s.position, s.normal);
        sum += light;
        arriving += visible;
        if (visible > most) {
            most = visible;
            strongest_and_share.rgb = cluster_color(k);
        }
    }
    strongest_and_share.a = sum > 0.0 ? arriving / sum : 1.0;
}
