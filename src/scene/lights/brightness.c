#include "scene/lights/brightness.h"

#include "base/log.h"
#include "scene/lights/emitter.h"

#include <cglm/cglm.h>

/* W/m2; of a narrow spot what is left when it is spread over the scene. */
static double irradiance(const struct emitter *emitter, const struct geometry *geometry) {
    double power = (double)glm_vec3_max((float *)emitter->intensity);
    if (emitter->type == EMITTER_DIRECTIONAL)
        return power;
    float distance = glm_vec3_distance((float *)emitter->position, (float *)geometry->center);
    double spread =
        emitter_flux(emitter, geometry->radius) / (GLM_PI * pow((double)geometry->radius, 2));
    return fmin(power / pow((double)fmaxf(distance, geometry->radius), 2), spread);
}

float scene_brightness(const struct scene *scene, const struct geometry *geometry) {
    struct emitters emitters = emitters_place(scene, 0);
    double sum = 0;
    for (int i = 0; i < emitters.count; i++)
        sum += irradiance(&emitters.items[i], geometry);
    emitters_free(&emitters);
    return (float)log2(sum / GLM_PI);
}

void scene_note_brightness(const struct scene *scene, const struct geometry *geometry) {
    const float stops_shown = 6; /* what lies in shade may want that much */
    const float stops_lit = 6;   /* less is nearly black on a display */
    float stops = scene_brightness(scene, geometry);
    if (stops > stops_shown)
        log_note("%s: its lights are %.0f times as bright as white: --set exposure=%.0f",
                 scene->path, (double)exp2f(stops), (double)-roundf(stops));
    else if (stops < -stops_lit && isfinite(stops))
        log_note("%s: its lights are dim, a white surface has 1/%.0f of a picture's white: --set "
                 "exposure=%.0f",
                 scene->path, (double)exp2f(-stops), (double)-roundf(stops));
}
