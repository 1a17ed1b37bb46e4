/* What lights see along their own axes, one map a light and six of a point light: linear depth for filters,
 * which cannot reach across the seams of the views' maps (passes/visibility/light_map.glsl). */
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

/* Maps of size x size texels for lights of that layout. */
bool light_map_pass_init(struct light_map_pass *pass, int size, const struct light_layout *lights);
void light_map_pass_free(struct light_map_pass *pass);

/* From the depths of the lights' views to pass->maps. Timer "light maps". */
void light_map_pass_render(const struct light_map_pass *pass, const struct frame *frame,
                           const struct texture views[LIGHT_MAP_KINDS]);

#endif
