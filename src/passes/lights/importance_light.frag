// Of light i: the fraction of VPLs that it takes over the fraction by flux alone, the fraction of all lights up to it, and that
// by flux alone.
#include "passes/lights/importance_parts.glsl"
#include "lib/vpl_shares.glsl"

layout(location = TARGET_RESULT) out vec4 density_and_ends;

void main() {
    int own = int(gl_FragCoord.x);
    float all = 0.0;
    for (int i = 0; i < light_count; i++)
        all += importance_of_light(i).r;
    float end = 0.0, end_by_flux = 0.0, fraction = 0.0, by_flux = 0.0;
    for (int i = 0; i <= own; i++) {
        by_flux = light_fraction(i, params.vpls);
        fraction = all > 0.0 ? mix(importance_of_light(i).r / all, by_flux, IMPORTANCE_LEAST) : by_flux;
        end += fraction;
        end_by_flux += by_flux;
    }
    density_and_ends = vec4(by_flux > 0.0 ? fraction / by_flux : 0.0, end, end_by_flux, 0.0);
}
