/* Renders airlight with shadows: single scattering of a medium towards the camera, and
 * transmittance.
 *
 * For each pixel and light, steps along the ray look up the light's shadow map. The shadow volumes
 * of Wyman and Ramsey that [Dong 2011 §8.2] names are not used. Steps are equiangular, seen from
 * the light [Kulla and Fajardo 2012]. The pixels of an 8x8 pattern step at different distances, and
 * a depth-aware blur joins them. Cost: steps x lights x pixels. */
#ifndef PASSES_AIRLIGHT_H
#define PASSES_AIRLIGHT_H

#include "gl/buffer.h"
#include "gl/texture.h"
#include "shared/medium.h"

struct emitters;
struct frame;
struct gbuffer;

struct airlight_desc {
    int width, height;
    int steps;          /* steps of a light; its light samples share them, at least 8 each */
    bool slides, panes; /* lights may have slides; the scene has panes */
};

struct airlight_pass {
    struct airlight_desc desc;
    GLuint programs[AIRLIGHT_KINDS], blur_programs[2];
    struct texture steps, half_blurred; /* RGBA32F */
    struct texture in_scatter;          /* RGBA16F, radiance times irradiance_scale */
    struct texture transmittance;       /* RGBA16F */
    GLuint steps_framebuffer, half_framebuffer, framebuffer;
    struct buffer params, blur_params;
};

bool airlight_pass_init(struct airlight_pass *pass, const struct airlight_desc *desc);
void airlight_pass_free(struct airlight_pass *pass);

/* Error: out of GPU memory; the pass stays unchanged. */
bool airlight_pass_resize(struct airlight_pass *pass, int width, int height);

/* Fills in_scatter and transmittance for a frame with a medium. `maps` are the shadow maps of the
 * frame's lights. `whole` holds the lights that the groups are samples of. Timer "airlight". */
void airlight_pass_render(const struct airlight_pass *pass, const struct frame *frame,
                          const struct gbuffer *gbuffer, const struct texture maps[LIGHT_MAP_KINDS],
                          const struct emitters *whole);

#endif
