/* Interpolates irradiance of surface elements at camera pixels: a mean of nearby elements with
 * similar normals.
 *
 * The thesis colours vertices, which are its elements. Here an element represents part of a large
 * triangle or many small vertices, so pixels find elements in a grid. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_INTERPOLATE_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_INTERPOLATE_H

#include "passes/targets.h"
#include "shared/element_grid.h"
#include "techniques/implicit-visibility/light.h"

struct frame;

struct interpolate_pass {
    GLuint program;
    struct irradiance irradiance;
    struct element_grid_params grid;
    /* Storage buffers, because texel buffers may have only 65,536 texels. */
    struct buffer params, cells, elements;
    uint32_t *firsts;   /* first element of each cell, and one past the last */
    float (*texels)[4]; /* upload buffer of the elements */
    int element_count, cell_count, cells_along[3];
};

/* Error: shader, or out of GPU memory. */
bool interpolate_pass_init(struct interpolate_pass *pass, int width, int height);
void interpolate_pass_free(struct interpolate_pass *pass);

/* Reserves memory for the elements within the geometry's bounds. Error: out of GPU memory; the
 * caller must then free the pass. */
bool interpolate_pass_fit(struct interpolate_pass *pass, const struct elements *elements,
                          const struct geometry *geometry);

/* Uploads the elements with their irradiance times `scale`. */
void interpolate_pass_write(struct interpolate_pass *pass, const struct elements *elements,
                            const struct element_light *light, const struct links *links,
                            float scale);

/* Fills pass->irradiance. Timer "interpolate". */
void interpolate_pass_render(const struct interpolate_pass *pass, const struct frame *frame,
                             const struct gbuffer *gbuffer);

#endif
