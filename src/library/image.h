/* Makes the library's images. */
#ifndef LIBRARY_IMAGE_H
#define LIBRARY_IMAGE_H

#include "base/image.h"
#include "library/manylight.h"

/* Wraps a picture in a handle and takes ownership of its memory. */
struct manylight_image *image_wrap(const struct image *image);

#endif
