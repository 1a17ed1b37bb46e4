#include "lab/export/lights.h"

#include <cglm/cglm.h>
#include <math.h>

bool export_is_light(const struct emitter *emitter) {
    return emitter->lamp == 0;
}

bool export_is_shape(const struct emitter *emitter) {
    return emitter->type == EMITTER_AREA ||
           (emitter->type == EMITTER_POINT && emitter_shape(emitter) == EMITTER_IS_SPHERE);
}

void export_note_light(struct export_target *target, const struct emitter *emitter) {
    const struct {
        bool is_so;
        const char *text;
    } notes[] = {
        {emitter->range > 0 && emitter->type != EMITTER_DIRECTIONAL, "its range is left out"},
        {emitter->size[0] > 0 && !export_is_shape(emitter), "its size is left out"},
        {export_is_shape(emitter), "its shape blocks light"},
        {emitter->type == EMITTER_SPOT,
         "another falloff at the edge of its cone, of the same flux"},
        {emitter_has_slide(emitter), "its slide is left out"},
    };
    for (size_t i = 0; i < sizeof notes / sizeof *notes; i++)
        if (notes[i].is_so && emitter->number >= 0)
            export_note(target, "light %d: %s", emitter->number, notes[i].text);
        else if (notes[i].is_so)
            export_note(target, "an added light: %s", notes[i].text);
}

/* A sphere's is its intensity over the area that is seen. */
void export_radiance(const struct emitter *emitter, float radiance[3]) {
    double area = emitter_extent(emitter) / (emitter->type == EMITTER_POINT ? 4 : 1);
    glm_vec3_scale((float *)emitter->intensity, (float)(1 / area), radiance);
}

/* --- cones ------------------------------------------------------------------------------------ */

/* The integral over all directions of a falloff that is linear in the angle, over 2 pi. */
static double linear_flux(double full, double end) {
    double ramp = end > full ? (sin(end) - sin(full)) / (end - full) : cos(full);
    return 1 - ramp;
}

static double linear_end(double full, double flux) {
    double low = full, high = GLM_PI;
    for (int i = 0; i < 60; i++) {
        double middle = (low + high) / 2;
        *(linear_flux(full, middle) < flux ? &low : &high) = middle;
    }
    return low;
}

struct spot_cone export_cone(const struct emitter *emitter) {
    double outer = (double)emitter->cos_outer;
    double width = fmax(.001, (double)emitter->cos_inner - outer);
    double inner = fmin(outer + width, 1);
    double full = acos(inner);
    struct emitter one = *emitter;
    one.intensity[0] = one.intensity[1] = one.intensity[2] = 1;
    double flux = emitter_flux(&one, 1) / (2 * GLM_PI);
    return (struct spot_cone){full * 180 / GLM_PI, linear_end(full, flux) * 180 / GLM_PI};
}

void export_place(const struct emitter *emitter, float matrix[16]) {
    bool is_disk = emitter_shape(emitter) == EMITTER_IS_DISK;
    float width = emitter->size[0] / 2, height = is_disk ? width : emitter->size[1] / 2;
    for (int row = 0; row < 3; row++) {
        matrix[4 * row] = -emitter->right[row] * width;
        matrix[4 * row + 1] = emitter->up[row] * height;
        matrix[4 * row + 2] = emitter->direction[row];
        matrix[4 * row + 3] = emitter->position[row];
    }
    for (int column = 0; column < 4; column++)
        matrix[12 + column] = column == 3;
}
