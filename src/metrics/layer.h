/* One layer of a picture as the metrics take it: R G B, linear, finite. */
#ifndef METRICS_LAYER_H
#define METRICS_LAYER_H

#include "base/image.h"

/* Takes the layer (image_find_layer) out of a picture and decodes sRGB where the picture is encoded. Error: no such layer, or a value that is NaN or infinite, with its pixel. */
bool layer_extract(struct image *layer, const struct image *picture, const char *name);

/* The same, of each pixel as much as a surface covers of it by `coverage`, a picture of that size with a channel A: of slivers
 * at silhouettes little is seen, and the more samples a picture has, the more of them it knows. Error: also, there is no A. */
bool layer_extract_covered(struct image *layer, const struct image *picture, const char *name,
                           const struct image *coverage);

/* The same as layer_extract from a file, whose windows the layer tells, and whether its values were encoded. Error: names
 * the file. */
bool layer_read(struct image *layer, const char *path, const char *name, bool *was_encoded);

#endif
