/* Pictures that hold the truth, made once and kept in a folder.
 *
 * A file's name tells the scene, the size, how it was made and a hash of the scene file and of
 * the camera and the light that were picked, so that a changed scene gets a new reference.
 */
#ifndef APPS_BENCH_REFERENCE_H
#define APPS_BENCH_REFERENCE_H

#include "measure/stage.h"
#include "base/image.h"

enum bench_reference_kind {
    BENCH_REFERENCE_NONE,
    BENCH_REFERENCE_PATH,    /* path-traced, one bounce */
    BENCH_REFERENCE_CENTERS, /* the same through pixels' centres: without the error of edges */
    BENCH_REFERENCE_VPLS,    /* every pixel takes every VPL, a hard shadow map each */
};

/* For option tables: "none", "path", "centers", "vpls", NULL. */
extern const char *const bench_reference_names[];

struct bench_reference_desc {
    enum bench_reference_kind kind;
    const char *cache; /* folder; NULL = the user's cache */
    const char *scene_path;
    const struct stage *stage;
    int width, height;
    double noise;  /* of a path-traced one: standard error over mean */
    bool software; /* of the context */
};

/* From the cache, or made now and put there. Error: of the tracer, the renderer or the file. */
bool bench_reference_get(const struct bench_reference_desc *desc, struct image *image);

/* A path-traced one, made now, of the stage as it is posed; the cache has no part in it. */
bool bench_reference_trace(const struct bench_reference_desc *desc, struct image *image);

/* The file that holds it, whether it exists or not; the caller frees the text. Error: the scene
 * cannot be read, or there is nowhere to keep things. */
char *bench_reference_path(const struct bench_reference_desc *desc);

#endif
