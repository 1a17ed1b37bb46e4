/* Works around OpenImageIO, which cannot read WebP colours unpremultiplied. */
#ifndef BASE_FILE_WEBP_H
#define BASE_FILE_WEBP_H

#include <stdbool.h>
#include <stddef.h>

/* Clears the alpha flag of a WebP file in memory, so decoders return colours as stored. Returns
 * false if it is no WebP or has no alpha flag. */
bool webp_hide_alpha(unsigned char *bytes, size_t size);

#endif
