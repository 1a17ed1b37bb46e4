#include "renderer/stage.h"

#include "scene/open.h"
#include "scene/placing.h"

#include <stdio.h>
#include <string.h>

static void name_after(struct stage *stage, const char *path) {
    const char *slash = strrchr(path, '/');
    const char *file = slash ? slash + 1 : path;
    file += strspn(file, ".");
    snprintf(stage->name, sizeof stage->name, "%.*s", (int)strcspn(file, "."), file);
}

static bool place(struct stage *stage, double time) {
    return camera_from_text(&stage->camera, &stage->scene, stage->camera_text, time, NULL) &&
           emitters_from_text(&stage->emitters, &stage->scene, stage->light_text, time);
}

bool stage_init(struct stage *stage, const struct stage_desc *desc) {
    *stage = (struct stage){.camera_text = desc->camera, .light_text = desc->light};
    name_after(stage, desc->path);
    const struct scene_open_desc open = {.bytes = desc->bytes,
                                         .choice = desc->choice,
                                         .light = desc->light,
                                         .clip = desc->clip,
                                         .environment = desc->environment,
                                         .punctual_scale = desc->punctual_scale};
    if (scene_open(&stage->scene, &stage->geometry, desc->path, &open) &&
        stage_pose(stage, (double)desc->time))
        return true;
    stage_free(stage);
    return false;
}

bool stage_pose(struct stage *stage, double time) {
    return geometry_pose(&stage->geometry, &stage->scene, time) && place(stage, time);
}

void stage_default_size(const struct stage *stage, int size[2]) {
    struct camera camera;
    int n = 0;
    camera_from_text(&camera, &stage->scene, stage->camera_text, 0, &n);
    camera_default_size(&stage->scene, n, size);
}

bool stage_show(const struct stage *stage, struct renderer *renderer) {
    struct renderer_desc desc = renderer->desc;
    desc.emitters = stage->emitters;
    desc.camera = stage->camera;
    return renderer_update(renderer) && renderer_follow(renderer, &desc);
}

void stage_free(struct stage *stage) {
    emitters_free(&stage->emitters);
    geometry_free(&stage->geometry);
    scene_free(&stage->scene);
    *stage = (struct stage){0};
}
