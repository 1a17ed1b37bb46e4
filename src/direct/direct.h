/* A method of direct light is bound only by what it writes: the light that comes straight from the
 * sources, at the G-buffer. */
#ifndef DIRECT_DIRECT_H
#define DIRECT_DIRECT_H

#include "base/settings.h"
#include "lights/sky.h"
#include "lights/view.h"
#include "scene/gpu/caster_pool.h"

struct frame;
struct gbuffer;

struct direct_desc {
    const struct settings *settings;
    int width, height;
    const struct light_layout *lights;
    bool specular;               /* the G-buffer has it */
    bool medium;                 /* frames have one, which takes its share of the light */
    bool slides;                 /* lights may have some */
    struct caster_pool *casters; /* must outlive the method */
    bool may_trace;              /* the BVH is ready in time */
    /* For environment_direct alone (direct/environment.h): */
    const struct direct_method *lamps;
    const struct environment_lights *sky;
};

struct direct_method {
    const char *name, *help;
    const struct settings_part *const *parts; /* what it has to set; null-terminated */
    /* Allocates and compiles all there is. Error: of the first pass that fails. */
    bool (*init)(void **state, const struct direct_desc *desc);
    void (*free)(void *state);
    /* Another size of picture. Error: out of GPU memory; all is as it was. */
    bool (*resize)(void *state, int width, int height);
    /* None of them can fail, allocate or compile. What no camera can change (NULL: nothing); what one camera's
     * G-buffer sees of it; and the result: RGBA32F, irradiance over pi, the radiance of a white
     * surface, W/(sr m2). */
    void (*render_lights)(void *state, const struct frame *frame);
    void (*render_view)(void *state, const struct frame *frame, const struct gbuffer *gbuffer);
    const struct texture *(*light)(const void *state);
    /* Where desc.specular, what is not diffuse: RGBA32F, radiance towards the camera, W/(sr m2). NULL: the
     * method shows all surfaces as diffuse. */
    const struct texture *(*specular)(const void *state);
};

/* All there are; their order means nothing. Null-terminated. */
extern const struct direct_method *const direct_methods[];

/* What is used where none is named: hard shadows, or soft ones where a light has a size. */
const struct direct_method *direct_for(const struct emitters *emitters);

/* The method of that name. Error, and NULL: names those there are. */
const struct direct_method *direct_find(const char *name);

#endif
