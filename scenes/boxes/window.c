/* A dusty room with a window of coloured panes in lead, lit by a spot outside: all light passes
 * glass. */
#include "scenes.h"
#include "shapes/placing.h"
#include "shapes/shapes.h"

#include <stdlib.h>

enum { COLUMNS = 4, ROWS = 5, COLOURS = 5 };

static const float pane = .6F, lead = .05F, left = -1.2F, sill = 1, glass = 3.1F;

static const float colours[COLOURS][3] = {
    {.9F, .12F, .08F}, {.1F, .25F, .9F}, {.95F, .75F, .12F}, {.12F, .7F, .25F}, {.85F, .85F, .8F}};

static void add_pieces(struct glb *glb, const char *name, const float albedo[3],
                       const float (*boxes)[2][3], int count) {
    struct surface surface = {0};
    for (int i = 0; i < count; i++)
        add_box(&surface, boxes[i][0], boxes[i][1]);
    place_surface(glb, name, glb_add_material(glb, name, albedo, GLB_SINGLE_SIDED), &surface);
}

/* Without a volume a pane is thin: light goes straight on. */
static int add_thin_glass(struct glb *glb, const char *name, const float color[3]) {
    struct text json = {0};
    text_print(&json,
               "\"name\":\"%s\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[%.9g,%.9g,%.9g,1],"
               "\"metallicFactor\":0,\"roughnessFactor\":0},\"extensions\":"
               "{\"KHR_materials_transmission\":{\"transmissionFactor\":1}}",
               name, color[0], color[1], color[2]);
    int index = glb_add_material_json(glb, json.data);
    free(json.data);
    glb->has_glass = true;
    return index;
}

static void add_panes(struct glb *glb) {
    static const char *const names[] = {"red", "blue", "yellow", "green", "white"};
    struct surface panes[COLOURS] = {0};
    for (int i = 0; i < COLUMNS * ROWS; i++) {
        float x = left + pane * (float)(i % COLUMNS), y = sill + pane * (float)(i / COLUMNS);
        /* Steps of 2 in a row and 3 between rows: no two neighbours are alike. */
        int colour = (2 * (i % COLUMNS) + 3 * (i / COLUMNS)) % COLOURS;
        add_quad(&panes[colour], (float[]){x, y, glass}, (float[]){x + pane, y, glass},
                 (float[]){x + pane, y + pane, glass}, (float[]){x, y + pane, glass});
    }
    for (int c = 0; c < COLOURS; c++)
        place_surface(glb, names[c], add_thin_glass(glb, names[c], colours[c]), &panes[c]);
}

static void add_lead(struct glb *glb) {
    const float right = left + COLUMNS * pane, top = sill + ROWS * pane, half = lead / 2;
    struct surface surface = {0};
    for (int i = 1; i < COLUMNS; i++) {
        float x = left + pane * (float)i;
        add_box(&surface, (float[]){x - half, sill, glass - half},
                (float[]){x + half, top, glass + half});
    }
    for (int i = 1; i < ROWS; i++) {
        float y = sill + pane * (float)i;
        add_box(&surface, (float[]){left, y - half, glass - half},
                (float[]){right, y + half, glass + half});
    }
    place_surface(glb, "lead",
                  glb_add_material(glb, "lead", (float[]){.1F, .1F, .1F}, GLB_SINGLE_SIDED),
                  &surface);
}

void make_window(struct glb *glb) {
    static const float walls[][2][3] = {
        {{-3.2F, 0, -4.2F}, {3.2F, 5, -4}}, {{-3.2F, 0, -4}, {-3, 5, 3}},
        {{3, 0, -4}, {3.2F, 5, 3}},         {{-3.2F, 5, -4.2F}, {3.2F, 5.2F, 3.2F}},
        {{-3.2F, 0, 3}, {-1.2F, 5, 3.2F}},  {{1.2F, 0, 3}, {3.2F, 5, 3.2F}},
        {{-1.2F, 0, 3}, {1.2F, 1, 3.2F}},   {{-1.2F, 4, 3}, {1.2F, 5, 3.2F}}};
    static const float floor[][2][3] = {{{-3.2F, -.2F, -4.2F}, {3.2F, 0, 3.2F}}};
    static const float blocks[][2][3] = {{{-1.9F, 0, -1.2F}, {-1.1F, .9F, -.4F}},
                                         {{.6F, 0, .2F}, {1.2F, 1.5F, .8F}}};
    add_pieces(glb, "floor", (const float[]){.55F, .53F, .5F}, floor, 1);
    add_pieces(glb, "walls", (const float[]){.7F, .68F, .64F}, walls, 8);
    add_pieces(glb, "blocks", (const float[]){.6F, .6F, .6F}, blocks, 2);
    add_lead(glb);
    add_panes(glb);
    glb_add_camera(glb, (const float[]){2.7F, 2.3F, -3.7F}, (const float[]){-.5F, -.17F, 1}, 62, .1,
                   50);
    glb_add_spot(glb, (const float[]){4, 8.5F, 11}, (const float[]){-.42F, -.64F, -.83F}, 16, 6000);
    glb->extras = "\"medium\":{\"sigma_s\":0.05,\"sigma_a\":0.002,\"g\":0.4}";
}
