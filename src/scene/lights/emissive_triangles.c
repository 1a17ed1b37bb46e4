#include "scene/lights/emissive_triangles.h"

#include "base/memory.h"
#include "scene/lights/emissive.h"
#include "scene/lights/lamp_triangles.h"
#include "scene/mesh/corners.h"
#include "scene/texture.h"
#include "shared/light_tree.h"

#include <stdlib.h>

static void add(struct emissive_triangles *list, const double radiance[3],
                struct emissive_place place) {
    struct light_triangle *item = &list->items[list->count];
    item->red = (float)radiance[0];
    item->green = (float)radiance[1];
    item->blue = (float)radiance[2];
    list->places[list->count++] = place;
}

/* Colours of a scene while they are looked up. */
struct looks {
    float srgb_to_linear[256];
    uint32_t left; /* as in struct lamp_triangles */
};

static void add_surface(struct emissive_triangles *list, const struct scene *scene,
                        const struct geometry *geometry, int number, struct looks *looks,
                        struct emissive_span span) {
    const struct emissive_surface *surface = &scene->surfaces[number];
    const struct mesh *mesh = &scene->meshes[scene->nodes[surface->node].mesh];
    const struct primitive *primitive = &mesh->primitives[surface->primitive];
    for (uint32_t i = span.first; i < span.end; i++) {
        const uint32_t *index =
            &primitive->indices[(uint32_t)surface->first + 3 * (i - span.first)];
        double radiance[3];
        lamp_triangle_radiance(scene, primitive, index, looks->srgb_to_linear, &looks->left,
                               radiance);
        bool shines = radiance[0] + radiance[1] + radiance[2] > 0 &&
                      corners_area(geometry, &geometry->indices[3 * (size_t)i]) > 0;
        bool is_double = scene->materials[primitive->material].double_sided;
        for (int side = 0; shines && side < (is_double ? 2 : 1); side++)
            add(list, radiance, (struct emissive_place){i, side == 1});
    }
}

/* Moves the triangles to the geometry's pose. */
static void move_to_pose(struct emissive_triangles *list, const struct geometry *geometry) {
    for (int i = 0; i < list->count; i++) {
        const struct emissive_place *place = &list->places[i];
        struct light_triangle *item = &list->items[i];
        vec3s edges[2];
        vec3s corner =
            corners_edges(geometry, &geometry->indices[3 * (size_t)place->triangle], edges);
        glm_vec3_copy(corner.raw, item->corner);
        glm_vec3_copy(edges[place->is_back].raw, item->edge_1);
        glm_vec3_copy(edges[!place->is_back].raw, item->edge_2);
    }
}

void emissive_triangles_init(struct emissive_triangles *list, const struct scene *scene,
                             const struct geometry *geometry, const struct emitters *emitters) {
    enum lamp_state *lamps = emissive_lamp_states(scene, emitters);
    struct emissive_span *spans = emissive_find_all(geometry, scene);
    struct looks looks = {.left = LAMP_LOOKS};
    size_t most = 0;
    texture_decode_table(looks.srgb_to_linear);
    *list = (struct emissive_triangles){0};
    for (int i = 0; i < scene->surface_count; i++)
        if (lamps[scene->surfaces[i].lamp] == LAMP_STOOD_IN_FOR)
            most += 2 * (size_t)(spans[i].end - spans[i].first);
    list->items = mem_alloc(most, sizeof *list->items);
    list->places = mem_alloc(most, sizeof *list->places);
    for (int i = 0; i < scene->surface_count; i++)
        if (lamps[scene->surfaces[i].lamp] == LAMP_STOOD_IN_FOR)
            add_surface(list, scene, geometry, i, &looks, spans[i]);
    move_to_pose(list, geometry);
    mem_free(lamps, spans);
}

void emissive_triangles_free(struct emissive_triangles *list) {
    mem_free(list->items, list->places);
    *list = (struct emissive_triangles){0};
}
