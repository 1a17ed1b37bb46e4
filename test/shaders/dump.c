/* dump FOLDER SCENE ...: the sources of all shaders, for another compiler to read: every setting of
 * every technique and direct method by turns, screen passes drawn and dispatched, on a driver that
 * draws nothing. In the first scene numbers as well, and by turns from presets, too. */
#include "null_driver.h"

#include "base/error.h"
#include "base/image.h"
#include "base/log.h"
#include "base/memory.h"
#include "direct/direct.h"
#include "gl/context/context.h"
#include "gl/screen.h"
#include "inspect/aov.h"
#include "inspect/inspect.h"
#include "inspect/probe.h"
#include "inspect/screen.h"
#include "renderer/stage.h"
#include "scene/lights/slide.h"
#include "scene/material.h"
#include "viewer/picture/reference.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIZE = 16 };

static void check(bool ok, const char *what) {
    if (ok)
        return;
    fprintf(stderr, "dump: %s: %s\n", what, error_get());
    exit(EXIT_FAILURE);
}

/* --- what looks into a frame --- */

static void inspect_all(struct renderer *renderer) {
    struct inspect inspect;
    struct output_list outputs;
    renderer_outputs(renderer, &outputs);
    check(inspect_init(&inspect), "inspect");
    for (int i = 0; i < outputs.count; i++)
        check(inspect_draw(&inspect, renderer,
                           &(struct inspect_choice){.output = outputs.items[i].name,
                                                    .layer = -1,
                                                    .chosen = -1,
                                                    .width = 4 * SIZE,
                                                    .height = 4 * SIZE,
                                                    .scale = 1}),
              outputs.items[i].name);
    inspect_free(&inspect);
    struct image layers;
    image_init(&layers, SIZE, SIZE, "R G B");
    check(aov_append(renderer,
                     inspect_find(renderer, OUTPUT_VALS) ? "val,ao,id.node" : "ao,id.node", NULL,
                     &layers),
          "AOV");
    image_free(&layers);
    struct probe probe = {0};
    struct pick pick;
    check(probe_pick(&probe, renderer, .5f, .5f, &pick), "probe");
    probe_free(&probe);
}

static void show_window(void) {
    struct screen screen;
    check(screen_init(&screen), "screen");
    screen_free(&screen);
    struct reference reference = {0};
    struct image picture;
    image_init(&picture, SIZE, SIZE, "R G B");
    check(reference_take(&reference, &picture), "reference");
    reference_free(&reference);
}

/* --- what a renderer is made of --- */

/* Settings that go together or not at all are refused: they have no shaders. */
static bool make(struct renderer *renderer, const struct renderer_desc *desc) {
    if (!technique_check(desc->technique, &desc->settings) || !renderer_follow(renderer, desc))
        return false;
    renderer_render(renderer);
    if (desc->progressive) {
        renderer_add_pass(renderer, 0);
        renderer_add_pass(renderer, 1);
    }
    return true;
}

static void make_and_inspect(struct renderer *renderer, const struct renderer_desc *desc) {
    check(make(renderer, desc), desc->technique->name);
    inspect_all(renderer);
}

/* Those of a choice; of numbers one or two that are not the default. */
static int values_of(const struct setting *setting, bool thorough, char values[16][16]) {
    const struct option *option = setting->option;
    int count = 0;
    if (option->type == OPTION_CHOICE)
        for (; count < 16 && option->choices[count]; count++)
            snprintf(values[count], 16, "%s", option->choices[count]);
    else if (option->type == OPTION_FLAG)
        snprintf(values[count++], 16, "%s", option->default_value != 0 ? "off" : "on");
    else if (thorough) {
        if (option->default_value != option->minimum)
            snprintf(values[count++], 16, "%g", option->minimum);
        if (option->default_value == option->minimum || option->type == OPTION_INT)
            snprintf(values[count++], 16, "%g",
                     fmin(option->maximum, fmax(1, 4 * option->minimum)));
    }
    return count;
}

static bool is_of(const struct settings_part *part, const struct settings_part *const *parts) {
    while (*parts && *parts != part)
        parts++;
    return *parts != NULL;
}

/* One setting after another away from where the base has it. */
static void turn(struct renderer *renderer, const struct renderer_desc *base,
                 const struct settings_part *const *parts, bool thorough) {
    for (struct setting setting = {0}; settings_next(&base->settings, &setting);) {
        char values[16][16];
        int count = is_of(setting.part, parts) ? values_of(&setting, thorough, values) : 0;
        for (int i = 0; i < count; i++) {
            struct renderer_desc desc = *base;
            if (setting_parse(&setting, &desc.settings, values[i]))
                make(renderer, &desc);
        }
    }
}

/* As every technique has them: few VPLs, for imperfect shadow maps deal points out to each. */
static void init_settings(struct settings *settings) {
    renderer_settings_init(settings);
    check(settings_assign(settings, "vpls=64"), "vpls");
}

/* Paths of lamps next door, with a medium and caustics, too. */
static void make_progressive(struct renderer *renderer, struct renderer_desc desc) {
    desc.progressive = true;
    make(renderer, &desc);
    struct renderer_desc next_door = desc;
    check(settings_assign(&next_door.settings, "lights.importance=on lights.bounces=2"), "bounces");
    make(renderer, &next_door);
    check(settings_assign(&desc.settings, "medium.scatter=1"), "medium");
    make(renderer, &desc);
    check(settings_assign(&desc.settings, "caustics.surface=patches caustics.medium=lines"),
          "caustics");
    make(renderer, &desc);
    check(settings_assign(&desc.settings, "medium.scatter=0"), "medium");
    make(renderer, &desc);
}

static void make_technique(struct renderer *renderer, const struct technique *technique,
                           bool thorough) {
    struct renderer_desc desc = renderer->desc;
    init_settings(&desc.settings);
    desc.direct = NULL;
    desc.progressive = false;
    desc.technique = technique;
    make_and_inspect(renderer, &desc);
    turn(renderer, &desc, technique->parts, thorough);
    make_progressive(renderer, desc);
    for (const struct preset *p = technique->presets; p && p->name; p++) {
        struct renderer_desc preset = desc;
        preset.progressive = false;
        init_settings(&preset.settings);
        check(settings_assign(&preset.settings, p->settings), p->name);
        if (thorough)
            turn(renderer, &preset, technique->parts, true);
        make_and_inspect(renderer, &preset);
    }
}

static void make_direct(struct renderer *renderer, const struct direct_method *direct,
                        bool thorough) {
    static const struct settings_part *const parts[] = {&picture_part, &sky_part, &material_part,
                                                        NULL};
    struct renderer_desc desc = renderer->desc;
    init_settings(&desc.settings);
    desc.progressive = false;
    desc.technique = technique_find("unshadowed");
    desc.direct = direct;
    turn(renderer, &desc, direct->parts, thorough);
    turn(renderer, &desc, parts, thorough);
    make_progressive(renderer, desc);
}

static void init(struct renderer *renderer, const struct stage *stage) {
    struct renderer_desc desc = {.width = SIZE,
                                 .height = SIZE,
                                 .scene = &stage->scene,
                                 .geometry = &stage->geometry,
                                 .emitters = stage->emitters,
                                 .camera = stage->camera};
    init_settings(&desc.settings);
    check(renderer_init(renderer, &desc), stage->scene.path);
}

static void begin(struct renderer *renderer, struct stage *stage, const struct stage_desc *opened) {
    check(stage_init(stage, opened), opened->path);
    init(renderer, stage);
}

static void make_scene(const char *path, bool thorough) {
    struct stage stage;
    struct renderer renderer;
    begin(&renderer, &stage, &(struct stage_desc){.path = path});
    for (const struct technique *const *t = techniques; *t; t++)
        make_technique(&renderer, *t, thorough);
    for (const struct direct_method *const *d = direct_methods; *d; d++)
        make_direct(&renderer, *d, thorough);
    renderer_free(&renderer);
    stage_free(&stage);
}

/* Spots may have slides: of one white texel. */
static void make_with_slides(const char *path) {
    unsigned char white[4] = {255, 255, 255, 255};
    struct stage stage;
    struct renderer renderer;
    check(stage_init(&stage, &(struct stage_desc){.path = path}), path);
    stage.scene.slides = mem_alloc(1, sizeof *stage.scene.slides);
    stage.scene.slide_count = 1;
    slide_init(stage.scene.slides, 0, &(struct bitmap){.width = 1, .height = 1, .rgba = white});
    stage.emitters.items[0].slide = stage.scene.slides;
    init(&renderer, &stage);
    for (const struct technique *const *t = techniques; *t; t++)
        make_technique(&renderer, *t, false);
    for (const struct direct_method *const *d = direct_methods; *d; d++)
        make_direct(&renderer, *d, false);
    renderer_free(&renderer);
    stage_free(&stage);
}

/* More lights than have maps. */
static void make_with_many_lights(const char *path) {
    enum { COUNT = 17 };
    struct stage stage;
    struct renderer renderer;
    check(stage_init(&stage, &(struct stage_desc){.path = path}), path);
    struct emitter first = stage.emitters.items[0];
    stage.emitters.items = mem_resize(stage.emitters.items, COUNT, sizeof first);
    stage.emitters.count = COUNT;
    for (int i = 0; i < COUNT; i++)
        stage.emitters.items[i] = first;
    init(&renderer, &stage);
    for (const struct technique *const *t = techniques; *t; t++)
        make_technique(&renderer, *t, false);
    renderer_free(&renderer);
    stage_free(&stage);
}

/* Its glass and fog beside an environment. Glass reflects a part diffusely. */
static void make_under_sky(const char *path) {
    struct stage stage;
    struct renderer renderer;
    check(stage_init(&stage, &(struct stage_desc){.path = path, .environment = {"scenes/day.hdr"}}),
          path);
    for (int m = 0; m < stage.scene.material_count; m++)
        stage.scene.materials[m].transmission *= .8F;
    init(&renderer, &stage);
    make_progressive(&renderer, renderer.desc);
    renderer_free(&renderer);
    stage_free(&stage);
}

int main(int argc, char **argv) {
    if (argc < 3)
        return 2;
    null_driver_keep(argv[1]);
    log_set_level(LOG_QUIET);
    struct context *context = context_adopt(null_driver_getproc, false);
    check(context != NULL, "context");
    struct screen_times times;
    check(screen_time_ways(&times), "screen probe");
    for (int i = 2; i < argc; i++) {
        screen_set_way(SCREEN_FRAGMENT);
        make_scene(argv[i], i == 2);
        screen_set_way(SCREEN_COMPUTE);
        make_scene(argv[i], false);
        make_under_sky(argv[i]);
    }
    make_with_slides(argv[argc - 1]);
    make_with_many_lights(argv[argc - 1]);
    screen_set_way(SCREEN_FRAGMENT);
    make_with_slides(argv[argc - 1]);
    make_with_many_lights(argv[argc - 1]);
    show_window();
    context_free(context);
    printf("%d shaders\n", null_driver_count());
    return 0;
}
