/* Points and lines over the picture of a scene: VPLs, and VALs with their rectangles and normals.
 */
#ifndef VIEWER_MARKS_H
#define VIEWER_MARKS_H

#include "passes/frame.h"
#include "techniques/technique.h"

struct marks {
    GLuint point_program, val_program;
    struct buffer params;
};

struct marks_desc {
    GLuint framebuffer; /* of the picture's size */
    int width, height;
    float scale;     /* of the monitor */
    bool by_cluster; /* VPLs in their VAL's colour, else in that of their light */
    bool with_vpls, with_vals;
    int chosen; /* VAL that stands out; -1 = none */
    bool only_chosen;
    float usual_flux; /* W of a usual VPL */
};

bool marks_init(struct marks *marks);
void marks_free(struct marks *marks);

void marks_draw(const struct marks *marks, const struct frame *frame, const struct gbuffer *gbuffer,
                const struct technique_outputs *outputs, const struct marks_desc *desc);

/* The colour of VAL k: glsl/viewer/mark.glsl's. */
uint32_t marks_cluster_color(int k);

#endif
