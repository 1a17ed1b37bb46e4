/* Light profiles: files of all kinds made of known functions of direction, closed forms, pictures
 * against those of a point light and of the path tracer, and what is refused. */
#include "command_support.h"
#include "gltf_parts.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/text.h"
#include "scene/lights/emitter.h"
#include "scene/lights/profile.h"

#include <cglm/util.h>
#include <math.h>
#include <stdlib.h>

/* --- files of known functions ----------------------------------------------------------------- */

/* Intensity to the right, up and ahead, cd; by its symmetry: across both planes, across the plane
 * of up, of right, of none; and around the axis. */
enum symmetry { BOTH, UP, RIGHT, NONE, AROUND };

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

/* Angles of a file: from, to, step. */
static const struct made {
    const char *name, *header, *lamps; /* after TILT=; up to the multiplier */
    int type;                          /* of LM-63; 0: EULUMDAT */
    enum symmetry symmetry;
    double planes[3], angles[3];
    double factor; /* of what the file lists */
    int isym;
} made[] = {
    {"1986, around",
     "lamp of a test\nTILT=NONE",
     "1 1000 2",
     1,
     AROUND,
     {0, 0, 1},
     {0, 180, 5},
     2,
     0},
    {"1991, quadrants",
     "IESNA91\n[TEST] 1\nTILT=NONE",
     "1 1000 1",
     1,
     BOTH,
     {0, 90, 10},
     {0, 180, 5},
     1,
     0},
    {"1995, 0 to 180",
     "IESNA:LM-63-1995\n[MANUFAC] x\nTILT=INCLUDE\n1\n3\n0 45 90\n1 .9 .8",
     "1 1000 1",
     1,
     UP,
     {0, 180, 15},
     {0, 180, 5},
     1,
     0},
    {"1995, 90 to 270",
     "IESNA:LM-63-1995\nTILT=NONE",
     "1 1000 1",
     1,
     RIGHT,
     {90, 270, 15},
     {0, 180, 5},
     1,
     0},
    {"2002, whole",
     "IESNA:LM-63-2002\nTILT=NONE",
     "2 -1 .5",
     1,
     NONE,
     {0, 360, 15},
     {0, 180, 5},
     .5,
     0},
    {"2019, downwards",
     "IES:LM-63-2019\n[TEST] 2\nTILT=NONE",
     "1 -1 1",
     1,
     NONE,
     {0, 360, 7.5},
     {0, 90, 2.5},
     1,
     0},
    {"2019, upwards, to 345",
     "IES:LM-63-2019\nTILT=NONE",
     "1 -1 1",
     1,
     NONE,
     {0, 345, 15},
     {90, 180, 2.5},
     1,
     0},
    {"type B", "IESNA:LM-63-2002\nTILT=NONE", "1 -1 1", 2, NONE, {-90, 90, 5}, {-90, 90, 5}, 1, 0},
    {"type B, half",
     "IESNA:LM-63-2002\nTILT=NONE",
     "1 -1 1",
     2,
     RIGHT,
     {0, 90, 5},
     {-90, 90, 5},
     1,
     0},
    {"type A", "IESNA:LM-63-1995\nTILT=NONE", "1 -1 1", 3, NONE, {-90, 90, 5}, {-90, 90, 5}, 1, 0},
    {"EULUMDAT, none", NULL, NULL, 0, NONE, {0, 345, 15}, {0, 180, 5}, 1.5, 0},
    {"EULUMDAT, around", NULL, NULL, 0, AROUND, {0, 345, 15}, {0, 180, 5}, 1.5, 1},
    {"EULUMDAT, 0 to 180", NULL, NULL, 0, UP, {0, 345, 15}, {0, 180, 5}, 1.5, 2},
    {"EULUMDAT, 90 to 270", NULL, NULL, 0, RIGHT, {0, 345, 15}, {0, 180, 5}, 1.5, 3},
    {"EULUMDAT, quadrants", NULL, NULL, 0, BOTH, {0, 345, 15}, {0, 180, 5}, 1.5, 4},
};
enum { MADE = sizeof made / sizeof *made };

static int count_of(const double range[3]) {
    return (int)lround((range[1] - range[0]) / range[2]) + 1;
}

static void print_range(struct text *text, const double range[3], char end) {
    for (int i = 0; i < count_of(range); i++)
        text_print(text, "%g%c", range[0] + i * range[2], end);
}

static void print_candela(struct text *text, const struct made *file, double first, int planes) {
    for (int p = 0; p < planes; p++)
        for (int a = 0; a < count_of(file->angles); a++) {
            double d[3];
            direction_at(file->type ? file->type : PROFILE_C, first + p * file->planes[2],
                         file->angles[0] + a * file->angles[2], d);
            text_print(text, "%.6f\n", intensity(file->symmetry, d) / file->factor);
        }
}

static char *print_eulumdat(const struct made *file) {
    static const char head[] = "maker\r\n1\r\n";
    struct text text = {0};
    int all = count_of(file->planes), n = count_of(file->angles);
    int count[] = {all, 1, all / 2 + 1, all / 2 + 1, all / 4 + 1};
    text_print(&text, "%s%d\r\n%d\r\n15\r\n%d\r\n5\r\n", head, file->isym, all, n);
    text_print(&text,
               "report\nlamp\n1\nfile\ndate\n100\n0\n50\n90\n0\n0\n0\n0\n0\n100\n80\n1\n0\n");
    text_print(&text, "2\n1\nlamp\n1500\nwhite\n80\n20\n1\nlamp\n3000\nwhite\n80\n40\n");
    text_print(&text, "0\n0\n0\n0\n0\n0\n0\n0\n0\n0\n");
    print_range(&text, file->planes, '\n');
    print_range(&text, file->angles, '\n');
    print_candela(&text, file, file->isym == 3 ? 270 : 0, count[file->isym]);
    return text.data;
}

static char *print_file(const struct made *file) {
    struct text text = {0};
    if (file->type == 0)
        return print_eulumdat(file);
    text_print(&text, "%s\n%s %d %d %d 2 0 0 0\n1 1 10\n", file->header, file->lamps,
               count_of(file->angles), count_of(file->planes), file->type);
    print_range(&text, file->angles, ' ');
    text_print(&text, "\n");
    print_range(&text, file->planes, ',');
    text_print(&text, "\n");
    print_candela(&text, file, file->planes[0], count_of(file->planes));
    return text.data;
}

static bool is_within(const struct made *file, const double d[3]) {
    double away = acos(d[2]) * 180 / GLM_PI;
    return file->type > 1 ? d[2] > 0 : away >= file->angles[0] && away <= file->angles[1];
}

/* --- closed forms ----------------------------------------------------------------------------- */

static void test_directions(void **state) {
    (void)state;
    for (int f = 0; f < MADE; f++) {
        char *text = print_file(&made[f]);
        struct profile profile;
        double worst = 0;
        check_ok(made[f].name, profile_parse(&profile, text));
        for (int i = 0; i < 2000; i++) {
            double z = -1 + (i + .5) / 1000, turn = 2.399963 * i, r = sqrt(1 - z * z);
            double d[3] = {r * cos(turn), r * sin(turn), z};
            double expected = is_within(&made[f], d) ? intensity(made[f].symmetry, d) : 0;
            worst = fmax(worst, fabs(profile_candela(&profile, d) - expected));
        }
        check_at_most(made[f].name, worst, 1); /* linear between angles */
        profile_free(&profile);
        free(text);
    }
}

/* The light that shines is that of the file: 4 pi times the mean intensity, and what the slide has.
 */
static void test_flux(void **state) {
    (void)state;
    for (int f = 0; f < MADE; f++) {
        char *text = print_file(&made[f]);
        struct profile profile;
        struct slide slide;
        double lumens = 0, shown = 0;
        enum { STEPS = 40000 };
        check_ok(made[f].name, profile_parse(&profile, text));
        double mean = (double)slide_init_profile(&slide, 0, &profile);
        struct emitter light = emitter_new(EMITTER_POINT);
        light.slide = &slide;
        for (int i = 0; i < STEPS; i++) {
            double z = -1 + 2 * (i + .5) / STEPS, turn = 2.399963 * i, r = sqrt(1 - z * z);
            double d[3] = {r * cos(turn), r * sin(turn), z};
            float world[3], rgb[3];
            for (int c = 0; c < 3; c++)
                world[c] = (float)(d[0] * (double)light.right[c] + d[1] * (double)light.up[c] +
                                   d[2] * (double)light.direction[c]);
            emitter_slide(&light, world, rgb);
            shown += 4 * GLM_PI / STEPS * mean * (double)rgb[1];
            lumens +=
                is_within(&made[f], d) ? 4 * GLM_PI / STEPS * intensity(made[f].symmetry, d) : 0;
        }
        check_near(made[f].name, 4 * GLM_PI * mean / lumens, 1, .005);
        check_near("as it is shown", shown / lumens, 1, .005);
        slide_free(&slide);
        profile_free(&profile);
        free(text);
    }
}

/* --- scenes ----------------------------------------------------------------------------------- */

/* A floor of 12 m and a wall, of that albedo, and a light 3 m above the floor that looks down, with
 * its right to the right; or turned. */
static void write_scene(const char *name, const char *light, const char *more, double albedo) {
    static const float clip[] = {0, 3}; /* a time and a value */
    static const char accessors[] =
        "[{\"bufferView\": 0, \"componentType\": 5126, \"count\": 4, \"type\": \"VEC3\"},"
        " {\"bufferView\": 0, \"byteOffset\": 48, \"componentType\": 5123, \"count\": 6,"
        " \"type\": \"SCALAR\"}, {\"bufferView\": 0, \"byteOffset\": 64, \"componentType\":"
        " 5126, \"count\": 1, \"type\": \"SCALAR\"}, {\"bufferView\": 0, \"byteOffset\": 68,"
        " \"componentType\": 5126, \"count\": 1, \"type\": \"SCALAR\"}]";
    char nodes[2048], materials[256], all[2048];
    snprintf(materials, sizeof materials,
             "[{\"pbrMetallicRoughness\": {\"metallicFactor\": 0, \"baseColorFactor\":"
             " [%g, %g, %g, 1]}, \"doubleSided\": true}]",
             albedo, albedo, albedo);
    snprintf(nodes, sizeof nodes,
             "[{\"mesh\": 0, \"matrix\": [12,0,0,0, 0,0,-12,0, 0,12,0,0, -6,0,6,1]},"
             " {\"mesh\": 0, \"matrix\": [12,0,0,0, 0,12,0,0, 0,0,12,0, -6,0,-2,1]},"
             " {\"translation\": [0, 3, 0], \"rotation\": [-0.70710678, 0, 0, 0.70710678], %s}]",
             light);
    snprintf(all, sizeof all, "%s \"extensionsUsed\": [\"KHR_lights_punctual\"],", more);
    write_parts(name, &(struct gltf_parts){.accessors = accessors,
                                           .materials = materials,
                                           .nodes = nodes,
                                           .more = all,
                                           .extra = clip,
                                           .extra_size = sizeof clip});
}

#define PUNCTUAL "\"extensions\": {\"KHR_lights_punctual\": {\"light\": 0}}"

/* As extras of a point light. */
static void write_extras_scene(const char *name, const char *extras, double albedo) {
    char more[1024];
    snprintf(more, sizeof more,
             "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"type\": \"point\"%s}]}},",
             extras);
    write_scene(name, PUNCTUAL, more, albedo);
}

static void write_profile(const char *name, int f) {
    char *text = print_file(&made[f]);
    write_text(scratch(name), text);
    free(text);
}

/* A cosine is the Lambertian lamp of CIE 171's case 5.2, at any place of the file: in a file beside
 * the scene, in data, in a buffer view. */
static void test_cosine(void **state) {
    (void)state;
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
    write_scene("ies.glb",
                "\"extensions\": {\"EXT_lights_ies\": {\"light\": 0, \"multiplier\": 2,"
                " \"color\": [0.5, 0.5, 0.5]}}",
                "\"extensions\": {\"EXT_lights_ies\": {\"lights\": [{\"uri\": \"cosine.ies\"}]}},",
                0);
    write_extras_scene("extras.glb", ", \"extras\": {\"profile\": \"cosine.ies\"}", 0);
    write_scene("clip.glb", PUNCTUAL,
                "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"type\": \"point\","
                " \"intensity\": 1.5, \"extras\": {\"profile\": \"cosine.ies\"}}]}},"
                " \"animations\": [{\"samplers\": [{\"input\": 2, \"output\": 3}], \"channels\":"
                " [{\"sampler\": 0, \"target\": {\"path\": \"pointer\", \"extensions\":"
                " {\"KHR_animation_pointer\": {\"pointer\": \"/extensions/KHR_lights_punctual/"
                "lights/0/intensity\"}}}}]}],",
                0);
    static const char *const lines[] = {
        "% probe @/clip.glb @/cosine.csv --bounces 0 -q --punctual-scale .3333333",
        "% probe @/ies.glb @/cosine.csv --bounces 0 -q",
        "% probe @/extras.glb @/cosine.csv --bounces 0 -q",
        "% probe @/ies.glb @/cosine.csv --by frame --bounces 1 -q",
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        static const double expected[] = {1000 / 9., 90, 1000 * 9 / (13.5 * 13.5)};
        expect(0, lines[i]);
        const char *at = output;
        for (int row = 0; row < 3; row++) {
            double x, y, z, nx, ny, nz, direct, indirect;
            at = strchr(at, '\n') + 1;
            assert_int_equal(sscanf(at, "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &x, &y, &z, &nx, &ny,
                                    &nz, &direct, &indirect),
                             8);
            check_near("lx", direct, expected[row], .002 * expected[row]);
        }
    }
}

/* A profile of one intensity is a point light, in all that lights do. */
static void test_constant(void **state) {
    (void)state;
    static const char *const draws[] = {
        "render %s --size 32x24 -o %s",
        "render %s --size 32x24 -o %s --technique implicit-visibility",
        "render %s --size 32x24 -o %s --technique imperfect-volume",
        "render %s --size 32x24 -o %s --set lights.bounces=2 --set medium.scatter=.1",
        "reference %s --size 32x24 -o %s --spp 4 --bounces 2",
    };
    write_text(scratch("even.ies"), "TILT=NONE\n1 -1 1 2 1 1 2 0 0 0 1 1 9 0 180 0 100 100");
    write_extras_scene("even.glb", ", \"extras\": {\"profile\": \"even.ies\"}", .7);
    write_extras_scene("point.glb", ", \"intensity\": 100", .7);
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
static void test_turned(void **state) {
    (void)state;
    write_profile("whole.ies", 4);
    write_profile("around.ies", 0);
    write_scene("whole.glb", "\"extensions\": {\"EXT_lights_ies\": {\"light\": 1}}",
                "\"extensions\": {\"EXT_lights_ies\": {\"lights\": [{\"uri\": \"around.ies\"},"
                " {\"uri\": \"whole.ies\"}]}},",
                .7);
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

static void test_broken_files(void **state) {
    (void)state;
    static const struct {
        const char *text, *says;
    } files[] = {
        {"", "EULUMDAT, as there is no line TILT=: line 1: the file ends"},
        {"TILT=NONE\n", "line 2: the file ends before number of lamps"},
        {"TILT=NONE\n1 1 one", "line 2: candela multiplier: 'one' is no number"},
        {"TILT=NONE\n1 1 0", "line 2: candela multiplier: 0 is not from"},
        {"TILT=NONE\n1 1 1\n2.5", "line 3: number of vertical angles: 2.5 is no whole number"},
        {"TILT=NONE\n1 1 1\n2 1 4", "line 3: photometric type: 4 is not from 1 to 3"},
        {"TILT=NONE\n1 1 1\n99999 1 1", "line 3: number of vertical angles: 99999 is not from"},
        {"TILT=NONE\n1 1 1 2 1 1 2 0 0 0 1 1 1\n90\n0\n0\n1 1", "vertical angles: 0 does not inc"},
        {"TILT=NONE\n1 1 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n1",
         "line 5: the file ends before candela"},
        {"TILT=NONE\n1 1 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n1 -1", "line 5: candela: -1 is not from"},
        {"TILT=NONE\n1 1 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n1 nan",
         "line 5: candela: 'nan' is no num"},
        {"TILT=NONE\n1 1 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n0 0", "it has no light"},
        {"TILT=NONE\n1 1 1 2 2 1 2 0 0 0 1 1 1\n0 90\n0 45\n1 1 1 1",
         "from 0 to 45 degrees have no"},
        {"TILT=NONE\n1 1 1 2 2 2 2 0 0 0 1 1 1\n0 180\n0 90\n1 1 1 1", "from 0 to 180 degrees are"},
        {"TILT=INCLUDE\n1\n9\n0 90\n", "line 5: the file ends before TILT"},
        {"maker\n1\n7\n", "line 3: symmetry: 7 is not from 0 to 4"},
        {"maker\n1\n\n4\n", "line 3: symmetry is missing"},
        {"maker\n1\n4\n6\n15\n2\n1\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n1\n0\n1\n1\n\n9\n\n\n\n1\n1\n1"
         "\n"
         "1\n1\n1\n1\n1\n1\n1\n",
         "line 4: 6 C-planes do not have the symmetry 4"},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct profile profile;
        check_refused(profile_parse(&profile, files[i].text), files[i].says);
        assert_null(profile.candela);
    }
}

/* A file cut anywhere is refused, or read where only blanks are lost. */
static void test_cut_files(void **state) {
    (void)state;
    for (int f = 0; f < MADE; f += 10) {
        char *text = print_file(&made[f]);
        int read = 0;
        size_t length = strlen(text);
        for (size_t cut = 0; cut<length; cut += cut> 600 && cut + 99 < length ? 97 : 1) {
            char kept = text[cut];
            struct profile profile;
            text[cut] = '\0';
            if (profile_parse(&profile, text)) {
                read++;
                profile_free(&profile);
            }
            text[cut] = kept;
        }
        check_at_most("files that are read in spite of a cut", read, 9);
        free(text);
    }
}

static void test_refusals(void **state) {
    (void)state;
    static const struct {
        const char *extras, *says;
    } lights[] = {
        {", \"extras\": {\"profile\": \"none.ies\"}", "light 0: extras: profile: cannot open"},
        {", \"extras\": {\"profile\": 7}", "light 0: extras: profile: it is no file's name"},
        {", \"extras\": {\"profile\": \"cut.ies\", \"radius\": 1}", "only a point light without"},
        {", \"extras\": {\"profile\": \"cut.ies\"}",
         "light 0: extras: profile: cut.ies: line 2: the file ends before"},
    };
    write_text(scratch("cut.ies"), "TILT=NONE\n1 1 1 2 1 1");
    for (size_t i = 0; i < sizeof lights / sizeof *lights; i++) {
        write_extras_scene("broken.glb", lights[i].extras, .5);
        expect_command(1, "info", "@/broken.glb");
        expect_text(lights[i].says);
    }
    write_scene("broken.glb", "\"extensions\": {\"EXT_lights_ies\": {\"light\": 0}}",
                "\"extensions\": {\"EXT_lights_ies\": {\"lights\": [{\"name\": \"a\"}]}},", .5);
    expect_command(1, "info", "@/broken.glb");
    expect_text("light profile 0: neither uri nor bufferView");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_directions), cmocka_unit_test(test_flux),
        cmocka_unit_test(test_cosine),     cmocka_unit_test(test_constant),
        cmocka_unit_test(test_turned),     cmocka_unit_test(test_broken_files),
        cmocka_unit_test(test_cut_files),  cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
