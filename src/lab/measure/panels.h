/* Several pictures beside the reference, as one: light above, differences from the reference below. */
#ifndef LAB_MEASURE_PANELS_H
#define LAB_MEASURE_PANELS_H

#include "base/image.h"

/* All three-channel, linear, of one size; a test without pixels has an empty panel. title: what
 * label_draw knows. Error: of the file. */
bool panels_write(const char *path, const char *title, const struct image *reference,
                  const struct image *tests, int test_count);

#endif
