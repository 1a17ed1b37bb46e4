/* Adds up the direct light of all lights, each with its maps of depth: what the methods of direct light
 * have in common. */
#ifndef PASSES_DIRECT_LIGHT_H
#define PASSES_DIRECT_LIGHT_H

#include "gl/pass.h"
#include "shared/light.h"

struct frame;
struct gbuffer;

struct direct_light_desc {
    int width, height;
    int map_size;      /* of a single view's map, or of a light's own, texels a side */
    bool own_maps;     /* of lights (passes/visibility/light_map.glsl), not of their views */
    float bias;        /* receiver offset along its normal, texels of the map */
    float map_bias;    /* where distances are compared, of the distance */
    float contact;     /* casters so near are compared one by one, of the distance */
    float shift, gain; /* struct lookup_params' */
    bool specular;     /* the G-buffer has it: what is not diffuse goes to a target of its own */
    bool medium;       /* frames have one */
    bool slides;       /* lights may have some */
    const char
        *fragment; /* with passes/visibility/direct_light.glsl; of one light, for each PROJECTION */
    const char *defines; /* for it, each with a semicolon behind */
};

enum { DIRECT_LIGHT_TEXTURES_MAX = 6 };

/* What the shader reads besides the G-buffer. */
struct direct_light_inputs {
    const struct texture *maps[LIGHT_MAP_KINDS]; /* of depth: those of a light's kind */
    struct pass_texture more[DIRECT_LIGHT_TEXTURES_MAX];
    struct pass_block block; /* may be none */
};

struct direct_light_pass {
    GLuint perspective_program, orthographic_program;
    struct direct_light_target {
        struct texture light;    /* RGBA32F, irradiance over pi, W/(sr m2) */
        struct texture specular; /* RGBA32F, radiance towards the eye, where desc.specular */
        GLuint framebuffer;
    } target;
    struct buffer lookups[LIGHT_MAP_KINDS];
};

bool direct_light_pass_init(struct direct_light_pass *pass, const struct direct_light_desc *desc);
void direct_light_pass_free(struct direct_light_pass *pass);

/* Error: out of GPU memory; all is as it was. */
bool direct_light_pass_resize(struct direct_light_pass *pass, int width, int height);

/* Fills pass->target, or adds to what it has. Timer "direct". */
enum direct_light_start { DIRECT_LIGHT_ANEW, DIRECT_LIGHT_ADDS };
void direct_light_pass_render(const struct direct_light_pass *pass, const struct frame *frame,
                              const struct gbuffer *gbuffer,
                              const struct direct_light_inputs *inputs,
                              enum direct_light_start start);

#endif
