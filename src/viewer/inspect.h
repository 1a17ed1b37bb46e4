/* The buffers of the frame, as pictures to step through. */
#ifndef VIEWER_INSPECT_H
#define VIEWER_INSPECT_H

#include "renderer/renderer.h"
#include "viewer/marks.h"

enum inspect_kind {
    SHOW_PICTURE,
    SHOW_NORMAL,
    SHOW_ALBEDO,
    SHOW_DEPTH,
    SHOW_RSM_NORMAL,
    SHOW_RSM_ALBEDO,
    SHOW_RSM_DEPTH,
    SHOW_VPLS,
    SHOW_CLUSTERS,
    SHOW_MAP_DEPTH,
    SHOW_BASIS_COS,
    SHOW_BASIS_SIN,
    SHOW_BASIS_Z_COS,
    SHOW_BASIS_Z_SIN,
    SHOW_VISIBILITY,
    SHOW_GATHERED,
    SHOW_BLURRED,
    SHOW_COUNT,
};

struct inspect_row {
    const char *name, *help;
};

extern const struct inspect_row inspect_rows[SHOW_COUNT];

struct inspect {
    GLuint program, visibility_program;
    struct visibility_desc visibility; /* what visibility_program is made for */
    struct buffer params, visibility_params;
    struct texture canvas;
    GLuint framebuffer;
    struct marks marks;
};

struct inspect_choice {
    enum inspect_kind kind;
    int layer;         /* of those that have several; -1 = a sheet of all */
    int chosen;        /* VAL that stands out; -1 = none */
    int width, height; /* room for a sheet, pixels */
    float scale;       /* of the monitor */
};

bool inspect_init(struct inspect *inspect);
void inspect_free(struct inspect *inspect);

/* How many layers there are; 0 where the technique has no such buffer. */
int inspect_layers(const struct renderer *renderer, enum inspect_kind kind);

/* Draws into inspect->canvas. Error: GPU memory, shader. */
bool inspect_draw(struct inspect *inspect, struct renderer *renderer,
                  const struct inspect_choice *choice);

/* Which layer of a sheet lies at a place of the canvas (0 to 1, y down); -1 = none. */
int inspect_sheet_layer(const struct renderer *renderer, const struct inspect_choice *choice,
                        float x, float y);

#endif
