/* The outputs of a frame as pictures: maps and buffers as colours, lights as marks in the scene. */
#ifndef INSPECT_INSPECT_H
#define INSPECT_INSPECT_H

#include "inspect/lookup.h"
#include "inspect/marks.h"
#include "inspect/sheet.h"
#include "renderer/renderer.h"

struct inspect {
    GLuint program;
    struct lookup visibility;
    struct buffer params;
    struct texture no_plane, no_layers; /* a sampler that nothing is read by has one of them */
    struct texture canvas;
    GLuint framebuffer;
    struct marks marks;
};

struct inspect_choice {
    const char *output; /* its name; NULL = none, the picture itself */
    int layer;          /* of those that have several; -1 = a sheet of all */
    int chosen;         /* VAL that stands out; -1 = none */
    int width, height;  /* room for a sheet, pixels */
    float scale;        /* of the monitor */
};

bool inspect_init(struct inspect *inspect);
void inspect_free(struct inspect *inspect);

/* How many layers an output has; 0 where there is no such output. */
int inspect_layers(const struct renderer *renderer, const char *output);

/* The name of the first output of a kind, NULL where there is none; and whether one is of a kind. */
const char *inspect_find(const struct renderer *renderer, enum output_kind kind);
bool inspect_is(const struct renderer *renderer, const char *output, enum output_kind kind);

/* Draws an output that there is into inspect->canvas. Error: GPU memory, shader. */
bool inspect_draw(struct inspect *inspect, struct renderer *renderer,
                  const struct inspect_choice *choice);

/* How the layers lie in the canvas; false where it shows one alone. */
bool inspect_sheet(const struct renderer *renderer, const struct inspect_choice *choice,
                   struct sheet *sheet);

/* Which layer of a sheet lies at a place of the canvas (0 to 1, y down); -1 = none. */
int inspect_sheet_layer(const struct renderer *renderer, const struct inspect_choice *choice,
                        float x, float y);

#endif
