/* Framebuffers: the textures that a pass writes. */
#ifndef GL_FRAMEBUFFER_H
#define GL_FRAMEBUFFER_H

#include "gl/texture.h"

enum { FRAMEBUFFER_COLORS_MAX = 8 };

/* Level 0 of each texture is attached with all layers; gl_Layer selects a layer of an array. */
struct framebuffer_desc {
    const char *label;
    const struct texture *colors[FRAMEBUFFER_COLORS_MAX]; /* ends at the first NULL */
    const struct texture *depth;
};

/* Creates a framebuffer. Error: the driver refuses the combination. */
bool framebuffer_init(GLuint *framebuffer, const struct framebuffer_desc *desc);
void framebuffer_free(GLuint *framebuffer);
#define framebuffers_free(...) MEM_EACH(GLuint, framebuffer_free, __VA_ARGS__)

/* Creates a texture and a framebuffer with the same label that has it as its only colour. */
bool framebuffer_init_target(struct texture *texture, GLuint *framebuffer,
                             const struct texture_desc *desc);

/* Attachments of a framebuffer, for passes that store to its textures (gl/screen.h). */
struct framebuffer_targets {
    struct framebuffer_target {
        GLuint texture; /* 0: none */
        GLenum kind, format;
    } colors[FRAMEBUFFER_COLORS_MAX];
    GLuint depth;
};

/* Returns the attachments, valid until the next framebuffer is created. */
const struct framebuffer_targets *framebuffer_targets(GLuint framebuffer);

/* Creates a context's list of framebuffers. For contexts only. Free accepts NULL. */
struct framebuffer_list *framebuffer_list_create(void);
void framebuffer_list_free(struct framebuffer_list *list);

/* Fills a colour of floats, a colour of integers, or the depth. Framebuffer 0 is the window's. */
void framebuffer_clear_color(GLuint framebuffer, int target, const float rgba[4]);
void framebuffer_clear_integers(GLuint framebuffer, int target, const GLuint rgba[4]);
void framebuffer_clear_depth(GLuint framebuffer, float depth);

#endif
