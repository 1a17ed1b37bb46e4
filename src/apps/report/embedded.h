/* Pictures within a page: data URIs of PNG files. */
#ifndef APPS_REPORT_EMBEDDED_H
#define APPS_REPORT_EMBEDDED_H

#include "base/image.h"

#include <stdio.h>

/* The beauty layer as a screen shows it: clamped to [0, 1] and sRGB-encoded. */
bool embedded_print_picture(FILE *out, const struct image *picture);

/* Its difference from the reference, mean of R, G and B, in false colours whose ends are `top` times the reference's
 * mean. */
bool embedded_print_difference(FILE *out, const struct image *picture,
                               const struct image *reference, double top);

#endif
