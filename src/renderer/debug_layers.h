/* Layers that show how a picture came about: --aov. */
#ifndef RENDERER_DEBUG_LAYERS_H
#define RENDERER_DEBUG_LAYERS_H

#include "renderer/renderer.h"

enum debug_layer {
    DEBUG_GATHERED,   /* gathered.*: the indirect layer before the blur */
    DEBUG_VAL,        /* val.*: the colour of the VAL that lights the pixel most */
    DEBUG_VISIBILITY, /* visibility.Y: the share of the VALs' light that arrives */
    DEBUG_VPL,        /* vpl.*: flux of the VPLs that the pixel shows, W */
    DEBUG_LAYER_COUNT,
};

/* A bit, 1 << enum debug_layer, for each of the names: "val,visibility". Error: tells the names
 * there are. */
bool debug_layers_parse(unsigned *layers, const char *names);

/* Whether the renderer's technique has what the layers show; else an error. */
bool debug_layers_check(const struct renderer *renderer, unsigned layers);

/* Adds the layers to those of the last frame (renderer_read_layers). Error: out of GPU memory, or
 * the check's. */
bool debug_layers_append(struct renderer *renderer, unsigned layers, struct image *image);

#endif
