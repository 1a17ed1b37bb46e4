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

static bool has_triangles(const struct scene *scene) {
    for (int i = 0; i < scene->node_count; i++)
        if (scene->nodes[i].mesh >= 0 && scene->meshes[scene->nodes[i].mesh].primitive_count > 0)
            return true;
    return false;
}

bool scene_open(struct scene *scene, struct geometry *geometry, const char *path,
                const struct scene_open_desc *desc) {
    *geometry = (struct geometry){0};
    if (scene_load(scene, path) && change(scene, desc)) {
        bool is_empty = desc && desc->may_be_empty && !has_triangles(scene);
        if (is_empty || lay_out(scene, geometry))
            return true;
    }
    scene_free(scene);
    return false;
}
