/* Cryptomatte: ids of the nodes, meshes or materials in a pixel, and the part of it that each
 * covers [Friedman and Jones 2015]. A pixel has six ids. The largest comes first, and samples of a
 * seventh are dropped. The pixel is the filter. */
#ifndef SCENE_CRYPTOMATTE_H
#define SCENE_CRYPTOMATTE_H

#include "scene/surface_layers.h"

/* Returns the bits of a name's id: its MurmurHash3_32, made a normal float. */
uint32_t cryptomatte_id(const char *name);

/* Fills the image's last 12 channels and adds the header. layer: as in surface_layer_id_name.
 * numbers: number of each triangle's part, from 1 on; freed. Error: that of view->look. */
bool cryptomatte_fill(const struct surface_view *view, int layer, uint32_t *numbers,
                      struct image *image);

#endif
