/* Where VPLs matter to the picture, or starts of paths of light: an importance map over the domain of each light, by which
 * they are placed [Georgiev and Slusallek 2010; Ritschel et al. 2011].
 *
 * Two rounds draw 4096 candidates each, the second round by the map of the first. The value of a candidate is the irradiance
 * that a VPL there gives to 64 pixels of the picture, with one ray for visibility (src/passes/lights/importance_candidate.frag).
 * Values add up in cells of the lights' domains. VPLs are Halton points warped by the map, a quarter of them as by flux alone,
 * and divide their flux by their density: their light is right on the mean, whatever the map holds. A map of later bounces
 * counts each candidate where its light walks to, and leaves half of the starts to flux alone.
 *
 * The map depends on the camera and on nothing drawn before. Cost: 8192 rays, half a million geometry terms.
 */
#ifndef PASSES_IMPORTANCE_MAP_H
#define PASSES_IMPORTANCE_MAP_H

#include "passes/targets.h"
#include "passes/vpls.h"
#include "scene/gpu/caster_pool.h"

struct frame;

struct importance_map_desc {
    struct caster_pool *casters; /* must outlive the pass */
    int lights;                  /* of the frame's layout, at least 1 */
    int vpls;                    /* N */
    bool sky_rays;               /* as VPLs */
    int bounces;                 /* more than 1: where light of the second bounce and on starts */
};

enum { IMPORTANCE_ROUNDS = 2 };

struct importance_map_pass {
    struct importance_map_desc desc;
    const struct caster_bvh *bvh;
    GLuint candidate_programs[IMPORTANCE_ROUNDS], add_programs[IMPORTANCE_ROUNDS];
    GLuint light_program, density_program;
    struct texture
        candidates; /* place, light and value of each, RGBA32F; a round below the other */
    struct importance_map map;
    GLuint candidate_framebuffer, value_framebuffer, light_framebuffer, density_framebuffer;
    struct buffer params;
};

/* Error: driver, memory, or more triangles than OpenGL has room for. */
bool importance_map_pass_init(struct importance_map_pass *pass,
                              const struct importance_map_desc *desc);
void importance_map_pass_free(struct importance_map_pass *pass);

/* Fills pass->map for frame->gbuffer. `rays` have a tree. `shares` has how many VPLs each light
 * takes by flux alone (passes/lights/vpl.h). Timer "importance map". */
void importance_map_pass_render(const struct importance_map_pass *pass, const struct frame *frame,
                                const struct gbuffer rsm[LIGHT_MAP_KINDS],
                                const struct light_rays *rays, const struct buffer *shares);

#endif
