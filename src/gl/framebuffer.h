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
#define framebuffers_free(...) MEM_EACH(GLuint, framebuffer_free, __VA_ARGS__)

/* A texture, and a framebuffer of its label that draws into it alone. */
bool framebuffer_init_target(struct texture *texture, GLuint *framebuffer,
                             const struct texture_desc *desc);

/* What it attaches: for passes that store to its textures in place of drawing (gl/screen.h). */
struct framebuffer_targets {
    struct framebuffer_target {
        GLuint texture; /* 0 = none */
        GLenum kind, format;
    } colors[FRAMEBUFFER_COLORS_MAX];
    GLuint depth;
};

/* Valid until the next framebuffer is made. */
const struct framebuffer_targets *framebuffer_targets(GLuint framebuffer);

/* For contexts: what they know of their framebuffers. Accepts NULL. */
struct framebuffer_list *framebuffer_list_create(void);
void framebuffer_list_free(struct framebuffer_list *list);

/* Fills one of the colours, of floats or of integers, or the depth. 0 is the window's. Lifts what the present pass keeps from
 * being written: a pass that keeps colours begins after. */
void framebuffer_clear_color(GLuint framebuffer, int target, const float rgba[4]);
void framebuffer_clear_integers(GLuint framebuffer, int target, const GLuint rgba[4]);
void framebuffer_clear_depth(GLuint framebuffer, float depth);

#endif
