/* Irradiance of surface elements at the camera's pixels: a mean of the elements around a surface that face alike.
 *
 * The thesis colours the vertices that the elements are. Here elements stand for parts of large triangles and for many
 * vertices of fine ones, so that pixels find them in a grid. */
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
    struct buffer params, cells, elements; /* storages: texel buffers need have but 65,536 texels */
    uint32_t *firsts;                      /* of each cell, and one more */
    float (*texels)[4];                    /* of the elements */
    int element_count, cell_count, cells_along[3];
};

/* Error: shader, or out of GPU memory. */
bool interpolate_pass_init(struct interpolate_pass *pass, int width, int height);
void interpolate_pass_free(struct interpolate_pass *pass);

/* Makes room for elements like these in the geometry's bounds. Error: out of GPU memory; the pass must then be freed. */
bool interpolate_pass_fit(struct interpolate_pass *pass, const struct elements *elements,
                          const struct geometry *geometry);

/* Uploads the elements with their irradiance times scale. */
void interpolate_pass_write(struct interpolate_pass *pass, const struct elements *elements,
                            const struct element_light *light, const struct links *links,
                            float scale);

/* Fills pass->irradiance. Timer "interpolate". */
void interpolate_pass_render(const struct interpolate_pass *pass, const struct frame *frame,
                             const struct gbuffer *gbuffer);

#endif
