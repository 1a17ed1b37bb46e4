/* Adds up the direct light of all lights, each with its maps of depth: what the methods of direct light
 * have in common. */
#ifndef PASSES_DIRECT_LIGHT_H
#define PASSES_DIRECT_LIGHT_H

#include "passes/frame.h"

struct direct_light_desc {
    int width, height;
    int map_size;         /* of a single view's map, texels a side */
    float bias;           /* receiver offset along its normal, texels of the map */
    float map_bias;       /* where distances are compared, of the distance */
    const char *fragment; /* with visibility/direct_light.glsl; of one light, for each PROJECTION */
    const char *defines;  /* for it, each with a semicolon behind */
};

struct direct_light_pass {
    GLuint perspective_program, orthographic_program;
    struct direct_light_target {
        struct texture light; /* RGBA32F, irradiance over pi, W/(sr m2) */
        GLuint framebuffer;
    } target;
    struct buffer lookups[LIGHT_MAP_KINDS];
};

bool direct_light_pass_init(struct direct_light_pass *pass, const struct direct_light_desc *desc);
void direct_light_pass_free(struct direct_light_pass *pass);

/* Error: out of GPU memory; all is as it was. */
bool direct_light_pass_resize(struct direct_light_pass *pass, int width, int height);

/* Fills pass->target.light, or adds to what it has. Timer "direct". */
enum direct_light_start { DIRECT_LIGHT_ANEW, DIRECT_LIGHT_ADDS };
void direct_light_pass_render(const struct direct_light_pass *pass, const struct frame *frame,
                              const struct gbuffer *gbuffer,
                              const struct texture maps[LIGHT_MAP_KINDS],
                              enum direct_light_start start);

#endif
