/* The gl floor's objects: shaders and their messages, programs, textures, the ledger of memory,
 * timers. */
#define _POSIX_C_SOURCE 200809L
#include "render_support.h"

#include "gl/buffer.h"
#include "gl/framebuffer.h"
#include "gl/glsl.h"
#include "gl/memory.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "gl/timer.h"

#include <sys/stat.h>
#include <time.h>

/* --- shaders ---------------------------------------------------------------------------------- */

static const char *shader_folder(void) {
    static char folder[512];
    snprintf(folder, sizeof folder, "%s", scratch("glsl"));
    mkdir(folder, 0777);
    return folder;
}

static void write_shader(const char *name, const char *text) {
    const char *path = form("%s/%s", shader_folder(), name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static int use_shader_folder(void **state) {
    (void)state;
    static const char *const folders[] = {"lib", "../src", "../src/techniques", "../src/direct"};
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        const char *path = form("%s/%s", shader_folder(), folders[i]);
        mkdir(path, 0777);
    }
    glsl_set_folder(shader_folder());
    return 0;
}

static int use_embedded_shaders(void **state) {
    (void)state;
    glsl_set_folder(NULL);
    return 0;
}

static void expect_error(const char *part) {
    printf("    %s\n", error_get());
    if (!strstr(error_get(), part))
        fail_msg("'%s' is not in: %s", part, error_get());
}

TEST_WITH(includes, use_shader_folder, use_embedded_shaders) {
    struct glsl_source source;
    write_shader("main.frag", "#include \"lib/a.glsl\"\n#include \"lib/b.glsl\"\nint own;\n");
    write_shader("lib/a.glsl", "#include \"lib/b.glsl\"\nint a;\n");
    write_shader("lib/b.glsl", "int b;\n");
    check_ok("load", glsl_load(&source, "main.frag", "ONE 1;TWO 2"));
    assert_int_equal(source.file_count, 3);
    assert_string_equal(source.files[0], "main.frag");
    assert_string_equal(source.files[1], "lib/a.glsl");
    /* Below its defines, and each file's own below what it includes. */
    const char *head = "#version 450 core\n#define ONE 1\n#define TWO 2\n";
    assert_memory_equal(source.text, head, strlen(head));
    const char *b = strstr(source.text, "int b;"), *a = strstr(source.text, "int a;");
    assert_true(b && a && b < a && a < strstr(source.text, "int own;"));
    assert_null(strstr(source.text, "#include"));
    glsl_free(&source);
}

/* In a context of its own, as the driver also tells the debug log. */
static void expect_compile_error(void **state, const char *fragment, const char *part) {
    GLuint program;
    struct context *context = open_context(CONTEXT_AUTO);
    write_shader("triangle.vert", "void main() { gl_Position = vec4(0.0); }\n");
    write_shader("main.frag", fragment);
    struct program_desc desc = {.vertex = "triangle.vert", .fragment = "main.frag"};
    assert_false(program_init(&program, &desc));
    expect_error("shader main.frag does not compile");
    expect_error(part);
    assert_int_equal(program, 0);
    program_free(&program);
    context_free(context);
    context_make_current(*state);
}

static void expect_compiles(const char *fragment) {
    GLuint program;
    write_shader("triangle.vert", "void main() { gl_Position = vec4(0.0); }\n");
    write_shader("main.frag", fragment);
    struct program_desc desc = {.vertex = "triangle.vert", .fragment = "main.frag"};
    check_ok("program", program_init(&program, &desc));
    program_free(&program);
}

/* What is included twice is there once, be it also hidden by an #if or included by itself. */
TEST_WITH(once, use_shader_folder, use_embedded_shaders) {
    write_shader("lib/a.glsl", "#include \"lib/b.glsl\"\nfloat a() { return b(); }\n");
    write_shader("lib/b.glsl", "#include \"lib/b.glsl\"\nfloat b() { return 1.0; }\n");
    expect_compiles("#include \"lib/a.glsl\"\n#include \"lib/b.glsl\"\n"
                    "void main() { a(), b(); }\n");
    expect_compiles("#if 0\n#include \"lib/b.glsl\"\n#endif\n#include \"lib/a.glsl\"\n"
                    "void main() { a(); }\n");
}

/* Lines keep their numbers behind what the compiler skips. */
TEST_WITH(skipped_lines, use_shader_folder, use_embedded_shaders) {
    write_shader("lib/a.glsl", "#include \"lib/b.glsl\"\nfloat a() { return b(); }\n");
    write_shader("lib/b.glsl", "float b() { return 1.0; }\n\n\n");
    expect_compile_error(state,
                         "#if 0\n#include \"lib/a.glsl\"\n#endif\n"
                         "void main() { wrong = 1; }\n",
                         "main.frag:4");
    expect_compile_error(state,
                         "#if 0\n#include \"lib/a.glsl\"\n # else\n"
                         "void main() { wrong = 1; }\n#endif\n",
                         "main.frag:4");
    expect_compile_error(state,
                         "#if 0\n#include \"lib/a.glsl\"\n#elif 1\n"
                         "void main() { wrong = 1; }\n#endif\n",
                         "main.frag:4");
    expect_compile_error(state,
                         "#include \"lib/b.glsl\"\n#include \"lib/a.glsl\"\n"
                         "void main() { wrong = 1; }\n",
                         "main.frag:3");
}

/* A technique's shaders are in its folder, beside the shaders' own. */
TEST_WITH(owned_shaders, use_shader_folder, use_embedded_shaders) {
    write_shader("lib/b.glsl", "float b() { return 1.0; }\n");
    write_shader("../src/techniques/a.glsl", "float a() { return b(); }\n");
    write_shader("../src/direct/c.glsl", "float c() { return b(); }\n");
    expect_compiles("#include \"lib/b.glsl\"\n#include \"techniques/a.glsl\"\n"
                    "#include \"direct/c.glsl\"\nvoid main() { a(), c(); }\n");
}

TEST_WITH(missing_include, use_shader_folder, use_embedded_shaders) {
    struct glsl_source source;
    write_shader("main.frag", "int one;\n#include \"lib/c.glsl\"\n");
    write_shader("lib/c.glsl", "\n\n#include \"lib/nowhere.glsl\"\n");
    assert_false(glsl_load(&source, "main.frag", NULL));
    expect_error("main.frag:2: lib/c.glsl:3: cannot open ");
    expect_error("lib/nowhere.glsl: No such file");
    glsl_set_folder(NULL);
    assert_false(glsl_load(&source, "nowhere.frag", NULL));
    expect_error("no shader file 'nowhere.frag' is embedded");
}

/* A mistake in an included file is told by that file's name and line. */
TEST_WITH(messages, use_shader_folder, use_embedded_shaders) {
    write_shader("lib/wrong.glsl", "int fine;\nint wrong = nothing;\n");
    expect_compile_error(state, "#include \"lib/wrong.glsl\"\nvoid main() {}\n",
                         "lib/wrong.glsl:2");
}

/* What other drivers write. */
TEST(places) {
    static const struct {
        const char *message, *explained;
    } cases[] = {
        {"0:100002(13): error: what\n0:7(1): why",
         "lib/a.glsl:2(13): error: what\nmain.frag:7(1): why"},
        {"0(100002) : error C1: what\n", "lib/a.glsl:2 : error C1: what\n"},
        {"ERROR: 0:100002: 'x' : what\n", "lib/a.glsl:2: 'x' : what\n"},
        {"2 errors\n0:900001: what", "2 errors\n0:900001: what"},
    };
    struct glsl_source source = {.files = {"main.frag", "lib/a.glsl"}, .file_count = 2};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *explained = glsl_explain(&source, cases[i].message);
        assert_string_equal(explained, cases[i].explained);
        free(explained);
    }
}

TEST_WITH(link_errors, use_shader_folder, use_embedded_shaders) {
    GLuint program;
    write_shader("triangle.vert", "void main() { gl_Position = vec4(0.0); }\n");
    write_shader("main.frag", "in vec3 missing;\nlayout(location = 0) out vec3 color;\n"
                              "void main() { color = missing; }\n");
    assert_false(program_init(
        &program, &(struct program_desc){.vertex = "triangle.vert", .fragment = "main.frag"}));
    expect_error("triangle.vert and main.frag do not link");
    assert_int_equal(program, 0);
}

/* Alike programs are one object; a define makes another. */
TEST(programs) {
    GLuint programs[3];
    struct program_desc desc = {.vertex = "fullscreen.vert",
                                .fragment = "passes/picture/depth.frag"};
    check_ok("program", program_init(&programs[0], &desc));
    check_ok("program", program_init(&programs[1], &desc));
    desc.defines = "DIFFERENT 1";
    check_ok("program", program_init(&programs[2], &desc));
    assert_true(programs[0] && programs[2] && programs[0] != programs[2]);
    for (int i = 0; i < 3; i++) {
        program_free(&programs[i]);
        assert_int_equal(programs[i], 0);
        program_free(&programs[i]); /* a zeroed one is nothing */
    }
}

/* --- textures, buffers, ledger ---------------------------------------------------------------- */

TEST(ledger) {
    size_t before = gpu_memory_total();
    int objects = gpu_memory_object_count();
    struct texture texture;
    struct buffer buffer, empty;
    check_ok(
        "texture",
        texture_init(&texture, &FILLED(texture_desc, .label = "test", .target = GL_TEXTURE_2D_ARRAY,
                                       .format = GL_RGBA16F, .width = 8, .height = 4, .layers = 3,
                                       .levels = texture_full_levels(8, 4))));
    assert_int_equal(texture_full_levels(8, 4), 4);
    assert_int_equal(gpu_memory_total() - before, 8 * 3 * (32 + 8 + 2 + 1));
    check_ok("buffer", buffer_init(&buffer, "test", 100, NULL));
    check_ok("buffer", buffer_init(&empty, "test", 0, NULL));
    assert_int_equal(gpu_memory_total() - before, 8 * 3 * 43 + 116);
    assert_int_equal(gpu_memory_object_count() - objects, 3);
    textures_free(&texture, &texture);
    buffers_free(&buffer, &buffer, &empty);
    assert_int_equal(gpu_memory_total(), before);
    assert_int_equal(gpu_memory_object_count(), objects);
}

TEST(too_large) {
    struct texture texture;
    struct texture_desc desc = {.label = "huge", .format = GL_R8, .width = 1 << 24};
    assert_false(texture_init(&texture, &desc));
    expect_error("texture 'huge': 16777216x1x1 is above the limit of ");
    texture_free(&texture);
}

/* The largest texture of the limits is above any memory. In a context of its own, as the driver
 * also tells the debug log. */
TEST(out_of_memory) {
    struct context *context = open_context(CONTEXT_AUTO);
    struct texture texture;
    GLint size, layers;
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    gl.GetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &layers);
    struct texture_desc desc = {.label = "vast",
                                .target = GL_TEXTURE_2D_ARRAY,
                                .format = GL_RGBA32F,
                                .width = size,
                                .height = size,
                                .layers = layers};
    assert_false(texture_init(&texture, &desc));
    const char *what =
        form("(%dx%dx%d, %.1f MiB)", size, size, layers, (double)size * size * layers / (1 << 16));
    expect_error("texture 'vast': out of GPU memory ");
    expect_error(what);
    texture_free(&texture);

    /* A driver may promise memory that it has not, and fail later: more than the GPU's
     * is refused. */
    struct buffer buffer;
    gl.memory = 1 << 20;
    desc.width = desc.height = 256;
    desc.layers = 1;
    check_ok("texture of the memory's size", texture_init(&texture, &desc));
    texture_free(&texture);
    desc.layers = 2;
    assert_false(texture_init(&texture, &desc));
    expect_error("texture 'vast': out of GPU memory (256x256x2, 2.0 MiB)");
    assert_false(buffer_init(&buffer, "long", (1 << 20) + 1, NULL));
    expect_error("buffer 'long': out of GPU memory (1.0 MiB)");
    context_free(context);
    context_make_current(*state);
}

TEST(buffers) {
    struct buffer buffer;
    const uint32_t words[4] = {1, 2, 3, 4}, more[2] = {7, 8};
    uint32_t read[4];
    check_ok("buffer", buffer_init(&buffer, "test", sizeof words, words));
    buffer_write(&buffer, 4, sizeof more, more);
    buffer_read(&buffer, 0, sizeof read, read);
    assert_memory_equal(read, ((uint32_t[]){1, 7, 8, 4}), sizeof read);
    buffer_free(&buffer);
}

/* --- timers ----------------------------------------------------------------------------------- */

/* Something that takes time on any driver: what was asked before is done when it begins, as a GPU
 * would not. */
static void work(void) {
    gl.Finish();
    struct timespec nap = {.tv_nsec = 2000000};
    nanosleep(&nap, NULL);
}

static void run_frame(struct timers *timers, int repeats) {
    timer_begin(timers, "frame");
    timer_begin(timers, "one");
    work();
    timer_end(timers);
    timer_begin(timers, "two");
    for (int i = 0; i < repeats; i++) {
        timer_begin(timers, "inner");
        work();
        timer_end(timers);
    }
    timer_end(timers);
    timer_end(timers);
}

static void check_timers(bool software) {
    struct timers timers;
    timers_init(&timers, true, software);
    for (int i = 0; i < 2 * TIMER_RING; i++)
        run_frame(&timers, 3);
    timers_flush(&timers);
    assert_int_equal(timers.count, 4);
    assert_string_equal(timers.results[0].path, "frame");
    assert_string_equal(timers.results[3].path, "frame/two/inner");
    assert_int_equal(timers.results[3].depth, 2);
    for (int i = 0; i < timers.count; i++)
        printf("    %-20s %8.3f ms\n", timers.results[i].path, timers.results[i].ms);
    double inner = timer_ms(&timers, "frame/two/inner"), two = timer_ms(&timers, "frame/two");
    double one = timer_ms(&timers, "frame/one"), frame = timer_ms(&timers, "frame");
    /* Times of one path add up; a query's clock may tick in steps of a microsecond. */
    assert_true(one >= 1.9 && inner >= 5.9 && two >= inner - .1 && frame >= one + two - .1);
    assert_true(timer_ms(&timers, "no such") == 0);
    timers_free(&timers);
}

TEST(clock) {
    check_timers(true);
}

TEST(queries) {
    check_timers(false);
}

/* Hundreds of passes of one name, as instant radiosity has with small batches. */
TEST(many_passes) {
    struct timers timers;
    timers_init(&timers, true, false);
    for (int frame = 0; frame < 3; frame++) {
        timer_begin(&timers, "frame");
        for (int i = 0; i < 1000; i++) {
            timer_begin(&timers, i % 2 ? "maps" : "gather");
            timer_end(&timers);
        }
        timer_end(&timers);
    }
    timers_flush(&timers);
    assert_int_equal(timers.count, 3);
    timers_free(&timers);
}

TEST(disabled) {
    struct timers timers;
    timers_init(&timers, false, true);
    run_frame(&timers, 1);
    assert_int_equal(timers.count, 0);
    timers_free(&timers);
}

RUN_TESTS(open_group_context, close_group_context)
