#include "scene/lights/slide.h"

#include "base/image.h"
#include "base/memory.h"
#include "scene/lights/emitter.h"
#include "scene/texture.h"

#include <cglm/vec3.h>
#include <cglm/util.h>
#include <math.h>
#include <stdlib.h>

void slide_init(struct slide *slide, int layer, const struct bitmap *bitmap) {
    size_t count = (size_t)bitmap->width * (size_t)bitmap->height;
    float srgb_to_linear[256];
    texture_decode_table(srgb_to_linear);
    *slide = (struct slide){layer, bitmap->width, bitmap->height,
                            mem_alloc(count, sizeof *slide->texels)};
    for (size_t i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            slide->texels[i][c] = srgb_to_linear[bitmap->rgba[4 * i + (size_t)c]];
}

void slide_free(struct slide *slide) {
    free(slide->texels);
    *slide = (struct slide){0};
}

/* glsl/lib/light.glsl has the same. */
static void lookup(const struct slide *slide, float x, float y, float rgb[3]) {
    float left = floorf(x), top = floorf(y);
    vec3 rows[2];
    for (int row = 0; row < 2; row++) {
        int j = (int)glm_clamp(top + (float)row, 0, (float)(slide->height - 1));
        int a = (int)glm_clamp(left, 0, (float)(slide->width - 1));
        int b = (int)glm_clamp(left + 1, 0, (float)(slide->width - 1));
        glm_vec3_lerp(slide->texels[j * slide->width + a], slide->texels[j * slide->width + b],
                      x - left, rows[row]);
    }
    glm_vec3_lerp(rows[0], rows[1], y - top, rgb);
}

void emitter_slide(const struct emitter *emitter, const float direction[3], float rgb[3]) {
    const struct slide *slide = emitter->slide;
    float ahead = glm_vec3_dot((float *)direction, (float *)emitter->direction);
    glm_vec3_one(rgb);
    if (!slide || emitter->type != EMITTER_SPOT || ahead <= 0)
        return;
    float scale = emitter_slide_scale(emitter) / ahead;
    float x = scale * glm_vec3_dot((float *)direction, (float *)emitter->right);
    float y = scale * glm_vec3_dot((float *)direction, (float *)emitter->up);
    lookup(slide, (.5F + .5F * x) * (float)slide->width - .5F,
           (.5F - .5F * y) * (float)slide->height - .5F, rgb);
}

float emitter_slide_scale(const struct emitter *emitter) {
    float cosine = fmaxf(emitter->cos_outer, cosf(SLIDE_CONE_MAX));
    return cosine / sqrtf(fmaxf(1 - cosine * cosine, 1e-12F));
}
