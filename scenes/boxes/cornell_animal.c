/* A horse in the Cornell box, 17000 faces of its own [Dong 2009, Table 1]. */
#include "boxes/horse.h"
#include "scenes.h"
#include "shapes/decimate.h"
#include "shapes/shapes.h"

#include "base/memory.h"

#include <cglm/cglm.h>
#include <stdlib.h>

/* Larger than life, as the room is; turned so that its head comes towards the camera. A sole
 * reaches a hair below the floor. */
static void place(struct surface *surface) {
    const float scale = 1.62f, turn = glm_rad(28.0f), c = cosf(turn), s = sinf(turn);
    for (uint32_t i = 0; i < surface->vertex_count; i++) {
        float *p = surface->position[i], *n = surface->normal[i];
        glm_vec3_copy((vec3){scale * (c * p[0] - s * p[2]) - 0.55f, fmaxf(scale * p[1], 0.0f),
                             scale * (s * p[0] + c * p[2]) - 0.95f},
                      p);
        glm_vec3_copy((vec3){c * n[0] - s * n[2], n[1], s * n[0] + c * n[2]}, n);
    }
}

void make_cornell_animal(struct glb *glb) {
    struct soft_body *horse = mem_alloc(1, sizeof *horse);
    struct marching_cubes cubes;
    struct surface surface = {0};
    add_cornell_room(glb);
    int coat =
        glb_add_material(glb, "horse", (const float[]){0.75f, 0.72f, 0.66f}, GLB_SINGLE_SIDED);
    shape_horse(horse);
    struct implicit implicit = soft_implicit(horse);
    struct marching_grid grid = soft_grid(horse, 0.010f);
    marching_cubes_init(&cubes);
    marching_cubes_polygonise(&cubes, &implicit, &grid, &surface);
    decimate(&surface, 17000);
    smooth_normals(&surface, 0);
    place(&surface);
    glb_add_mesh(glb, "horse", &surface, coat, NULL);
    glb_add_spot(glb, (const float[]){-0.9f, 2.4f, 2.3f}, (const float[]){0.781f, 0.556f, -0.284f},
                 29.0, 500.0);
    surface_free(&surface);
    marching_cubes_free(&cubes);
    free(horse);
}
