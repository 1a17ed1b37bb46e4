/* Draws pictures into the window: fitted or enlarged, two at a wipe or side by side, or their
 * difference. */
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
    SCREEN_DIFFERENCE, /* difference of the two pictures, four times as bright */
    SCREEN_LAYOUTS
};

struct screen_pictures {
    const struct texture *left, *right; /* RGBA8, sRGB-encoded; right may be NULL */
    enum screen_layout layout;
    float split; /* left edge of right, 0 to 1 */
    int beside;  /* distance from left to right, pixels of the window */
};

bool screen_init(struct screen *screen);
void screen_free(struct screen *screen);

/* Returns the largest rectangle of width over height, centred in the area. */
struct rectangle screen_fit(struct rectangle area, int width, int height);

/* Draws the pictures into the window's framebuffer of this height; enlarged pixels become squares.
 * The area around the pictures becomes dark. */
void screen_draw(const struct screen *screen, int window_height, const struct rectangle *target,
                 const struct screen_pictures *pictures);

#endif
