/* A plant and a fence before a window: thin casters at many distances from what they shade, under a
 * light that is wide beside them. The window is an emissive surface. */
#include "scenes.h"

#include "atrium/furnishing.h"
#include "shapes/placing.h"
#include "shapes/shapes.h"

static void place_room(struct glb *glb, int white) {
    place_quad(glb, "floor", white,
               (const float[4][3]){{-2, 0, 2}, {3, 0, 2}, {3, 0, -2}, {-2, 0, -2}});
    place_quad(glb, "back wall", white,
               (const float[4][3]){{-2, 0, -2}, {3, 0, -2}, {3, 2.6F, -2}, {-2, 2.6F, -2}});
    place_quad(glb, "far wall", white,
               (const float[4][3]){{3, 0, -2}, {3, 0, 2}, {3, 2.6F, 2}, {3, 2.6F, -2}});
}

static void place_plant(struct glb *glb, int clay, int green) {
    static const struct plant tuft = {
        .leaves = 40, .segments = 8, .height = .9F, .spread = .6F, .leaf_width = .05F, .seed = 7};
    static const struct lathe_point pot[] = {{.radius = 0, .y = 0},
                                             {.radius = .13F, .y = 0},
                                             {.radius = .18F, .y = .3F},
                                             {.radius = 0, .y = .3F}};
    struct surface surface = {0}, leaves = {0};
    const float foot[3] = {.2F, 0, -.5F}, top[3] = {.2F, .28F, -.5F};
    struct surface piece = {0};
    add_lathe(&piece, pot, 4, 24, 0);
    add_copy(&surface, &piece, 0, foot);
    surface_free(&piece);
    place_surface(glb, "pot", clay, &surface);
    add_plant(&piece, &tuft);
    add_copy(&leaves, &piece, 0, top);
    surface_free(&piece);
    place_surface(glb, "leaves", green, &leaves);
}

/* Pickets of two centimetres, and two rails. */
static void place_fence(struct glb *glb, int wood) {
    enum { PICKETS = 12 };
    struct surface fence = {0};
    for (int i = 0; i < PICKETS; i++) {
        float z = .2F + .1F * (float)i;
        add_box(&fence, (const float[]){.49F, 0, z}, (const float[]){.51F, .9F, z + .02F});
    }
    add_box(&fence, (const float[]){.51F, .15F, .15F}, (const float[]){.53F, .19F, 1.4F});
    add_box(&fence, (const float[]){.51F, .7F, .15F}, (const float[]){.53F, .74F, 1.4F});
    place_surface(glb, "fence", wood, &fence);
}

void make_plant(struct glb *glb) {
    int white = glb_add_material(glb, "white", (const float[]){.75F, .74F, .72F}, GLB_SINGLE_SIDED);
    int clay = glb_add_material(glb, "clay", (const float[]){.6F, .3F, .2F}, GLB_SINGLE_SIDED);
    int wood = glb_add_material(glb, "wood", (const float[]){.55F, .45F, .35F}, GLB_SINGLE_SIDED);
    int green = glb_add_material(glb, "green", (const float[]){.2F, .4F, .12F}, GLB_DOUBLE_SIDED);
    int glow = glb_add_lamp(glb, "window", (const float[]){9, 10, 11});
    place_room(glb, white);
    place_quad(
        glb, "window", glow,
        (const float[4][3]){{-2, .8F, .6F}, {-2, .8F, -.6F}, {-2, 2.2F, -.6F}, {-2, 2.2F, .6F}});
    place_plant(glb, clay, green);
    place_fence(glb, wood);
    glb_add_camera(glb, (const float[]){-.3F, 1.9F, 4}, (const float[]){.9F, -1.2F, -4}, 42, .1,
                   50);
}
