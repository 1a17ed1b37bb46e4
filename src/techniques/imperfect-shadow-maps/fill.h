/* Closes holes between the points of imperfect shadow maps by pull and push [Ritschel et al. 2008; Marroquim
 * et al. 2007]: coarser maps are made of what is there, and finer ones take from them what is not. */
#ifndef TECHNIQUES_FILL_H
#define TECHNIQUES_FILL_H

#include "passes/maps.h"
#include "shared/splat.h"

struct frame;

struct fill_pass {
    GLuint pull_program, push_program, map_program;
    struct texture pulled[FILL_LEVELS],
        pushed[FILL_LEVELS]; /* R16, level l + 1; the last is pulled alone */
    GLuint pulled_framebuffers[FILL_LEVELS], pushed_framebuffers[FILL_LEVELS];
    struct depth_maps maps;
    struct buffer params;
};

/* For so many maps of that size. */
bool fill_pass_init(struct fill_pass *pass, int size, int count);
void fill_pass_free(struct fill_pass *pass);

/* From the first views->count maps with holes to pass->maps; points are of that radius, metres.
 * Timer "fill". */
void fill_pass_render(struct fill_pass *pass, const struct frame *frame,
                      const struct depth_maps *holes, const struct map_views *views, float radius);

#endif
