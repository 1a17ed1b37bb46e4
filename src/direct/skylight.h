/* Direct light of a sky, beside whichever method gives that of all other lights: by default 120 area lights with
 * soft shadows [Dong 2011 §5.3.2]. */
#ifndef DIRECT_SKYLIGHT_H
#define DIRECT_SKYLIGHT_H

#include "base/settings.h"
#include "passes/visibility/sky_light.h"
#include "passes/visibility/sky_map.h"

struct skylight_settings {
    int lights, fit; /* enum sky_fit */
    int map_size;    /* texels a side */
    int shadow_rays;
    int directions; /* that reflected light starts from, at most */
};

extern const struct settings_part sky_part;

struct skylight_desc {
    const struct settings *settings;
    struct caster_pool *casters;
    int width, height;
    int count;  /* of lights; 0: there is no sky */
    int suns;   /* the first ones */
    bool gloss; /* the G-buffer has it */
};

struct skylight {
    int count;
    struct sky_map_pass maps;
    struct sky_light_pass light;
    struct buffer lights; /* struct sky_block */
};

/* Error: of the first pass that fails. */
bool skylight_init(struct skylight *skylight, const struct skylight_desc *desc);
void skylight_free(struct skylight *skylight);

/* Error: out of GPU memory; all is as it was. */
bool skylight_resize(struct skylight *skylight, int width, int height);

/* None of them can fail. Without a sky nothing is done, and the light is direct's own. specular: where
 * desc.gloss. */
void skylight_write(struct skylight *skylight, const struct sky_block *block);
void skylight_render_lights(const struct skylight *skylight, const struct frame *frame);
void skylight_render_view(const struct skylight *skylight, const struct frame *frame,
                          const struct gbuffer *gbuffer, const struct texture *direct,
                          const struct texture *specular);
const struct texture *skylight_light(const struct skylight *skylight, const struct texture *direct);
const struct texture *skylight_specular(const struct skylight *skylight,
                                        const struct texture *specular);

#endif
