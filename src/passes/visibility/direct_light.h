/* Sums the direct light of all lights by their depth maps: the common part of the direct
 * methods. */
#ifndef PASSES_DIRECT_LIGHT_H
#define PASSES_DIRECT_LIGHT_H

#include "gl/pass.h"
#include "shared/light.h"

struct frame;
struct gbuffer;

struct direct_light_desc {
    int width, height;
    int map_size;      /* side of a view's or a light's map, texels */
    bool own_maps;     /* reads maps of lights (passes/visibility/light_map.glsl), not of views */
    float bias;        /* receiver offset along its normal, texels of the map */
    float map_bias;    /* bias of distance comparisons, over the distance */
    float contact;     /* range of casters that are compared one by one, over the distance */
    float shift, gain; /* as in struct lookup_params */
    /* Specular light goes to a second target; needs the G-buffer's specular target. */
    bool specular;
    bool medium; /* frames have a medium */
    bool slides; /* lights may have slides */
    /* Shader of one light with passes/visibility/direct_light.glsl, built for each PROJECTION. */
    const char *fragment;
    const char *defines; /* defines of the fragment shader, each followed by a semicolon */
};

enum { DIRECT_LIGHT_TEXTURES_MAX = 6 };

/* Inputs of the shader besides the G-buffer. */
struct direct_light_inputs {
    const struct texture *maps[LIGHT_MAP_KINDS]; /* depth maps of each kind of light view */
    struct pass_texture more[DIRECT_LIGHT_TEXTURES_MAX];
    struct pass_block block; /* optional */
};

struct direct_light_pass {
    GLuint perspective_program, orthographic_program;
    struct direct_light_target {
        struct texture light;    /* RGBA32F, irradiance over pi, W/(sr m2) */
        struct texture specular; /* RGBA32F, radiance towards the camera, with desc.specular */
        GLuint framebuffer;
    } target;
    struct buffer lookups[LIGHT_MAP_KINDS];
};

bool direct_light_pass_init(struct direct_light_pass *pass, const struct direct_light_desc *desc);
void direct_light_pass_free(struct direct_light_pass *pass);

/* Error: out of GPU memory; the pass stays unchanged. */
bool direct_light_pass_resize(struct direct_light_pass *pass, int width, int height);

/* Fills pass->target, or adds to its contents. Timer "direct". */
enum direct_light_start { DIRECT_LIGHT_ANEW, DIRECT_LIGHT_ADDS };
void direct_light_pass_render(const struct direct_light_pass *pass, const struct frame *frame,
                              const struct gbuffer *gbuffer,
                              const struct direct_light_inputs *inputs,
                              enum direct_light_start start);

#endif
