/* Pictures that hold the truth, made once and kept in a folder.
 *
 * A file's name tells the scene, the size, how it was made, and a hash of all that it depends on:
 * triangles, materials, textures, camera and light as they are posed, and the sources of what makes
 * it. What has changed gets a new truth.
 */
#ifndef APPS_BENCH_MEASURE_TRUTH_H
#define APPS_BENCH_MEASURE_TRUTH_H

#include "base/image.h"
#include "quality/measure.h"

enum truth_kind {
    TRUTH_NONE,
    TRUTH_PATH,    /* path-traced */
    TRUTH_CENTERS, /* the same through pixels' centres: without the error of edges */
    TRUTH_VPLS,    /* every pixel takes every VPL, a hard shadow map each */
    TRUTH_SEEN, /* path-traced through pixels' centres: direct light alone, and what it is made of */
};

/* For option tables: "none", "path", "centers", "vpls", "seen", NULL. */
extern const char *const truth_names[];

/* How TRUTH_VPLS is rendered, for variants. */
extern const char truth_vpls[];

struct truth_desc {
    enum truth_kind kind;
    const char *cache; /* folder; NULL = the user's cache */
    double noise;      /* of a path-traced one: standard error over mean */
};

/* Of the desc's stage in its size, of as many bounces and with its `materials`; its other settings do not count. From the cache, or made now and put
 * there. Error: of the tracer, the renderer or the file. */
bool truth_get(const struct truth_desc *truth, const struct measure_desc *desc,
               struct image *image);

/* A path-traced one, made now; the cache has no part in it. */
bool truth_trace(const struct truth_desc *truth, const struct measure_desc *desc,
                 struct image *image);

/* The file that holds it, whether it exists or not; the caller frees the text. NULL: an error, there
 * is nowhere to keep things. */
char *truth_path(const struct truth_desc *truth, const struct measure_desc *desc);

/* Noise of a path-traced picture: standard error of the indirect layer, RMS over its mean; 0 where
 * it does not tell. */
double truth_noise(const struct image *image);

/* The same of layer_extract_covered. */
double truth_noise_covered(const struct image *image);

#endif
