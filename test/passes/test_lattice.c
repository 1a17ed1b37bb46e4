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

static const char *const libraries[] = {"lib/lattice.glsl", "lib/weighted_pick.glsl",
                                        "passes/gather/representative.glsl", "shared/types.h",
                                        "shared/bindings.h"};

static const char body[] =
    "#include \"passes/gather/representative.glsl\"\n"
    "layout(local_size_x = 8, local_size_y = 8) in;\n"
    "layout(std430, binding = 0) writeonly buffer numbers { float number[]; };\n"
    "void main() {\n"
    "    ivec2 at = ivec2(gl_GlobalInvocationID.xy);\n"
    "    number[at.y * SIDE + at.x] = group_random(at * APART, 0.0);\n"
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
    snprintf(defines, sizeof defines, "SIDE %d;APART %d;RECEIVERS 0;RECEIVERS_ADAPTIVE 1", SIDE,
             APART);
    glsl_set_folder(write_shaders());
    check_ok("numbers", program_init(&program, &(struct program_desc){.compute = "numbers.comp",
                                                                      .defines = defines}) &&
                            buffer_init(&buffer, "numbers", SIDE * SIDE * sizeof *numbers, NULL));
    glsl_set_folder(NULL);
    pass_begin(&untimed, &(struct pass_state){
                             .name = "numbers", .program = program, .storages = {{0, &buffer}}});
    pass_dispatch(SIDE / 8, SIDE / 8, 1);
    pass_end(&untimed);
    buffer_read(&buffer, 0, SIDE * SIDE * sizeof *numbers, numbers);
    buffer_free(&buffer);
    program_free(&program);
}

/* Each is the fraction of x steps along x and y along y: against integers, and against the multiples that these stand
 * for. */
static void test_numbers(void **state) {
    (void)state;
    static float numbers[SIDE * SIDE];
    double wrong = 0, furthest = 0;
    need_file("glsl/lib/lattice.glsl");
    read_numbers(numbers);
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        uint32_t x = i % SIDE * APART, y = i / SIDE * APART;
        uint32_t turns = x * 3242174889u + y * 2447445414u;
        double multiple = x * .7548776662466927 + y * .5698402909980532;
        double number = (double)numbers[i], off = fabs(number - (multiple - floor(multiple)));
        wrong = fmax(wrong, fabs(number - (turns >> 8) / 16777216.));
        furthest = fmax(furthest, fmin(off, 1 - off));
    }
    check_at_most("off the integers' number", wrong, 0);
    check_at_most("off the fraction of the multiple", furthest, 3e-6);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_numbers),
    };
    return cmocka_run_group_tests_name("lattice", tests, open_group_context, close_group_context);
}
