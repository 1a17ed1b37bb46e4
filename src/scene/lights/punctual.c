#include "scene/lights/punctual.h"

#include "base/error.h"
#include "base/log.h"

#include <cglm/cglm.h>

bool punctual_follow(struct scene *scene, float scale) {
    float user = scale == 0 ? 1 : scale, file = scene->punctual_scale;
    float all = user * (file == 0 ? 1 : file);
    bool any = false;
    for (int i = 0; i < scene->light_count; i++) {
        struct scene_light *light = &scene->lights[i];
        if (light->type == EMITTER_AREA) /* EXT_lights_area's, or of a surface */
            continue;
        any = true;
        light->scale *= all;
        for (int c = 0; c < 3; c++)
            light->intensity[c] = fminf(light->intensity[c] * all, SCENE_LIGHT_MOST);
    }
    if (any && user == 1 && file == 0 && scene->of_blender_3 && scene->surface_count > 0)
        log_note("%s: Blender 3 writes lamps 683 times too bright beside surfaces that emit: "
                 "--punctual-scale .001464",
                 scene->path);
    scene->punctual_given = user;
    return any || user == 1 || error_set("%s: it has no punctual light to be scaled", scene->path);
}
