#include "apps/stage.h"

#include <stdio.h>
#include <string.h>

static void name_after(struct stage *stage, const char *path) {
    const char *slash = strrchr(path, '/');
    const char *file = slash ? slash + 1 : path;
    snprintf(stage->name, sizeof stage->name, "%.*s", (int)strcspn(file, "."), file);
}

static bool place(struct stage *stage, const struct stage_desc *desc) {
    int camera = desc->camera ? camera_find(&stage->scene, desc->camera) : 0;
    int light = desc->light ? light_find(&stage->scene, desc->light) : 0;
    if (camera < 0 || light < 0)
        return false;
    camera_place(&stage->camera, &stage->scene, camera, desc->time);
    light_place(&stage->light, &stage->scene, light, desc->time);
    return true;
}

bool stage_init(struct stage *stage, const struct stage_desc *desc) {
    *stage = (struct stage){0};
    name_after(stage, desc->path);
    if (scene_load(&stage->scene, desc->path) &&
        geometry_init(&stage->geometry, &stage->scene, desc->time) && place(stage, desc))
        return true;
    stage_free(stage);
    return false;
}

void stage_free(struct stage *stage) {
    geometry_free(&stage->geometry);
    scene_free(&stage->scene);
    *stage = (struct stage){0};
}
