/* What all many-light techniques share: reflective shadow map, VPLs, gather and blur. They differ
 * in the visibility between. */
#ifndef TECHNIQUES_MANY_LIGHTS_H
#define TECHNIQUES_MANY_LIGHTS_H

#include "passes/gather/blur.h"
#include "passes/gather/adaptive.h"
#include "passes/gather/gather.h"
#include "passes/gather/specular_rays.h"
#include "passes/gather/near_field.h"
#include "passes/lights/albedos.h"
#include "passes/lights/bounce.h"
#include "passes/lights/importance_map.h"
#include "techniques/path_starts.h"
#include "passes/lights/vpl.h"
#include "passes/picture/geometry.h"
#include "techniques/technique.h"

/* --- settings ---
 *
 * Defaults differ from the paper's [Dong 2009 §5-7] where others err less; MANY_LIGHTS_AS_PUBLISHED has the paper's.
 * Lengths are fractions of the spread of the VPLs, of the picture's height at a pixel's depth, or of the root of the
 * surfaces' area: neither units nor a plain around a room change what a setting means. */

enum { RSM_SIZE_MIN = 16 };

enum { IMPORTANCE_OFF, IMPORTANCE_AUTO, IMPORTANCE_ON };

struct lights_settings {
    int vpls; /* N; 0: many_lights_chosen */
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
    int adaptive; /* n of pixels with few like neighbours; 0: as all others; -1: many_lights_chosen */
    int adaptive_factor; /* 0: many_lights_chosen */
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

/* What maps and VALs need, where area lights may do without visibility and rays without maps. */
#define SHADOWS "cluster-lights.shadows!=none, clustered.trace!=on"

extern const struct settings_part lights_part, map_part, lookup_part, gather_part, blur_part,
    caster_part;

/* Near distance of a map, over the spread of the VPLs: nearer casters are ignored. It is at most the spacing of the
 * VPLs. */
extern const float many_lights_near_clip;

/* Bound of the geometry term by gather.clamp=value, times the squared radius of the scene. */
extern const float many_lights_clamp_value;

/* The presets that all have, and the published way through what they share. */
#define MANY_LIGHTS_FAST                                                                           \
    { "fast", "the defaults", "", "normal" }

#define MANY_LIGHTS_AS_PUBLISHED                                                                   \
    "lights.importance=off gather.adaptive=0 caster.error=0 blur.separable=off blur.cosine=.8"

/* Passes after the first: few VPLs, nothing interleaved or blurred. Where rays say what light arrives the mean of many
 * passes is unbiased, but for what patches take from later bounces, and for specular reflection. */
#define MANY_LIGHTS_REFINED                                                                        \
    "lights.vpls=64 lights.rsm-size=2048 lights.facets=on gather.interleave=1 gather.clamp=near "  \
    "gather.near-samples=256 blur.radius=0 lights.paths=256"

extern const struct refinement many_lights_refinement;

/* The settings with numbers in place of the values that leave a choice to the program. */
struct settings many_lights_chosen(const struct settings *settings, bool by_rays);

/* --- passes --- */

/* How the gather asks for visibility. */
struct many_lights_visibility {
    enum visibility_lookup lookup;
    int map_count;
    bool map_per_vpl; /* as in struct gather_desc, as is: */
    bool cuts;        /* but what is reflected as by a mirror takes VPLs */
    int map_size;     /* 0: as the settings have it */
    int block;        /* pixels a side of a block that shares its visibility; 0: none does */
    bool together;    /* pixels that are not on lists test it for several VPLs, too */
};

/* A pass without a program is one that the settings or the scene's materials leave out. */
struct many_lights {
    struct settings settings; /* that it was made for */
    struct many_lights_visibility visibility;
    struct caster_pool *casters;
    const struct caster_bvh *tree; /* where VPLs or specular rays ask by it */
    int specular;                  /* SPECULAR_... */
    bool medium;                   /* frames have one */
    bool slides;                   /* lights may have some */
    struct gbuffer rsm[LIGHT_MAP_KINDS];
    struct geometry_pass geometry;
    struct importance_map_pass importance; /* where VPLs are placed by it */
    struct vpl_pass vpl;
    struct vpl_buffer vpls;
    struct albedos albedos; /* of what rays of light meet; zeroed where there are none */
    int bounces;            /* where more than one: */
    struct bounce_pass bounce;
    struct path_starts path_starts;          /* where VPLs are placed by importance */
    struct near_field_pass near_field;       /* clamp=near */
    struct specular_rays_pass specular_rays; /* specular=rays */
    /* As large as the picture: */
    struct gather_pass gather;
    struct adaptive_pass adaptive; /* pixels with few like neighbours gather more */
    struct gather_pass adaptive_gather;
    struct gather_pass specular_gather; /* what reflects as by a mirror */
    struct blur_pass specular_blur;
    struct blur_pass blur; /* puts tiles in order, too; without it the gather is the result */
};

struct step_inputs;

/* The settings of a lookup. */
struct visibility_desc many_lights_lookup(const struct settings *settings,
                                          enum visibility_lookup lookup, int map_count);

/* Whether the scene has so few triangles that rays are traced though nobody asked for them: their BVH is built at load,
 * and for each pose anew. */
bool many_lights_may_trace(const struct scene *scene, const struct geometry *geometry);

/* As technique->check: each place of the pattern takes one VPL at least. */
bool many_lights_check(const struct settings *settings);

bool many_lights_init(struct many_lights *lights, const struct technique_desc *desc,
                      const struct many_lights_visibility *visibility);
void many_lights_free(struct many_lights *lights);

/* As technique->resize; as technique->contribution, below: of a state that begins with its many_lights. */
bool many_lights_resize(void *state, int width, int height);

/* Pixels to each side; 0: no blur. */
int many_lights_blur_radius(const struct settings *settings);

/* The casters that the settings ask for. */
struct caster_desc many_lights_caster(const struct settings *settings);

/* A pass of a frame by many lights, in the order that they are drawn. */
struct step {
    enum step_part { STEP_LIGHTS, STEP_BEGIN, STEP_GATHER, STEP_FINISH } part;
    const char *timer;
    const char *when; /* in words: settings and scenes that have it; NULL: all */
    size_t
        made; /* where `when`: of its program in struct many_lights, 0 in frames without the pass */
    void (*draw)(struct many_lights *lights, const struct step_inputs *inputs);
};

struct step_inputs {
    const struct frame *frame;
    const struct gbuffer *gbuffer;      /* not of STEP_LIGHTS */
    const struct gather_inputs *gather; /* of STEP_GATHER */
};

/* All of them; the last has no timer. */
extern const struct step many_lights_steps[];

/* Whether frames of the state, which begins with its many_lights, have the pass. */
bool step_runs(const struct step *step, const void *state);

/* RSM and VPLs, into lights->vpls; and where there are more bounces, those of all later ones into
 * lights->bounce.vpls. */
void many_lights_render_vpls(struct many_lights *lights, const struct frame *frame);

/* The gather: begins at zero, and then adds VPLs in as many calls as the technique likes. */
void many_lights_begin(struct many_lights *lights, const struct frame *frame,
                       const struct gbuffer *gbuffer);
void many_lights_gather(struct many_lights *lights, const struct frame *frame,
                        const struct gbuffer *gbuffer, const struct gather_inputs *inputs);

/* The near field, where it is not the VPLs', and the blur: after the gather. */
void many_lights_finish(struct many_lights *lights, const struct frame *frame,
                        const struct gbuffer *gbuffer);

/* All of it, where nothing is drawn between: of all bounces, by rays or without visibility. */
void many_lights_render_view(struct many_lights *lights, const struct frame *frame,
                             const struct gbuffer *gbuffer);

/* As technique->follows_camera. */
bool many_lights_follow_camera(const void *state);

/* As technique->contribution. */
struct contribution many_lights_contribution(const void *state);

/* Members of a struct technique whose functions are static and have the members' names. */
#define MANY_LIGHTS_TECHNIQUE                                                                      \
    .parts = parts, .presets = presets, .init = init, .free = free_state,                          \
    .render_lights = render_lights, .follows_camera = many_lights_follow_camera,                   \
    .render_view = render_view, .contribution = many_lights_contribution, .outputs = outputs,      \
    .steps = many_lights_steps

/* As technique->outputs; the VPLs as they are made, or as a technique has them with what it adds. */
void many_lights_outputs(const struct many_lights *lights, const struct vpl_buffer *vpls,
                         struct output_list *outputs);

#endif
