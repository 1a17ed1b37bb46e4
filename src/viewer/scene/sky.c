#include "viewer/scene/sky.h"

#include "base/file/folder.h"
#include "base/memory.h"
#include "scene/framing.h"
#include "viewer/picture/picture.h"
#include "viewer/scene/placed.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Whether the light stands in for those that the file lacks, as no light does beside a sky. */
static bool stands_in(const struct viewer *viewer, const struct emitter *light) {
    return light->number >= 0 && framing_made_light(&viewer->document.scene, light->number);
}

/* The lights beside a new sky; NULL: without one, where all of the scene's shine if no other does.
 * To be freed. */
static struct emitters with_sky(const struct viewer *viewer, const struct environment *sky) {
    struct emitters lights = emitters_copy(&viewer->placed.emitters);
    int kept = 0;
    if (!sky && lights.count == 0)
        emitters_from_text(&lights, &viewer->document.scene, NULL, viewer->placed.time);
    for (int i = 0; sky && i < lights.count; i++)
        if (!stands_in(viewer, &lights.items[i]))
            lights.items[kept++] = lights.items[i];
    lights.count = sky ? kept : lights.count;
    lights.sky = sky;
    return lights;
}

static void take_lights(struct viewer *viewer, struct emitters *lights) {
    struct placed *placed = &viewer->placed;
    if (lights->count != placed->emitters.count)
        placed->chosen_light = 0;
    emitters_free(&placed->emitters);
    placed->emitters = *lights;
}

/* The renderer is made anew: its programs and its textures are the sky's, too. text: of the lights
 * that shine then; NULL = those that do, and the sky. Error: all is what it was, and the sky still
 * the caller's. */
static bool put(struct viewer *viewer, struct environment *sky, const char *text) {
    struct environment **own = &viewer->document.scene.environment, *before = *own;
    struct placed placed = viewer->placed;
    struct emitters lights = with_sky(viewer, sky);
    struct renderer renderer;
    compiling_wait(&viewer->compiling);
    *own = sky;
    viewer->placed.emitters = lights;
    bool away = viewer_pose_start(viewer);
    bool ok =
        (!text || viewer_place_lights(viewer, text)) && viewer_init_renderer(viewer, &renderer);
    viewer_pose_back(viewer, away);
    lights = viewer->placed.emitters;
    viewer->placed.emitters = placed.emitters;
    if (!ok) {
        *own = before;
        viewer->placed = placed;
        emitters_free(&lights);
        return false;
    }
    take_lights(viewer, &lights);
    viewer_take_renderer(viewer, &renderer);
    environment_free(before);
    viewer_tell_sky(viewer);
    viewer_touch(viewer);
    return true;
}

static struct environment *load(const char *path) {
    struct environment *sky = mem_alloc(1, sizeof *sky);
    if (environment_load(sky, path))
        return sky;
    free(sky);
    return NULL;
}

bool viewer_open_sky(struct viewer *viewer, const char *path) {
    char *whole = path_of_user(path);
    struct environment *sky = load(whole);
    free(whole);
    if (!sky) {
        viewer_tell_error(viewer);
        return false;
    }
    viewer_forget_sky(viewer);
    viewer->opening.arriving_sky = sky;
    return true;
}

/* Whether the scene's shaders with that sky are there. */
static bool has_shaders(struct viewer *viewer, struct environment *sky) {
    struct scene scene = viewer->document.scene;
    struct renderer_desc desc = viewer_first_desc(viewer, &viewer->document);
    scene.environment = sky;
    desc.scene = &scene;
    desc.camera = viewer->placed.orbit.camera;
    desc.emitters = with_sky(viewer, sky);
    bool has = compiling_has(&viewer->compiling, &desc);
    emitters_free(&desc.emitters);
    return has;
}

static void tell_new_sky(struct viewer *viewer, int lights_before) {
    const char *path = viewer->document.scene.environment->path;
    bool fewer = viewer->placed.emitters.count < lights_before;
    messages_add(&viewer->host.messages, UI_NORMAL,
                 "%s is the sky%s. As a reference to compare with: Compare, file.", path_name(path),
                 fewer ? ", and the lights that stood in for missing ones are gone" : "");
}

void viewer_follow_sky(struct viewer *viewer) {
    struct environment *sky = viewer->opening.arriving_sky;
    if (!sky || !has_shaders(viewer, sky))
        return;
    int lights_before = viewer->placed.emitters.count;
    viewer->opening.arriving_sky = NULL;
    if (put(viewer, sky, NULL)) {
        tell_new_sky(viewer, lights_before);
        return;
    }
    viewer_tell_error(viewer);
    environment_free(sky);
}

void viewer_forget_sky(struct viewer *viewer) {
    if (!viewer->opening.arriving_sky)
        return;
    if (viewer->opening.leaving_sky)
        compiling_wait(&viewer->compiling);
    environment_free(viewer->opening.leaving_sky);
    viewer->opening.leaving_sky = viewer->opening.arriving_sky;
    viewer->opening.arriving_sky = NULL;
}

void viewer_tell_sky(struct viewer *viewer) {
    const struct environment *sky = viewer->document.scene.environment;
    snprintf(viewer->panel.sky_path, sizeof viewer->panel.sky_path, "%s", sky ? sky->path : "");
}

void viewer_touch_sky(struct viewer *viewer) {
    struct compare *compare = &viewer->shown.compare;
    renderer_relight(&viewer->shown.renderer);
    if (compare->has_other)
        renderer_relight(&compare->other);
    viewer_touch(viewer);
}

bool viewer_sky_shines(const struct viewer *viewer) {
    return viewer->placed.emitters.sky;
}

bool viewer_can_do_without_sky(const struct viewer *viewer) {
    return viewer->placed.emitters.count > 0;
}

bool viewer_can_remove_sky(const struct viewer *viewer) {
    return viewer_can_do_without_sky(viewer) || emitter_node_count(&viewer->document.scene) > 0;
}

void viewer_let_sky_shine(struct viewer *viewer, bool shines) {
    viewer->placed.emitters.sky = shines ? viewer->document.scene.environment : NULL;
    viewer_touch(viewer);
}

void viewer_remove_sky(struct viewer *viewer) {
    viewer_forget_sky(viewer);
    if (viewer->document.scene.environment && !put(viewer, NULL, NULL))
        viewer_tell_error(viewer);
}

/* A sky of the same file is turned in place. */
bool viewer_show_sky(struct viewer *viewer, const struct session *session) {
    struct environment *sky = viewer->document.scene.environment;
    bool same = !sky == !session->sky && (!sky || strcmp(sky->path, session->sky) == 0);
    viewer_forget_sky(viewer);
    if (!same) {
        sky = session->sky ? load(session->sky) : NULL;
        if (session->sky && !sky)
            return false;
    }
    if (sky) {
        sky->turn = session->sky_turn;
        sky->strength = session->sky_strength;
    }
    if (same && sky)
        viewer_touch_sky(viewer);
    if (same || put(viewer, sky, session->lights))
        return true;
    environment_free(sky);
    return false;
}
