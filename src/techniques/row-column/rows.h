/* Rows of the matrix of pixels x VPLs: the light of every VPL at some pixels of the picture. A
 * paraboloid map at the pixel gives the visibility of all VPLs [Hašan et al. 2007]. */
#ifndef TECHNIQUES_ROWS_H
#define TECHNIQUES_ROWS_H

#include "passes/gather/gather.h"
#include "passes/vpls.h"

struct rows_desc {
    int rows;         /* r, the most rows */
    int lights;       /* VPLs of all bounces */
    int clamp, later; /* GATHER_CLAMP_... of the first bounce; of later ones */
    bool has_later;
    struct visibility_desc visibility;
};

struct rows_pass {
    struct rows_desc desc;
    GLuint pick_program, program, later_program;
    struct buffer places;
    GLuint place_vertices;
    struct vpl_buffer pixels; /* count: r of the last picture; their spread is unused */
    struct texture matrix;    /* RGBA32F: VPLs x r */
    GLuint framebuffer;
    struct buffer lookup_params;
    float (*room)[2];
};

bool rows_pass_init(struct rows_pass *pass, const struct rows_desc *desc);
void rows_pass_free(struct rows_pass *pass);

/* Samples one random pixel in each cell of a grid, into pass->pixels. Timer "rows". */
void rows_pass_pick(struct rows_pass *pass, const struct frame *frame,
                    const struct gbuffer *gbuffer, uint32_t seed);

struct rows_inputs {
    const struct vpl_buffer *vpls;
    bool later;
    int first_light;                    /* first column of the VPLs */
    int first, count;                   /* range of rows whose maps exist */
    const struct buffer *gather_params; /* parameters from gather_pass_write_params */
    struct visibility_inputs visibility;
};

/* Fills the columns of `vpls` in some rows. Timer "rows". */
void rows_pass_render(const struct rows_pass *pass, const struct frame *frame,
                      const struct rows_inputs *inputs);

/* Reads the matrix row by row after drawing. It waits for the GPU. */
void rows_pass_read(const struct rows_pass *pass, float (*matrix)[4]);

#endif
