/* Numbers by which one of many is taken (glsl/lib/lattice.glsl): the same bits on every driver, whatever it rounds. */
#include "support.h"

#include "gl/glsl.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "render_support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { SIDE = 64, APART = 127 }; /* pixels of a picture of 8K, one in APART along each side */
enum { GROUP, PLACE_X, PLACE_Y, TEST, KINDS };

static const char *const libraries[] = {"lib/lattice.glsl",           "lib/weighted_pick.glsl",
                                        "gather/representative.glsl", "gather/correction_test.glsl",
                                        "shared/correction.h",        "shared/types.h",
                                        "shared/bindings.h"};

static const char body[] =
    "#include \"gather/representative.glsl\"\n"
    "#include \"gather/correction_test.glsl\"\n"
    "layout(local_size_x = 8, local_size_y = 8) in;\n"
    "layout(std430, binding = 0) writeonly buffer numbers { float number[]; };\n"
    "void main() {\n"
    "    ivec2 at = ivec2(gl_GlobalInvocationID.xy);\n"
    "    int i = KINDS * (at.y * SIDE + at.x);\n"
    "    number[i] = group_random(at * APART, 0.0);\n"
    "    vec2 place = fract(test_place(at) * float(CORRECTION_SIDE));\n"
    "    number[i + 1] = place.x;\n"
    "    number[i + 2] = place.y;\n"
    "    number[i + 3] = test_random(at);\n"
    "}\n";

static void copy_library(const char *folder, const char *name) {
    static char text[1 << 15];
    char from[256], to[640];
    snprintf(from, sizeof from, "glsl/%s", name);
    snprintf(to, sizeof to, "%s/%s", folder, name);
    FILE *in = fopen(from, "r"), *out = fopen(to, "w");
    assert_true(in && out);
    size_t size = fread(text, 1, sizeof text, in);
    assert_true(size < sizeof text && fwrite(text, 1, size, out) == size);
    fclose(in);
    assert_int_equal(fclose(out), 0);
}

static const char *write_shaders(void) {
    static char folder[512];
    static const char *const parts[] = {"", "/lib", "/gather", "/shared"};
    char path[640];
    snprintf(folder, sizeof folder, "%s", scratch("lattice_glsl"));
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        snprintf(path, sizeof path, "%s%s", folder, parts[i]);
        mkdir(path, 0777);
    }
    for (size_t i = 0; i < sizeof libraries / sizeof *libraries; i++)
        copy_library(folder, libraries[i]);
    snprintf(path, sizeof path, "%s/numbers.comp", folder);
    FILE *file = fopen(path, "w");
    assert_true(file && fputs(body, file) >= 0 && fclose(file) == 0);
    return folder;
}

static void read_numbers(float *numbers) {
    GLuint program;
    struct buffer buffer;
    struct timers untimed = {0};
    char defines[96];
    snprintf(defines, sizeof defines, "SIDE %d;APART %d;KINDS %d;RECEIVERS 0;RECEIVERS_ADAPTIVE 1",
             SIDE, APART, KINDS);
    glsl_set_folder(write_shaders());
    check_ok("numbers",
             program_init(&program,
                          &(struct program_desc){.compute = "numbers.comp", .defines = defines}) &&
                 buffer_init(&buffer, "numbers", SIDE * SIDE * KINDS * sizeof *numbers, NULL));
    glsl_set_folder(NULL);
    pass_begin(&untimed, &(struct pass_state){
                             .name = "numbers", .program = program, .storages = {{0, &buffer}}});
    pass_dispatch(SIDE / 8, SIDE / 8, 1);
    pass_end(&untimed);
    buffer_read(&buffer, 0, SIDE * SIDE * KINDS * sizeof *numbers, numbers);
    buffer_free(&buffer);
    program_free(&program);
}

/* Each is the fraction of x steps along x, y along y, and of the start. */
static const struct kind {
    const char *name;
    int apart;
    uint32_t x, y, start;
    double step_x, step_y;
} kinds[KINDS] = {
    [GROUP] = {"groups", APART, 3242174889u, 2447445414u, 0, .7548776662466927, .5698402909980532},
    [PLACE_X] = {"places, x", 1, 3242174889u, 2654435769u, 3242174889u / 2, .7548776662466927,
                 .6180339887498949},
    [PLACE_Y] = {"places, y", 1, 2447445414u, 1779033704u, 2447445414u / 2, .5698402909980532,
                 .4142135623730950},
    [TEST] = {"tests", 1, 2654435769u, 3144134278u, 0, .6180339887498949, .7320508075688773},
};

/* Against integers; and against the multiples that they stand for. A place lies in one of 8 cells along each side, so
 * that its number has lost three bits. */
static void check_numbers(const struct kind *kind, const float *numbers) {
    const double most = kind->start ? 8 / 16777216. : 0;
    double wrong = 0, furthest = 0;
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        uint32_t x = i % SIDE * (uint32_t)kind->apart, y = i / SIDE * (uint32_t)kind->apart;
        uint32_t turns = x * kind->x + y * kind->y + kind->start;
        double multiple =
            x * kind->step_x + y * kind->step_y + (kind->start ? kind->step_x / 2 : 0);
        double number = (double)numbers[i * KINDS];
        double off = fabs(number - (multiple - floor(multiple)));
        wrong = fmax(wrong, fabs(number - (turns >> 8) / 16777216.));
        furthest = fmax(furthest, fmin(off, 1 - off));
    }
    printf("    %s\n", kind->name);
    check_at_most("off the integers' number", wrong, most);
    check_at_most("off the fraction of the multiple", furthest, 3e-6);
}

static void test_numbers(void **state) {
    (void)state;
    static float numbers[SIDE * SIDE * KINDS];
    need_file("glsl/lib/lattice.glsl");
    read_numbers(numbers);
    for (int i = 0; i < KINDS; i++)
        check_numbers(&kinds[i], numbers + i);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_numbers),
    };
    return cmocka_run_group_tests_name("lattice", tests, open_group_context, close_group_context);
}
