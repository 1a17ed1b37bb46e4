// Fourier bases, four terms at a time [Dong 2011 §5.2, §5.3.1; erratum c_k = pi (2k-1)]: of the argument a that the
// map's range makes of its depths.
#include "shared/basis.h"
#include "visibility/series.glsl"

layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray depths;

flat in int instance;

layout(location = TARGET_BASIS_COS) out vec4 basis_cos;   // cos c_k a, as (b + 1) / 2
layout(location = TARGET_BASIS_SIN) out vec4 basis_sin;   // sin c_k a
layout(location = TARGET_BASIS_Z_COS) out vec4 basis_z_cos; // a cos c_k a
layout(location = TARGET_BASIS_Z_SIN) out vec4 basis_z_sin; // a sin c_k a
layout(location = TARGET_BASIS_Z) out float basis_z;    // a

const float PI = 3.14159265358979;

void main() {
    float z = texelFetch(depths, ivec3(gl_FragCoord.xy, instance), 0).r;
    float a = z < 1.0 ? series_argument(series_range_at(instance), z) : SERIES_END;
    // c_k = pi (2k - 1) climbs by 2 pi: one sine and cosine, then turns by 2 pi a.
    float first = PI * float(2 * params.first_term + 1) * a, turn = 2.0 * PI * a;
    vec2 angle = vec2(cos(first), sin(first)), rotation = vec2(cos(turn), sin(turn));
    vec4 c, s;
    for (int k = 0; k < 4; k++) {
        c[k] = angle.x;
        s[k] = angle.y;
        angle = vec2(angle.x * rotation.x - angle.y * rotation.y,
                     angle.x * rotation.y + angle.y * rotation.x);
    }
    basis_cos = c * 0.5 + 0.5;
    basis_sin = s * 0.5 + 0.5;
    basis_z_cos = a * c;
    basis_z_sin = a * s;
    basis_z = a;
}
