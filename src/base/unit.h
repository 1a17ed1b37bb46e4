/* Unit vectors for cglm, of vectors of any length; zero stays zero.
 *
 * cglm 0.9 and later treat vectors shorter than 1.2e-7 as zero, but cross products of edges of
 * small triangles can be that short. test/lint refuses cglm's functions. */
#ifndef BASE_UNIT_H
#define BASE_UNIT_H

#include <cglm/struct.h>

static inline void vec3_unit_to(vec3 v, vec3 out) {
    float square = glm_vec3_norm2(v);
    if (square > 1e-30F && square < 1e38F) {
        glm_vec3_scale(v, 1 / sqrtf(square), out);
        return;
    }
    /* The square overflows or loses digits long before its root does. */
    double x = v[0], y = v[1], z = v[2], length = sqrt(x * x + y * y + z * z);
    for (int c = 0; c < 3; c++)
        out[c] = length > 0 ? (float)(v[c] / length) : 0;
}

static inline void vec3_unit(vec3 v) {
    vec3_unit_to(v, v);
}

static inline void vec3_unit_cross(vec3 a, vec3 b, vec3 out) {
    glm_vec3_cross(a, b, out);
    vec3_unit(out);
}

static inline vec3s vec3s_unit(vec3s v) {
    vec3_unit(v.raw);
    return v;
}

static inline vec3s vec3s_unit_cross(vec3s a, vec3s b) {
    return vec3s_unit(glms_vec3_cross(a, b));
}

/* Writes the octahedral code of a unit vector, from 0 to 1, as glsl/lib/direction.glsl. */
static inline void octahedral_encode(const float n[3], float code[2]) {
    float sum = fabsf(n[0]) + fabsf(n[1]) + fabsf(n[2]);
    for (int c = 0; c < 2; c++) {
        float folded = copysignf(1 - fabsf(n[1 - c] / sum), n[c]);
        code[c] = .5F + .5F * (n[2] >= 0 ? n[c] / sum : folded);
    }
}

#endif
