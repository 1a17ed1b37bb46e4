/* Closes holes between the points of imperfect shadow maps by pull-push [Ritschel et al. 2008;
 * Marroquim et al. 2007]. Coarser maps average the covered texels; finer maps take holes from
 * them. */
#ifndef TECHNIQUES_FILL_H
#define TECHNIQUES_FILL_H

#include "passes/maps.h"
#include "shared/splat.h"

struct frame;

struct fill_pass {
    GLuint pull_program, push_program, map_program;
    struct texture pulled[FILL_LEVELS],
        pushed[FILL_LEVELS]; /* R16, level l + 1; the last level is only pulled */
    GLuint pulled_framebuffers[FILL_LEVELS], pushed_framebuffers[FILL_LEVELS];
    struct depth_maps maps;
    struct buffer params;
};

/* Makes the pass for `count` maps of size x size texels. */
bool fill_pass_init(struct fill_pass *pass, int size, int count);
void fill_pass_free(struct fill_pass *pass);

/* Fills the first views->count maps of `holes` into pass->maps. radius: of a point, metres. Timer
 * "fill". */
void fill_pass_render(struct fill_pass *pass, const struct frame *frame,
                      const struct depth_maps *holes, const struct map_views *views, float radius);

#endif
