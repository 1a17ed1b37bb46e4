/* Each option that --help-all lists, at each place where it may be given: it changes a file or the
 * text, or is refused, or a list has the reason why neither is so. An option without a value here
 * fails. */
#include "command_support.h"

#define SCENE "scenes/moving-spot.glb "
#define SMALL SCENE "--size 8x8 --environment @/sky.exr -v "
#define PROBED SCENE "--environment @/sky.exr -v --grid -.3,.5,.3,.6,0,0,0,0,-.6,2x1 "

/* Command lines to which each option of their subcommand is added. */
static const struct place {
    const char *command, *base;
    bool is_slow; /* tried in a long run alone */
} places[] = {
    {"compare", "@/a.exr @/b.exr", false},
    {"compare", "@/a.exr @/b.exr -o @/out/o.png", false},
    {"compare", "@/a.exr @/b.exr -o @/out/o.exr -m rmse", false},
    {"compare", "@/a.png --json @/b.png", false},
    {"export", SCENE "-o @/out/o --environment @/sky.exr", false},
    {"export", SCENE "-o @/out/o --environment @/sky.exr --format mitsuba", false},
    {"info", SCENE, false},
    {"info", "", true},
    {"probe", PROBED "--spp 4 -o @/out/o.csv", true},
    {"probe", PROBED "--by frame -o @/out/o.csv", true},
    {"reference", SMALL "--spp 1 -o @/out/o.exr", true},
    {"reference", SMALL "--spp 1 --bounces 0 -o @/out/o.exr", true},
    {"reference", SMALL "--technique vpl-raytraced -o @/out/o.exr", true},
    {"render", SMALL "-o @/out/o.exr", true},
    {"render", SMALL "-o @/out/o.pfm", true},
    {"render", SMALL "-o @/out/o.hdr", true},
    {"render", SMALL "-o @/out/o.tif", true},
    {"render", SMALL "-o @/out/o.png", true},
    {"render", SMALL "-o @/out/o.jpg --frames 1", true},
    {"render", SMALL "-o @/out/o.#.tga --frames 1..3x2", true},
    {"render", SMALL "-o @/out/o.mp4 --frames 0..1", true},
};

/* What is given for each option; for that of one subcommand alone where its name is in front. */
/* clang-format off */
static const char *const values[][2] = {
    {"aov", "ao"}, {"reference:aov", "uv"}, {"cameras", "@/views.txt"}, {"ao", ".5"}, {"background", "none"}, {"bounces", "3"}, {"budget", "50ms"}, {"by", "frame"},
    {"camera", "'0 eye=0,1,3 forward=0,0,-1'"}, {"centers", ""}, {"clip", "none"},
    {"context", "osmesa"}, {"denoise", ""}, {"device", "0"},
    {"direct", "cssm"}, {"environment", "@/sky2.exr"}, {"environment-strength", "2"},
    {"environment-turn", "90"}, {"first-pass", "3"}, {"format", "exr"}, {"export:format", "mitsuba"}, {"efficacy", "179"}, {"exposures", "-9,-8,2"},
    {"fps", "7"}, {"frames", "2"}, {"grid", "0,.5,0,1,0,0,0,0,-1,2x1"}, {"gl", ""}, {"gl-debug", ""}, {"glsl", "glsl"}, {"help", ""},
    {"help-all", ""}, {"json", ""}, {"layer", "direct"}, {"compare:layer", "Z"}, {"light", "sky"},
    {"light-paths", "1000"}, {"materials", "diffuse"}, {"max", "mae=0"}, {"max-error", "90%"},
    {"metric", "mae"}, {"noise", "50%"}, {"passes", "2"}, {"paths", "8"},
    {"ppd", "20"}, {"punctual-scale", "2"}, {"progress", "json"}, {"quality", "draft"}, {"quiet", ""},
    {"reference-layer", "Z"}, {"root", "scenes"}, {"scene", "0"}, {"variant", "0"}, {"screen-passes", "compute"}, {"seed", "5"},
    {"seen", ""}, {"set", "exposure=2"}, {"reference:set", "medium.scatter=.3"},
    {"size", "9x9"}, {"skip-existing", ""}, {"smooth", ""}, {"spp", "2"},
    {"stats", ""}, {"strict", ""}, {"technique", "unshadowed"}, {"reference:technique", "vpl-raytraced"},
    {"threads", "1"}, {"time", "3"}, {"top", "7"}, {"unit", "W/m2"}, {"verbose", ""},
};
/* clang-format on */

/* Those that may change nothing, and why. */
static const char *const without_effect[][2] = {
    {"context", "the same picture by another library"},
    {"device", "the device that is taken without it"},
    {"direct", "no light has a size"},
    {"gl", "all that info tells without a SCENE"},
    {"gl-debug", "OpenGL has no messages"},
    {"glsl", "the same shaders"},
    {"materials", "all surfaces are diffuse"},
    {"quiet", "commands without notes"},
    {"root", "a scene of one file"},
    {"scene", "the file has one scene"},
    {"screen-passes", "the same picture by other shaders"},
    {"set", "an exposure is for displays; the header of an EXR tells it"},
    {"skip-existing", "no file is there"},
    {"smooth", "the scene has no glass"},
    {"strict", "a scene without defects"},
    {"threads", "the same picture"},
    {"verbose", "it is given already"},
};

static bool may_change_nothing(const char *option) {
    for (size_t i = 0; i < sizeof without_effect / sizeof *without_effect; i++)
        if (strcmp(without_effect[i][0], option) == 0)
            return true;
    return false;
}

static const char *find_value(const char *command, const char *option) {
    const char *found = NULL;
    const char *own = form("%s:%s", command, option);
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        if (strcmp(values[i][0], own) == 0)
            return values[i][1];
        found = strcmp(values[i][0], option) == 0 ? values[i][1] : found;
    }
    if (!found)
        fail_msg("no value of %s --%s", command, option);
    return found;
}

/* Pictures of two brightnesses, and two skies. */
static int make_inputs(void **state) {
    (void)state;
    struct image image;
    bool ok = true;
    image_init(&image, 8, 4, "R G B Z");
    for (int n = 0; n < 4; n++) {
        static const char *const names[] = {"a.exr", "b.exr", "sky.exr", "sky2.exr"};
        for (int i = 0; i < 8 * 4 * 4; i++)
            image.pixels[i] = (float)(i * (n + 3) % 11) / 16;
        ok = ok && image_write(&image, scratch(names[n]));
    }
    image_free(&image);
    for (int n = 0; n < 2; n++) {
        unsigned char rgba[8 * 4 * 4];
        for (int i = 0; i < 8 * 4 * 4; i++)
            rgba[i] = (unsigned char)(i * (n + 3) % 251);
        ok = ok && bitmap_write(&(struct bitmap){8, 4, rgba}, scratch(n ? "b.png" : "a.png"));
    }
    write_text(scratch("views.txt"), "0 fov=.5\n0 fov=.6\n0 fov=.7\ntime=1 0 fov=.8\n");
    return ok ? 0 : -1;
}

/* Exit status; what is written and told, as one text. Times that are told become a letter. */
static int run_place(const struct place *place, const char *more, char *told, size_t size) {
    const char *line =
        form("rm -rf @/out && mkdir @/out && (%% %s %s %s; echo \"status $?\") 2>&1 | "
             "sed -E '/^manylight: (note: )?(start|level)|milliseconds/d; s/[0-9.]+ m?s//g' && "
             "cd @/out && find . -type f | sort | xargs -r md5sum",
             place->command, place->base, more);
    assert_int_equal(run_line(line), 0);
    snprintf(told, size, "%s", output);
    const char *status = strstr(output, "status ");
    assert_non_null(status);
    return atoi(status + strlen("status "));
}

/* A name of "  -o, --output FILE" or "  --size WxH", or NULL. */
static const char *option_of_line(const char *line, char name[64]) {
    const char *at = strstr(line, "--");
    if (strncmp(line, "  -", 3) != 0 || !at || at > line + 6)
        return NULL;
    snprintf(name, 64, "%.*s", (int)strspn(at + 2, "abcdefghijklmnopqrstuvwxyz-"), at + 2);
    return name;
}

static bool is_ignored(const struct place *place, const char *name, const char *base) {
    static char told[sizeof output];
    char more[256];
    snprintf(more, sizeof more, "--%s %s", name, find_value(place->command, name));
    int status = run_place(place, more, told, sizeof told);
    if (status != 0 && !strstr(told, "manylight "))
        fail_msg("%s %s: status %d without a word", place->command, more, status);
    snprintf(more, sizeof more, "--%s ", name);
    bool ignored = status == 0 && strcmp(told, base) == 0 && !may_change_nothing(name) &&
                   !strstr(place->base, more); /* the same once more */
    if (ignored)
        printf("    %s %s: --%s is ignored\n", place->command, place->base, name);
    return ignored;
}

TEST(options) {
    static char help[sizeof output], base[sizeof output];
    char name[64];
    int ignored = 0;
    bool has_ffmpeg = run_line("command -v ffmpeg") == 0;
    need_all_formats();
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        const struct place *place = places + i;
        if ((place->is_slow && !is_long_run()) || (strstr(place->base, ".mp4") && !has_ffmpeg))
            continue;
        expect_command(0, place->command, "--help-all");
        snprintf(help, sizeof help, "%s", output);
        assert_int_equal(run_place(place, "", base, sizeof base), 0);
        for (const char *line = help; line; line = strchr(line, '\n')) {
            line += *line == '\n';
            if (option_of_line(line, name) && strcmp(name, "output") != 0)
                ignored += is_ignored(place, name, base);
        }
    }
    assert_int_equal(ignored, 0);
}

/* Options that have no effect at a place: the same in a short run. */
TEST(refusals) {
    static const char *const wrong[][2] = {
        {"render a.glb -o a.exr --layer direct", "--layer is for formats of one layer"},
        {"render a.glb -o a.pfm --aov ao", "--aov is for formats that hold all layers"},
        {"render a.glb -o a.png --fps 24", "--fps is for --frames"},
        {"render a.glb -o a.png -q -v", "--verbose is for runs without --quiet"},
        {"reference a.glb -o a.exr --technique vpl-raytraced --spp 4", "--spp is for --tech"},
        {"reference a.glb -o a.exr --context egl", "--context is for --technique vpl-"},
        {"reference a.glb -o a.exr --bounces 0 --denoise", "--denoise is for --bounces of 1"},
        {NULL},
    };
    expect_refusals(2, "", wrong);
}

/* Formats of one layer hold the one that was asked for: that of an EXR. */
TEST(layers) {
    static const char *const formats[] = {"pfm", "hdr", "tif"};
    for (size_t i = 0; i < 2; i++) {
        const char *layer = i ? "direct" : "indirect";
        if (!is_tried_here(i, 2))
            continue;
        expect(
            0,
            form("%% render scenes/cornell-box.glb --technique unshadowed --size 16x16 --layer %s "
                 "-o @/l.exr -o @/l.pfm -o @/l.hdr%s",
                 layer, knows_format("tif") ? " -o @/l.tif" : ""));
        for (size_t f = 0; f < 3; f++) {
            if (!knows_format(formats[f]))
                continue;
            expect(0, form("%% compare @/l.%s @/l.exr --reference-layer %s -m rmse --max "
                           "relative-mae=.3%%",
                           formats[f], layer));
            expect(1, form("%% compare @/l.%s @/l.exr --max relative-mae=.3%%",
                           formats[f])); /* the picture is another one */
        }
    }
}

RUN_TESTS(make_inputs, NULL)
