/* A technique computes indirect light by passes of its choice. Its result is a struct contribution, which the composite
 * adds to the picture. docs/dev/architecture.md lists the steps that add one; test/guests/techniques/ambient/ is the
 * smallest. */
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
    const struct geometry *geometry; /* in its pose at this time */
    struct caster_pool *casters;     /* of the geometry; moved with it */
    int width, height;
    const struct light_layout *lights;
    bool specular; /* some materials are specular: the G-buffer has a target for them */
    bool medium;   /* frames have one, which takes its share of all light */
};

/* A named choice of settings. */
struct preset {
    const char *name, *help;
    const char *settings; /* "clustered.visibility=cssm blur.cosine=.8" */
    const char *word;     /* its name for --quality and in the viewer; NULL: the same */
};

/* How the passes after the first are made, so that their mean approaches the reference: by another technique, or the
 * same, with settings of its own. It contributes the same kinds of light. */
struct refinement {
    const char *technique;
    const char *settings; /* as a preset's; other settings keep their values */
    float first_weight;   /* weight of the first pass in the mean, over that of a later pass */
};

struct technique {
    const char *name, *help;
    const struct settings_part *const *parts; /* tables of its settings; null-terminated */
    const struct preset *presets;             /* ends with a row of no name; NULL = none */
    const struct refinement *refinement;      /* NULL: all passes are made as the first */
    bool seeks_lights; /* lights.importance=auto: follows the camera where lamps are unseen */
    /* Refuses values that exclude each other; NULL: none do. Error: for the user. */
    bool (*check)(const struct settings *settings);
    /* Whether rays through a BVH of the scene test the visibility of all its lights; NULL: it has no such rays. */
    bool (*by_rays)(const struct settings *settings, const struct scene *scene,
                    const struct geometry *geometry);
    /* Makes *state, with all textures and programs. Error: of the first pass that fails; free is then called. */
    bool (*init)(void **state, const struct technique_desc *desc);
    void (*free)(void *state);
    /* Changes the size of the picture; results of render_lights stay. Error: out of GPU memory; the
     * state is unchanged. */
    bool (*resize)(void *state, int width, int height);
    /* The geometry has moved; may allocate. NULL: the technique keeps no copy of it. Error: out of GPU memory; the
     * technique must then be freed. */
    bool (*update)(void *state, const struct geometry *geometry);
    /* Both cannot fail, allocate or compile. render_lights draws the parts that depend on no camera, once for any number of
     * views (NULL: none); render_view draws the parts for one camera and its G-buffer. */
    void (*render_lights)(void *state, const struct frame *frame);
    /* Whether render_lights depends on the camera's G-buffer: it is then called for each view (NULL: it does not). */
    bool (*follows_camera)(const void *state);
    void (*render_view)(void *state, const struct frame *frame, const struct gbuffer *gbuffer);
    struct contribution (*contribution)(const void *state);
    const struct step
        *steps; /* its passes, of a state that begins with struct many_lights; NULL: not told */
    /* Adds intermediate results to look at, beside those of the renderer; NULL: none. */
    void (*outputs)(const void *state, struct output_list *outputs);
};

/* All techniques, in any order. Null-terminated. registry.c lists them. */
extern const struct technique *const techniques[];

/* The technique without --technique, and the first with which others are compared. */
extern const struct technique *const technique_default, *const technique_baseline;

/* Whether the technique can work with the settings; else its error. */
bool technique_check(const struct technique *technique, const struct settings *settings);

/* The technique of that name; NULL is the default's. Error, and NULL: names all techniques. */
const struct technique *technique_find(const char *name);

#endif
