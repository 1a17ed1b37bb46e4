/* Puts pictures into the window: fitted, side by side at a wipe. */
#ifndef INSPECT_SCREEN_H
#define INSPECT_SCREEN_H

#include "gl/buffer.h"
#include "gl/texture.h"
#include "gl/timer.h"

struct screen {
    GLuint program;
    struct buffer params;
};

struct rectangle {
    int x, y, width, height; /* pixels of the window, y down */
};

struct screen_pictures {
    const struct texture *left, *right; /* RGBA8, sRGB-encoded; right may be NULL */
    float split;                        /* where right begins, 0 to 1 */
};

bool screen_init(struct screen *screen);
void screen_free(struct screen *screen);

/* The largest rectangle of that shape amid an area; not enlarged beyond it, and pixel for pixel
 * where it just fits. */
struct rectangle screen_fit(struct rectangle area, int width, int height);

/* Draws into the window's framebuffer of that height; all around the pictures becomes dark. */
void screen_draw(const struct screen *screen, int window_height, const struct rectangle *target,
                 const struct screen_pictures *pictures);

#endif
