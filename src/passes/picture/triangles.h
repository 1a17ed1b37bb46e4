/* Finds the triangle that each pixel shows at one place, as the G-buffer has it at centres. */
#ifndef PASSES_TRIANGLES_H
#define PASSES_TRIANGLES_H

#include "passes/frame.h"

/* Draws the frame's scene for a camera, and returns the triangle of each pixel, row 0 at the top:
 * its first index is 3 x (number - 1); 0: none. place: from the pixel's centre, pixels, y up. The
 * caller frees it. NULL: out of GPU memory, or a shader. */
uint32_t *triangles_read(const struct frame *frame, const struct camera *camera, int width,
                         int height, const float place[2]);

#endif
