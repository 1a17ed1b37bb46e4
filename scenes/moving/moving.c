/* Scenes in which little moves, but all of the indirect light with it. */
#include "scenes.h"
#include "shapes/placing.h"
#include "shapes/shapes.h"

#include <cglm/cglm.h>

/* A spot in the Cornell box that walks from the left wall to the ceiling and back [Dong 2009,
 * Fig. 8]: ten seconds, on the ceiling at five. */
void make_moving_spot(struct glb *glb) {
    enum { KEYS = 41 };
    static const float eye[3] = {1.1f, 2.0f, 1.2f};
    float times[KEYS], turns[KEYS][4];
    for (int k = 0; k < KEYS; k++) {
        times[k] = 0.25f * (float)k;
        float up = 0.5f - 0.5f * cosf(2.0f * GLM_PIf * (float)k / (KEYS - 1));
        float angle = glm_rad(glm_lerp(2.0f, 84.0f, up));
        glb_direction((const float[]){-cosf(angle), sinf(angle), -0.25f * cosf(angle)}, turns[k]);
    }
    add_cornell_room(glb);
    add_cornell_blocks(glb);
    int spot = glb_add_spot(glb, eye, (const float[]){-1.0f, 0.0f, -0.25f}, 24.0, 500.0);
    glb_animate_rotation(glb, spot, KEYS, times, (const float(*)[4])turns);
}

/* --- the door --------------------------------------------------------------------------------- */

enum { WHITE, BLUE, RED };

/* Two rooms of 4 x 3 x 4 m with a wall between them at x = 0, all of boxes 0.2 m thick. */
static void add_rooms(struct glb *glb) {
    static const struct {
        const char *name;
        int material;
        float low[3], high[3];
    } boxes[] = {
        {"floor", WHITE, {-4.3f, -0.2f, -2.2f}, {4.3f, 0.0f, 2.2f}},
        {"ceiling", WHITE, {-4.3f, 3.0f, -2.2f}, {4.3f, 3.2f, 2.2f}},
        {"back wall", WHITE, {-4.3f, 0.0f, -2.2f}, {4.3f, 3.0f, -2.0f}},
        {"front wall", WHITE, {-4.3f, 0.0f, 2.0f}, {4.3f, 3.0f, 2.2f}},
        {"far wall of the lit room", RED, {-4.3f, 0.0f, -2.0f}, {-4.1f, 3.0f, 2.0f}},
        {"far wall of the dark room", WHITE, {4.1f, 0.0f, -2.0f}, {4.3f, 3.0f, 2.0f}},
        {"wall left of the door", WHITE, {-0.1f, 0.0f, -2.0f}, {0.1f, 3.0f, -0.6f}},
        {"wall right of the door", WHITE, {-0.1f, 0.0f, 0.6f}, {0.1f, 3.0f, 2.0f}},
        {"wall above the door", WHITE, {-0.1f, 2.2f, -0.6f}, {0.1f, 3.0f, 0.6f}},
    };
    for (size_t i = 0; i < sizeof boxes / sizeof boxes[0]; i++)
        place_box(glb, boxes[i].name, boxes[i].material, boxes[i].low, boxes[i].high);
}

/* A door between a lit and a dark room, shut at 0 s, wide open at 5 s and shut at 10 s. It lies
 * against the wall on the lit side and covers the opening with 5 cm to spare; the camera looks at
 * it from the dark. */
void make_door(struct glb *glb) {
    enum { KEYS = 41 };
    static const float hinge[3] = {-0.1f, 0.0f, 0.65f};
    float times[KEYS], turns[KEYS][4];
    glb_add_material(glb, "white", (const float[]){0.75f, 0.74f, 0.72f}, GLB_SINGLE_SIDED);
    glb_add_material(glb, "blue", (const float[]){0.15f, 0.25f, 0.55f}, GLB_SINGLE_SIDED);
    glb_add_material(glb, "red", (const float[]){0.65f, 0.15f, 0.10f}, GLB_SINGLE_SIDED);
    add_rooms(glb);
    struct surface surface = {0};
    add_box(&surface, (const float[]){-0.06f, 0.0f, -1.3f}, (const float[]){0.0f, 2.25f, 0.0f});
    int joint = glb_add_joint(glb, "hinge", -1, hinge);
    glb_hang(glb, glb_add_mesh(glb, "door", &surface, BLUE, NULL), joint);
    surface_free(&surface);
    for (int k = 0; k < KEYS; k++) {
        times[k] = 0.25f * (float)k;
        float open = 0.5f - 0.5f * cosf(2.0f * GLM_PIf * (float)k / (KEYS - 1));
        glm_quatv(turns[k], glm_rad(110.0f * open), (vec3){0.0f, 1.0f, 0.0f});
    }
    glb_animate_rotation(glb, joint, KEYS, times, (const float(*)[4])turns);
    glb_add_camera(glb, (const float[]){3.9f, 1.6f, 1.2f}, (const float[]){-1.0f, -0.08f, -0.32f},
                   60.0, 0.05, 50.0);
    glb_add_spot(glb, (const float[]){-0.6f, 2.6f, -1.6f}, (const float[]){-0.8f, -0.65f, 0.45f},
                 35.0, 120.0);
}
