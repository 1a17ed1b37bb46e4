/* Writes several pictures beside the reference into one: pictures above, their differences
 * below. */
#ifndef LAB_MEASURE_PANELS_H
#define LAB_MEASURE_PANELS_H

#include "base/image.h"

/* Writes the panels. All pictures have three linear channels and one size; a test without pixels
 * leaves its panel empty. title: characters of label_draw. Error: as of the file. */
bool panels_write(const char *path, const char *title, const struct image *reference,
                  const struct image *tests, int test_count);

#endif
