/* What every pass of one frame gets. Passes exchange the structs of the headers in this folder: targets.h, maps.h,
 * vpls.h, lists.h, slot_lights.h. No pass includes another. */
#ifndef PASSES_FRAME_H
#define PASSES_FRAME_H

#include "gl/pass.h"
#include "lights/view.h"
#include "scene/camera_range.h"
#include "scene/gpu/scene_gpu.h"

struct gbuffer;

struct frame {
    struct timers *timers;
    const struct buffer *view; /* for BLOCK_VIEW */
    const struct view *camera; /* what it holds */
    struct camera_range camera_range;
    const struct gbuffer *gbuffer; /* the camera's, where lights follow it; else NULL */
    bool of_panes;                 /* the G-buffer that is lit is that of panes */
    /* Lights: for a direct method the lights that shine, for a technique the light samples from which reflected light
     * starts. */
    const struct buffer *lights;  /* for BLOCK_LIGHTS */
    const struct texture *direct; /* of the camera's pixels (direct/direct.h) */
    const struct buffer *medium;  /* for BLOCK_MEDIUM; NULL where there is neither it nor a pane */
    const struct scene_gpu *scene;
    const struct emitters *emitters;
    const struct light_block *light_block; /* of the emitters: what the buffer holds */
    struct light_layout layout;            /* of the lights' maps */
    const struct light_group *groups;      /* layout.groups of them; NULL for direct light */
    const struct texture *sky_pieces;      /* of light samples (shared/sky.h) */
    const struct geometry *geometry; /* the scene's bounds and radius; for views of other lights */
    /* Of the camera's pixels: sample assignment (passes/picture/antialias.h), and edge samples
     * (lib/edge_sample.glsl). */
    const struct texture *assignment, *edge_samples;
    int pass; /* number of the pass, each with other light samples; 0: the first, or the only one */
    float irradiance_scale; /* stored irradiance = W/m2 times this: a power of two that
                                           keeps half floats in range at every scale of scene and light */
};

/* From 0 to 1, 0 in the first pass: multiples of the golden ratio, for numbers of pixels that are others in each pass. */
float frame_turn(const struct frame *frame);

/* Defines of a program that evaluates lights, with a semicolon at the end: a medium, and slides of spots. */
const char *light_defines(bool has_medium, bool has_slides);

/* Adds what programs of a medium read: its block, and the tree of panes. */
void frame_add_medium(const struct frame *frame, struct pass_state *state);

/* Adds what a program that evaluates lights reads of both. */
void frame_add_light(const struct frame *frame, struct pass_state *state);

/* Lets what is drawn by one of the programs end where the camera's range does (passes/picture/camera_range.glsl). */
void frame_cut_by_range(const struct frame *frame, struct pass_state *state);

/* The camera's view, of that many layers; the margin is draw_views'. */
struct draw_views frame_camera_views(const struct frame *frame, int layers, float margin);

/* The lights' of that kind. */
struct draw_views frame_light_views(const struct frame *frame, int kind);

/* Sets what lib/light_target.glsl needs to draw views of that kind; returns how many there are. */
int frame_target_views(const struct frame *frame, GLuint program, int kind);

#endif
