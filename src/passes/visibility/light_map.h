/* Renders linear depth along each light's own axes: one map a light, six a point light. Filters
 * cannot cross the seams between the maps of views (passes/visibility/light_map.glsl). */
#ifndef PASSES_LIGHT_MAP_H
#define PASSES_LIGHT_MAP_H

#include "passes/maps.h"
#include "shared/light.h"

struct frame;
struct light_layout;

struct light_map_pass {
    GLuint program, framebuffer;
    struct light_maps maps;
};

/* Makes maps of size x size texels for the lights of the layout. */
bool light_map_pass_init(struct light_map_pass *pass, int size, const struct light_layout *lights);
void light_map_pass_free(struct light_map_pass *pass);

/* Renders pass->maps from the depths of the lights' views. Timer "light maps". */
void light_map_pass_render(const struct light_map_pass *pass, const struct frame *frame,
                           const struct texture views[LIGHT_MAP_KINDS]);

#endif
