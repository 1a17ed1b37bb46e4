#include "scene/open.h"

#include "scene/animation.h"
#include "scene/brightness.h"
#include "scene/framing.h"
#include "scene/recentre.h"

static bool lay_out(struct scene *scene, struct geometry *geometry) {
    struct framing framing;
    framing_add(&framing, scene);
    if (!geometry_init(geometry, scene, 0))
        return false;
    if (scene_recentre(scene, geometry)) {
        geometry_free(geometry);
        if (!geometry_init(geometry, scene, 0))
            return false;
    }
    framing_place(&framing, scene, geometry);
    scene_note_brightness(scene, geometry);
    return true;
}

static bool change(struct scene *scene, const struct scene_open_desc *desc) {
    return !desc || ((!desc->clip || scene_select_clip(scene, desc->clip)) &&
                     environment_follow(&scene->environment, &desc->environment));
}

bool scene_open(struct scene *scene, struct geometry *geometry, const char *path,
                const struct scene_open_desc *desc) {
    *geometry = (struct geometry){0};
    if (scene_load(scene, path) && change(scene, desc) && lay_out(scene, geometry))
        return true;
    scene_free(scene);
    return false;
}
