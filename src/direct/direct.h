/* Interface of direct light methods: light that reaches the G-buffer straight from the sources. */
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
    bool specular;               /* the G-buffer has specular materials */
    bool medium;                 /* frames have a medium, which absorbs and scatters light */
    bool slides;                 /* lights may have slides */
    struct caster_pool *casters; /* must outlive the method */
    bool may_trace;              /* rays may be traced: the BVH is ready in time */
    /* For environment_direct and sampled_direct only (direct/environment.h, direct/sampled.h). */
    const struct direct_method *lamps;
    const struct environment_lights *sky;
};

struct direct_method {
    const char *name, *help;
    const struct settings_part *const *parts; /* settings of the method; NULL-terminated */
    /* Allocates and compiles everything. Error: as of the first pass that fails. */
    bool (*init)(void **state, const struct direct_desc *desc);
    void (*free)(void *state);
    /* Sets the size of the picture, pixels. Error: out of GPU memory; the state is unchanged. */
    bool (*resize)(void *state, int width, int height);
    /* Render without failure, allocation or compilation. render_lights: all that does not depend on
     * the camera (NULL: nothing). render_view: direct light at a camera's G-buffer. light: its
     * RGBA32F texture, irradiance over pi, the radiance of a white surface, W/(sr m2). */
    void (*render_lights)(void *state, const struct frame *frame);
    void (*render_view)(void *state, const struct frame *frame, const struct gbuffer *gbuffer);
    const struct texture *(*light)(const void *state);
    /* Returns specular light if desc.specular: RGBA32F, radiance towards the camera, W/(sr m2).
     * NULL: the method renders all surfaces as diffuse. */
    const struct texture *(*specular)(const void *state);
};

/* All methods in no special order, NULL-terminated. */
extern const struct direct_method *const direct_methods[];

/* Returns the default method: hard shadows, or soft ones if a light has a size. */
const struct direct_method *direct_for(const struct emitters *emitters);

/* Returns the method of that name. Error, and NULL: lists the names. */
const struct direct_method *direct_find(const char *name);

#endif
