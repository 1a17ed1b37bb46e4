#include "viewer/scene/lights.h"

#include "base/memory.h"

#include <cglm/cglm.h>

#include <string.h>

bool viewer_has_light(const struct viewer *viewer) {
    return viewer->placed.emitters.count > 0;
}

struct emitter *viewer_light(const struct viewer *viewer) {
    return &viewer->placed.emitters.items[viewer->placed.chosen_light];
}

bool viewer_light_is_moved(const struct viewer *viewer, int i) {
    return viewer->placed.emitters.items[i].number < 0 || viewer->placed.emitters.items[i].moved;
}

void viewer_touch_light(struct viewer *viewer) {
    viewer_light(viewer)->moved = 1;
    viewer_touch(viewer);
}

void viewer_reset_light(struct viewer *viewer) {
    struct emitter *light = viewer_light(viewer);
    if (light->number < 0)
        return;
    emitter_place(light, &viewer->document.scene, light->number, viewer->placed.time);
    viewer_touch(viewer);
}

double viewer_light_power(const struct viewer *viewer, const struct emitter *light) {
    return emitter_flux(light, viewer->document.geometry.radius);
}

void viewer_set_light_power(struct viewer *viewer, struct emitter *light, double power) {
    double before = viewer_light_power(viewer, light);
    for (int c = 0; c < 3; c++)
        light->intensity[c] =
            before > 0 ? (float)((double)light->intensity[c] * power / before) : (float)power;
}

void viewer_retype_light(struct viewer *viewer, enum emitter_type type) {
    struct emitter *light = viewer_light(viewer);
    double power = viewer_light_power(viewer, light);
    bool was_sun = light->type == EMITTER_DIRECTIONAL, sun = type == EMITTER_DIRECTIONAL;
    light->type = type;
    if (was_sun || sun) /* metres or radians */
        light->size[0] = light->size[1] = 0;
    if (type == EMITTER_POINT)
        light->size[1] = 0;
    if (type == EMITTER_AREA && light->size[0] == 0)
        light->size[0] = .1F * viewer->document.geometry.radius;
    viewer_set_light_power(viewer, light, power);
    viewer_touch_light(viewer);
}

/* Before the eye, over what it looks at. */
static void place_ahead(const struct viewer *viewer, struct emitter *light) {
    const struct orbit *orbit = &viewer->placed.orbit;
    const struct camera *camera = &orbit->camera;
    vec3 point, towards;
    glm_vec3_copy((float *)camera->eye, light->position);
    glm_vec3_muladds((float *)camera->forward, .5F * orbit->distance, light->position);
    glm_vec3_muladds((float *)camera->up, .15F * orbit->distance, light->position);
    glm_vec3_copy((float *)camera->eye, point);
    glm_vec3_muladds((float *)camera->forward, orbit->distance, point);
    glm_vec3_sub(point, light->position, towards);
    emitter_aim(light, towards);
}

/* As strong as the chosen one, or else as what lights the scene's middle with 1 W/m2. */
void viewer_add_light(struct viewer *viewer, enum emitter_type type) {
    struct placed *placed = &viewer->placed;
    float radius = viewer->document.geometry.radius;
    struct emitter light = emitter_new(type);
    if (type == EMITTER_AREA)
        light.size[0] = light.size[1] = .2F * radius;
    place_ahead(viewer, &light);
    viewer_set_light_power(viewer, &light,
                           viewer_has_light(viewer)
                               ? viewer_light_power(viewer, viewer_light(viewer))
                               : GLM_PI * (double)(radius * radius));
    struct emitters *all = &placed->emitters;
    all->items = mem_resize(all->items, (size_t)all->count + 1, sizeof light);
    all->items[all->count] = light;
    placed->chosen_light = all->count++;
    viewer->hand.light_tool.shown = true;
    viewer_touch_light(viewer);
}

bool viewer_can_remove_light(const struct viewer *viewer) {
    return viewer->placed.emitters.count > (viewer->placed.emitters.sky ? 0 : 1);
}

void viewer_remove_light(struct viewer *viewer) {
    struct placed *placed = &viewer->placed;
    struct emitters *emitters = &placed->emitters;
    int n = placed->chosen_light;
    if (!viewer_can_remove_light(viewer) || n >= emitters->count)
        return;
    memmove(&emitters->items[n], &emitters->items[n + 1],
            (size_t)(emitters->count - n - 1) * sizeof *emitters->items);
    emitters->count--;
    placed->chosen_light = n > 0 ? n - 1 : 0;
    viewer_touch(viewer);
}
