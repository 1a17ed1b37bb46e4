/* A table under a rectangular lamp: the penumbra of its top, of its legs where they stand, and of
 * what lies and stands on it. The lamp is an emissive surface, as Blender writes one. */
#include "scenes.h"
#include "shapes/placing.h"
#include "shapes/shapes.h"

static void place_table(struct glb *glb, int wood) {
    place_box(glb, "top", wood, (const float[]){-.8F, .72F, -.45F},
              (const float[]){.8F, .76F, .45F});
    for (int leg = 0; leg < 4; leg++) {
        float x = leg % 2 ? .68F : -.74F, z = leg / 2 ? .33F : -.39F;
        place_box(glb, "leg", wood, (const float[]){x, 0, z},
                  (const float[]){x + .06F, .72F, z + .06F});
    }
}

void make_table(struct glb *glb) {
    int white = glb_add_material(glb, "white", (const float[]){.75F, .74F, .72F}, GLB_SINGLE_SIDED);
    int wood = glb_add_material(glb, "wood", (const float[]){.55F, .36F, .2F}, GLB_SINGLE_SIDED);
    int red = glb_add_material(glb, "red", (const float[]){.65F, .15F, .1F}, GLB_SINGLE_SIDED);
    int glow = glb_add_lamp(glb, "lamp", (const float[]){20, 19, 17});
    place_quad(glb, "floor", white,
               (const float[4][3]){{-3, 0, 3}, {3, 0, 3}, {3, 0, -2}, {-3, 0, -2}});
    place_quad(glb, "wall", white,
               (const float[4][3]){{-3, 0, -2}, {3, 0, -2}, {3, 3, -2}, {-3, 3, -2}});
    place_quad(glb, "lamp", glow,
               (const float[4][3]){
                   {-.4F, 2.2F, -.2F}, {.4F, 2.2F, -.2F}, {.4F, 2.2F, .2F}, {-.4F, 2.2F, .2F}});
    place_table(glb, wood);
    struct surface ball = {0};
    add_ball(&ball, (const float[]){.35F, .91F, .05F}, .15F, 16);
    place_surface(glb, "ball", red, &ball);
    place_box(glb, "book", white, (const float[]){-.5F, .76F, -.2F},
              (const float[]){-.2F, .8F, .2F});
    glb_add_camera(glb, (const float[]){1.7F, 1.9F, 2.9F}, (const float[]){-1.7F, -1.35F, -3}, 40,
                   .1, 50);
}
