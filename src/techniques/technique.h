/* A technique is a recipe of passes, bound only by what it writes: irradiance at the G-buffer. */
#ifndef TECHNIQUES_TECHNIQUE_H
#define TECHNIQUES_TECHNIQUE_H

#include "passes/frame.h"
#include "passes/visibility.h"
#include "techniques/settings.h"

struct technique_desc {
    const struct settings *settings;
    int width, height;
    int light_views;
};

/* What there is to look at after a frame; NULL where a technique has no such thing. */
struct technique_outputs {
    const struct irradiance *irradiance; /* plain, blurred */
    const struct irradiance *gathered;   /* in tiles, before the blur */
    const struct gbuffer *rsm;
    const struct vpl_buffer *vpls;
    const struct map_views *val_views;
    const struct texture *val_positions, *val_normals, *val_fluxes; /* M x 1 */
    const struct texture *val_extremes; /* bounding rectangles: max s, max t, -min s, -min t */
    const struct visibility_desc
        *visibility; /* how maps are looked up; by blocks, where they are */
    const struct depth_maps *depth_maps;
    const struct basis_maps *basis_maps;
};

struct technique {
    const char *name, *help;
    bool exact_casters; /* its maps show every triangle: what it is for is the plain truth */
    /* Allocates and compiles all there is. Error: of the first pass that fails. */
    bool (*init)(void **state, const struct technique_desc *desc);
    void (*free)(void *state);
    /* Another size of picture; the lights that were rendered stay. Error: out of GPU memory; all is
     * as it was. */
    bool (*resize)(void *state, int width, int height);
    /* Both cannot fail, allocate or compile. What no camera can change, to be used by any number
     * of views; and what one camera's G-buffer sees of it. */
    void (*render_lights)(void *state, const struct frame *frame);
    void (*render_view)(void *state, const struct frame *frame, const struct gbuffer *gbuffer);
    void (*outputs)(const void *state, struct technique_outputs *outputs);
};

/* Null-terminated. */
extern const struct technique *const techniques[];

/* The names, for option tables; null-terminated. */
extern const char *const technique_names[];

#endif
