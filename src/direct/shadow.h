/* What methods that draw shadow maps have in common: settings, the maps, and the light that arrives by
 * them. The state of such a method is a struct shadow, or begins with one. */
#ifndef DIRECT_SHADOW_H
#define DIRECT_SHADOW_H

#include "direct/direct.h"
#include "passes/visibility/direct_light.h"
#include "passes/visibility/shadow_map.h"

struct shadow_settings {
    int size; /* of a light's map, texels a side */
};

extern const struct settings_part shadow_part;

struct shadow {
    struct shadow_map_pass maps;
    struct direct_light_pass light;
    struct direct_light_inputs inputs; /* of light; the views' maps, unless the method has others */
};

/* The picture's size and the receiver's offset are taken from desc, and the maps' size where program has none;
 * what else it has stays. Error: as of the passes; shadow_end frees what is there. */
bool shadow_begin(struct shadow *shadow, const struct direct_desc *desc,
                  const struct direct_light_desc *program);
void shadow_end(struct shadow *shadow);

/* For struct direct_method. free is for a state that is a struct shadow and no more. */
void shadow_free(void *state);
bool shadow_resize(void *state, int width, int height);
void shadow_render_lights(void *state, const struct frame *frame);
void shadow_render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer);
const struct texture *shadow_light(const void *state);
const struct texture *shadow_specular(const void *state);

/* Members of a struct direct_method. */
#define SHADOW_METHOD .resize = shadow_resize, .light = shadow_light, .specular = shadow_specular

#endif
