/* manylight render: pictures offscreen. */
#include "apps/apps.h"
#include "apps/arguments.h"
#include "apps/context_options.h"
#include "apps/stats.h"

#include "base/error.h"
#include "base/image_file.h"
#include "gl/glsl.h"
#include "renderer/renderer.h"

#include <string.h>

struct values {
    struct common_values common;
    struct context_desc context;
    struct text_list outputs, settings;
    int size[2];
    int technique;
    const char *camera, *light, *glsl;
    float time;
    bool stats;
};

static const struct option options[] = {
    {"output", 'o', OPTION_LIST, offsetof(struct values, outputs), .value_name = "FILE",
     .help = "picture to write; the extension picks the format; repeatable"},
    {"size", 0, OPTION_SIZE, offsetof(struct values, size), 800, 1, 16384,
     .help = "of the picture, pixels"},
    {"technique", 0, OPTION_CHOICE, offsetof(struct values, technique), .choices = technique_names,
     .help = "how indirect light is made"},
    {"set", 0, OPTION_LIST, offsetof(struct values, settings), .value_name = "KEY=VALUE",
     .help = "a setting of the list below; repeatable"},
    {"camera", 0, OPTION_TEXT, offsetof(struct values, camera), .value_name = "NAME|N",
     .help = "camera of the scene [the first]"},
    {"light", 0, OPTION_TEXT, offsetof(struct values, light), .value_name = "NAME|N",
     .help = "light of the scene [the first]"},
    {"time", 0, OPTION_FLOAT, offsetof(struct values, time), 0, 0, 1e6,
     .help = "of the animation, seconds"},
    {"stats", 0, OPTION_FLAG, offsetof(struct values, stats),
     .help = "print faces, lights, memory and time per pass"},
    {"glsl", 0, OPTION_TEXT, offsetof(struct values, glsl), .value_name = "DIR",
     .help = "read the shaders from this folder, not from the binary"},
    CONTEXT_OPTIONS(struct values, context),
    {NULL},
};

static void print_settings(FILE *out) {
    fprintf(out, "\nsettings, for --set:\n");
    options_print_help(out, settings_table, "");
}

static const struct arguments arguments = {
    .synopsis = "SCENE -o FILE [OPTION ...]",
    .summary =
        "Renders a glTF scene offscreen. EXR and PFM get linear radiance, EXR with all layers;\n"
        "PNG, JPEG and the like get the picture as a display shows it.",
    .options = options,
    .min_positional = 1,
    .max_positional = 1,
    .print_more = print_settings,
};

static bool check_outputs(const struct values *values) {
    if (values->outputs.count == 0)
        return error_set("no output: -o FILE");
    bool is_float;
    for (int i = 0; i < values->outputs.count; i++)
        if (!image_format_is_float(values->outputs.items[i], &is_float))
            return false;
    return true;
}

static bool parse_settings(const struct values *values, struct settings *settings) {
    options_set_defaults(settings_table, settings);
    for (int i = 0; i < values->settings.count; i++)
        if (!option_assign(settings_table, settings, values->settings.items[i]))
            return false;
    return settings_check(settings);
}

static bool write_output(struct renderer *renderer, const char *path) {
    bool is_float, ok;
    if (!image_format_is_float(path, &is_float))
        return false;
    if (is_float) {
        struct image image;
        ok = renderer_read_layers(renderer, &image) && image_write(&image, path);
        image_free(&image);
    } else {
        struct bitmap bitmap;
        renderer_read_display(renderer, &bitmap);
        ok = bitmap_write(&bitmap, path);
        bitmap_free(&bitmap);
    }
    return ok;
}

/* Which of the scene's cameras and lights, and where they are. */
static bool place(const struct values *values, const struct scene *scene,
                  struct renderer_desc *desc) {
    int camera = values->camera ? camera_find(scene, values->camera) : 0;
    int light = values->light ? light_find(scene, values->light) : 0;
    if (camera < 0 || light < 0)
        return false;
    camera_place(&desc->camera, scene, camera, values->time);
    light_place(&desc->light, scene, light, values->time);
    return true;
}

static bool render(const struct values *values, const struct renderer_desc *desc) {
    struct renderer renderer;
    if (!renderer_init(&renderer, desc))
        return false;
    renderer_render(&renderer);
    if (values->stats) {
        renderer_render(&renderer); /* the first frame also compiled */
        stats_print(&renderer);
    }
    bool ok = true;
    for (int i = 0; ok && i < values->outputs.count; i++)
        ok = write_output(&renderer, values->outputs.items[i]);
    renderer_free(&renderer);
    return ok;
}

static bool render_scene(const struct values *values, const struct settings *settings,
                         const char *path) {
    struct scene scene = {0};
    struct geometry geometry = {0};
    struct renderer_desc desc = {
        .width = values->size[0],
        .height = values->size[1],
        .technique = values->technique,
        .settings = *settings,
        .scene = &scene,
        .geometry = &geometry,
        .timed = values->stats,
    };
    struct context *context = NULL;
    bool ok = scene_load(&scene, path) && geometry_init(&geometry, &scene, values->time) &&
              place(values, &scene, &desc) && (context = context_create(&values->context));
    if (ok) {
        desc.software = context_is_software(context);
        ok = render(values, &desc);
        context_free(context);
    }
    geometry_free(&geometry);
    scene_free(&scene);
    return ok;
}

int app_render(int argc, char **argv) {
    struct values values;
    struct settings settings;
    const char *scene;
    int count, status;
    if (!arguments_parse(&arguments, &values, argc, argv, &scene, &count, &status))
        return status;
    if (!check_outputs(&values) || !parse_settings(&values, &settings))
        return arguments_misuse(argv[0]);
    glsl_set_folder(values.glsl);
    return render_scene(&values, &settings, scene) ? STATUS_OK : arguments_fail(argv[0]);
}
