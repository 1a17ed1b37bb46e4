/* Light of further bounces: points of surfaces gather from VPLs and become VPLs themselves
 * [Keller 1997, Instant Radiosity].
 *
 * The first bounce is the VPLs' of the reflective shadow map. E at P points makes each a VPL of flux
 * albedo E A: the second bounce. From these the points gather again, and so on; what they gathered of
 * all bounces is what they reflect in the end, so that one gather of the picture serves all.
 *
 * Each point is picked from BOUNCE_CANDIDATES, spread by area over all surfaces that do not lie within solids
 * (scene/mesh/surface_points.h), by what they reflect of a few VPLs: much of a hall lies in the dark, and VPLs should
 * be where light is (glsl/lights/bounce_pick.vert). Candidates and the numbers that pick depend on no light and no
 * camera, so that a frame depends on its time alone.
 *
 * Metaballs are lit, but pass none of it on. Visibility is that of the VPLs' maps. Cost: P lookups for each VPL and
 * bounce, and a third of that to pick; and once rays for the candidates. Bias: what is nearer than points are apart
 * they light as patches (glsl/gather/patch.glsl); and what maps cannot resolve.
 */
#ifndef PASSES_BOUNCE_H
#define PASSES_BOUNCE_H

#include "passes/visibility/visibility.h"
#include "scene/mesh/surface_points.h"

/* VPLs by which points are picked: the first ones, which are an even subset. */
enum { BOUNCE_PICKING_VPLS = 32 };

struct bounce_desc {
    const struct scene *scene;
    const struct geometry *geometry; /* as it is posed now: candidates are dealt by its areas */
    int count;                       /* P */
    int seed;                        /* of the candidates */
    bool map_per_vpl;                /* as in struct gather_desc */
    struct visibility_desc visibility;
};

struct bounce_pass {
    struct bounce_desc desc;
    GLuint candidate_program, pick_program, gather_program, reflect_program;
    struct solids solids;             /* within which no candidate lies */
    struct surface_points candidates; /* those of a point after those of the one before */
    int dealt_pass;                   /* that they are those of */
    unsigned pose;                    /* that they were uploaded for; 0: none */
    struct vpl *room;                 /* for what is uploaded */
    struct vpl_buffer places, points; /* the candidates and the points: flux is the albedo */
    struct texture candidate_light;   /* P x BOUNCE_CANDIDATES, RGBA32F: irradiance */
    struct texture last, sum; /* P x BOUNCE_ROWS, RGBA32F: irradiance of the last bounce, of all */
    GLuint candidate_framebuffer, framebuffer;
    struct vpl_buffer vpls; /* what the points reflect; C(i) = 0 */
    struct buffer lookup_params;
};

bool bounce_pass_init(struct bounce_pass *pass, const struct bounce_desc *desc);
void bounce_pass_free(struct bounce_pass *pass);

struct bounce_inputs {
    const struct vpl_buffer *vpls;
    int first, count;                    /* of the VPLs; all of them where count is 0 */
    struct visibility_inputs visibility; /* unless VISIBILITY_LOOKUP_NONE */
};

/* Picks the points by the light of the inputs' first VPLs; they have no light then. */
void bounce_pass_pick(struct bounce_pass *pass, const struct frame *frame,
                      const struct bounce_inputs *inputs);

/* Begins the next bounce. */
void bounce_pass_begin(const struct bounce_pass *pass);

/* Adds the VPLs' light. */
void bounce_pass_gather(const struct bounce_pass *pass, const struct frame *frame,
                        const struct bounce_inputs *inputs);

/* Makes pass->vpls of what arrived in the last bounce, or in all. Timer "bounces", as of all. */
void bounce_pass_reflect(const struct bounce_pass *pass, const struct frame *frame, bool all);

#endif
