/* A dusty hall with windows along one side, lit from far outside: shafts of light through
 * a medium. */
#include "scenes.h"
#include "shapes/placing.h"
#include "shapes/shapes.h"

enum { WINDOWS = 4 };

static void add_pieces(struct glb *glb, const char *name, const float albedo[3],
                       const float (*boxes)[2][3], int count) {
    struct surface surface = {0};
    for (int i = 0; i < count; i++)
        add_box(&surface, boxes[i][0], boxes[i][1]);
    place_surface(glb, name, glb_add_material(glb, name, albedo, GLB_SINGLE_SIDED), &surface);
}

/* The wall at z = 3: a sill, a lintel, and piers between windows of one metre. */
static void add_windows(struct glb *glb) {
    const float first = -5.5F, width = 1, pier = 2;
    struct surface surface = {0};
    add_box(&surface, (const float[]){-6, 0, 3}, (const float[]){6, 2, 3.3F});
    add_box(&surface, (const float[]){-6, 5, 3}, (const float[]){6, 6, 3.3F});
    for (int i = 0; i <= WINDOWS; i++) {
        float from = i > 0 ? first + (float)i * (width + pier) - pier : -6;
        float to = i < WINDOWS ? first + (float)i * (width + pier) : 6;
        add_box(&surface, (const float[]){from, 2, 3}, (const float[]){to, 5, 3.3F});
    }
    place_surface(
        glb, "windows",
        glb_add_material(glb, "windows", (const float[]){.7F, .66F, .6F}, GLB_SINGLE_SIDED),
        &surface);
}

void make_hall(struct glb *glb) {
    static const float floor[][2][3] = {{{-6.3F, -.3F, -3.3F}, {6.3F, 0, 3.3F}}};
    static const float walls[][2][3] = {{{-6.3F, 0, -3.3F}, {6.3F, 6, -3}},
                                        {{-6.3F, 0, -3}, {-6, 6, 3.3F}},
                                        {{6, 0, -3}, {6.3F, 6, 3.3F}},
                                        {{-6.3F, 6, -3.3F}, {6.3F, 6.3F, 3.3F}}};
    static const float benches[][2][3] = {{{-3.5F, 0, -2}, {-2.9F, .5F, 1}},
                                          {{-1.5F, 0, -2}, {-.9F, .5F, 1}},
                                          {{.5F, 0, -2}, {1.1F, .5F, 1}},
                                          {{2.5F, 0, -2}, {3.1F, .5F, 1}},
                                          {{4.6F, 0, -.6F}, {5.4F, 1.3F, .6F}}};
    add_pieces(glb, "floor", (const float[]){.45F, .4F, .34F}, floor, 1);
    add_pieces(glb, "walls", (const float[]){.7F, .66F, .6F}, walls, 4);
    add_windows(glb);
    add_pieces(glb, "benches", (const float[]){.4F, .22F, .12F}, benches, 5);
    glb_add_camera(glb, (const float[]){-5.6F, 1.9F, -1.6F}, (const float[]){1, .03F, .28F}, 60, .1,
                   50);
    glb_add_spot(glb, (const float[]){11, 15, 17}, (const float[]){-.6F, -.72F, -.85F}, 24, 14000);
    glb->extras = "\"medium\":{\"sigma_s\":0.04,\"sigma_a\":0.002,\"g\":0.6}";
}
