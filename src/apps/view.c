/* manylight view: the desktop viewer. */
#include "apps/arguments.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/subcommands.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/file/output_file.h"
#include "quality/quality.h"
#include "viewer/viewer.h"

struct values {
    struct common_values common;
    struct technique_values technique;
    struct viewer_desc viewer;
    const char *format;
};

OPTION_ASSERT_SIZE(struct viewer_desc, width, height);

static const struct option options[] = {
    {"size", 0, OPTION_SIZE, offsetof(struct values, viewer.width), 800, 16, 16384,
     .help = "size of the picture, pixels"},
    {"budget", 0, OPTION_FLOAT, offsetof(struct values, viewer.budget), 0, 0, 1e6,
     .value_name = "Xms", .unit = "ms",
     .help = "time per frame, ms: adapts settings not given by\n"
             "--set, from the times of the frames before; 0: off"},
    TECHNIQUE_OPTIONS(struct values, technique),
    STAGE_OPTIONS(struct values, viewer),
    SCENE_OPTION(struct values, viewer.choice),
    VARIANT_OPTION(struct values, viewer.choice),
    {"layer", 0, OPTION_CHOICE, offsetof(struct values, viewer.layer), .choices = shown_layer_names,
     .help = "light to show"},
    {"passes", 0, OPTION_INT, offsetof(struct values, viewer.passes), 0, 0, 1000000,
     .help =
         "number of passes whose mean the picture becomes while nothing moves, as in manylight\n"
         "render --passes; 1: a single frame; 0: 1024, on software OpenGL 1"},
    {"reference", 0, OPTION_TEXT, offsetof(struct values, viewer.reference), .value_name = "FILE",
     .help = "picture of the same view to compare with"},
    {"frames", 0, OPTION_INT, offsetof(struct values, viewer.frames), 0, 0, 1e9,
     .help = "number of frames to render at full size before exit; 0: until closed"},
    {"screenshot", 0, OPTION_TEXT, offsetof(struct values, viewer.screenshot), .value_name = "FILE",
     .help = "file for the picture after --frames (or the first frame), before exit"},
    FORMAT_OPTION(struct values, format),
    {"settings", 0, OPTION_TEXT, offsetof(struct values, viewer.session), .value_name = "FILE",
     .help = "file of settings, camera and lights saved by\n"
             "the panel; replaces --set, --camera, --light"},
    {"scale", 0, OPTION_FLOAT, offsetof(struct values, viewer.scale), 0, 0, 4,
     .help = "scale of text and widgets; 0: the monitor's"},
    {"full-screen", 0, OPTION_FLAG, offsetof(struct values, viewer.full_screen),
     .help = "start in full screen; F11 returns to a window"},
    {"no-panel", 0, OPTION_FLAG, offsetof(struct values, viewer.no_panel),
     .help = "show only the picture; F2 brings the panel"},
    {"places", 0, OPTION_TEXT, offsetof(struct values, viewer.places), .value_name = "FILE",
     .help = "file that gets the rectangle of each widget as \"x y width height name\", for\n"
             "scripts; its last line counts the F9 presses after which everything was drawn"},
    {"glsl", 0, OPTION_TEXT, offsetof(struct values, viewer.glsl), .value_name = "DIR",
     .help = "folder of shaders, a glsl/ with src/ beside it, in\n"
             "place of the built-in shaders; F5 reads them again"},
    SCREEN_OPTION(struct values, viewer.screen),
    {"gl-debug", 0, OPTION_FLAG, offsetof(struct values, viewer.debug),
     .help = "debug context, which prints messages of OpenGL to standard error"},
    {NULL},
};

static void print_techniques(FILE *out, const void *values) {
    const struct values *own = values;
    technique_values_print_help(out, &own->technique, own->common.help_all);
}

static const struct arguments arguments = {
    .synopsis = "[SCENE] [OPTION ...]",
    .summary = "Shows a glTF scene in a window, rendered live. F1 lists keys and mouse actions.\n"
               "SCENE - is standard input.",
    .options = options,
    .opens_scenes = true,
    .max_positional = 1,
    .print_more = print_techniques,
};

/* A picture to be looked at is exposed by itself, and bright light in it rolls off, unless it is
 * told otherwise; one that is written is as manylight render has it. */
static void choose_tone(struct values *values) {
    struct viewer_desc *desc = &values->viewer;
    if (desc->frames || desc->screenshot || desc->session)
        return;
    desc->auto_exposure = !technique_values_name(&values->technique, &picture_part, "exposure");
    struct picture_settings picture =
        *settings_of(struct picture_settings, &desc->settings, &picture_part);
    if (!technique_values_name(&values->technique, &picture_part, "tone-map"))
        picture.tone_map = TONE_MAP_FILMIC;
    settings_set(&desc->settings, &picture_part, &picture);
}

int app_view(int argc, char **argv) {
    struct values values = {0};
    const char *scene;
    int count, status;
    if (!arguments_parse(&arguments, &values, argc, argv, &scene, &count, &status))
        return status;
    struct viewer_desc *desc = &values.viewer;
    const char *screenshot = desc->screenshot;
    desc->scene = scene;
    desc->given = &values.technique.settings;
    bool is_float;
    if (!technique_values_resolve(&values.technique, &desc->technique, &desc->direct,
                                  &desc->settings) ||
        !outputs_use_format(&screenshot, 1, values.format) ||
        (screenshot && !image_format_is_float(screenshot, &is_float)))
        return arguments_misuse(argv[0]);
    if (desc->budget > 0 && quality_is_preset(desc->given->items, desc->given->count)) {
        error_set("--budget excludes path=, which sets what it would choose");
        return arguments_misuse(argv[0]);
    }
    choose_tone(&values);
    if ((desc->frames || screenshot) && !scene) {
        error_set("--frames and --screenshot need a scene");
        return arguments_misuse(argv[0]);
    }
    if (screenshot && !output_file_check(screenshot, (const char *[]){scene, desc->reference}, 2))
        return arguments_fail(argv[0]);
    return viewer_run(desc) ? STATUS_OK : arguments_fail(argv[0]);
}
