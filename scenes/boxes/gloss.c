/* A room with balls of metal and of plastic, from smooth on the left to rough on the right, under a
 * lamp; and thin rails, whose glints flicker where a method samples them too seldom. */
#include "scenes.h"
#include "shapes/placing.h"
#include "shapes/shapes.h"

#include <cglm/cglm.h>

enum { ROUGHNESSES = 4 };

static const float roughnesses[ROUGHNESSES] = {.1F, .3F, .6F, 1};

static void place_ball(struct glb *glb, const char *name, int material, const float center[3]) {
    struct surface ball = {0};
    add_ball(&ball, center, .34F, 24);
    place_surface(glb, name, material, &ball);
}

/* From wall to wall. */
static void place_rail(struct glb *glb, int material, float height) {
    static const struct lathe_point profile[] = {
        {0, -1.9F, 0}, {.012F, -1.9F, 0}, {.012F, 1.9F, 0}, {0, 1.9F, 0}};
    struct surface rail = {0};
    add_lathe(&rail, profile, 4, 12, 0);
    for (uint32_t i = 0; i < rail.vertex_count; i++) {
        float *p = rail.position[i], *n = rail.normal[i];
        glm_vec3_copy((vec3){p[1], height - p[0], p[2] - 1.7F}, p);
        glm_vec3_copy((vec3){n[1], -n[0], n[2]}, n);
    }
    place_surface(glb, "rail", material, &rail);
}

static void place_room(struct glb *glb) {
    int white = glb_add_material(glb, "white", (const float[]){.72F, .71F, .68F}, GLB_SINGLE_SIDED);
    int red = glb_add_material(glb, "red", (const float[]){.6F, .1F, .08F}, GLB_SINGLE_SIDED);
    int blue = glb_add_material(glb, "blue", (const float[]){.12F, .2F, .5F}, GLB_SINGLE_SIDED);
    const struct {
        const char *name;
        int material;
        float corners[4][3];
    } walls[] = {
        {"floor", white, {{-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2}}},
        {"ceiling", white, {{-2, 2.6F, -2}, {2, 2.6F, -2}, {2, 2.6F, 2}, {-2, 2.6F, 2}}},
        {"back wall", white, {{-2, 0, -2}, {2, 0, -2}, {2, 2.6F, -2}, {-2, 2.6F, -2}}},
        {"left wall", red, {{-2, 0, 2}, {-2, 0, -2}, {-2, 2.6F, -2}, {-2, 2.6F, 2}}},
        {"right wall", blue, {{2, 0, -2}, {2, 0, 2}, {2, 2.6F, 2}, {2, 2.6F, -2}}},
    };
    for (size_t i = 0; i < sizeof walls / sizeof walls[0]; i++)
        place_quad(glb, walls[i].name, walls[i].material, walls[i].corners);
}

void make_gloss(struct glb *glb) {
    static const float gold[3] = {1, .77F, .34F}, green[3] = {.1F, .35F, .16F},
                       steel[3] = {.56F, .57F, .58F};
    place_room(glb);
    for (int i = 0; i < ROUGHNESSES; i++) {
        float x = -1.29F + .86F * (float)i;
        int metal = glb_add_specular(glb, "metal", gold, 1, roughnesses[i]);
        int plastic = glb_add_specular(glb, "plastic", green, 0, roughnesses[i]);
        place_ball(glb, "metal ball", metal, (const float[]){x, 1.06F, -.9F});
        place_ball(glb, "plastic ball", plastic, (const float[]){x, .34F, .3F});
    }
    place_box(glb, "shelf",
              glb_add_material(glb, "wood", (const float[]){.5F, .33F, .2F}, GLB_SINGLE_SIDED),
              (const float[]){-1.8F, .66F, -1.3F}, (const float[]){1.8F, .72F, -.5F});
    int rail = glb_add_specular(glb, "steel", steel, 1, .2F);
    for (int i = 0; i < 3; i++)
        place_rail(glb, rail, 1.75F + .16F * (float)i);
    place_quad(glb, "lamp", glb_add_lamp(glb, "lamp", (const float[]){14, 13, 11}),
               (const float[4][3]){
                   {-.6F, 2.5F, -.1F}, {.6F, 2.5F, -.1F}, {.6F, 2.5F, .7F}, {-.6F, 2.5F, .7F}});
    glb_add_camera(glb, (const float[]){0, 1.35F, 6.3F}, (const float[]){0, -.03F, -1}, 33, .1, 50);
}
