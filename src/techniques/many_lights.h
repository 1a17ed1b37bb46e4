/* The common part of all many-light techniques: reflective shadow map, VPLs, gather and blur. They
 * differ in visibility. */
#ifndef TECHNIQUES_MANY_LIGHTS_H
#define TECHNIQUES_MANY_LIGHTS_H

#include "passes/gather/blur.h"
#include "passes/gather/adaptive.h"
#include "passes/gather/gather.h"
#include "passes/gather/specular_rays.h"
#include "passes/gather/near_field.h"
#include "passes/gather/near_sampled.h"
#include "passes/lights/albedos.h"
#include "passes/lights/bounce.h"
#include "passes/lights/importance_map.h"
#include "techniques/path_starts.h"
#include "passes/lights/vpl.h"
#include "passes/picture/geometry.h"
#include "techniques/technique.h"

/* --- settings ---
 *
 * Some defaults differ from [Dong 2009 §5-7] because they err less; MANY_LIGHTS_AS_PUBLISHED has
 * the paper's. Lengths are relative: to the spread of the VPLs, the picture's height at a pixel's
 * depth, or the root of the surface area. So neither units nor a ground plane around a room change
 * a setting's meaning. */

enum { RSM_SIZE_MIN = 16 };

enum { IMPORTANCE_OFF, IMPORTANCE_AUTO, IMPORTANCE_ON };

struct lights_settings {
    int vpls; /* N; 0: value of many_lights_chosen */
    int seed, rsm_size;
    int bounces, paths; /* P */
    int importance;     /* IMPORTANCE_... */
    bool facets;
};

struct map_settings {
    int size;
};

struct lookup_settings {
    int terms; /* K */
};

struct gather_settings {
    int interleave, clamp; /* GATHER_CLAMP_... */
    int near_samples;
    int adaptive;        /* n of adaptive pixels; 0: off; -1: value of many_lights_chosen */
    int adaptive_factor; /* 0: value of many_lights_chosen */
    bool edge_samples;
    int specular; /* SPECULAR_... - 1 */
};

struct blur_settings {
    int radius;
    bool separable;
    float distance, cosine; /* alpha, beta */
};

struct caster_settings {
    float error;
    int long_count;
};

/* Condition under which maps and VALs are used. */
#define SHADOWS "cluster-lights.shadows!=none, clustered.trace!=on"

extern const struct settings_part lights_part, map_part, lookup_part, gather_part, blur_part,
    caster_part;

/* Near distance of a map, over the spread of the VPLs; nearer casters are ignored. At most the VPL
 * spacing. */
extern const float many_lights_near_clip;

/* Bound of the geometry term with gather.clamp=value, times the squared scene radius. */
extern const float many_lights_clamp_value;

/* The preset that all techniques have, and the published values of common settings. */
#define MANY_LIGHTS_FAST                                                                           \
    { "fast", "the defaults", "", "normal" }

#define MANY_LIGHTS_AS_PUBLISHED                                                                   \
    "lights.importance=off gather.adaptive=0 caster.error=0 blur.separable=off blur.cosine=.8"

/* Settings of passes after the first: few VPLs, no interleaving, no blur. With rays the mean of
 * many passes is unbiased, except for patches of later bounces and for specular reflection. */
#define MANY_LIGHTS_REFINED                                                                        \
    "lights.vpls=64 lights.rsm-size=2048 lights.facets=on gather.interleave=1 gather.clamp=near "  \
    "gather.near-samples=256 blur.radius=0 lights.paths=256"

extern const struct refinement many_lights_refinement;

/* Returns the settings with automatic values (0 or -1) replaced. by_rays: of technique->by_rays. */
struct settings many_lights_chosen(const struct settings *settings, bool by_rays);

/* --- passes --- */

/* Visibility tests of the gather. */
struct many_lights_visibility {
    enum visibility_lookup lookup;
    int map_count;
    bool map_per_vpl; /* as in struct gather_desc */
    bool cuts;        /* as in struct gather_desc; the specular gather still takes VPLs */
    int map_size;     /* 0: size of the settings */
    int block;        /* side of a visibility block, pixels; 0: none */
    bool together;    /* planar pixels also share tests among several VPLs */
};

/* Passes of a many-light technique. A pass without a program is disabled by the settings or the
 * materials. */
struct many_lights {
    struct settings settings; /* settings at init */
    struct many_lights_visibility visibility;
    struct caster_pool *casters;
    const struct caster_bvh
        *tree;    /* BVH if VPLs, specular rays or sampled lights trace it; else NULL */
    int specular; /* SPECULAR_... */
    bool medium;  /* frames have a medium */
    bool slides;  /* lights may have slides */
    bool sampled; /* some lights have no maps (passes/sampled_lights.h) */
    struct gbuffer rsm[LIGHT_MAP_KINDS];
    struct geometry_pass geometry;
    struct importance_map_pass importance; /* if VPLs are placed by importance */
    struct vpl_pass vpl;
    struct vpl_buffer vpls;
    struct albedos albedos; /* albedos for light rays; zeroed without them */
    int bounces;            /* if more than 1, the next member is used */
    struct bounce_pass bounce;
    struct path_starts path_starts;          /* if VPLs are placed by importance */
    struct near_field_pass near_field;       /* with clamp=near */
    struct near_sampled_pass near_sampled;   /* the same, of sampled lights */
    struct specular_rays_pass specular_rays; /* with specular=rays */
    /* Passes of the picture's size: */
    struct gather_pass gather;
    struct adaptive_pass adaptive; /* list of adaptive pixels */
    struct gather_pass adaptive_gather;
    struct gather_pass specular_gather; /* specular light */
    struct blur_pass specular_blur;
    struct blur_pass blur; /* also reorders tiles; without it the gather is the result */
};

struct step_inputs;

/* Returns the parameters of a lookup by the settings. */
struct visibility_desc many_lights_lookup(const struct settings *settings,
                                          enum visibility_lookup lookup, int map_count);

/* True if the scene has few enough triangles to trace rays by default. The BVH is then built at
 * load and for each pose. */
bool many_lights_may_trace(const struct scene *scene, const struct geometry *geometry);

/* Implements technique->check. Error: fewer VPLs than places of the interleaving pattern. */
bool many_lights_check(const struct settings *settings);

bool many_lights_init(struct many_lights *lights, const struct technique_desc *desc,
                      const struct many_lights_visibility *visibility);
void many_lights_free(struct many_lights *lights);

/* Implements technique->resize, for a state that begins with its many_lights. */
bool many_lights_resize(void *state, int width, int height);

/* Returns the blur's taps on each side, pixels; 0: no blur. */
int many_lights_blur_radius(const struct settings *settings);

/* Returns the casters that the settings describe. */
struct caster_desc many_lights_caster(const struct settings *settings);

/* A pass of a frame by many lights, in the order of drawing. */
struct step {
    enum step_part { STEP_LIGHTS, STEP_BEGIN, STEP_GATHER, STEP_FINISH } part;
    const char *timer;
    const char *when; /* settings and scenes that have the pass, in words; NULL: all */
    /* With `when`: offset of its program in struct many_lights. Frames without the pass have
     * program 0. */
    size_t made;
    void (*draw)(struct many_lights *lights, const struct step_inputs *inputs);
};

struct step_inputs {
    const struct frame *frame;
    const struct gbuffer *gbuffer;      /* except in STEP_LIGHTS */
    const struct gather_inputs *gather; /* in STEP_GATHER */
};

/* Lists all passes; the last row has no timer. */
extern const struct step many_lights_steps[];

/* True if frames of the state, which begins with its many_lights, have the pass. */
bool step_runs(const struct step *step, const void *state);

/* Renders RSM and VPLs into lights->vpls. With more than one bounce it also fills
 * lights->bounce.vpls with all later bounces. */
void many_lights_render_vpls(struct many_lights *lights, const struct frame *frame);

/* Gather: many_lights_begin clears it, many_lights_gather adds VPLs in any number of calls. */
void many_lights_begin(struct many_lights *lights, const struct frame *frame,
                       const struct gbuffer *gbuffer);
void many_lights_gather(struct many_lights *lights, const struct frame *frame,
                        const struct gbuffer *gbuffer, const struct gather_inputs *inputs);

/* Adds the near field if VPLs leave it out, and blurs. Call it after the gather. */
void many_lights_finish(struct many_lights *lights, const struct frame *frame,
                        const struct gbuffer *gbuffer);

/* Runs begin, gather of all bounces, and finish, for techniques with rays or without visibility. */
void many_lights_render_view(struct many_lights *lights, const struct frame *frame,
                             const struct gbuffer *gbuffer);

/* Implements technique->follows_camera, for a state that begins with its many_lights. */
bool many_lights_follow_camera(const void *state);

/* Implements technique->contribution, for a state that begins with its many_lights. */
struct contribution many_lights_contribution(const void *state);

/* Members of a struct technique whose static functions have the members' names. */
#define MANY_LIGHTS_TECHNIQUE                                                                      \
    .samples_lights = true, .parts = parts, .presets = presets, .init = init, .free = free_state,  \
    .render_lights = render_lights, .follows_camera = many_lights_follow_camera,                   \
    .render_view = render_view, .contribution = many_lights_contribution, .outputs = outputs,      \
    .steps = many_lights_steps

/* Implements technique->outputs. `vpls` are the VPLs to show, with the additions of the
 * technique. */
void many_lights_outputs(const struct many_lights *lights, const struct vpl_buffer *vpls,
                         struct output_list *outputs);

#endif
