/* Targets of a frame: surfaces, irradiance, and a technique's contribution. Row 0 is the bottom
 * row, as in OpenGL. */
#ifndef PASSES_TARGETS_H
#define PASSES_TARGETS_H

#include "gl/pass.h"
#include "gl/texture.h"
#include "shared/gather.h"
#include "shared/light.h"

#include <string.h>

/* Surfaces seen from the camera (one layer) or from the lights. The lights' G-buffer is the
 * reflective shadow map of one LIGHT_MAP_KIND: one layer a view, no textures without views.
 *   normal   RG16     world normal, octahedral
 *   albedo   RGBA16   square root of the albedo; A = 1 on surfaces. RGBA16F with facets:
 *                     albedo x cosine at the shading normal / cosine at the triangle's normal,
 *                     which `normal` then is
 *   depth    D32F     reversed (shared/view.h); 0: no surface
 *   emission RGBA16F  radiance times irradiance_scale; camera only, if a material is emissive or
 *                     not plain (scene/material.h)
 *   specular RGBA16   specular reflectance (lib/brdf.glsl), if a material is not plain: for the
 *                     camera, and for lights if rays read it. Then normal is the bent one, and
 *                     albedo the diffuse part's. Lights' views add the specular part as diffuse.
 */
struct gbuffer {
    struct texture normal, albedo, depth, emission, specular;
    GLuint framebuffer;
    int width, height, layers;
};

/* Irradiance times irradiance_scale, in tiles of equal place in the n x n pattern; in picture order
 * with interleave 1. RGBA32F if many draws add up, because half floats lose digits. RGBA16F if one
 * draw writes. */
struct irradiance {
    struct texture texture;
    GLuint framebuffer;
    int width, height; /* of the picture */
    int interleave, tile_width, tile_height;
};

/* Contribution of a technique; each member is NULL without one. Composite adds the others:
 *
 *     L = transmittance (albedo (direct + caustic + irradiance / pi) + radiance)
 *         + in_scatter + volume_caustic
 *
 * Light of surfaces is irradiance, without the albedo, or radiance towards the camera. Light before
 * the surfaces is in_scatter, with the transmittance of the surfaces' light. Textures have the
 * picture's size; radiance and in_scatter are times irradiance_scale. */
struct contribution {
    const struct irradiance *irradiance;
    /* Irradiance of edge samples, and the list texel of each pixel's sample
     * (lib/tiles.glsl). Both or none. */
    const struct irradiance *edge_sample_irradiance;
    const struct texture *edge_sample_texels;
    const struct texture *radiance;
    const struct texture
        *direct_specular; /* RGBA32F, unscaled: replaces that of the direct method */
    const struct texture *in_scatter,
        *transmittance; /* both or none; a scene's medium replaces them */
    /* Set by the renderer, RGBA32F, unscaled: radiance of a white surface; radiance. If A of
     * `caustic` is not 0, the pixel shows glass or a mirror, and RGB is its radiance
     * (passes/caustics/glass.h). */
    const struct texture *caustic, *volume_caustic;
};

/* Background of a display, behind all surfaces. */
struct background {
    int kind;        /* BACKGROUND_..., shared/composite.h */
    float colour[3]; /* display values from 0 to 1 */
};

struct gbuffer_desc {
    const char *label;
    int width, height, layers;
    bool has_emission, has_specular;
    bool facets; /* as in struct geometry_desc */
};

bool gbuffer_init(struct gbuffer *gbuffer, const struct gbuffer_desc *desc);
void gbuffer_free(struct gbuffer *gbuffer);

/* Binds the textures of lib/rsm.glsl, with the specular one if the maps have a specular target. The
 * maps of one kind stand in for a missing kind, which is not read, because drivers warn
 * of empty units. */
void rsm_add(struct pass_state *state, const struct gbuffer rsm[LIGHT_MAP_KINDS]);

bool irradiance_init(struct irradiance *irradiance, const char *label, GLenum format, int width,
                     int height, int interleave);
void irradiance_free(struct irradiance *irradiance);

/* Changes the picture's size. Error: out of GPU memory; the target stays unchanged. */
bool irradiance_resize(struct irradiance *irradiance, int width, int height);

/* Defines TYPE_resize, which recreates a pass's members from `first` to `last` for another picture
 * size by the file's init_targets and free_targets. Without memory the pass stays unchanged. */
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

/* Sets the viewport to the tile of a slot of the pattern, between two draws of a pass. */
void irradiance_view_tile(const struct irradiance *irradiance, int slot);

/* Returns the pattern's parameters for shaders. */
struct interleaving irradiance_pattern(const struct irradiance *irradiance);

#endif
