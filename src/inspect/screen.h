/* Puts pictures into the window: fitted or enlarged, both at a wipe or beside each other, or their difference. */
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

enum screen_layout {
    SCREEN_WIPE,
    SCREEN_BESIDE,
    SCREEN_DIFFERENCE, /* of what is shown, four times as bright */
    SCREEN_LAYOUTS
};

struct screen_pictures {
    const struct texture *left, *right; /* RGBA8, sRGB-encoded; right may be NULL */
    enum screen_layout layout;
    float split; /* where right begins, 0 to 1 */
    int beside;  /* pixels of the window from left to right */
};

bool screen_init(struct screen *screen);
void screen_free(struct screen *screen);

/* The largest rectangle of that shape amid an area; not enlarged beyond it, and pixel for pixel
 * where it just fits. */
struct rectangle screen_fit(struct rectangle area, int width, int height);

/* Pixels that are enlarged become squares. Draws into the window's framebuffer of that height; all around the pictures becomes dark. */
void screen_draw(const struct screen *screen, int window_height, const struct rectangle *target,
                 const struct screen_pictures *pictures);

#endif
