/* Framebuffers: which textures a pass writes. */
#ifndef GL_FRAMEBUFFER_H
#define GL_FRAMEBUFFER_H

#include "gl/texture.h"

enum { FRAMEBUFFER_COLORS_MAX = 8 };

/* Attaches level 0 of whole textures: every layer of an array, picked by gl_Layer. */
struct framebuffer_desc {
    const char *label;
    const struct texture *colors[FRAMEBUFFER_COLORS_MAX]; /* up to the first NULL */
    const struct texture *depth;
};

/* Error: the driver refuses the combination. */
bool framebuffer_init(GLuint *framebuffer, const struct framebuffer_desc *desc);
void framebuffer_free(GLuint *framebuffer);

/* Fills one of the colours, of floats or of integers, or the depth. 0 is the window's. Lifts what the present pass keeps from
 * being written: a pass that keeps colours begins after. */
void framebuffer_clear_color(GLuint framebuffer, int target, const float rgba[4]);
void framebuffer_clear_integers(GLuint framebuffer, int target, const GLuint rgba[4]);
void framebuffer_clear_depth(GLuint framebuffer, float depth);

#endif
