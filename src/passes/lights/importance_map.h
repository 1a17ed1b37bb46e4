/* Places VPLs or path starts by an importance map over each light's domain [Georgiev and Slusallek
 * 2010; Ritschel et al. 2011].
 *
 * Two rounds draw 4096 candidates each, the second by the map of the first. The value of a
 * candidate is the irradiance that its VPL gives to 64 pixels, with one visibility ray
 * (importance_candidate.frag). Values are summed in cells of the lights' domains. VPLs are Halton
 * points warped by the map; a quarter is placed by flux alone. Each divides its flux by its
 * density, so its light is unbiased. A map of later bounces counts a candidate where its path ends
 * and leaves half of the starts to flux.
 *
 * The map depends on the camera and on nothing drawn before. Cost: 8192 rays, 0.5 M geometry
 * terms. */
#ifndef PASSES_IMPORTANCE_MAP_H
#define PASSES_IMPORTANCE_MAP_H

#include "passes/targets.h"
#include "passes/vpls.h"
#include "scene/gpu/caster_pool.h"

struct frame;

struct importance_map_desc {
    struct caster_pool *casters; /* must outlive the pass */
    int lights;                  /* lights of the frame's layout, at least 1 */
    int vpls;                    /* N */
    bool sky_rays;               /* VPLs of the environment come from rays */
    bool sampled;                /* some lights are sampled */
    int bounces;                 /* above 1: the map is for the second and later bounces */
};

enum { IMPORTANCE_ROUNDS = 2 };

struct importance_map_pass {
    struct importance_map_desc desc;
    const struct caster_bvh *bvh;
    GLuint candidate_programs[IMPORTANCE_ROUNDS], add_programs[IMPORTANCE_ROUNDS];
    GLuint light_program, density_program;
    /* RGBA32F: position, light and value of each candidate; one round below the other. */
    struct texture candidates;
    struct importance_map map;
    GLuint candidate_framebuffer, value_framebuffer, light_framebuffer, density_framebuffer;
    struct buffer params;
};

/* Error: driver, memory, or more triangles than OpenGL allows. */
bool importance_map_pass_init(struct importance_map_pass *pass,
                              const struct importance_map_desc *desc);
void importance_map_pass_free(struct importance_map_pass *pass);

/* Fills pass->map for frame->gbuffer. `rays` needs a tree. `shares` holds the VPLs of each light by
 * flux alone (passes/lights/vpl.h). Timer "importance map". */
void importance_map_pass_render(const struct importance_map_pass *pass, const struct frame *frame,
                                const struct gbuffer rsm[LIGHT_MAP_KINDS],
                                const struct light_rays *rays, const struct buffer *shares);

#endif
