#include "skies/skies.h"

#include <cglm/cglm.h>
#include <math.h>

/* What grass and sand send back. */
static const float ground[3] = {.13F, .12F, .09F};

void paint_day(const float direction[3], float radiance[3]) {
    static const float sun[3] = {-.36F, .8F, .48F}, glow[3] = {640, 600, 520};
    static const float spread = .055F; /* rad */
    if (direction[1] < 0) {
        glm_vec3_copy((float *)ground, radiance);
        return;
    }
    float haze = expf(-5 * direction[1]);
    glm_vec3_lerp((vec3){.16F, .3F, .62F}, (vec3){.85F, .9F, 1}, haze, radiance);
    float off = acosf(fminf(glm_vec3_dot((float *)direction, (float *)sun), 1)) / spread;
    glm_vec3_muladds((float *)glow, expf(-off * off), radiance);
}

void paint_overcast(const float direction[3], float radiance[3]) {
    if (direction[1] < 0)
        glm_vec3_copy((float *)ground, radiance);
    else
        glm_vec3_scale((vec3){.3F, .31F, .33F}, 1 + 2 * direction[1], radiance);
}
