/* Draws points and lines over the picture of a scene: VPLs, and VALs with their rectangles and
 * normals. */
#ifndef INSPECT_MARKS_H
#define INSPECT_MARKS_H

#include "techniques/output.h"

struct frame;
struct gbuffer;

struct marks {
    GLuint point_program, val_program;
    struct buffer params;
};

struct marks_desc {
    GLuint framebuffer; /* framebuffer of the picture's size */
    int width, height;
    float scale;                   /* scale of the monitor */
    const struct vpl_buffer *vpls; /* NULL: none */
    const struct val_output *vals;
    bool by_cluster; /* true: VPLs in the colour of their VAL; false: of their light */
    int chosen;      /* highlighted VAL; -1: none */
    bool only_chosen;
    float usual_flux; /* flux of a usual VPL, W */
};

bool marks_init(struct marks *marks);
void marks_free(struct marks *marks);

void marks_draw(const struct marks *marks, const struct frame *frame, const struct gbuffer *gbuffer,
                const struct marks_desc *desc);

/* Computes the colour of VAL k, as src/inspect/mark.glsl does. */
void marks_cluster_color(int k, unsigned char rgb[3]);

#endif
