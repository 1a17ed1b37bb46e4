/* What a frame is drawn into: surfaces, irradiance, and what a technique makes of them. All pictures have row 0 at the
 * bottom, as GL has it. */
#ifndef PASSES_TARGETS_H
#define PASSES_TARGETS_H

#include "gl/pass.h"
#include "gl/texture.h"
#include "shared/gather.h"
#include "shared/light.h"

#include <string.h>

/* Surfaces seen from the camera (one layer) or from the lights (the reflective shadow map: one of
 * LIGHT_MAP_KINDS, a layer each view; without textures where there are none of the kind). Arrays of
 * layers:
 *   normal  RG16      world normal, octahedral
 *   albedo  RGBA16    square root of the albedo; A = 1 where something is. RGBA16F of facets: of what a
 *                     triangle receives, over what meets its plane, times the albedo; normal is the triangle's
 *   depth   D32F      reversed (shared/view.h); 0 where nothing is
 *   emission RGBA16F  radiance times irradiance_scale; in the camera's view alone, if a material
 *                     is emissive or not plain (scene/material.h)
 *   specular RGBA16   specular reflectance (lib/specular.glsl), if a material is not plain: in the camera's view,
 *                     and in lights' views if rays read it. The normal is then the bent one. The
 *                     albedo is the diffuse part's. Lights' views add what the specular part
 *                     reflects, as if it were diffuse.
 */
struct gbuffer {
    struct texture normal, albedo, depth, emission, specular;
    GLuint framebuffer;
    int width, height, layers;
};

/* Irradiance times irradiance_scale; in tiles of equal place in the n x n pattern, or plain where
 * interleave is 1. RGBA32F where many draws add up: halves would lose some of each. RGBA16F where
 * one draw writes. */
struct irradiance {
    struct texture texture;
    GLuint framebuffer;
    int width, height; /* of the picture that it stands for */
    int interleave, tile_width, tile_height;
};

/* What a technique makes, each NULL where it does not; composite adds what is there:
 *
 *     L = transmittance (albedo (direct + caustic + irradiance / pi) + radiance) + in_scatter + volume_caustic
 *
 * Light of surfaces: irradiance, not yet times albedo, or radiance towards the camera. Light of
 * what lies before them: in_scatter, with the share of the surfaces' light that passes. Textures
 * are of the picture's size; radiance and in_scatter times irradiance_scale. */
struct contribution {
    const struct irradiance *irradiance;
    /* Of edge samples, and at each pixel the texel of its own (passes/gather/list_texel.glsl); both or none. */
    const struct irradiance *edge_sample_irradiance;
    const struct texture *edge_sample_texels;
    const struct texture *radiance;
    const struct texture
        *direct_specular; /* RGBA32F, not scaled: in place of the direct method's */
    const struct texture *in_scatter,
        *transmittance; /* both or none; a scene's medium replaces them */
    /* The renderer's, RGBA32F: radiance of a white surface, and radiance; not scaled. Where A of caustic is not 0 the pixel
     * shows glass or a mirror, and the texel is the radiance that these show (passes/caustics/glass.h). */
    const struct texture *caustic, *volume_caustic;
};

/* What a display shows behind all surfaces. */
struct background {
    int kind;        /* BACKGROUND_..., shared/composite.h */
    float colour[3]; /* light of the display, from 0 to 1 */
};

struct gbuffer_desc {
    const char *label;
    int width, height, layers;
    bool has_emission, has_specular;
    bool facets; /* as geometry_desc's */
};

bool gbuffer_init(struct gbuffer *gbuffer, const struct gbuffer_desc *desc);
void gbuffer_free(struct gbuffer *gbuffer);

/* Binds what lib/rsm.glsl reads, and lib/rsm_specular.glsl where the maps have that target. For a kind that is not there, and is not read, the other stands in:
 * drivers warn of empty units. */
void rsm_add(struct pass_state *state, const struct gbuffer rsm[LIGHT_MAP_KINDS]);

bool irradiance_init(struct irradiance *irradiance, const char *label, GLenum format, int width,
                     int height, int interleave);
void irradiance_free(struct irradiance *irradiance);

/* Another size of the picture. Error: out of GPU memory; it is unchanged. */
bool irradiance_resize(struct irradiance *irradiance, int width, int height);

/* Defines TYPE_resize, which makes the members of a pass from `first` to `last` anew for another size of the picture, by the
 * init_targets and free_targets of its file. Where there is no memory for them the pass is unchanged. */
#define DEFINE_RESIZE(type, first, last)                                                           \
    bool type##_resize(struct type *pass, int width, int height) {                                 \
        struct type fresh = *pass;                                                                 \
        memset(&fresh.first, 0,                                                                    \
               offsetof(struct type, last) + sizeof fresh.last - offsetof(struct type, first));    \
        fresh.desc.width = width;                                                                  \
        fresh.desc.height = height;                                                                \
        bool ok = init_targets(&fresh);                                                            \
        free_targets(ok ? pass : &fresh);                                                          \
        if (ok)                                                                                    \
            *pass = fresh;                                                                         \
        return ok;                                                                                 \
    }

/* For shaders. */
struct interleaving irradiance_pattern(const struct irradiance *irradiance);

#endif
