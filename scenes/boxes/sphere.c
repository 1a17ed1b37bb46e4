/* The inside of a diffuse sphere, whose light is known exactly.
 *
 * Radius R = 1, albedo 1/2, a point light of I = pi W/sr in the centre: the direct radiance is
 * albedo I / (pi R^2) = 0.5 everywhere, one bounce adds 0.25 and all bounces end at 1, because the
 * geometry term between any two points of a sphere is 1 / (4 R^2). */
#include "scenes.h"
#include "shapes/placing.h"
#include "shapes/shapes.h"

#include <cglm/cglm.h>

/* 12 n^2 = 20172 triangles: faces lie within 0.04 % of the sphere. */
enum { SQUARES_PER_SIDE = 41 };

void make_sphere(struct glb *glb) {
    int half = glb_add_material(glb, "half", (const float[]){0.5f, 0.5f, 0.5f}, GLB_SINGLE_SIDED);
    struct surface surface = {0};
    add_sphere_inside(&surface, SQUARES_PER_SIDE);
    place_surface(glb, "sphere", half, &surface);
    /* Off the centre, so that the picture sees the wall at many angles. */
    glb_add_camera(glb, (const float[]){0.2f, 0.1f, 0.6f}, (const float[]){-0.3f, -0.1f, -1.0f},
                   75.0, 0.01, 10.0);
    glb_add_light(glb, &(struct glb_light){.name = "point",
                                           .direction = {0.0f, 0.0f, -1.0f},
                                           .color = {1.0f, 1.0f, 1.0f},
                                           .intensity = GLM_PI});
}
