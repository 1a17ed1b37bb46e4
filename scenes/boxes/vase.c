/* A vase on a table, turned from a curved profile: dark inside, lit outside, with one wall between
 * [Mavridis and Papaioannou 2011, fig. 7]. */
#include "scenes.h"
#include "shapes/placing.h"
#include "shapes/shapes.h"

#include <cglm/cglm.h>

#include <math.h>

/* Of the profile from the middle of the foot up the outside, over the rim and down to the bottom
 * inside: radius and height, metres. */
static const float profile[][2] = {
    {0, .76F},     {.12F, .76F},  {.13F, .78F},  {.1F, .82F},   {.17F, .92F},   {.22F, 1.04F},
    {.2F, 1.16F},  {.13F, 1.27F}, {.12F, 1.33F}, {.18F, 1.42F}, {.165F, 1.42F}, {.1F, 1.33F},
    {.11F, 1.27F}, {.18F, 1.16F}, {.2F, 1.04F},  {.15F, .92F},  {.08F, .85F},   {0, .84F},
};

enum { LAST = sizeof profile / sizeof *profile - 1, SIDES = 48, STEPS = 4 };

/* Of the holes in the bottom and the foot, metres: triangles that end in a point have no normals
 * there. */
static const float pole = .001F;

/* Along a Catmull-Rom spline through the profile. */
static float spline(int axis, float at) {
    int k = (int)fminf(at, LAST - 1);
    float t = at - (float)k, a = profile[k > 0 ? k - 1 : 0][axis], b = profile[k][axis],
          c = profile[k + 1][axis], d = profile[k + 2 > LAST ? LAST : k + 2][axis];
    return b + .5F * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

static void turned(const void *context, float u, float v, float point[3]) {
    float turn = 2 * (float)GLM_PI * v, radius = fmaxf(spline(0, u * LAST), pole);
    (void)context;
    point[0] = radius * cosf(turn);
    point[1] = spline(1, u * LAST);
    point[2] = -radius * sinf(turn);
}

void make_vase(struct glb *glb) {
    int white = glb_add_material(glb, "white", (const float[]){.75F, .74F, .72F}, GLB_SINGLE_SIDED);
    int wood = glb_add_material(glb, "wood", (const float[]){.55F, .36F, .2F}, GLB_SINGLE_SIDED);
    int clay = glb_add_material(glb, "clay", (const float[]){.65F, .45F, .3F}, GLB_SINGLE_SIDED);
    struct surface vase = {0};
    place_quad(glb, "floor", white,
               (const float[4][3]){{-2, 0, 2}, {2, 0, 2}, {2, 0, -1}, {-2, 0, -1}});
    place_quad(glb, "wall", white,
               (const float[4][3]){{-2, 0, -1}, {2, 0, -1}, {2, 2, -1}, {-2, 2, -1}});
    place_box(glb, "table", wood, (const float[]){-.5F, .72F, -.4F},
              (const float[]){.5F, .76F, .4F});
    place_box(glb, "foot", wood, (const float[]){-.1F, 0, -.1F}, (const float[]){.1F, .72F, .1F});
    add_sheet(&vase, &(struct sheet){.place = turned, .nu = STEPS * LAST, .nv = SIDES});
    place_surface(glb, "vase", clay, &vase);
    glb_add_camera(glb, (const float[]){.5F, 2.1F, 1.6F}, (const float[]){-.5F, -1.1F, -1.6F}, 36,
                   .05, 20);
    glb_add_spot(glb, (const float[]){1.2F, 2.6F, 1.4F}, (const float[]){-1.2F, -1.5F, -1.5F}, 35,
                 20);
}
