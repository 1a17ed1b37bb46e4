// Fourier bases of the map depth z, four terms at a time [Dong 2011 §5.2, §5.3.1; erratum c_k = pi (2k-1)].
#include "shared/basis.h"

layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray depths;

flat in int instance;

layout(location = TARGET_BASIS_COS) out vec4 basis_cos;   // cos c_k z, as (b + 1) / 2
layout(location = TARGET_BASIS_SIN) out vec4 basis_sin;   // sin c_k z
layout(location = TARGET_BASIS_Z_COS) out vec4 basis_z_cos; // z cos c_k z
layout(location = TARGET_BASIS_Z_SIN) out vec4 basis_z_sin; // z sin c_k z
layout(location = TARGET_BASIS_Z) out float basis_z;    // z

const float PI = 3.14159265358979;

void main() {
    float z = texelFetch(depths, ivec3(gl_FragCoord.xy, instance), 0).r;
    // c_k = pi (2k - 1) climbs by 2 pi: one sine and cosine, then turns by 2 pi z.
    float first = PI * float(2 * params.first_term + 1) * z, turn = 2.0 * PI * z;
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
    basis_z_cos = z * c;
    basis_z_sin = z * s;
    basis_z = z;
}
