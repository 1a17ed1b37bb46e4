#include "scene/lights/slide.h"

#include "base/image.h"
#include "base/memory.h"
#include "scene/lights/emitter.h"
#include "scene/lights/profile.h"
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
                            mem_alloc(count, sizeof *slide->texels), false};
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

/* Texels of profiles: half and quarter degrees. */
enum { PROFILE_COLUMNS = 721, PROFILE_ROWS = 721 };

static int columns_of(const struct profile *profile) {
    return profile->type == PROFILE_C && profile->plane_count == 1 ? 1 : PROFILE_COLUMNS;
}

int slide_profile_size(const struct profile *profile) {
    return columns_of(profile) * PROFILE_ROWS;
}

/* Fills a row; returns its sum of intensities. */
static double fill_row(struct slide *slide, const struct profile *profile, int row) {
    double away = GLM_PI * row / (PROFILE_ROWS - 1), sum = 0;
    for (int i = 0; i < slide->width; i++) {
        double turn = slide->width > 1 ? 2 * GLM_PI * i / (slide->width - 1) : 0;
        double direction[3] = {sin(away) * cos(turn), sin(away) * sin(turn), cos(away)};
        double candela = profile_candela(profile, direction);
        glm_vec3_broadcast((float)candela, slide->texels[row * slide->width + i]);
        sum += i + 1 < slide->width || slide->width == 1 ? candela : 0; /* the first once more */
    }
    return sum;
}

float slide_init_profile(struct slide *slide, int layer, const struct profile *profile) {
    double sum = 0, weights = 0;
    *slide =
        (struct slide){layer, columns_of(profile), PROFILE_ROWS,
                       mem_alloc((size_t)slide_profile_size(profile), sizeof *slide->texels), true};
    for (int row = 0; row < PROFILE_ROWS; row++) {
        double weight = sin(GLM_PI * row / (PROFILE_ROWS - 1));
        sum += weight * fill_row(slide, profile, row);
        weights += weight * (slide->width > 1 ? slide->width - 1 : 1);
    }
    for (int i = 0; i < slide_profile_size(profile); i++)
        glm_vec3_scale(slide->texels[i], (float)(weights / sum), slide->texels[i]);
    return (float)(sum / weights);
}

bool emitter_has_slide(const struct emitter *emitter) {
    return emitter->slide &&
           (emitter->slide->is_profile ? emitter->type == EMITTER_POINT && emitter->size[0] <= 0
                                       : emitter->type == EMITTER_SPOT);
}

void emitter_slide(const struct emitter *emitter, const float direction[3], float rgb[3]) {
    const struct slide *slide = emitter->slide;
    glm_vec3_one(rgb);
    if (!emitter_has_slide(emitter))
        return;
    float ahead = glm_vec3_dot((float *)direction, (float *)emitter->direction);
    float x = glm_vec3_dot((float *)direction, (float *)emitter->right);
    float y = glm_vec3_dot((float *)direction, (float *)emitter->up);
    if (slide->is_profile) {
        float turn = atan2f(y, x) / (2 * GLM_PIf), away = atan2f(hypotf(x, y), ahead) / GLM_PIf;
        lookup(slide, (turn - floorf(turn)) * (float)(slide->width - 1),
               away * (float)(slide->height - 1), rgb);
    } else if (ahead > 0) {
        float scale = emitter_slide_scale(emitter) / ahead;
        lookup(slide, (.5F + .5F * scale * x) * (float)slide->width - .5F,
               (.5F - .5F * scale * y) * (float)slide->height - .5F, rgb);
    }
}

void emitter_intensity(const struct emitter *emitter, float away, float turn, float rgb[3]) {
    vec3 direction;
    glm_vec3_scale((float *)emitter->direction, cosf(away), direction);
    glm_vec3_muladds((float *)emitter->right, sinf(away) * cosf(turn), direction);
    glm_vec3_muladds((float *)emitter->up, sinf(away) * sinf(turn), direction);
    emitter_slide(emitter, direction, rgb);
    glm_vec3_mul(rgb, (float *)emitter->intensity, rgb);
}

float emitter_slide_scale(const struct emitter *emitter) {
    float cosine = fmaxf(emitter->cos_outer, cosf(SLIDE_CONE_MAX));
    return emitter->slide && emitter->slide->is_profile
               ? 0
               : cosine / sqrtf(fmaxf(1 - cosine * cosine, 1e-12F));
}
