/* Common parts of methods with shadow maps: settings, maps, and light that arrives through them.
 * The state of a method is a struct shadow or begins with one. */
#ifndef DIRECT_SHADOW_H
#define DIRECT_SHADOW_H

#include "direct/direct.h"
#include "passes/visibility/direct_light.h"
#include "passes/visibility/shadow_map.h"

struct shadow_settings {
    int size; /* texels per side of a light's map */
};

extern const struct settings_part shadow_part;

struct shadow {
    struct shadow_map_pass maps;
    struct direct_light_pass light;
    struct direct_light_inputs inputs; /* of light; shadow maps unless the method has others */
};

/* Makes maps and passes. desc gives the picture's size and the specular, medium and slides flags.
 * The receiver's offset is fixed; the map size is the setting's unless program has one. Error: as
 * of the passes; call shadow_end then. */
bool shadow_begin(struct shadow *shadow, const struct direct_desc *desc,
                  const struct direct_light_desc *program);
void shadow_end(struct shadow *shadow);

/* Members of a struct direct_method. shadow_free requires a state that is exactly a struct
 * shadow. */
void shadow_free(void *state);
bool shadow_resize(void *state, int width, int height);
void shadow_render_lights(void *state, const struct frame *frame);
void shadow_render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer);
const struct texture *shadow_light(const void *state);
const struct texture *shadow_specular(const void *state);

/* Initialises the other members of a struct direct_method. */
#define SHADOW_METHOD .resize = shadow_resize, .light = shadow_light, .specular = shadow_specular

#endif
