/* A pass begins with its complete GL state, so that nothing leaks from one to the next. */
#ifndef GL_PASS_H
#define GL_PASS_H

#include "gl/timer.h"

enum pass_depth {
    PASS_DEPTH_OFF,
    PASS_DEPTH_LESS,    /* test and write; 1 is far */
    PASS_DEPTH_GREATER, /* test and write; 0 is far: reversed depth */
};

enum pass_blend {
    PASS_BLEND_OFF,
    PASS_BLEND_ADD,
    PASS_BLEND_MAX,
    PASS_BLEND_OVER, /* colour comes multiplied by its alpha */
};

struct pass_state {
    const char *name; /* timer and debug group */
    GLuint program;
    GLuint framebuffer;  /* 0 = none, for transform feedback */
    GLuint vertex_array; /* 0 = an empty one: vertices come from gl_VertexID */
    int x, y, width, height;
    enum pass_depth depth;
    enum pass_blend blend;
    bool cull_back;     /* faces seen from behind are left out */
    int clip_distances; /* gl_ClipDistance[0 .. this) */
};

/* Sets all state and starts the timer. Depth ranges over [0, 1] (GL_ZERO_TO_ONE). */
void pass_begin(struct timers *timers, const struct pass_state *state);
void pass_end(struct timers *timers);

/* The state alone, within a pass of several draws. */
void pass_set_state(const struct pass_state *state);

/* One triangle that covers the viewport, `instances` times. */
void pass_draw_fullscreen(int instances);

/* Points first .. first + count through transform feedback into the buffer, from its start. */
void pass_feedback(GLuint buffer, int first, int count);

#endif
