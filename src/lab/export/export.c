/* manylight export: a scene for other renderers. */
#include "apps/arguments.h"
#include "apps/interrupt.h"
#include "apps/options.h"
#include "apps/subcommands.h"

#include "base/error.h"
#include "base/file/output_file.h"
#include "base/memory.h"
#include "lab/export/meshes.h"
#include "scene/texture.h"

#include <string.h>

enum export_format { FORMAT_PACK, FORMAT_MITSUBA };

static const char *const format_names[] = {"pack", "mitsuba", NULL};
static bool (*const exporters[])(struct export_target *) = {export_pack, export_mitsuba};

struct values {
    struct common_values common;
    struct stage_desc stage;
    const char *output;
    int format, size[2], bounces, samples, materials;
};

static const struct option options[] = {
    {"output", 'o', OPTION_TEXT, offsetof(struct values, output), .value_name = "FOLDER",
     .help = "folder to make; an error if it exists"},
    {"format", 0, OPTION_CHOICE, offsetof(struct values, format), .choices = format_names,
     .help = "pack: GLB, and camera and lights as JSON; mitsuba: XML of Mitsuba 3"},
    {"size", 0, OPTION_SIZE, offsetof(struct values, size), 0, 1, 16384, .help = SIZE_HELP},
    {"bounces", 0, OPTION_INT, offsetof(struct values, bounces), 1, 0, 1000,
     .help = "number of indirect bounces; 0: direct light only"},
    {"spp", 0, OPTION_INT, offsetof(struct values, samples), 256, 1, 1e6,
     .help = "samples per pixel of the file for Mitsuba"},
    {"materials", 0, OPTION_CHOICE, offsetof(struct values, materials), .choices = materials_names,
     .help = "materials of surfaces: as near to glTF's as the\n"
             "format has them, or diffuse in their base colour"},
    STAGE_OPTIONS(struct values, stage),
    SCENE_OPTION(struct values, stage.choice),
    VARIANT_OPTION(struct values, stage.choice),
    {NULL},
};

static const struct arguments arguments = {
    .synopsis = "SCENE -o FOLDER [OPTION ...]",
    .summary =
        "Writes a scene for other renderers: triangles, camera and lights as they are at one\n"
        "time. Notes, repeated in the files, name what the format cannot say.\n"
        "bench/entries/README.md tells how to draw a pack and how to score the picture.\n"
        "SCENE - is standard input.",
    .options = options,
    .opens_scenes = true,
    .min_positional = 1,
    .max_positional = 1,
};

/* --- the scene -------------------------------------------------------------------------------- */

static void note_scene(struct export_target *target, int format) {
    const struct medium *medium = &target->stage->scene.medium;
    static const struct medium none = {0};
    if (memcmp(medium, &none, sizeof none) != 0)
        export_note(target, "the medium is left out");
    for (int i = 0; i < target->stage->emitters.count; i++) {
        const struct emitter *emitter = &target->stage->emitters.items[i];
        if (format == FORMAT_PACK && emitter_has_slide(emitter))
            export_note(target, "light %d: its slide is left out", emitter->number);
    }
    if (format == FORMAT_PACK && target->stage->scene.clip_count > 0)
        export_note(target, "the scene moves: draw it at %.9g s with all clips",
                    target->stage->geometry.pose.time);
}

static bool export_stage(const struct values *values, const struct stage *stage) {
    struct export_target target = {.stage = stage,
                                   .width = values->size[0],
                                   .height = values->size[1],
                                   .bounces = values->bounces,
                                   .samples = values->samples,
                                   .materials = (enum materials)values->materials};
    int size[2];
    if (stage->camera.shift[0] != 0 || stage->camera.shift[1] != 0)
        return error_set("camera: the files hold no shifted lens");
    if (camera_axis_norm2(stage->camera.right) != 1)
        return error_set("camera: the files hold no pixels that are not square");
    stage_default_size(stage, size);
    if (target.width == 0) {
        target.width = size[0];
        target.height = size[1];
    }
    interrupts_catch();
    char *folder = output_folder_begin(values->output);
    if (!folder)
        return false;
    target.folder = folder;
    texture_decode_table(target.srgb_to_linear);
    export_meshes_find(&target);
    note_scene(&target, values->format);
    bool ok = exporters[values->format](&target) && !interrupt_came();
    export_meshes_free(&target);
    free(target.notes.data);
    ok = output_folder_end(folder, values->output, ok);
    interrupts_obey();
    return ok;
}

int app_export(int argc, char **argv) {
    struct values values = {0};
    struct stage stage;
    int count, status;
    if (!arguments_parse(&arguments, &values, argc, argv, &values.stage.path, &count, &status))
        return status;
    const struct option_use uses[] = {{"spp", values.format != FORMAT_PACK, "--format mitsuba"},
                                      {NULL}};
    if (!values.output)
        error_set("-o FOLDER is missing");
    if (!values.output || !arguments_check_use(&values.common, uses))
        return arguments_misuse(argv[0]);
    if (!stage_init(&stage, &values.stage))
        return arguments_fail(argv[0]);
    bool ok = export_stage(&values, &stage);
    stage_free(&stage);
    return ok ? STATUS_OK : arguments_fail(argv[0]);
}
