/* A technique computes indirect light by passes of its choice. Its result is a struct contribution,
 * which the composite adds to the picture. docs/dev/architecture.md lists the steps that add a
 * technique; test/guests/techniques/ambient/ is the smallest. */
#ifndef TECHNIQUES_TECHNIQUE_H
#define TECHNIQUES_TECHNIQUE_H

#include "base/settings.h"
#include "lights/view.h"
#include "passes/targets.h"
#include "scene/gpu/caster_pool.h"
#include "techniques/output.h"

struct frame;
struct step;

struct technique_desc {
    const struct settings *settings;
    const struct scene *scene;
    const struct geometry *geometry; /* in its current pose */
    struct caster_pool *casters;     /* casters of the geometry; they move with it */
    int width, height;
    const struct light_layout *lights;
    bool specular; /* some materials are specular: the G-buffer has a specular target */
    bool medium;   /* frames have a medium, which attenuates light */
};

/* A named choice of settings. */
struct preset {
    const char *name, *help;
    const char *settings; /* for example "clustered.visibility=cssm blur.cosine=.8" */
    const char *word;     /* name for --quality and in the viewer; NULL: `name` */
};

/* Settings of passes after the first, so that their mean approaches the reference. The technique
 * may differ, but must contribute the same kinds of light. */
struct refinement {
    const char *technique;
    const char *settings; /* in the form of a preset; other settings keep their values */
    float first_weight;   /* weight of the first pass over that of a later pass */
};

struct technique {
    const char *name, *help;
    const struct settings_part *const *parts; /* tables of its settings; null-terminated */
    const struct preset *presets;             /* ends with a row without a name; NULL: none */
    const struct refinement *refinement;      /* NULL: later passes are made as the first */
    bool samples_lights; /* VPLs start from lights without maps, too (passes/sampled_lights.h) */
    bool seeks_lights;   /* lights.importance=auto: follows the camera if it sees no lamp's light */
    /* Refuses combinations of values; NULL: none. Error: names the settings, for the user. */
    bool (*check)(const struct settings *settings);
    /* True if rays through a BVH test the visibility of all its lights; NULL: never. */
    bool (*by_rays)(const struct settings *settings, const struct scene *scene,
                    const struct geometry *geometry);
    /* Makes *state with all textures and programs. Error: that of the failed pass; the caller then
     * calls free. */
    bool (*init)(void **state, const struct technique_desc *desc);
    void (*free)(void *state);
    /* Changes the picture's size and keeps results of render_lights. Error: out of GPU memory; the
     * state stays unchanged. */
    bool (*resize)(void *state, int width, int height);
    /* Follows moved geometry; may allocate. NULL: the technique has no copy. Error: out of GPU
     * memory; the technique must then be freed. */
    bool (*update)(void *state, const struct geometry *geometry);
    /* Neither may fail, allocate or compile. render_lights draws camera-independent parts, once
     * for any number of views (NULL: none). render_view draws the parts of one camera and its
     * G-buffer. */
    void (*render_lights)(void *state, const struct frame *frame);
    /* True if render_lights depends on the camera's G-buffer and must run for each view; NULL: it
     * does not. */
    bool (*follows_camera)(const void *state);
    void (*render_view)(void *state, const struct frame *frame, const struct gbuffer *gbuffer);
    struct contribution (*contribution)(const void *state);
    const struct step *steps; /* passes of a state that begins with struct many_lights, or NULL */
    /* Adds intermediate results for inspection, besides those of the renderer; NULL: none. */
    void (*outputs)(const void *state, struct output_list *outputs);
};

/* All techniques, in any order, null-terminated. registry.c lists them. */
extern const struct technique *const techniques[];

/* The default technique, and the baseline that comparisons start with. */
extern const struct technique *const technique_default, *const technique_baseline;

/* True if the technique accepts the settings. Error: that of technique->check. */
bool technique_check(const struct technique *technique, const struct settings *settings);

/* Returns the technique of this name; NULL: the default. Error, NULL: unknown; names all
 * techniques. */
const struct technique *technique_find(const char *name);

#endif
