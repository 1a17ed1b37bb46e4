/* References: pictures made once and kept in a folder.
 *
 * A file's name tells the scene, the size, how it was made, and a hash of all that it depends on:
 * triangles, materials, textures, camera and light as they are posed, and the sources of what makes
 * it. What has changed gets a new reference. */
#ifndef LAB_MEASURE_REFERENCE_H
#define LAB_MEASURE_REFERENCE_H

#include "base/image.h"
#include "quality/measure.h"

enum reference_kind {
    REFERENCE_NONE,
    REFERENCE_PATH,    /* path-traced */
    REFERENCE_CENTERS, /* the same through pixels' centres: without the error of edges */
    REFERENCE_VPLS,    /* every pixel takes every VPL, a hard shadow map each */
    REFERENCE_SEEN, /* path-traced through pixels' centres: direct light alone, and what it is made
                       of */
    REFERENCE_AO,   /* path-traced: ambient occlusion alone */
};

/* For option tables: "none", "path", "centers", "vpls", "seen", "ao", NULL. */
extern const char *const reference_names[];

/* How REFERENCE_VPLS is rendered, for variants. */
extern const char reference_vpls[];

struct reference_desc {
    enum reference_kind kind;
    const char *cache; /* folder; NULL = the user's cache */
    double noise;      /* of a path-traced one: standard error over mean */
};

/* Of the desc's stage in its size, of as many bounces and with its `materials`; its other settings
 * do not count. From the cache, or made now and put there. Error: of the tracer, the renderer or
 * the file. */
bool reference_get(const struct reference_desc *reference, const struct measure_desc *desc,
                   struct image *image);

/* A path-traced one, made now; the cache has no part in it. */
bool reference_trace(const struct reference_desc *reference, const struct measure_desc *desc,
                     struct image *image);

/* The file that holds it, whether it exists or not; the caller frees the text. NULL: an error,
 * there is nowhere to keep things. */
char *reference_path(const struct reference_desc *reference, const struct measure_desc *desc);

/* Noise of a path-traced picture: standard error of the indirect layer, RMS over its mean; 0 where
 * it does not tell. */
double reference_noise(const struct image *image);

/* The same of layer_extract_covered. */
double reference_noise_covered(const struct image *image);

#endif
