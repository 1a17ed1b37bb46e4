/* Extracts a layer of a picture for metrics: R G B, linear, finite. */
#ifndef METRICS_LAYER_H
#define METRICS_LAYER_H

#include "base/image.h"

/* Copies a layer (image_find_layer) and decodes it if the picture is sRGB-encoded. Error: no such
 * layer, or a NaN or infinite value, with its pixel. */
bool layer_extract(struct image *layer, const struct image *picture, const char *name);

/* Copies a layer and multiplies it by channel A of `coverage`, a picture of the same size. Reason:
 * slivers at silhouettes count little, and pictures with more samples know more of them. Error:
 * also without A. */
bool layer_extract_covered(struct image *layer, const struct image *picture, const char *name,
                           const struct image *coverage);

/* Reads a layer from a file, with the file's windows. was_encoded: the values were sRGB. Error:
 * names the file. */
bool layer_read(struct image *layer, const char *path, const char *name, bool *was_encoded);

#endif
