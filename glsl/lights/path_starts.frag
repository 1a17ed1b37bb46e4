// The fraction of light paths that begin at VPLs up to this one: partly by power, partly as many at each.
#include "lib/vpl_texels.glsl"
#include "shared/bounce.h"

layout(location = TARGET_RESULT) out float end;

void main() {
    int own = int(gl_FragCoord.x);
    float all = 0.0, squares = 0.0, before = 0.0;
    for (int i = 0; i < params.vpls; i++) {
        vpl v = vpl_at(i);
        float power = v.reach > 0.0 ? dot(v.flux, vec3(1.0)) : 0.0;
        all += power;
        squares += power * power;
        before += i <= own ? power : 0.0;
    }
    float even = float(own + 1) / float(params.vpls);
    // As many are even as VPLs would do for the light: paths follow power where few VPLs have most of it.
    float effective = all * all / max(float(params.vpls) * squares, 1e-30);
    end = all > 0.0 ? mix(before / all, even, effective) : even;
}
