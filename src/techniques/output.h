/* Outputs of a frame, for the viewer and --aov: the renderer and the technique each add rows to a list. output_find
 * finds a row by its name, output_vpls and output_vals by its kind; NULL: there is none. */
#ifndef TECHNIQUES_OUTPUT_H
#define TECHNIQUES_OUTPUT_H

#include "passes/visibility/visibility.h"

/* What is shown of an output, and what its source is. src/inspect/inspect.c draws each kind (mode_of, texture_of). */
enum output_kind {
    OUTPUT_NORMAL,       /* struct gbuffer: its layers of world normals, where a surface is */
    OUTPUT_ALBEDO,       /* struct texture: layers, square root of the albedo */
    OUTPUT_DEPTH,        /* struct texture: layers, reversed depth from the camera */
    OUTPUT_SINGLE_DEPTH, /* struct texture: a layer for each light of one view */
    OUTPUT_FACE_DEPTH,   /* struct texture: a layer for each face of lights of six */
    OUTPUT_IRRADIANCE,   /* struct irradiance */
    OUTPUT_VPLS,         /* struct vpl_buffer */
    OUTPUT_VALS,         /* struct val_output */
    OUTPUT_VISIBILITY,   /* struct val_output: which of the VALs' light arrives */
    OUTPUT_MAP_DEPTH,    /* struct depth_maps */
    OUTPUT_BASIS,        /* struct texture: layers of paraboloid maps in [0, 1] */
    OUTPUT_SIGNED_BASIS, /* struct texture: the same in [-1, 1] */
    OUTPUT_AO,           /* struct drawn_output */
    OUTPUT_AIRLIGHT,     /* struct texture: radiance times irradiance_scale */
    OUTPUT_RADIANCE,     /* struct texture: radiance */
    OUTPUT_VOXELS,       /* struct drawn_output: radiosity times irradiance_scale */
    OUTPUT_KINDS,        /* new kinds stand before it */
};

/* Virtual area lights, and how the maps from them are looked up. Textures are M x 1. */
struct val_output {
    const struct texture *positions, *normals, *fluxes; /* position w: how many VPLs */
    const struct texture *extremes; /* bounding rectangles: max s, max t, -min s, -min t */
    const struct visibility_desc *visibility; /* by blocks, where they look up */
    struct visibility_inputs maps;            /* bases NULL where they are not made */
};

struct frame;
struct gbuffer;
struct renderer;

/* A picture of the last frame that no frame draws: it is drawn when somebody looks at it. */
struct drawn_output {
    /* Before anything is drawn; NULL: nothing is refused. Error: memory. */
    bool (*check)(const struct renderer *renderer);
    /* The picture, until the next change; NULL: an error, out of GPU memory or a shader. */
    const struct irradiance *(*draw)(void *state, struct renderer *renderer,
                                     const struct frame *frame, const struct gbuffer *gbuffer);
    void *state;
};

struct output {
    const char *name; /* a word for command lines: "rsm-normal" */
    const char *help;
    enum output_kind kind;
    const void *source; /* of the technique or renderer, until it changes or is freed */
};

enum { OUTPUTS_MAX = 32 };

struct output_list {
    struct output items[OUTPUTS_MAX];
    int count;
};

void output_add(struct output_list *list, const struct output *output);

/* NULL where there is none of the name, as of NULL. */
const struct output *output_find(const struct output_list *list, const char *name);

/* The first of its kind; NULL where there is none. */
const struct vpl_buffer *output_vpls(const struct output_list *list);
const struct val_output *output_vals(const struct output_list *list);

#endif
