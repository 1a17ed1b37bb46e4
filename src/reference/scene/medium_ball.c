#include "reference/scene/medium_ball.h"

#include "reference/vector.h"
#include "scene/medium.h"

#include <math.h>

struct medium_ball medium_ball_of(const struct medium *medium, const struct geometry *geometry) {
    vec3s scattering = vector_of(medium->scattering);
    return (struct medium_ball){
        .exists = medium_exists(medium),
        .scattering = scattering,
        .extinction = glms_vec3_add(scattering, vector_of(medium->absorption)),
        .g = medium->g,
        .center = vector_of(geometry->center),
        .radius = geometry->radius,
    };
}

bool medium_segment(const struct medium_ball *medium, vec3s origin, vec3s direction, float length,
                    float segment[2]) {
    vec3s from_center = glms_vec3_sub(origin, medium->center);
    float along = -glms_vec3_dot(from_center, direction);
    float aside2 = glms_vec3_norm2(glms_vec3_muladds(direction, along, from_center));
    float half = sqrtf(fmaxf(medium->radius * medium->radius - aside2, 0));
    segment[0] = fmaxf(along - half, 0);
    segment[1] = fminf(along + half, length);
    return segment[0] < segment[1];
}

vec3s medium_passes(const struct medium_ball *medium, float length) {
    vec3s passes = glms_vec3_one();
    for (int c = 0; c < 3 && medium->exists; c++)
        passes.raw[c] = expf(-medium->extinction.raw[c] * length);
    return passes;
}

vec3s medium_transmittance(const struct medium_ball *medium, vec3s origin, vec3s direction,
                           float length) {
    float segment[2];
    if (!medium->exists || !medium_segment(medium, origin, direction, length, segment))
        return glms_vec3_one();
    return medium_passes(medium, segment[1] - segment[0]);
}

float medium_phase(float g, float cosine) {
    float sharp = fabsf(g), peak = copysignf(1, g); /* the cosine where it is greatest */
    float square = (1 - sharp) * (1 - sharp) + 2 * sharp * (1 - peak * cosine);
    return (1 - g * g) / (4 * GLM_PIf * square * sqrtf(square));
}
