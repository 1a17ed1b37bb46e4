#include "apps/export/slides.h"

#include "base/file/image_file.h"
#include "base/memory.h"
#include "base/unit.h"
#include "scene/lights/slide.h"

#include <math.h>
#include <stdlib.h>

/* Texels a side, or as many as the slide has: falloffs at a cone's edge are fine lines. */
enum { SIZE_LEAST = 1024 };

bool export_is_projector(const struct emitter *emitter) {
    return emitter->slide && emitter->type == EMITTER_SPOT &&
           emitter->cos_outer >= cosf(SLIDE_CONE_MAX);
}

double export_projector_angle(const struct emitter *emitter) {
    return 2 * atan(1 / (double)emitter_slide_scale(emitter)) * 180 / GLM_PI;
}

float export_projector_peak(const struct emitter *emitter) {
    return glm_vec3_max((float *)emitter->intensity);
}

char *export_projector_name(const struct emitter *emitter) {
    return mem_printf("slide-%d.exr", emitter->number);
}

static int size_of(const struct slide *slide) {
    int larger = slide->width > slide->height ? slide->width : slide->height;
    return larger > SIZE_LEAST ? larger : SIZE_LEAST;
}

/* x and y from -1 to 1, to the right and up as the light sees them. */
static void write_texel(const struct emitter *emitter, float x, float y, float to[3]) {
    float scale = emitter_slide_scale(emitter), peak = export_projector_peak(emitter);
    vec3 direction;
    glm_vec3_scale((float *)emitter->direction, scale, direction);
    glm_vec3_muladds((float *)emitter->right, x, direction);
    glm_vec3_muladds((float *)emitter->up, y, direction);
    vec3_unit(direction);
    float cosine = glm_vec3_dot(direction, (float *)emitter->direction);
    emitter_slide(emitter, direction, to);
    glm_vec3_mul(to, (float *)emitter->intensity, to);
    glm_vec3_scale(to, emitter_cone(emitter, cosine) * powf(cosine, 3), to);
    glm_vec3_scale(to, peak > 0 ? 1 / peak : 0, to);
}

bool export_projector_picture(struct export_target *target, const struct emitter *emitter) {
    int n = size_of(emitter->slide);
    struct image image;
    image_init(&image, n, n, "R G B");
    for (int row = 0; row < n; row++)
        for (int column = 0; column < n; column++)
            write_texel(emitter, (2 * (float)column + 1) / (float)n - 1,
                        1 - (2 * (float)row + 1) / (float)n, image_at(&image, column, row));
    export_note(target, "light %d: its slide and its cone are %d x %d texels", emitter->number, n,
                n);
    char *name = export_projector_name(emitter), *path = export_path(target, name);
    bool ok = image_write(&image, path);
    image_free(&image);
    mem_free(path, name);
    return ok;
}
