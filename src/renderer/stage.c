#include "renderer/stage.h"

#include "base/memory.h"
#include "scene/lens.h"
#include "scene/open.h"
#include "scene/placing.h"

#include <math.h>
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
    const struct scene_open_desc open = {.filled = desc->filled,
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

/* Copies vertices to where they are in the arrays of `parts`. */
static void take_positions(const struct geometry *geometry, const struct geometry_part *parts,
                           float (*positions)[3]) {
    for (int i = 0; i < geometry->part_count; i++)
        if (!parts[i].dynamic)
            memcpy(positions + parts[i].first_vertex,
                   geometry->position + geometry->parts[i].first_vertex,
                   parts[i].vertex_count * sizeof *positions);
}

bool stage_find_motion(struct stage *stage, double time, double step,
                       struct surface_motion *motion) {
    struct geometry *geometry = &stage->geometry;
    struct geometry_part *parts = mem_alloc((size_t)geometry->part_count, sizeof *parts);
    size_t bytes = geometry->vertex_count * sizeof *geometry->position;
    bool ok = true;
    *motion = (struct surface_motion){.positions = {NULL}};
    memcpy(parts, geometry->parts, (size_t)geometry->part_count * sizeof *parts);
    for (int i = 0; i < 2; i++)
        motion->positions[i] = mem_copy(geometry->position, bytes, 1);
    for (int i = 0; ok && i < 2; i++) {
        double then = fmax(0, i == 0 ? time + step : time - step);
        ok = geometry_pose(geometry, &stage->scene, then) &&
             camera_from_text(&motion->cameras[i], &stage->scene, stage->camera_text, then, NULL);
        if (ok)
            take_positions(geometry, parts, motion->positions[i]);
    }
    free(parts);
    return geometry_pose(geometry, &stage->scene, time) && ok;
}

void stage_default_size(const struct stage *stage, int size[2]) {
    struct camera camera;
    int n = 0;
    camera_from_text(&camera, &stage->scene, stage->camera_text, 0, &n);
    camera_default_size(&stage->scene, n, size);
    for (int i = 0; i < 2 && camera.size[0] > 0; i++)
        size[i] = camera.size[i];
    lens_default_size(&camera, size);
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
