/* A row of the failure suite as one picture: the reference and what each technique made of it, with
 * the differences below. */
#ifndef APPS_FAILURE_PICTURE_H
#define APPS_FAILURE_PICTURE_H

#include "base/image.h"

#include <stdbool.h>

/* All three-channel, linear, of one size; indirect light. title: what label_draw knows. */
struct failure_picture {
    const struct image *reference, *tests;
    int test_count;
    const char *title;
};

/* Error: of the file. */
bool failure_picture_write(const struct failure_picture *picture, const char *path);

#endif
