/* A picture is the same, bit by bit, whatever renders it in software: with any number of threads,
 * any width of vectors, with and without AVX2, and again. Only processors before AVX differ, by how
 * they round halves. */
#include "command_support.h"

#include "base/file/file.h"

/* The bytes of the scene's picture, rendered or traced, with these variables of the environment. */
static struct file_bytes picture(const char *arguments, const char *environment) {
    struct file_bytes bytes;
    const char *command = form("%s %s %s -o %s --size 64x64 -q", environment, binary_path(),
                               arguments, scratch("bits.exr"));
    assert_int_equal(run_command(command, output, sizeof output), 0);
    check_ok("picture", file_read(&bytes, scratch("bits.exr")));
    return bytes;
}

/* What a driver's variables do is known of llvmpipe. */
static void skip_without_llvmpipe(void) {
    expect(0, "% info --gl");
    if (!strstr(output, "llvmpipe"))
        skip();
}

static void check_same(const char *arguments, const char *const *environments, int count) {
    struct file_bytes expected = picture(arguments, "");
    for (int i = 0; i < count; i++) {
        struct file_bytes bytes = picture(arguments, environments[i]);
        size_t differing = bytes.size != expected.size;
        for (size_t k = 0; k < bytes.size && k < expected.size; k++)
            differing += bytes.data[k] != expected.data[k];
        printf("    %-36s %-32s %zu of %zu bytes differ\n", arguments, environments[i], differing,
               expected.size);
        assert_int_equal(differing, 0);
        free(bytes.data);
    }
    free(expected.data);
}

TEST(rendered) {
    static const char *const scenes[] = {"cornell-box", "character"};
    static const char *const environments[] = {
        "",
        "LP_NUM_THREADS=0",
        "LP_NUM_THREADS=1",
        "LP_NATIVE_VECTOR_WIDTH=128",
        "GALLIUM_OVERRIDE_CPU_CAPS=avx",
    };
    skip_without_llvmpipe();
    for (int i = 0; i < 2; i++) {
        const char *arguments = form("render scenes/%s.glb", scenes[i]);
        check_same(arguments, environments,
                   i == 0 || is_long_run() ? sizeof environments / sizeof *environments : 2);
    }
}

/* The path tracer: each thread takes other pixels each time. */
TEST(traced) {
    static const char *const environments[] = {"", "taskset -c 0"};
    check_same("reference scenes/metaballs.glb --spp 2", environments, 2);
}

TEST(without_avx) {
    double error = NAN;
    skip_without_llvmpipe();
    struct file_bytes bytes = picture("render scenes/cornell-box.glb", "");
    free(bytes.data);
    rename(scratch("bits.exr"), scratch("bits-avx.exr"));
    bytes = picture("render scenes/cornell-box.glb", "GALLIUM_OVERRIDE_CPU_CAPS=sse4.1");
    free(bytes.data);
    expect(0, "% compare @/bits.exr @/bits-avx.exr -l indirect -m relative-rmse");
    assert_int_equal(sscanf(output, "relative-rmse %lf", &error), 1);
    /* Measured: .0175; of it all but .0035 are other lights that answer for others where
     * detail is. */
    check_at_most("relative RMSE without AVX", error, .03);
}

RUN_TESTS(NULL, NULL)
