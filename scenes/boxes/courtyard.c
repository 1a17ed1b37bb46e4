/* A courtyard under a sky and nothing else: walls that leave a piece of it, a roof on posts along
 * one of them, and blocks in the open and below the roof. */
#include "scenes.h"
#include "shapes/placing.h"
#include "shapes/shapes.h"

static void add_pieces(struct glb *glb, const char *name, const float albedo[3],
                       const float (*boxes)[2][3], int count) {
    struct surface surface = {0};
    for (int i = 0; i < count; i++)
        add_box(&surface, boxes[i][0], boxes[i][1]);
    place_surface(glb, name, glb_add_material(glb, name, albedo, GLB_SINGLE_SIDED), &surface);
}

void make_courtyard(struct glb *glb) {
    static const float floor[][2][3] = {{{-4.3F, -.2F, -3.3F}, {4.3F, 0, 3.3F}}};
    static const float walls[][2][3] = {{{-4.3F, 0, -3.3F}, {4.3F, 4, -3}},
                                        {{-4.3F, 0, 3}, {4.3F, 4, 3.3F}},
                                        {{-4.3F, 0, -3}, {-4, 4, 3}},
                                        {{4, 0, -3}, {4.3F, 4, 3}}};
    static const float roof[][2][3] = {{{-4, 2.4F, -3}, {4, 2.6F, -1}},
                                       {{-3.9F, 0, -1.3F}, {-3.6F, 2.4F, -1}},
                                       {{-1.4F, 0, -1.3F}, {-1.1F, 2.4F, -1}},
                                       {{1.1F, 0, -1.3F}, {1.4F, 2.4F, -1}},
                                       {{3.6F, 0, -1.3F}, {3.9F, 2.4F, -1}}};
    static const float blocks[][2][3] = {{{-.6F, 0, .2F}, {.4F, 1, 1.1F}},
                                         {{1.7F, 0, -2.4F}, {2.5F, 1.5F, -1.7F}},
                                         {{2.2F, 0, .3F}, {2.9F, .5F, 1.5F}}};
    add_pieces(glb, "floor", (const float[]){.5F, .47F, .42F}, floor, 1);
    add_pieces(glb, "walls", (const float[]){.72F, .68F, .6F}, walls, 4);
    add_pieces(glb, "roof", (const float[]){.55F, .36F, .2F}, roof, 5);
    add_pieces(glb, "blocks", (const float[]){.65F, .2F, .12F}, blocks, 3);
    glb_add_camera(glb, (const float[]){-3.4F, 2.5F, 2.6F}, (const float[]){3.4F, -1.35F, -2.9F},
                   55, .1, 50);
    glb->extras = "\"environment\":\"day.hdr\"";
}
