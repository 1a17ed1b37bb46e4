#include "scene/open.h"

#include "scene/camera_range.h"
#include "scene/clips.h"
#include "scene/darkness.h"
#include "scene/framing.h"
#include "scene/lights/brightness.h"
#include "scene/lights/punctual.h"
#include "scene/placing.h"
#include "scene/recentre.h"

static bool lay_out_anew(struct scene *scene, struct geometry *geometry) {
    geometry_free(geometry);
    return geometry_init(geometry, scene, 0);
}

static bool lay_out(struct scene *scene, struct geometry *geometry, const char *light) {
    struct framing framing;
    bool is_lit = emitters_text_is_complete(scene, light);
    framing_add(&framing, scene, !is_lit);
    if (!geometry_init(geometry, scene, 0) ||
        (scene_recentre(scene, geometry) && !lay_out_anew(scene, geometry)))
        return false;
    framing_place(&framing, scene, geometry);
    scene_check_ranges(scene, geometry);
    if (!is_lit && scene_is_dark(scene, geometry)) { /* geometry knows how many nodes there are */
        framing_add_lights(&framing, scene);
        if (!lay_out_anew(scene, geometry))
            return false;
        framing_place(&framing, scene, geometry);
    }
    if (framing.light >= 0)
        scene_note_mirrors(scene, geometry);
    scene_note_brightness(scene, geometry);
    return true;
}

static bool change(struct scene *scene, const struct scene_open_desc *desc) {
    if (!desc || !desc->clip)
        clips_note_left_out(scene);
    return punctual_follow(scene, desc ? desc->punctual_scale : 0) &&
           (!desc || ((!desc->clip || clips_select(scene, desc->clip)) &&
                      environment_follow(&scene->environment, &desc->environment)));
}

static bool has_triangles(const struct scene *scene) {
    for (int i = 0; i < scene->node_count; i++)
        if (!scene->nodes[i].hidden && scene->nodes[i].mesh >= 0 &&
            scene->meshes[scene->nodes[i].mesh].primitive_count > 0)
            return true;
    return false;
}

bool scene_open(struct scene *scene, struct geometry *geometry, const char *path,
                const struct scene_open_desc *desc) {
    *geometry = (struct geometry){0};
    const struct scene_open_desc usual = {0};
    const struct scene_open_desc *from = desc ? desc : &usual;
    bool ok = from->filled ? scene_take(scene, from->filled)
                           : scene_load_choice(scene, path, &from->choice);
    if (ok && change(scene, desc)) {
        bool is_empty = desc && desc->may_be_empty && !has_triangles(scene);
        if (is_empty || lay_out(scene, geometry, desc ? desc->light : NULL))
            return true;
    }
    scene_free(scene);
    return false;
}
