/* A technique is a recipe of passes, bound only by what it writes: a contribution to the picture.
 */
#ifndef TECHNIQUES_TECHNIQUE_H
#define TECHNIQUES_TECHNIQUE_H

#include "base/settings.h"
#include "lights/view.h"
#include "passes/targets.h"
#include "scene/gpu/caster_pool.h"
#include "techniques/output.h"

struct frame;

struct technique_desc {
    const struct settings *settings;
    const struct scene *scene;
    const struct geometry *geometry; /* as it is posed now */
    struct caster_pool *casters;     /* of the geometry; moved with it */
    int width, height;
    const struct light_layout *lights;
    bool specular; /* materials are not all plain: the G-buffer has a specular target */
};

/* A named choice of settings. */
struct preset {
    const char *name, *help;
    const char *settings; /* "clustered.visibility=cssm blur.cosine=.8" */
    const char *word;     /* that --quality and the viewer have for it; NULL: its name */
};

/* How the passes after the first are made, so that their mean loses what the first approximates: by
 * another technique, or the same, with settings of its own. It contributes the same kinds of light. */
struct refinement {
    const char *technique;
    const char *settings; /* as a preset's; all others are as they are set */
    float first_weight;   /* of the first pass in the mean: as many others are as true */
};

struct technique {
    const char *name, *help;
    const struct settings_part *const *parts; /* what it has to set; null-terminated */
    const struct preset *presets;             /* ends with a row of no name; NULL = none */
    const struct refinement *refinement;      /* NULL: all passes are made as the first */
    /* What the ranges of single settings cannot say; NULL = nothing. Error: for the user. */
    bool (*check)(const struct settings *settings);
    /* Allocates and compiles all there is. Error: of the first pass that fails. */
    bool (*init)(void **state, const struct technique_desc *desc);
    void (*free)(void *state);
    /* Another size of picture; the lights that were rendered stay. Error: out of GPU memory; all is
     * as it was. */
    bool (*resize)(void *state, int width, int height);
    /* The geometry has moved; may allocate. NULL where a technique keeps nothing of it. Error: out
     * of GPU memory; the technique must then be freed. */
    bool (*update)(void *state, const struct geometry *geometry);
    /* Both cannot fail, allocate or compile. What no camera can change, to be used by any number
     * of views (NULL: nothing); and what one camera's G-buffer sees of it. */
    void (*render_lights)(void *state, const struct frame *frame);
    void (*render_view)(void *state, const struct frame *frame, const struct gbuffer *gbuffer);
    struct contribution (*contribution)(const void *state);
    /* Adds what there is to look at; NULL: nothing. */
    void (*outputs)(const void *state, struct output_list *outputs);
};

/* All there are; their order means nothing. Null-terminated. */
extern const struct technique *const techniques[];

/* What is used where none is named, and what the others are first compared with. */
extern const struct technique *const technique_default, *const technique_baseline;

/* Whether the technique can work with the settings; else its error. */
bool technique_check(const struct technique *technique, const struct settings *settings);

/* The technique of that name; NULL is the default's. Error, and NULL: names those there are. */
const struct technique *technique_find(const char *name);

#endif
