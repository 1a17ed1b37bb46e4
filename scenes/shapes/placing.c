#include "placing.h"

#include "shapes.h"

#include <stddef.h>

void place_surface(struct glb *glb, const char *name, int material, struct surface *surface) {
    glb_add_mesh(glb, name, surface, material, NULL);
    surface_free(surface);
}

void place_quad(struct glb *glb, const char *name, int material, const float corners[4][3]) {
    struct surface surface = {0};
    add_quad(&surface, corners[0], corners[1], corners[2], corners[3]);
    place_surface(glb, name, material, &surface);
}

void place_box(struct glb *glb, const char *name, int material, const float low[3],
               const float high[3]) {
    struct surface surface = {0};
    add_box(&surface, low, high);
    place_surface(glb, name, material, &surface);
}
