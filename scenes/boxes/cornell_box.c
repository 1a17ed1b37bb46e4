/* The Cornell box, after the measurements published by the Cornell University Program of Computer
 * Graphics ("The Cornell Box: Box Data").
 *
 * The data are in millimetres, x to the left and z away from the camera. A hundredth of that in
 * metres, x centred, y up and z towards the camera makes a box of the size of a room.
 *
 * [Dong 2009, Table 1] counts 18 faces. Here they are the five walls, the lamp (which is off: the
 * light is a spot, so that most of the picture is lit indirectly) and two blocks of six faces. */
#include "scenes.h"
#include "shapes/shapes.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stddef.h>

enum { WHITE, RED, GREEN, LAMP };

static const struct {
    const char *name;
    float albedo[3];
} materials[] = {
    [WHITE] = {"white", {0.725f, 0.71f, 0.68f}},
    [RED] = {"red", {0.63f, 0.065f, 0.05f}},
    [GREEN] = {"green", {0.14f, 0.45f, 0.091f}},
    [LAMP] = {"lamp", {0.78f, 0.78f, 0.78f}},
};

/* Corners as published. */
static const struct {
    const char *name;
    int material;
    float corners[4][3];
} walls[] = {
    {"floor",
     WHITE,
     {{552.8f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 559.2f}, {549.6f, 0.0f, 559.2f}}},
    {"ceiling",
     WHITE,
     {{556.0f, 548.8f, 0.0f},
      {556.0f, 548.8f, 559.2f},
      {0.0f, 548.8f, 559.2f},
      {0.0f, 548.8f, 0.0f}}},
    {"back wall",
     WHITE,
     {{549.6f, 0.0f, 559.2f},
      {0.0f, 0.0f, 559.2f},
      {0.0f, 548.8f, 559.2f},
      {556.0f, 548.8f, 559.2f}}},
    {"right wall",
     GREEN,
     {{0.0f, 0.0f, 559.2f}, {0.0f, 0.0f, 0.0f}, {0.0f, 548.8f, 0.0f}, {0.0f, 548.8f, 559.2f}}},
    {"left wall",
     RED,
     {{552.8f, 0.0f, 0.0f},
      {549.6f, 0.0f, 559.2f},
      {556.0f, 548.8f, 559.2f},
      {556.0f, 548.8f, 0.0f}}},
    /* Half a millimetre below the ceiling, which has no hole for it. */
    {"lamp",
     LAMP,
     {{343.0f, 548.3f, 227.0f},
      {343.0f, 548.3f, 332.0f},
      {213.0f, 548.3f, 332.0f},
      {213.0f, 548.3f, 227.0f}}},
};

static const struct {
    const char *name;
    float top[4][3];
} blocks[] = {
    {"short block",
     {{130.0f, 165.0f, 65.0f},
      {82.0f, 165.0f, 225.0f},
      {240.0f, 165.0f, 272.0f},
      {290.0f, 165.0f, 114.0f}}},
    {"tall block",
     {{423.0f, 330.0f, 247.0f},
      {265.0f, 330.0f, 296.0f},
      {314.0f, 330.0f, 456.0f},
      {472.0f, 330.0f, 406.0f}}},
};

/* From the published frame to ours. */
static void to_room(const float corners[4][3], float room[4][3]) {
    for (int i = 0; i < 4; i++) {
        room[i][0] = (278.0f - corners[i][0]) / 100.0f;
        room[i][1] = corners[i][1] / 100.0f;
        room[i][2] = (279.6f - corners[i][2]) / 100.0f;
    }
}

int add_cornell_room(struct glb *glb) {
    for (size_t i = 0; i < sizeof materials / sizeof materials[0]; i++)
        glb_add_material(glb, materials[i].name, materials[i].albedo, GLB_SINGLE_SIDED);
    for (size_t i = 0; i < sizeof walls / sizeof walls[0]; i++) {
        float corners[4][3];
        struct surface surface = {0};
        to_room(walls[i].corners, corners);
        add_quad(&surface, corners[0], corners[1], corners[2], corners[3]);
        glb_add_mesh(glb, walls[i].name, &surface, walls[i].material, NULL);
        surface_free(&surface);
    }
    /* As published: at (278, 273, -800), focal length 35 mm, film 25 mm wide and high. */
    const double fov = 2.0 * atan(0.025 / 2.0 / 0.035) * 180.0 / GLM_PI;
    glb_add_camera(glb, (const float[]){0.0f, 2.73f, 10.796f}, (const float[]){0.0f, 0.0f, -1.0f},
                   fov, 0.1, 50.0);
    return WHITE;
}

void add_cornell_blocks(struct glb *glb) {
    for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) {
        float top[4][3];
        struct surface surface = {0};
        to_room(blocks[i].top, top);
        add_block(&surface, top, 0.0f);
        glb_add_mesh(glb, blocks[i].name, &surface, WHITE, NULL);
        surface_free(&surface);
    }
}

/* A red spot at the tall block, a blue one at the right wall, and a lamp below the ceiling. */
void make_three_lights(struct glb *glb) {
    add_cornell_room(glb);
    add_cornell_blocks(glb);
    glb_add_light(glb, &(struct glb_light){.name = "red",
                                           .eye = {-2.2f, 4.6f, 2.2f},
                                           .direction = {0.45f, -0.75f, -0.85f},
                                           .color = {1.0f, 0.22f, 0.1f},
                                           .intensity = 120.0,
                                           .half_angle = 24.0});
    glb_add_light(glb, &(struct glb_light){.name = "blue",
                                           .eye = {0.6f, 2.8f, 2.4f},
                                           .direction = {0.75f, -0.2f, -0.6f},
                                           .color = {0.12f, 0.3f, 1.0f},
                                           .intensity = 160.0,
                                           .half_angle = 18.0});
    glb_add_light(glb, &(struct glb_light){.name = "lamp",
                                           .eye = {0.3f, 4.9f, -0.4f},
                                           .direction = {0.0f, 0.0f, -1.0f},
                                           .color = {1.0f, 0.9f, 0.75f},
                                           .intensity = 6.0});
}

void make_cornell_box(struct glb *glb) {
    add_cornell_room(glb);
    add_cornell_blocks(glb);
    glb_add_spot(glb, (const float[]){1.1f, 2.3f, 1.9f}, (const float[]){-0.778f, 0.592f, -0.209f},
                 29.0, 500.0);
}
