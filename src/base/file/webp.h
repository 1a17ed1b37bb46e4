/* The one thing of WebP that OpenImageIO cannot be asked for: colours that are not times alpha. */
#ifndef BASE_FILE_WEBP_H
#define BASE_FILE_WEBP_H

#include <stdbool.h>
#include <stddef.h>

/* Makes a WebP file in memory claim that it has no alpha, so that decoders give its colours as
 * stored. False: it is none, or claims so already. */
bool webp_hide_alpha(unsigned char *bytes, size_t size);

#endif
