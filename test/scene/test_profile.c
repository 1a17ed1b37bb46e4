/* Light profiles: files of all kinds made of known functions of direction, closed forms, pictures
 * against those of a point light and of the path tracer, and what is refused. */
#include "command_support.h"
#include "gltf_parts.h"

#include "base/text.h"
#include "metrics/colour.h"
#include "scene/lights/emitter.h"
#include "scene/lights/profile.h"

#include <cglm/util.h>

/* --- files of known functions ----------------------------------------------------------------- */

/* Intensity to the right, up and ahead, cd; symmetric about no plane, the axis, the plane of right,
 * of up, of both. */
enum symmetry { NONE, AROUND, UP, RIGHT, BOTH }; /* as EULUMDAT counts them */

static double intensity(enum symmetry symmetry, const double d[3]) {
    double value = 50 + 20 * d[2] + 10 * d[2] * d[2];
    if (symmetry != AROUND)
        value += 25 * d[0] * d[0];
    if (symmetry == UP || symmetry == NONE)
        value += 15 * d[0];
    if (symmetry == RIGHT || symmetry == NONE)
        value += 12 * d[1];
    return value;
}

static void direction_at(int type, double plane, double angle, double d[3]) {
    double p = plane * GLM_PI / 180, a = angle * GLM_PI / 180;
    double c[3] = {sin(a) * cos(p), sin(a) * sin(p), cos(a)};  /* around the axis */
    double b[3] = {sin(p), cos(p) * sin(a), cos(p) * cos(a)};  /* poles to the right and left */
    double at[3] = {sin(p) * cos(a), sin(a), cos(p) * cos(a)}; /* poles above and below */
    memcpy(d, type == PROFILE_C ? c : type == PROFILE_B ? b : at, sizeof c);
}

/* A file by its first line; angles from, to and by so many degrees. */
static const struct made {
    const char *head;
    int type; /* of LM-63; 0: EULUMDAT */
    enum symmetry symmetry;
    double planes[3], angles[3];
    double factor; /* of the candela that the file lists */
} made[] = {
    {"a lamp of 1986", 1, AROUND, {0, 0, 1}, {0, 180, 5}, 2},
    {"IESNA91", 1, BOTH, {0, 90, 10}, {0, 180, 5}, 1},
    {"IESNA:LM-63-1995\n[TEST] 1", 1, UP, {0, 180, 15}, {0, 180, 5}, 1},
    {"IESNA:LM-63-1995, 90 to 270", 1, RIGHT, {90, 270, 15}, {0, 180, 5}, 1},
    {"IESNA:LM-63-2002", 1, NONE, {0, 360, 15}, {0, 180, 5}, .5},
    {"IES:LM-63-2019, down", 1, NONE, {0, 360, 7.5}, {0, 90, 2.5}, 1},
    {"IES:LM-63-2019, up, to 345", 1, NONE, {0, 345, 15}, {90, 180, 2.5}, 1},
    {"type B", 2, NONE, {-90, 90, 5}, {-90, 90, 5}, 1},
    {"type B, half", 2, RIGHT, {0, 90, 5}, {-90, 90, 5}, 1},
    {"type A", 3, NONE, {-90, 90, 5}, {-90, 90, 5}, 1},
    {"EULUMDAT, none", 0, NONE, {0, 345, 15}, {0, 180, 5}, 1.5},
    {"EULUMDAT, around", 0, AROUND, {0, 345, 15}, {0, 180, 5}, 1.5},
    {"EULUMDAT, 0 to 180", 0, UP, {0, 345, 15}, {0, 180, 5}, 1.5},
    {"EULUMDAT, 90 to 270", 0, RIGHT, {0, 345, 15}, {0, 180, 5}, 1.5},
    {"EULUMDAT, quadrants", 0, BOTH, {0, 345, 15}, {0, 180, 5}, 1.5},
};
enum { MADE = sizeof made / sizeof *made, WHOLE = 4 };

static int count_of(const double range[3]) {
    return (int)lround((range[1] - range[0]) / range[2]) + 1;
}

static void print_range(struct text *text, const double range[3], char end) {
    for (int i = 0; i < count_of(range); i++)
        text_print(text, "%g%c", range[0] + i * range[2], end);
}

static char *print_file(const struct made *file) {
    struct text text = {0};
    int all = count_of(file->planes), n = count_of(file->angles), planes = all;
    double first = file->planes[0];
    if (file->type > 0) {
        text_print(&text, "%s\nTILT=%s\n1 -1 %g %d %d %d 2 0 0 0\n1 1 10\n", file->head,
                   file->symmetry == UP ? "INCLUDE\n1\n3\n0 45 90\n1 .9 .8" : "NONE", file->factor,
                   n, all, file->type);
        print_range(&text, file->angles, ' ');
        print_range(&text, file->planes, ',');
    } else {
        const int counts[] = {all, 1, all / 2 + 1, all / 2 + 1, all / 4 + 1};
        planes = counts[file->symmetry];
        first = file->symmetry == RIGHT ? 270 : 0;
        text_print(&text, "%s\r\n1\r\n%d\r\n%d\n15\n%d\n5\n", file->head, (int)file->symmetry, all,
                   n);
        text_print(&text, "report\nlamp\n1\nfile\ndate\n100\n0\n50\n90\n0\n0\n0\n0\n0\n100\n80\n"
                          "1\n0\n2\n1\nlamp\n1500\nwhite\n80\n20\n1\nlamp\n3000\nwhite\n80\n40\n"
                          "0\n0\n0\n0\n0\n0\n0\n0\n0\n0\n");
        print_range(&text, file->planes, '\n');
        print_range(&text, file->angles, '\n');
    }
    for (int i = 0; i < planes * n; i++) {
        double d[3];
        direction_at(file->type ? file->type : PROFILE_C, first + i / n * file->planes[2],
                     file->angles[0] + i % n * file->angles[2], d);
        text_print(&text, "%.6f\n", intensity(file->symmetry, d) / file->factor);
    }
    return text.data;
}

static bool is_within(const struct made *file, const double d[3]) {
    double away = acos(d[2]) * 180 / GLM_PI;
    return file->type > 1 ? d[2] > 0 : away >= file->angles[0] && away <= file->angles[1];
}

/* --- closed forms ----------------------------------------------------------------------------- */

/* Each direction has the function's intensity, so has a green light with the slide, and both have
 * its flux. */
TEST(files) {
    enum { STEPS = 40000 };
    for (int f = 0; f < MADE; f++) {
        char *text = print_file(&made[f]);
        struct profile profile;
        struct slide slide;
        bool is_whole = made[f].type < 2 && made[f].angles[1] - made[f].angles[0] == 180;
        double lumens = 0, shown = 0, worst = 0;
        check_ok(made[f].head, profile_parse(&profile, text));
        double mean = (double)slide_init_profile(&slide, 0, &profile);
        struct emitter light = emitter_new(EMITTER_POINT);
        light.slide = &slide;
        light.intensity[0] = light.intensity[2] = 0;
        light.intensity[1] = (float)(mean / .7152);
        for (int i = 0; i < STEPS; i++) {
            double z = -1 + 2 * (i + .5) / STEPS, turn = 2.399963 * i, r = sqrt(1 - z * z);
            double d[3] = {r * cos(turn), r * sin(turn), z};
            double expected = is_within(&made[f], d) ? intensity(made[f].symmetry, d) : 0;
            float rgb[3];
            emitter_intensity(&light, (float)acos(z), (float)atan2(d[1], d[0]), rgb);
            float own = rgb_luminance(rgb);
            shown += 4 * GLM_PI / STEPS * (double)own;
            lumens += 4 * GLM_PI / STEPS * expected;
            worst = fmax(worst, fabs(profile_candela(&profile, d) - expected));
            worst = is_whole ? fmax(worst, fabs((double)own - expected)) : worst;
        }
        check_at_most("cd, linear between angles", worst, 1);
        check_near("flux", 4 * GLM_PI * mean / lumens, 1, .005);
        check_near("as it is shown", shown / lumens, 1, .005);
        slide_free(&slide);
        profile_free(&profile);
        free(text);
    }
}

/* --- scenes ----------------------------------------------------------------------------------- */

#define SCALAR_AT(offset)                                                                          \
    "{bufferView: 0, byteOffset: " #offset ", componentType: 5126, count: 1, type: SCALAR}"
#define PARTS_CLIP "[" PARTS_QUAD ", " SCALAR_AT(64) ", " SCALAR_AT(68) "]"
#define PUNCTUAL "{KHR_lights_punctual: {light: 0}}"
#define LIGHT(more) "{KHR_lights_punctual: {lights: [{type: point" more "}]}}"

/* A floor of 12 m and a wall, of that albedo, and a light 3 m above the floor that looks down.
 * light, lights: extensions of its node and of the file. A clip has the time 0 and the value 3. */
static void write_scene(const char *name, const char *light, const char *lights, double albedo) {
    static const float clip[] = {0, 3};
    const char *materials = form("[{pbrMetallicRoughness: {metallicFactor: 0, baseColorFactor: "
                                 "[%g, %g, %g, 1]}, doubleSided: true}]",
                                 albedo, albedo, albedo);
    const char *nodes =
        form("[{mesh: 0, matrix: [12,0,0,0, 0,0,-12,0, 0,12,0,0, -6,0,6,1]}, {mesh: 0, matrix: "
             "[12,0,0,0, 0,12,0,0, 0,0,12,0, -6,0,-2,1]}, {translation: [0, 3, 0], rotation: "
             "[-0.70710678, 0, 0, 0.70710678], extensions: %s}]",
             light);
    const char *more = form("extensions: %s,", lights);
    write_parts(name, &PARTS(.accessors = PARTS_CLIP, .materials = materials, .nodes = nodes,
                             .more = more, EXTRA(clip)));
}

static void write_profile(const char *name, int f) {
    char *text = print_file(&made[f]);
    write_text(scratch(name), text);
    free(text);
}

/* A cosine is the Lambertian lamp of CIE 171's case 5.2; factors of the light, of the user and of
 * clips count. */
TEST(cosine) {
    struct text text = {0};
    text_print(&text, "TILT=NONE\n1 -1 10 91 1 1 2 0 0 0 1 1 9\n");
    for (int a = 0; a <= 90; a++)
        text_print(&text, "%d ", a);
    text_print(&text, "\n0\n");
    for (int a = 0; a <= 90; a++)
        text_print(&text, "%.7f ", 100 * cos(a * GLM_PI / 180));
    write_text(scratch("cosine.ies"), text.data);
    free(text.data);
    write_text(scratch("cosine.csv"), "0,0,0,0,1,0\n1,0,0,0,1,0\n1.5,0,1.5,0,1,0\n");
    write_scene("ies.glb", "{EXT_lights_ies: {light: 0, multiplier: 2, color: [0.5, 0.5, 0.5]}}",
                "{EXT_lights_ies: {lights: [{uri: 'cosine.ies'}]}}", 0);
    write_scene(
        "clip.glb", PUNCTUAL,
        LIGHT(
            ", intensity: 1.5, extras: {profile: 'cosine.ies'}") ", animations: [{samplers: "
                                                                 "[{input: 2, output: 3}], "
                                                                 "channels: [{sampler: 0, target: "
                                                                 "{path: pointer, extensions: "
                                                                 "{KHR_animation_pointer: "
                                                                 "{pointer: "
                                                                 "'/extensions/KHR_lights_punctual/"
                                                                 "lights/0/intensity'}}}}]}]",
        0);
    static const char *const lines[] = {
        "% probe @/clip.glb @/cosine.csv --bounces 0 -q --punctual-scale .3333333",
        "% probe @/ies.glb @/cosine.csv --bounces 0 -q",
        "% probe @/ies.glb @/cosine.csv --by frame --bounces 1 -q",
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        static const double expected[] = {1000 / 9., 90, 1000 * 9 / (13.5 * 13.5)};
        expect(0, lines[i]);
        const char *at = output;
        for (int row = 0; row < 3; row++) {
            at = strchr(at, '\n') + 1;
            for (int column = 0; column < 6; column++)
                at = strchr(at, ',') + 1;
            check_near("lx", strtod(at, NULL), expected[row], .002 * expected[row]);
        }
    }
}

/* A profile of one intensity is a point light, in all that lights do. */
TEST(constant) {
    static const char *const draws[] = {
        "render %s --size 32x24 -o %s",
        "render %s --size 32x24 -o %s --technique implicit-visibility",
        "render %s --size 32x24 -o %s --technique imperfect-volume",
        "render %s --size 32x24 -o %s --set lights.bounces=2 --set medium.scatter=.1",
        "reference %s --size 32x24 -o %s --spp 4 --bounces 2",
    };
    write_scene(
        "even.glb", PUNCTUAL,
        LIGHT(
            ", extras: {profile: 'data:,TILT=NONE%0A1 -1 1 2 1 1 2 0 0 0 1 1 9 0 180 0 100 100'}"),
        .7);
    write_scene("point.glb", PUNCTUAL, LIGHT(", intensity: 100"), .7);
    for (size_t i = 0; i < sizeof draws / sizeof *draws; i++) {
        char line[512];
        if (!is_tried_here(i, 2))
            continue;
        snprintf(line, sizeof line, draws[i], "@/even.glb", "@/even.exr -q");
        expect_command(0, line, "");
        snprintf(line, sizeof line, draws[i], "@/point.glb", "@/point.exr -q");
        expect_command(0, line, "");
        expect_command(0, "compare", "@/even.exr @/point.exr --max relative-rmse=.2%");
        expect_command(0, "compare", "@/even.exr @/point.exr -l indirect --max relative-rmse=.5%");
    }
}

/* A profile without symmetry, in a turned light, by shaders and by rays. */
TEST(turned) {
    write_profile("whole.ies", WHOLE);
    write_profile("around.ies", 0);
    write_scene("whole.glb", "{EXT_lights_ies: {light: 1}}",
                "{EXT_lights_ies: {lights: [{uri: 'around.ies'}, {uri: 'whole.ies'}]}}", .7);
    expect_command(0, "render", "@/whole.glb --size 48x36 -q -o @/frame.exr --set samples=1");
    expect_command(0, "reference",
                   "@/whole.glb --size 48x36 -q -o @/traced.exr --spp 64 --centers");
    expect_command(0, "compare", "@/frame.exr @/traced.exr -l direct --max relative-rmse=.5%");
    expect_command(0, "compare", "@/frame.exr @/traced.exr -l indirect --max relative-bias=3%");
    expect_command(1, "render", "@/whole.glb -o @/no.exr --light '0 size=1,0'");
    expect_text("a light with a profile is a point without a size");
    expect_command(0, "info", "@/whole.glb");
    expect_text("by a profile");
}

/* --- refusals --------------------------------------------------------------------------------- */

TEST(broken_files) {
#define IES(counts, rest) "TILT=NONE\n1 1 1 " counts " 2 0 0 0 1 1 1\n" rest
    static const char *const files[][2] = {
        {"", "EULUMDAT, as there is no line TILT=: line 1: the file ends"},
        {"TILT=NONE\n", "line 2: the file ends before number of lamps"},
        {"TILT=NONE\n1 1 one", "line 2: candela multiplier: 'one' is no number"},
        {"TILT=NONE\n1 1 0", "line 2: candela multiplier: 0 is not from"},
        {"TILT=NONE\n1 1 1\n2.5", "line 3: number of vertical angles: 2.5 is no whole number"},
        {"TILT=NONE\n1 1 1\n2 1 4", "line 3: photometric type: 4 is not from 1 to 3"},
        {"TILT=NONE\n1 1 1\n99999 1 1", "line 3: number of vertical angles: 99999 is not from"},
        {IES("2 1 1", "90\n0\n0\n1 1"), "vertical angles: 0 does not increase"},
        {IES("2 1 1", "0 90\n0\n1"), "line 5: the file ends before candela"},
        {IES("2 1 1", "0 90\n0\n1 -1"), "line 5: candela: -1 is not from"},
        {IES("2 1 1", "0 90\n0\n1 nan"), "line 5: candela: 'nan' is no number"},
        {IES("2 1 1", "0 90\n0\n0 0"), "it has no light"},
        {IES("2 2 1", "0 90\n0 45\n1 1 1 1"), "from 0 to 45 degrees have no"},
        {IES("2 2 2", "0 180\n0 90\n1 1 1 1"), "from 0 to 180 degrees are"},
        {"TILT=INCLUDE\n1\n9\n0 90\n", "line 5: the file ends before TILT"},
        {"maker\n1\n7\n", "line 3: symmetry: 7 is not from 0 to 4"},
        {"maker\n1\n\n4\n", "line 3: symmetry is missing"},
        {"maker\n1\n0\n36\n12,5\n", "line 5: distance of C-planes: '12,5' is no number"},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct profile profile;
        check_refused(profile_parse(&profile, files[i][0]), files[i][1]);
        assert_null(profile.candela);
    }
}

TEST(refusals) {
    static const char ies[] = "{EXT_lights_ies: {light: 0}}";
    static const struct {
        const char *light, *lights, *says;
    } rows[] = {
        {PUNCTUAL, LIGHT(", extras: {profile: 'none.ies'}"),
         "light 0: extras: profile: cannot open"},
        {PUNCTUAL, LIGHT(", extras: {profile: 7}"), "profile: it is no file's name"},
        {PUNCTUAL, LIGHT(", extras: {profile: 'cut.ies', radius: 1}"),
         "only a point light without"},
        {PUNCTUAL, LIGHT(", extras: {profile: 'cut.ies'}"),
         "light 0: extras: profile: cut.ies: line 2: the file ends before"},
        {ies, "{EXT_lights_ies: {lights: [{name: a}]}}",
         "light profile 0: neither uri nor bufferView"},
        {ies, "{EXT_lights_ies: {lights: [{bufferView: 0}]}}",
         "light profile 0: buffer view 0: EULUMDAT"},
    };
    write_text(scratch("cut.ies"), "TILT=NONE\n1 1 1 2 1 1");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        write_scene("broken.glb", rows[i].light, rows[i].lights, .5);
        expect_command(1, "info", "@/broken.glb");
        expect_text(rows[i].says);
    }
}

RUN_TESTS(NULL, NULL)
