/* Metaballs in the Cornell box, about 5000 faces [Dong 2009, Table 1].
 *
 * The file holds their surface at time 0. The node's extras say how to make it at any other time:
 * they are the fields of struct metaballs. */
#include "scenes.h"

#include "scene/shapes/marching_cubes.h"
#include "scene/shapes/metaballs.h"

#include <stdio.h>

static const struct metaballs balls = {
    .count = 14,
    .low = {-2.3f, 0.25f, -2.3f},
    .high = {2.3f, 3.45f, 1.3f},
    .reach = 0.9f,
    .cell = 0.14f,
    .period = 20.0f,
};

static void print_extras(char *text, size_t size) {
    snprintf(text, size,
             "{\"metaballs\":{\"count\":%d,\"low\":[%.9g,%.9g,%.9g],\"high\":[%.9g,%.9g,%.9g],"
             "\"reach\":%.9g,\"cell\":%.9g,\"period\":%.9g}}",
             balls.count, balls.low[0], balls.low[1], balls.low[2], balls.high[0], balls.high[1],
             balls.high[2], balls.reach, balls.cell, balls.period);
}

void make_metaballs(struct glb *glb) {
    struct marching_cubes cubes;
    struct surface surface = {0};
    char extras[512];
    add_cornell_room(glb);
    int pearl =
        glb_add_material(glb, "metaballs", (const float[]){0.75f, 0.72f, 0.66f}, GLB_SINGLE_SIDED);
    print_extras(extras, sizeof extras);
    marching_cubes_init(&cubes);
    metaballs_polygonise(&balls, 0.0, &cubes, &surface);
    glb_add_mesh(glb, "metaballs", &surface, pearl, extras);
    glb_add_spot(glb, (const float[]){-0.9f, 2.4f, 2.3f}, (const float[]){0.781f, 0.556f, -0.284f},
                 29.0, 500.0);
    surface_free(&surface);
    marching_cubes_free(&cubes);
}
