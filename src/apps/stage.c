#include "apps/stage.h"

#include "scene/animation.h"

#include <stdio.h>
#include <string.h>

static void name_after(struct stage *stage, const char *path) {
    const char *slash = strrchr(path, '/');
    const char *file = slash ? slash + 1 : path;
    snprintf(stage->name, sizeof stage->name, "%.*s", (int)strcspn(file, "."), file);
}

static bool choose(struct stage *stage, const struct stage_desc *desc) {
    stage->camera_number = desc->camera ? camera_find(&stage->scene, desc->camera) : 0;
    stage->light_number = desc->light ? light_find(&stage->scene, desc->light) : 0;
    return stage->camera_number >= 0 && stage->light_number >= 0 &&
           (!desc->clip || scene_select_clip(&stage->scene, desc->clip));
}

static void place(struct stage *stage, double time) {
    camera_place(&stage->camera, &stage->scene, stage->camera_number, time);
    light_place(&stage->light, &stage->scene, stage->light_number, time);
}

bool stage_init(struct stage *stage, const struct stage_desc *desc) {
    *stage = (struct stage){0};
    name_after(stage, desc->path);
    if (scene_load(&stage->scene, desc->path) && choose(stage, desc) &&
        geometry_init(&stage->geometry, &stage->scene, desc->time)) {
        place(stage, desc->time);
        return true;
    }
    stage_free(stage);
    return false;
}

bool stage_pose(struct stage *stage, double time) {
    if (!geometry_pose(&stage->geometry, &stage->scene, time))
        return false;
    place(stage, time);
    return true;
}

void stage_free(struct stage *stage) {
    geometry_free(&stage->geometry);
    scene_free(&stage->scene);
    *stage = (struct stage){0};
}
