/* Pictures of the library. */
#ifndef LIBRARY_IMAGE_H
#define LIBRARY_IMAGE_H

#include "base/image.h"
#include "library/manylight.h"

/* Takes the picture. */
struct manylight_image *image_wrap(const struct image *image);

#endif
