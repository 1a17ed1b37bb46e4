/* Rows of the matrix of pixels x VPLs: pixels spread over the picture, and what light each has of every VPL. A row is
 * seen the other way round: one paraboloid map at the pixel tells which VPLs arrive [Hašan et al. 2007]. */
#ifndef TECHNIQUES_ROWS_H
#define TECHNIQUES_ROWS_H

#include "passes/gather/gather.h"
#include "passes/vpls.h"

struct rows_desc {
    int rows;         /* r, at most */
    int lights;       /* VPLs of all bounces */
    int clamp, later; /* of those of the first bounce, and of others */
    bool has_later;
    struct visibility_desc visibility;
};

struct rows_pass {
    struct rows_desc desc;
    GLuint pick_program, program, later_program;
    struct buffer places;
    GLuint place_vertices;
    struct vpl_buffer pixels; /* count: r of the last picture; they have no spread of their own */
    struct texture matrix;    /* RGBA32F: VPLs x r */
    GLuint framebuffer;
    struct buffer lookup_params;
    float (*room)[2];
};

bool rows_pass_init(struct rows_pass *pass, const struct rows_desc *desc);
void rows_pass_free(struct rows_pass *pass);

/* Picks one pixel at random of each cell of a grid, into pass->pixels. Timer "rows". */
void rows_pass_pick(struct rows_pass *pass, const struct frame *frame,
                    const struct gbuffer *gbuffer, uint32_t seed);

struct rows_inputs {
    const struct vpl_buffer *vpls;
    bool later;
    int first_light;                    /* their first column */
    int first, count;                   /* rows whose maps are there */
    const struct buffer *gather_params; /* what gather_pass_write_params wrote */
    struct visibility_inputs visibility;
};

/* Fills some columns of some rows. Timer "rows". */
void rows_pass_render(const struct rows_pass *pass, const struct frame *frame,
                      const struct rows_inputs *inputs);

/* The matrix, row by row, when all has been drawn: waits for the GPU. */
void rows_pass_read(const struct rows_pass *pass, float (*matrix)[4]);

#endif
