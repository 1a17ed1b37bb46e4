// Fourier bases of maps of depth, for MIP maps.
#include "shared/maps.h"

PASS_BLOCK(basis_params, 16)

#include "passes/visibility/series.glsl"

layout(binding = UNIT_MAP_DEPTH) uniform sampler2DArray depths;

flat in int instance;

layout(location = TARGET_BASIS_COS) out vec4 basis_cos;   // cos c_k a, as (b + 1) / 2
layout(location = TARGET_BASIS_SIN) out vec4 basis_sin;   // sin c_k a
layout(location = TARGET_BASIS_Z_COS) out vec4 basis_z_cos; // a cos c_k a
layout(location = TARGET_BASIS_Z_SIN) out vec4 basis_z_sin; // a sin c_k a
layout(location = TARGET_BASIS_Z) out float basis_z;    // a

void main() {
    float z = texelFetch(depths, ivec3(gl_FragCoord.xy, instance), 0).r;
    series_bases b = series_bases_of(instance, z, params.first_term);
    basis_cos = b.cosines * 0.5 + 0.5;
    basis_sin = b.sines * 0.5 + 0.5;
    basis_z_cos = b.a * b.cosines;
    basis_z_sin = b.a * b.sines;
    basis_z = b.a;
}
