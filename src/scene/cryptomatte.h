/* Cryptomatte: ids of the nodes, meshes or materials in a pixel, and the part of it that each
 * covers [Friedman and Jones 2015]. A pixel has six ids. The largest comes first, and samples of a
 * seventh are dropped. The pixel is the filter. */
#ifndef SCENE_CRYPTOMATTE_H
#define SCENE_CRYPTOMATTE_H

#include "scene/surface_layers.h"

/* Returns the bits of a name's id: its MurmurHash3_32, made a normal float. */
uint32_t cryptomatte_id(const char *name);

/* Fills the channels of mattes that the image has, and adds their header. Error: that of
 * view->look. */
bool cryptomatte_fill(const struct surface_view *view, struct image *image);

#endif
