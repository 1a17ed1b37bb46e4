/* Outputs of a frame, for the viewer and --aov. The renderer and the technique each add rows to a
 * list. */
#ifndef TECHNIQUES_OUTPUT_H
#define TECHNIQUES_OUTPUT_H

#include "passes/visibility/visibility.h"

/* Kinds of output, with the type of their source. src/inspect/inspect.c draws each (mode_of,
 * texture_of). */
enum output_kind {
    OUTPUT_NORMAL, /* struct gbuffer: world normals of each layer; nothing without a surface */
    OUTPUT_ALBEDO, /* struct texture: layers of square roots of albedo */
    OUTPUT_DEPTH,  /* struct texture: layers of reversed camera depth */
    OUTPUT_SINGLE_DEPTH, /* struct texture: one layer for each light with one view */
    OUTPUT_FACE_DEPTH,   /* struct texture: one layer for each face of lights with six views */
    OUTPUT_IRRADIANCE,   /* struct irradiance */
    OUTPUT_VPLS,         /* struct vpl_buffer */
    OUTPUT_VALS,         /* struct val_output */
    OUTPUT_VISIBILITY,   /* struct val_output: visible fraction of the VALs' light */
    OUTPUT_MAP_DEPTH,    /* struct depth_maps */
    OUTPUT_BASIS,        /* struct texture: layers of paraboloid maps in [0, 1] */
    OUTPUT_SIGNED_BASIS, /* struct texture: layers of paraboloid maps in [-1, 1] */
    OUTPUT_AO,           /* struct drawn_output */
    OUTPUT_AIRLIGHT,     /* struct texture: radiance times irradiance_scale */
    OUTPUT_RADIANCE,     /* struct texture: radiance */
    OUTPUT_ILLUMINANCE,  /* NULL: light that surfaces receive, as numbers */
    OUTPUT_LUMINANCE,    /* NULL: light that the camera sees, as numbers */
    OUTPUT_VOXELS,       /* struct drawn_output: radiosity times irradiance_scale */
    OUTPUT_KINDS,        /* number of kinds; add new ones above */
};

/* Virtual area lights, and lookups of their maps. Textures are M x 1. */
struct val_output {
    const struct texture *positions, *normals, *fluxes; /* position w: number of VPLs */
    const struct texture *extremes; /* bounding rectangles: max s, max t, -min s, -min t */
    const struct visibility_desc *visibility; /* lookup by visibility blocks, if enabled */
    struct visibility_inputs maps;            /* bases NULL without basis maps */
};

struct frame;
struct gbuffer;
struct renderer;

/* A picture of the last frame that is drawn only when it is shown or written. */
struct drawn_output {
    /* Checks before anything is drawn; NULL: accepts all. Error: memory. */
    bool (*check)(const struct renderer *renderer);
    /* Returns the picture, valid until the next change. Error, NULL: GPU memory, shader. */
    const struct irradiance *(*draw)(void *state, struct renderer *renderer,
                                     const struct frame *frame, const struct gbuffer *gbuffer);
    void *state;
};

struct output {
    const char *name; /* name on the command line, for example "rsm-normal" */
    const char *help;
    enum output_kind kind;
    const void *source; /* owned by the technique or renderer; valid until it changes or is freed */
};

enum { OUTPUTS_MAX = 32 };

struct output_list {
    struct output items[OUTPUTS_MAX];
    int count;
};

void output_add(struct output_list *list, const struct output *output);

/* Returns the output of this name; NULL if there is none or `name` is NULL. */
const struct output *output_find(const struct output_list *list, const char *name);

/* Return the first output of the kind; NULL if there is none. */
const struct vpl_buffer *output_vpls(const struct output_list *list);
const struct val_output *output_vals(const struct output_list *list);

#endif
