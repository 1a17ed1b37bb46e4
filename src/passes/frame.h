/* Data that every pass of a frame gets. Passes exchange the structs of this folder's headers:
 * targets.h, maps.h, vpls.h, lists.h, slot_lights.h. No pass includes another. */
#ifndef PASSES_FRAME_H
#define PASSES_FRAME_H

#include "gl/pass.h"
#include "lights/view.h"
#include "scene/camera_range.h"
#include "scene/gpu/scene_gpu.h"

struct gbuffer;

struct frame {
    struct timers *timers;
    const struct buffer *view; /* block BLOCK_VIEW */
    const struct view *camera; /* contents of `view` */
    struct camera_range camera_range;
    float sensor; /* distance of a white plane that the camera sees alone, metres; 0: none */
    const struct gbuffer *gbuffer; /* of the camera, if lights depend on it; else NULL */
    bool of_panes;                 /* the lit G-buffer is that of panes */
    /* Lights: the shining lights for a direct method; for a technique the light samples that
     * reflected light starts from. */
    const struct buffer *lights;  /* block BLOCK_LIGHTS */
    const struct texture *direct; /* direct light of the camera's pixels (direct/direct.h) */
    const struct buffer *medium;  /* block BLOCK_MEDIUM; NULL without medium and panes */
    const struct scene_gpu *scene;
    const struct emitters *emitters;
    const struct light_block *light_block; /* contents of `lights` */
    struct light_layout layout;            /* layout of the lights' maps */
    const struct light_group *groups;      /* layout.groups light groups; NULL for direct light */
    const struct sampled_lights *sampled;  /* lights without maps */
    /* Directions of an environment's light samples (shared/sky.h). */
    const struct texture *sky_pieces;
    /* Bounds and radius of the scene, for views of other lights. */
    const struct geometry *geometry;
    /* Camera pixels: sample assignment (passes/picture/antialias.h) and edge samples
     * (lib/edge_sample.glsl). */
    const struct texture *assignment, *edge_samples;
    int pass; /* index of the pass, 0 for the first or only one; each has other light samples */
    /* Stored irradiance over W/m2: a power of two that keeps half floats in range at every scale of
     * scene and light. */
    float irradiance_scale;
};

/* Returns the pass's rotation in [0, 1): multiples of the golden ratio, 0 in the first pass. Pixels
 * add it to their sample numbers. */
float frame_turn(const struct frame *frame);

/* Returns defines of a program that evaluates lights, each followed by a semicolon: HAS_MEDIUM,
 * HAS_SLIDES. */
const char *light_defines(bool has_medium, bool has_slides);

/* Binds the medium's block and the tree of panes. Binds nothing without medium and panes. */
void frame_add_medium(const struct frame *frame, struct pass_state *state);

/* Binds the medium and the spots' slides, for a program that evaluates lights. */
void frame_add_light(const struct frame *frame, struct pass_state *state);

/* Clips the pass's geometry at the camera's near and far limits
 * (passes/picture/camera_range.glsl). */
void frame_cut_by_range(const struct frame *frame, struct pass_state *state);

/* Returns the camera's view for `layers` layers; `margin` as in struct draw_views, NDC. */
struct draw_views frame_camera_views(const struct frame *frame, int layers, float margin);

/* Returns the lights' views of `kind`, LIGHT_MAP_..., for a program with lib/light_target.glsl. */
struct draw_views frame_light_views(const struct frame *frame, int kind, GLuint program);

/* Sets LOCATION_FIRST_VIEW for all views of `kind`; returns their number. */
int frame_target_views(const struct frame *frame, GLuint program, int kind);

#endif
