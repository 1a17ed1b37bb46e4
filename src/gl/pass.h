/* A pass begins with its complete GL state and with all that it binds, in one literal: nothing
 * leaks from one to the next, and what a pass reads and writes is told in one place. */
#ifndef GL_PASS_H
#define GL_PASS_H

#include "gl/buffer.h"
#include "gl/pixel_mask.h"
#include "gl/texture.h"
#include "gl/timer.h"

enum pass_depth {
    PASS_DEPTH_OFF,
    PASS_DEPTH_LESS,    /* test and write; 1 is far */
    PASS_DEPTH_GREATER, /* test and write; 0 is far; of two equal depths the later stays */
    PASS_DEPTH_EQUAL,   /* test alone */
};

enum pass_blend {
    PASS_BLEND_OFF,
    PASS_BLEND_ADD,
    PASS_BLEND_MAX,
    PASS_BLEND_OVER, /* colour comes multiplied by its alpha */
};

/* Faces: the front is where corners go counter-clockwise in the picture. */
enum pass_cull {
    PASS_CULL_NONE,
    PASS_CULL_BACK,
    PASS_CULL_FRONT,
};

/* Channels of colour, as bits. */
enum { PASS_RED = 1, PASS_GREEN = 2, PASS_BLUE = 4, PASS_ALPHA = 8 };

/* OpenGL promises 16 textures for a stage, its drivers for 4.5 offer 32. Specular rays by slides and maps of Fourier bases
 * need up to 18. */
enum { PASS_TEXTURES_MAX = 20, PASS_BLOCKS_MAX = 8, PASS_STORAGES_MAX = 4, PASS_IMAGES_MAX = 4 };

/* Numbers are those of shared/bindings.h and of the pass's own header there. Lists end with the first empty row. */
struct pass_texture {
    GLuint unit, texture;
};

/* A range of a buffer, as a uniform block or as storage that shaders write. */
struct pass_block {
    GLuint block;
    const struct buffer *buffer;
    size_t offset, size; /* size 0: to the buffer's end */
};

/* A level of a texture with all its layers, which shaders load and store texel by texel. */
struct pass_image {
    GLuint image;
    const struct texture *texture;
    int level;
    GLenum access; /* GL_READ_ONLY, GL_WRITE_ONLY, GL_READ_WRITE */
};

/* Zero means none, off, 0. */
struct pass_state {
    const char *name;    /* timer and debug group; required */
    GLuint program;      /* required */
    GLuint framebuffer;  /* 0: no target; what is drawn then leaves by feedback, image or storage */
    bool window;         /* the window's own framebuffer in its place */
    GLuint vertex_array; /* 0: no attributes; vertices come from gl_VertexID */
    int x, y, width, height;
    enum pass_depth depth;
    const struct pixel_mask *mask; /* of a screen pass that marks pixels or runs at those */
    enum pass_blend blend;
    unsigned kept_colors; /* PASS_RED | ...: channels that are not written */
    enum pass_cull cull;  /* which faces are left out */
    bool point_size;      /* points as wide as gl_PointSize says, not one pixel */
    int clip_distances;   /* gl_ClipDistance[0 .. this) */
    struct pass_texture textures[PASS_TEXTURES_MAX];
    struct pass_block blocks[PASS_BLOCKS_MAX];
    struct pass_block storages[PASS_STORAGES_MAX];
    struct pass_image images[PASS_IMAGES_MAX];
    GLbitfield barriers; /* how this pass reads what earlier ones stored to images and storages:
                            GL_TEXTURE_FETCH_BARRIER_BIT, ... */
};

/* Sets all state and starts the timer. Depth ranges over [0, 1] (GL_ZERO_TO_ONE). */
void pass_begin(struct timers *timers, const struct pass_state *state);
void pass_end(struct timers *timers);

/* The state alone, within a pass of several draws. */
void pass_set_state(const struct pass_state *state);

/* For literals that are put together of parts. */
void pass_add_texture(struct pass_state *state, GLuint unit, GLuint texture);
void pass_add_block(struct pass_state *state, GLuint block, const struct buffer *buffer);

/* What changes from draw to draw. */
void pass_bind_texture(GLuint unit, GLuint texture);
void pass_bind_block(const struct pass_block *block);
void pass_viewport(int x, int y, int width, int height);

/* Uniforms of the pass's program. */
void pass_set_int(GLint location, int value);
void pass_set_ints(GLint location, int x, int y, int z, int w);
void pass_set_float(GLint location, float value);
void pass_set_floats(GLint location, float x, float y, float z, float w);
void pass_set_pairs(GLint location, int count, const float *pairs);

/* All pixels of the viewport, `instances` times: one triangle, or a dispatch (gl/screen.h). */
void pass_draw_fullscreen(int instances);

/* Those pixels of the viewport that the program's own vertex stage covers by so many vertices of triangles, or that
 * the body finds by SCREEN_BEGIN. Parts of different numbers share no pixel. */
void pass_draw_part(int part, int vertices);

/* Vertices 0 .. count of each instance, as GL_POINTS or GL_TRIANGLES. */
void pass_draw(GLenum primitive, int count, int instances);

/* Points first .. first + count through transform feedback into the buffer, from its start. */
void pass_feedback(GLuint buffer, int first, int count);

/* Workgroups of a compute program. */
void pass_dispatch(int x, int y, int z);

#endif
