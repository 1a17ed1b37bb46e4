/* Passes. One struct literal states the complete GL state of a pass and all its bindings, so no
 * state leaks from one pass to the next. */
#ifndef GL_PASS_H
#define GL_PASS_H

#include "gl/buffer.h"
#include "gl/pixel_mask.h"
#include "gl/texture.h"
#include "gl/timer.h"

enum pass_depth {
    PASS_DEPTH_OFF,
    PASS_DEPTH_LESS,    /* test and write; far is 1 */
    PASS_DEPTH_GREATER, /* test and write; far is 0; of equal depths the later wins */
    PASS_DEPTH_EQUAL,   /* test only */
};

enum pass_blend {
    PASS_BLEND_OFF,
    PASS_BLEND_ADD,
    PASS_BLEND_MAX,
    PASS_BLEND_OVER, /* colours are premultiplied by alpha */
};

/* Faces to discard. A front face has counter-clockwise corners in the picture. */
enum pass_cull {
    PASS_CULL_NONE,
    PASS_CULL_BACK,
    PASS_CULL_FRONT,
};

/* OpenGL guarantees 16 textures per stage; drivers for 4.5 offer 32. Specular rays with slides,
 * fog, a sky, sampled lights and reflective maps of both kinds list 23. */
enum { PASS_TEXTURES_MAX = 32, PASS_BLOCKS_MAX = 8, PASS_STORAGES_MAX = 4, PASS_IMAGES_MAX = 4 };

/* Unit and block numbers are in shared/bindings.h and in the shared header of the pass. Lists end
 * at the first empty row. */
struct pass_texture {
    GLuint unit, texture;
};

/* Range of a buffer, used as a uniform block or as storage that shaders write. */
struct pass_block {
    GLuint block;
    const struct buffer *buffer;
    size_t offset, size; /* bytes; size 0: to the end of the buffer */
};

/* One level of a texture, with all layers, that shaders load and store. */
struct pass_image {
    GLuint image;
    const struct texture *texture;
    int level;
    GLenum access; /* GL_READ_ONLY, GL_WRITE_ONLY, GL_READ_WRITE */
};

/* State of a pass. Zero selects none, off or 0. */
struct pass_state {
    const char *name;    /* name of timer and debug group; required */
    GLuint program;      /* required */
    GLuint framebuffer;  /* 0: none; output through feedback, images or storage */
    bool window;         /* draws to the window; replaces framebuffer */
    GLuint vertex_array; /* 0: no attributes; vertices come from gl_VertexID */
    int x, y, width, height;
    enum pass_depth depth;
    const struct pixel_mask *mask; /* mask that a screen pass marks or runs at */
    enum pass_blend blend;
    enum pass_cull cull; /* faces to discard */
    bool point_size;     /* gl_PointSize sets the size of points; else one pixel */
    int clip_distances;  /* number of enabled gl_ClipDistance */
    struct pass_texture textures[PASS_TEXTURES_MAX];
    struct pass_block blocks[PASS_BLOCKS_MAX];
    struct pass_block storages[PASS_STORAGES_MAX];
    struct pass_image images[PASS_IMAGES_MAX];
    /* Barriers for reads of data that earlier passes stored to images and storage:
     * GL_TEXTURE_FETCH_BARRIER_BIT, ... */
    GLbitfield barriers;
};

/* Sets the whole state and starts the timer. Depth ranges over [0, 1] (GL_ZERO_TO_ONE). */
void pass_begin(struct timers *timers, const struct pass_state *state);
void pass_end(struct timers *timers);

/* Sets the state without a timer, between the draws of one pass. */
void pass_set_state(const struct pass_state *state);

/* Append a binding to a state that is built in steps. */
void pass_add_texture(struct pass_state *state, GLuint unit, GLuint texture);
void pass_add_block(struct pass_state *state, GLuint block, const struct buffer *buffer);

/* Set a binding, the viewport or the discarded faces between two draws of a pass. */
void pass_set_cull(enum pass_cull cull);
void pass_bind_texture(GLuint unit, GLuint texture);
void pass_bind_block(const struct pass_block *block);
void pass_viewport(int x, int y, int width, int height);

/* Set uniforms of the pass's program. */
void pass_set_int(GLint location, int value);
void pass_set_ints(GLint location, int x, int y, int z, int w);
void pass_set_float(GLint location, float value);
void pass_set_floats(GLint location, float x, float y, float z, float w);
void pass_set_pairs(GLint location, int count, const float *pairs);

/* Draws all pixels of the viewport, `instances` times, by a triangle or a dispatch
 * (gl/screen.h). */
void pass_draw_fullscreen(int instances);

/* Draws a part of the viewport. Drawn, the program's vertex stage covers it with triangles of
 * `vertices` corners in all. Dispatched, SCREEN_BEGIN of the body narrows the area. Parts with
 * different numbers share no pixel. */
void pass_draw_part(int part, int vertices);

/* Draws vertices 0 to count - 1 of each instance, as GL_POINTS or GL_TRIANGLES. */
void pass_draw(GLenum primitive, int count, int instances);

/* Writes points first to first + count - 1 to the start of the buffer by transform feedback. */
void pass_feedback(GLuint buffer, int first, int count);

/* Dispatches x * y * z workgroups of a compute program. */
void pass_dispatch(int x, int y, int z);

#endif
