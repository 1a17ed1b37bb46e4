/* Draws the outputs of a frame as pictures: maps and buffers as colours, lights as marks in the
 * scene. */
#ifndef INSPECT_INSPECT_H
#define INSPECT_INSPECT_H

#include "inspect/false_colours.h"
#include "inspect/lookup.h"
#include "inspect/marks.h"
#include "inspect/sheet.h"
#include "renderer/renderer.h"

struct inspect {
    GLuint program;
    struct lookup visibility;
    struct buffer params;
    struct texture no_plane, no_layers; /* for unused samplers */
    struct texture canvas;
    GLuint framebuffer;
    struct marks marks;
    struct heat_map light; /* of the canvas, if it shows light in false colours */
};

struct inspect_choice {
    const char *output; /* name; NULL: the picture itself */
    int layer;          /* layer of an output with several; -1: a sheet of all */
    int chosen;         /* highlighted VAL; -1: none */
    enum light_unit unit;
    float top;         /* end of the scale of light, in its unit; 0: fitted */
    int width, height; /* space for a sheet, pixels */
    float scale;       /* scale of the monitor */
};

bool inspect_init(struct inspect *inspect);
void inspect_free(struct inspect *inspect);

/* Returns the number of layers of an output; 0: no such output. */
int inspect_layers(const struct renderer *renderer, const char *output);

/* Return the name of the first output of a kind (NULL: none), or whether an output is of a kind. */
const char *inspect_find(const struct renderer *renderer, enum output_kind kind);
bool inspect_is(const struct renderer *renderer, const char *output, enum output_kind kind);

/* Draws an existing output into inspect->canvas. Error: GPU memory, shader. */
bool inspect_draw(struct inspect *inspect, struct renderer *renderer,
                  const struct inspect_choice *choice);

/* Returns the map that the canvas shows; NULL: no light in false colours. */
const struct heat_map *inspect_light(const struct inspect *inspect,
                                     const struct inspect_choice *choice);

/* Computes the layout of the layers in the canvas. Returns false if it shows one layer. */
bool inspect_sheet(const struct renderer *renderer, const struct inspect_choice *choice,
                   struct sheet *sheet);

/* Returns the layer of a sheet at a point of the canvas, in [0, 1]^2, y down; -1: none. */
int inspect_sheet_layer(const struct renderer *renderer, const struct inspect_choice *choice,
                        float x, float y);

#endif
