#include "base/file/webp.h"

#include <string.h>

/* RIFF, a size, WEBP, then the first chunk's name and size. */
enum { FIRST_NAME = 12, FIRST_DATA = 20 };

static bool clear(unsigned char *byte, unsigned char bit) {
    bool was_set = *byte & bit;
    *byte &= (unsigned char)~bit;
    return was_set;
}

/* VP8X begins with a byte of flags. VP8L has a signature byte, 14 bits each of width and height
 * less one, and a bit that tells of alpha. */
bool webp_hide_alpha(unsigned char *bytes, size_t size) {
    enum { FLAGS = FIRST_DATA, FLAG = 0x10, BITS = FIRST_DATA + 4, BIT = 0x10 };
    if (size <= BITS || memcmp(bytes, "RIFF", 4) != 0 || memcmp(bytes + 8, "WEBP", 4) != 0)
        return false;
    if (memcmp(bytes + FIRST_NAME, "VP8X", 4) == 0)
        return clear(bytes + FLAGS, FLAG);
    return memcmp(bytes + FIRST_NAME, "VP8L", 4) == 0 && clear(bytes + BITS, BIT);
}
