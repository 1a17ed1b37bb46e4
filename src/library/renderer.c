#define _POSIX_C_SOURCE 200809L
#include "renderer/renderer.h"

#include "base/error.h"
#include "base/memory.h"
#include "gl/api.h"
#include "gl/cancel.h"
#include "inspect/aov.h"
#include "library/desc.h"
#include "library/device.h"
#include "library/door.h"
#include "library/image.h"
#include "library/scene.h"
#include "quality/quality.h"
#include "renderer/about.h"
#include "shared/composite.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* How often a picture is drawn. */
struct drawing {
    int first_pass, passes;
    bool is_mean;
    bool has_direct; /* a method of direct light was named; else lights choose */
};

struct manylight_renderer {
    struct manylight_device *device;
    struct loan loan;
    struct renderer renderer;
    struct drawing drawing;
    char *camera; /* of the frame, as text; NULL: the first */
    double time, step;
    bool is_placed;
    struct camera others[2]; /* of a placed camera, in the next and the previous frame */
    bool exists;             /* the renderer; false after a failure that it does not outlive */
    bool has_frame;          /* that can be read */
};

/* --- what a descriptor comes to: as apps/render.c has it -------------------------------------- */

static bool find_quality(const char *name, enum quality *quality) {
    struct text_list known = {0};
    *quality = QUALITY_NORMAL;
    for (int i = 0; quality_names[i]; i++) {
        known.items[known.count++] = quality_names[i];
        if (name && strcmp(name, quality_names[i]) == 0) {
            *quality = (enum quality)i;
            return true;
        }
    }
    return !name || error_set("no quality is called '%s' (there is: %s %s %s %s)", name,
                              known.items[0], known.items[1], known.items[2], known.items[3]);
}

static bool resolve_settings(const struct manylight_renderer_desc *desc, struct renderer_desc *to,
                             struct drawing *drawing) {
    enum quality quality;
    if (!find_quality(desc->quality, &quality))
        return false;
    struct quality_choice choice = quality_named(quality);
    bool passes_given = desc->passes > 0;
    if (!(to->technique = technique_find(desc->technique)) ||
        (desc->direct && !(to->direct = direct_find(desc->direct))))
        return false;
    drawing->has_direct = desc->direct != NULL;
    drawing->passes = passes_given ? desc->passes : choice.passes;
    drawing->first_pass = desc->first_pass;
    drawing->is_mean = drawing->passes > 1 || drawing->first_pass > 0 || passes_given;
    return quality_settings(&choice, to->technique, &desc->settings, desc->settings ? 1 : 0,
                            &to->settings);
}

static bool check_numbers(const struct manylight_renderer_desc *desc) {
    return (desc_check("passes", desc->passes, 0, 1e6) &&
            desc_check("first_pass", desc->first_pass, 0, 1e6)) ||
           door_blame(MANYLIGHT_BAD_ARGUMENT);
}

static bool resolve(const struct manylight_renderer_desc *given, const struct loan *loan,
                    struct renderer_desc *to, struct drawing *drawing) {
    struct manylight_renderer_desc desc;
    int size[2];
    if (!desc_take(&desc, sizeof desc, given, "manylight_renderer_desc") || !check_numbers(&desc) ||
        !loan_size(loan, desc.camera, desc.width, desc.height, size))
        return false;
    *to = (struct renderer_desc){.width = size[0],
                                 .height = size[1],
                                 .scene = &loan->stage.scene,
                                 .geometry = &loan->stage.geometry,
                                 .emitters = loan->stage.emitters,
                                 .camera = loan->stage.camera,
                                 .keep_lights = desc.keep_lights != 0,
                                 .background.kind =
                                     desc.hide_environment ? BACKGROUND_NONE : BACKGROUND_SCENE,
                                 .timed = desc.timed != 0};
    if (!resolve_settings(&desc, to, drawing))
        return door_blame(MANYLIGHT_BAD_SETTING);
    to->progressive = drawing->is_mean;
    return true;
}

/* --- making ----------------------------------------------------------------------------------- */

/* One call, for the device's thread. */
struct call {
    struct manylight_renderer *of;
    const struct renderer_desc *desc;
    const struct manylight_renderer_desc *given;
    const struct manylight_view *given_view;
    struct manylight_view view;
    const char *text;
    char *room;
    size_t room_size;
    struct image image;
    struct bitmap bitmap;
    int layer;
    double milliseconds;
};

static bool init_renderer(void *user) {
    struct call *call = user;
    return call->of->exists = renderer_init(&call->of->renderer, call->desc);
}

static bool create(struct manylight_device *device, const struct manylight_scene *scene,
                   const struct manylight_renderer_desc *desc, struct manylight_renderer **out) {
    struct manylight_renderer *made = mem_alloc(1, sizeof *made);
    struct renderer_desc resolved;
    bool ok = scene_use(scene) && loan_take(&made->loan, scene);
    ok = ok && resolve(desc, &made->loan, &resolved, &made->drawing);
    ok = ok && device_do(device, init_renderer, &(struct call){.of = made, .desc = &resolved});
    scene_leave(scene);
    if (!ok) {
        loan_return(&made->loan);
        free(made);
        return false;
    }
    made->device = device_hold(device);
    *out = made;
    return true;
}

enum manylight_status manylight_renderer_create(struct manylight_device *device,
                                                struct manylight_scene *scene,
                                                const struct manylight_renderer_desc *desc,
                                                struct manylight_renderer **renderer) {
    struct door door;
    *renderer = NULL;
    door_enter(&door);
    return door_leave(&door, create(device, scene, desc, renderer), MANYLIGHT_FAILED);
}

static bool free_renderer(void *user) {
    struct manylight_renderer *renderer = ((struct call *)user)->of;
    if (renderer->exists)
        renderer_free(&renderer->renderer);
    renderer->exists = false;
    renderer->has_frame = false;
    return true;
}

void manylight_renderer_free(struct manylight_renderer *renderer) {
    struct door door;
    door_enter(&door);
    if (!renderer || !device_is_at_home()) {
        door_leave(&door, true, MANYLIGHT_OK);
        return;
    }
    bool ok = device_do(renderer->device, free_renderer, &(struct call){.of = renderer});
    /* A callback of the renderer at work must not pull it away. */
    bool at_work = !ok && door_blamed() == MANYLIGHT_BAD_ARGUMENT;
    if (!at_work) {
        loan_return(&renderer->loan);
        device_release(renderer->device);
        mem_free(renderer->camera, renderer);
    }
    door_leave(&door, !at_work, MANYLIGHT_BAD_ARGUMENT);
}

static bool check_exists(const struct manylight_renderer *renderer) {
    return renderer->exists ||
           error_set("the renderer ended with an earlier failure: make another one");
}

/* Runs a job of the renderer while its scene stays as it is. */
static bool do_job(struct manylight_renderer *renderer, worker_job *job, struct call *call) {
    struct manylight_scene *scene = renderer->loan.from;
    bool ok = scene_use(scene) && device_do(renderer->device, job, call);
    scene_leave(scene);
    return ok;
}

/* Follows a scene that has changed, or starts anew with it. Programs stay in the device's store. */
static bool follow_scene(struct manylight_renderer *renderer) {
    struct renderer_desc desc = renderer->renderer.desc;
    if (loan_is_current(&renderer->loan))
        return true;
    const struct geometry *geometry = &renderer->loan.stage.geometry;
    bool follows = renderer->exists && loan_is_followed(&renderer->loan);
    bool may_move = follows && renderer_follows(&renderer->renderer, geometry);
    bool ok = loan_renew(&renderer->loan);
    may_move = may_move && renderer_follows(&renderer->renderer, geometry);
    if (ok && follows && (may_move || geometry->changed < geometry->pose_count))
        return true;
    free_renderer(&(struct call){.of = renderer});
    if (!ok)
        return false;
    desc.emitters = renderer->loan.stage.emitters;
    desc.camera = renderer->loan.stage.camera;
    desc.direct = renderer->drawing.has_direct ? desc.direct : NULL;
    return renderer->exists = renderer_init(&renderer->renderer, &desc);
}

static bool check_frame(const struct manylight_renderer *renderer) {
    return check_exists(renderer) &&
           (loan_is_current(&renderer->loan) ||
            error_set("the scene has changed since the frame: manylight_render draws another") ||
            door_blame(MANYLIGHT_BAD_ARGUMENT)) &&
           (renderer->has_frame || error_set("there is no frame: manylight_render draws one") ||
            door_blame(MANYLIGHT_BAD_ARGUMENT));
}

static bool follow(void *user) {
    struct call *call = user;
    struct manylight_renderer *renderer = call->of;
    struct renderer_desc resolved;
    struct drawing drawing;
    if (!check_exists(renderer) || !follow_scene(renderer) ||
        !resolve(call->given, &renderer->loan, &resolved, &drawing) ||
        !renderer_follow(&renderer->renderer, &resolved))
        return false;
    renderer->drawing = drawing;
    renderer->has_frame = false;
    return true;
}

enum manylight_status manylight_renderer_change(struct manylight_renderer *renderer,
                                                const struct manylight_renderer_desc *desc) {
    struct door door;
    door_enter(&door);
    bool ok = do_job(renderer, follow, &(struct call){.of = renderer, .given = desc});
    return door_leave(&door, ok, MANYLIGHT_FAILED);
}

static bool refuse_null(const char *name) {
    error_set("%s is NULL", name);
    return door_blame(MANYLIGHT_BAD_ARGUMENT);
}

static bool read_setting(void *user) {
    struct call *call = user;
    struct setting setting;
    const struct settings *settings = &call->of->renderer.desc.settings;
    if (!call->text)
        return refuse_null("name");
    if (!check_exists(call->of) || !settings_find(settings, call->text, &setting))
        return false;
    setting_format(&setting, settings, call->room, call->room_size);
    return true;
}

enum manylight_status manylight_renderer_setting(struct manylight_renderer *renderer,
                                                 const char *name, char *text, size_t text_size) {
    struct door door;
    struct call call = {.of = renderer, .text = name, .room = text, .room_size = text_size};
    door_enter(&door);
    return door_leave(&door, do_job(renderer, read_setting, &call), MANYLIGHT_BAD_SETTING);
}

/* --- drawing ---------------------------------------------------------------------------------- */

/* A view being drawn. */
struct telling {
    const struct manylight_view *view;
    int pass, passes; /* those that are done, and all */
};

/* True: the caller cancels. */
static bool tell(void *user) {
    const struct telling *telling = user;
    const struct manylight_view *view = telling->view;
    char note[64];
    snprintf(note, sizeof note, "pass %d of %d", telling->pass, telling->passes);
    return view->progress &&
           view->progress(view->user, (double)telling->pass / telling->passes, note) != 0;
}

static void draw_pass(struct manylight_renderer *renderer, int pass) {
    const struct drawing *drawing = &renderer->drawing;
    if (drawing->is_mean)
        renderer_add_pass(&renderer->renderer, drawing->first_pass + pass);
    else
        renderer_render(&renderer->renderer);
}

/* Waits for each pass, as a GPU would take hundreds at once. Hosts draw in callbacks: none comes to
 * them within a pass. */
static bool draw_passes(struct call *call) {
    struct manylight_renderer *renderer = call->of;
    struct telling telling = {.view = &call->view, .passes = renderer->drawing.passes};
    bool watches = call->view.progress && !device_is_adopted(renderer->device);
    bool cancelled = false;
    for (int i = 0; i < telling.passes && !cancelled; i++) {
        if (watches)
            cancel_begin(tell, &telling, CANCEL_INTERVAL);
        draw_pass(renderer, i);
        if (watches && cancel_end()) {
            cancelled = true;
            renderer_forget_frame(&renderer->renderer);
        } else if (renderer->drawing.is_mean) {
            gl.Finish();
            telling.pass = i + 1;
            cancelled = tell(&telling);
        }
    }
    if (!cancelled)
        return true;
    error_set("cancelled");
    return door_blame(MANYLIGHT_CANCELLED);
}

/* Lights of a view may want another method of direct light than the scene's. */
static bool show(struct manylight_renderer *renderer) {
    struct renderer_desc desc = renderer->renderer.desc;
    desc.emitters = renderer->loan.stage.emitters;
    desc.camera = renderer->loan.stage.camera;
    desc.direct = renderer->drawing.has_direct ? desc.direct : NULL;
    return renderer_update(&renderer->renderer) && renderer_follow(&renderer->renderer, &desc);
}

/* After a pose that fails its triangles must not be drawn; after an update that fails, the renderer
 * neither. */
static bool draw(struct call *call) {
    struct manylight_renderer *renderer = call->of;
    if (!check_exists(renderer) || !follow_scene(renderer) ||
        !loan_pose(&renderer->loan, &call->view) ||
        (call->view.placed && !loan_place_others(&call->view, renderer->others)))
        return false;
    if (!show(renderer)) {
        free_renderer(call);
        return false;
    }
    return draw_passes(call);
}

/* What files tell of the frame. The camera's text is the caller's. */
static void keep_facts(struct manylight_renderer *renderer, const struct manylight_view *view) {
    const char *camera = view->placed ? "placed" : view->camera;
    free(renderer->camera);
    renderer->camera = camera ? mem_strdup(camera) : NULL;
    renderer->time = view->time;
    renderer->step = view->step;
    renderer->is_placed = view->placed;
}

static bool render(void *user) {
    struct call *call = user;
    call->of->has_frame = false;
    if (!desc_take(&call->view, sizeof call->view, call->given_view, "manylight_view"))
        return false;
    if (!draw(call))
        return false;
    keep_facts(call->of, &call->view);
    return call->of->has_frame = true;
}

enum manylight_status manylight_render(struct manylight_renderer *renderer,
                                       const struct manylight_view *view) {
    struct door door;
    door_enter(&door);
    struct call call = {.of = renderer, .given_view = view};
    return door_leave(&door, do_job(renderer, render, &call), MANYLIGHT_FAILED);
}

/* --- reading ---------------------------------------------------------------------------------- */

static void tell_facts(const struct manylight_renderer *renderer, struct image *image) {
    const struct drawing *drawing = &renderer->drawing;
    about_add(image, &(struct about){.scene = renderer->loan.stage.scene.path,
                                     .camera = renderer->camera,
                                     .technique = renderer->renderer.technique->name,
                                     .placed = &renderer->renderer.desc.camera,
                                     .settings = &renderer->renderer.desc.settings,
                                     .time = renderer->time});
    if (!drawing->is_mean)
        return;
    image->passes =
        mem_printf("%d..%d", drawing->first_pass, drawing->first_pass + drawing->passes - 1);
    image->weight = renderer_pass_weight(&renderer->renderer);
}

static bool find_motion(struct manylight_renderer *renderer, struct surface_motion *motion) {
    return loan_find_motion(&renderer->loan, renderer->camera,
                            renderer->is_placed ? renderer->others : NULL, renderer->time,
                            renderer->step, motion);
}

/* Returns the bits of the layers of every frame among the names; without any, of all. others: the
 * other names, owned; NULL: none. */
static unsigned take_layers(const struct renderer *renderer, const char *names, char **others) {
    char *list = mem_strdup(names ? names : ""), *next = NULL;
    unsigned bits = 0;
    for (char *name = strtok_r(list, ",", &next); name; name = strtok_r(NULL, ",", &next)) {
        unsigned bit = renderer_layer_bit(renderer, name);
        char *before = *others;
        bits |= bit;
        if (!bit) {
            *others = before ? mem_printf("%s,%s", before, name) : mem_strdup(name);
            free(before);
        }
    }
    free(list);
    return bits ? bits | 1U << LAYER_DEPTH : ~0U;
}

static bool append_layers(struct call *call, unsigned layers) {
    struct renderer *renderer = &call->of->renderer;
    if (aov_needs_pass(call->text) && call->of->drawing.is_mean) {
        error_set("aov: outputs of a technique are of one pass, and not of a mean");
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    }
    if (!aov_check(renderer, call->text))
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    struct surface_motion motion = {.positions = {NULL}};
    if (!renderer_read_some(renderer, layers, &call->image))
        return false;
    bool ok = (!surface_layers_move(call->text) || find_motion(call->of, &motion)) &&
              aov_append(renderer, call->text, &motion, &call->image);
    surface_motion_free(&motion);
    if (!ok) {
        image_free(&call->image);
        return false;
    }
    tell_facts(call->of, &call->image);
    return true;
}

static bool read_layers(void *user) {
    struct call *call = user;
    char *others = NULL;
    if (!check_frame(call->of))
        return false;
    unsigned layers = take_layers(&call->of->renderer, call->text, &others);
    call->text = others;
    bool ok = append_layers(call, layers);
    free(others);
    return ok;
}

enum manylight_status manylight_read(struct manylight_renderer *renderer, const char *outputs,
                                     struct manylight_image **image) {
    struct door door;
    struct call call = {.of = renderer, .text = outputs};
    *image = NULL;
    door_enter(&door);
    bool ok = do_job(renderer, read_layers, &call);
    if (ok)
        *image = image_wrap(&call.image);
    return door_leave(&door, ok, MANYLIGHT_FAILED);
}

static bool find_layer(const char *name, int *layer) {
    *layer = LAYER_BEAUTY;
    for (int i = 0; name && shown_layer_names[i]; i++)
        if (strcmp(name, shown_layer_names[i]) == 0) {
            *layer = i;
            return true;
        }
    return !name ||
           error_set("layer: '%s' is neither %s, %s nor %s", name, shown_layer_names[0],
                     shown_layer_names[1], shown_layer_names[2]) ||
           door_blame(MANYLIGHT_BAD_ARGUMENT);
}

static bool compose(void *user) {
    struct call *call = user;
    if (!check_frame(call->of) || !find_layer(call->text, &call->layer))
        return false;
    renderer_compose(&call->of->renderer, call->layer);
    return true;
}

static bool read_display(void *user) {
    struct call *call = user;
    return compose(call) && renderer_read_display(&call->of->renderer, &call->bitmap);
}

static bool copy_display(struct manylight_renderer *renderer, const char *layer, uint8_t *rgba,
                         size_t bytes) {
    struct call call = {.of = renderer, .text = layer};
    if (!do_job(renderer, read_display, &call))
        return false;
    size_t wanted = (size_t)call.bitmap.width * (size_t)call.bitmap.height * 4;
    bool fits = bytes >= wanted;
    if (fits)
        memcpy(rgba, call.bitmap.rgba, wanted);
    bitmap_free(&call.bitmap);
    return fits || error_set("display: %zu bytes have no room in %zu", wanted, bytes) ||
           door_blame(MANYLIGHT_BAD_ARGUMENT);
}

enum manylight_status manylight_read_display(struct manylight_renderer *renderer, const char *layer,
                                             uint8_t *rgba, size_t bytes) {
    struct door door;
    door_enter(&door);
    return door_leave(&door, copy_display(renderer, layer, rgba, bytes), MANYLIGHT_FAILED);
}

static bool compose_for_others(void *user) {
    bool ok = compose(user);
    gl.Finish();
    return ok;
}

enum manylight_status manylight_display_texture(struct manylight_renderer *renderer,
                                                const char *layer, uint32_t *texture, int *width,
                                                int *height) {
    struct door door;
    door_enter(&door);
    bool ok =
        device_is_adopted(renderer->device) ||
        error_set("the device has a context of its own, whose textures are for nobody else") ||
        door_blame(MANYLIGHT_BAD_ARGUMENT);
    ok = ok && do_job(renderer, compose_for_others, &(struct call){.of = renderer, .text = layer});
    if (ok) {
        *texture = renderer->renderer.composite.display.id;
        *width = renderer->renderer.desc.width;
        *height = renderer->renderer.desc.height;
    }
    return door_leave(&door, ok, MANYLIGHT_FAILED);
}

static bool read_time(void *user) {
    struct call *call = user;
    if (!call->text)
        return refuse_null("path");
    if (!check_frame(call->of))
        return false;
    timers_flush(&call->of->renderer.timers);
    call->milliseconds = timer_ms(&call->of->renderer.timers, call->text);
    return true;
}

enum manylight_status manylight_milliseconds(struct manylight_renderer *renderer, const char *path,
                                             double *milliseconds) {
    struct door door;
    struct call call = {.of = renderer, .text = path};
    door_enter(&door);
    bool ok = do_job(renderer, read_time, &call);
    *milliseconds = call.milliseconds;
    return door_leave(&door, ok, MANYLIGHT_FAILED);
}
