#include "apps/render_options.h"
#include "apps/outputs.h"

#include "quality/quality.h"
#include "renderer/renderer.h"

static const struct option options[] = {
    {"output", 'o', OPTION_LIST, offsetof(struct render_values, outputs), .value_name = "FILE",
     .help = "picture to write, in the format of its extension; or, with --frames, a video (.mp4,\n"
             ".mov, .mkv, .webm) through ffmpeg; repeatable"},
    FORMAT_OPTION(struct render_values, format),
    {"size", 0, OPTION_SIZE, offsetof(struct render_values, size), 0, 1, 16384, .help = SIZE_HELP},
    {"quality", 0, OPTION_CHOICE, offsetof(struct render_values, quality), QUALITY_NORMAL,
     .choices = quality_names,
     .help = "choice of settings and passes by name;\n"
             "--set and --passes override it"},
    {"max-error", 0, OPTION_FLOAT, offsetof(struct render_values, max_error), 0, 0, 1,
     .value_name = "X%",
     .help = "limit of the relative RMSE of indirect light; path-traces about\n"
             "9000 pixels at --time, then uses the cheapest setting within the limit;\n"
             "a single picture by software OpenGL may be path-traced; 0: off"},
    {"budget", 0, OPTION_FLOAT, offsetof(struct render_values, budget), 0, 0, 1e6,
     .value_name = "Xms", .unit = "ms",
     .help =
         "time per frame, ms: adapts settings not given by --set, from the times of the frames\n"
         "before; frames then depend on the machine and on each other; a single picture by\n"
         "software OpenGL is path-traced where that errs less; 0: off"},
    TECHNIQUE_OPTIONS(struct render_values, technique),
    {"layer", 0, OPTION_CHOICE, offsetof(struct render_values, layer), .choices = shown_layer_names,
     .help = "light that PNG, JPEG and similar formats\n"
             "show; EXR has all layers"},
    {"background", 0, OPTION_TEXT, offsetof(struct render_values, background),
     .value_name = "none|COLOUR",
     .help = "background in place of black or the environment, which still lights the scene:\n"
             "\"none\" makes PNG and TGA transparent; a display colour, #rrggbb or r,g,b from\n"
             "0 to 1, fills them; EXR and TIFF then have surfaces alone, with coverage in A",
     .rare = true},
    {"aov", 0, OPTION_TEXT, offsetof(struct render_values, aov), .value_name = "NAME[,NAME ...]",
     .help =
         "more layers of an EXR: outputs of the technique, for example gathered\n"
         "(before the blur), vpl (flux of VPLs), and with path=maps val (colour of the strongest\n"
         "VAL) and visibility (fraction of their light that arrives); with all techniques ao\n"
         "(ambient occlusion, by volume.*), id.node, id.mesh, id.material, position, depth, uv,\n"
         "motion.next and motion.previous (pixels to the frames 1 / fps away), and Cryptomatte by\n"
         "crypto.node, crypto.mesh, crypto.material",
     .rare = true},
    STAGE_OPTIONS(struct render_values, stage),
    SCENE_OPTION(struct render_values, stage.choice),
    VARIANT_OPTION(struct render_values, stage.choice),
    {"frames", 0, OPTION_TEXT, offsetof(struct render_values, frames), .value_name = "A..B|A,B,C",
     .help = "frames of a sequence, A..BxN every Nth; frame 0 is at --time; ####, @@@@, %04d or\n"
             "$F4 in the output's name becomes the number of the frame"},
    {"cameras", 0, OPTION_TEXT, offsetof(struct render_values, cameras), .value_name = "FILE",
     .help =
         "views in place of frames, a line of FILE each, numbered from 0: the text of --camera,\n"
         "which may begin with time=SECONDS; --frames chooses some",
     .rare = true},
    {"fps", 0, OPTION_TEXT, offsetof(struct render_values, fps), .value_name = "X|N/M",
     .help = "frames per second of a sequence; 24000/1001, or 23.976, 29.97 and 59.94 for the\n"
             "rates of NTSC [25]",
     .rare = true},
    {"passes", 0, OPTION_INT, offsetof(struct render_values, passes), 0, 0, 1000000,
     .help = "number of passes, each with its own VPLs and pixel positions; the\n"
             "picture is their mean and converges; passes after the first have own\n"
             "settings, which --set overrides; 0: by --quality, 64 for final, else 1"},
    {"first-pass", 0, OPTION_INT, offsetof(struct render_values, first_pass), 0, 0, 1000000,
     .help = "number of the first pass, for passes shared by processes;\n"
             "manylight average joins their EXR files to the same mean",
     .rare = true},
    {"skip-existing", 0, OPTION_FLAG, offsetof(struct render_values, skip_existing),
     .help = "leave out frames whose files exist and are whole: each is decoded to its last pixel",
     .rare = true},
    {"stats", 0, OPTION_FLAG, offsetof(struct render_values, stats),
     .help = "print faces, lights, memory and time per pass"},
    {"glsl", 0, OPTION_TEXT, offsetof(struct render_values, glsl), .value_name = "DIR",
     .help = "folder of shaders, a glsl/ with src/ beside it, in place of the built-in shaders",
     .rare = true},
    CONTEXT_OPTIONS(struct render_values, context),
    {NULL},
};

static void print_sequences(FILE *out) {
    fprintf(
        out,
        "\na sequence, split between processes by GNU parallel or by a job array of Slurm:\n"
        "  seq 0 25 225 | parallel 'manylight render S.glb -o out.####.exr --skip-existing \\\n"
        "      --frames {}..$(({} + 24))'\n"
        "  sbatch --array=0-9 --wrap 'i=$((SLURM_ARRAY_TASK_ID * 25)); manylight render S.glb \\\n"
        "      -o out.####.exr --skip-existing --frames $i..$((i + 24))'\n");
}

static void print_more(FILE *out, const void *values) {
    const struct render_values *own = values;
    if (own->common.help_all)
        print_sequences(out);
    technique_values_print_help(out, &own->technique, own->common.help_all);
}

const struct arguments render_arguments = {
    .synopsis = "SCENE -o FILE [OPTION ...]",
    .summary =
        "Renders a glTF scene without a window. EXR and PFM hold linear radiance, EXR all layers;\n"
        "PNG, JPEG and similar formats hold the picture as a display shows it. A frame depends "
        "only\n"
        "on its time, so processes can share a sequence; --budget is the exception. A file "
        "appears\n"
        "when it is whole, synced and read back, so a killed sequence can be resumed.\n"
        "Ctrl-C ends after the current frame or a second, Ctrl-\\ at once.\n"
        "SCENE - is standard input; -o - is standard output, in the format of --format.",
    .options = options,
    .opens_scenes = true,
    .shows_progress = true,
    .min_positional = 1,
    .max_positional = 1,
    .print_more = print_more,
};
