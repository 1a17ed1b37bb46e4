/* The gl floor: contexts and the function table. */
#include "support.h"

#include "gl/api.h"
#include "gl/context/context.h"
#include "gl/context/needs.h"
#include "shared/vpl.h"

static const struct context_desc egl_desc = {.kind = CONTEXT_EGL, .debug = true};
static const struct context_desc osmesa_desc = {.kind = CONTEXT_OSMESA, .debug = true};

/* A context that is current, or the test is skipped: a machine needs only one of the libraries. */
static struct context *open_context(const struct context_desc *desc) {
    struct context *context = context_create(desc);
    if (!context) {
        printf("    skipped: %s\n", error_get());
        skip();
    }
    return context;
}

static GLuint make_texel(const uint8_t colour[4]) {
    GLuint texture;
    gl.CreateTextures(GL_TEXTURE_2D, 1, &texture);
    gl.TextureStorage2D(texture, 1, GL_RGBA8, 1, 1);
    gl.ClearTexImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, colour);
    return texture;
}

static void check_texel(GLuint texture, const uint8_t colour[4]) {
    uint8_t read[4] = {0};
    gl.GetTextureImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, sizeof read, read);
    assert_memory_equal(read, colour, sizeof read);
}

static const uint8_t orange[4] = {255, 128, 0, 77}, teal[4] = {0, 128, 129, 255};

/* All that is promised of any context. */
static void check_context(const struct context_desc *desc, const char *description) {
    struct context *context = open_context(desc);
    assert_non_null(strstr(context_description(context), description));
    const char *renderer = (const char *)gl.GetString(GL_RENDERER);
    printf("    %s: %s\n", context_description(context), renderer);
    assert_int_equal(gl.software, strstr(renderer, "llvmpipe") != NULL);
#define CHECK_FUNCTION(type, name) assert_non_null(gl.name);
    GL_FUNCTIONS(CHECK_FUNCTION)
#undef CHECK_FUNCTION

    /* By the same call that tells, an extension is there; a part of its name is none. */
    const char *extension = (const char *)gl.GetStringi(GL_EXTENSIONS, 3);
    assert_true(gl_has_extension(&gl, extension));
    assert_false(gl_has_extension(&gl, "GL_ARB_"));

    GLuint texture = make_texel(orange);
    check_texel(texture, orange);
    gl.DeleteTextures(1, &texture);
    assert_int_equal(context_message_count(context), 0);
    context_free(context);
    assert_null(gl.CreateTextures);
}

TEST(egl) {
    check_context(&egl_desc, "EGL");
}

TEST(osmesa) {
    check_context(&osmesa_desc, "OSMesa");
}

static void check_messages(const struct context_desc *desc) {
    struct context *context = open_context(desc);
    GLuint no_such_texture = 4711;
    gl.TextureStorage2D(no_such_texture, 1, GL_RGBA8, 1, 1);
    gl.Enable(GL_VENDOR);
    assert_int_equal(context_message_count(context), 2);
    gl.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, "a notification does not count");
    gl.PopDebugGroup();
    assert_int_equal(context_message_count(context), 2);
    static const struct {
        GLenum type;
        GLuint id;
        int counts;
    } told[] = {{GL_DEBUG_TYPE_PERFORMANCE, 7, 0},
                {GL_DEBUG_TYPE_OTHER, 131218, 0},
                {GL_DEBUG_TYPE_OTHER, 131186, 0},
                {GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR, 8, 1}};
    for (size_t i = 0; i < sizeof told / sizeof *told; i++) {
        int before = context_message_count(context);
        gl.DebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, told[i].type, told[i].id,
                              GL_DEBUG_SEVERITY_MEDIUM, -1, "as a driver would say");
        printf("    message %u counts %d\n", told[i].id, context_message_count(context) - before);
        assert_int_equal(context_message_count(context) - before, told[i].counts);
    }
    context_free(context);
}

/* Reads units 3 and 4, an array, and the other one. */
static GLuint make_reader(const char *other) {
    const char *const texts[] = {
        "#version 450\n"
        "layout(local_size_x = 1) in;\n"
        "layout(binding = 3) uniform sampler2D read[2];\n"
        "layout(binding = ",
        other,
        ") uniform sampler2D other;\n"
        "layout(rgba8, binding = 0) writeonly uniform image2D written;\n"
        "void main() {\n"
        "    vec2 at = vec2(.5);\n"
        "    vec4 sum = texture(read[0], at) + texture(read[1], at) + texture(other, at);\n"
        "    imageStore(written, ivec2(0), sum / 3.0);\n"
        "}\n"};
    GLuint program = gl.CreateProgram(), shader = gl.CreateShader(GL_COMPUTE_SHADER);
    GLint linked = 0;
    gl.ShaderSource(shader, 3, texts, NULL);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader);
    gl.LinkProgram(program);
    gl.DeleteShader(shader);
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    assert_true(linked);
    return program;
}

/* What a sampler without a texture reads is each driver's choice: each one counts as a fault of a
 * draw or dispatch. */
TEST(samplers) {
    struct context *context = open_context(&(struct context_desc){.debug = true});
    GLuint program = make_reader("5"), read = make_texel(orange), written = make_texel(teal);
    gl.UseProgram(program);
    gl.BindImageTexture(0, written, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
    gl.BindTextureUnit(3, read);
    gl.DispatchCompute(1, 1, 1);
    assert_int_equal(context_message_count(context), 2);
    gl.BindTextureUnit(4, read);
    gl.BindTextureUnit(5, read);
    gl.DispatchCompute(1, 1, 1);
    gl.MemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    check_texel(written, orange);
    assert_int_equal(context_message_count(context), 2);
    gl.DeleteProgram(program);
    program = make_reader("4"); /* of the array's second element */
    gl.UseProgram(program);
    gl.DispatchCompute(1, 1, 1);
    assert_int_equal(context_message_count(context), 3);
    gl.DeleteProgram(program);
    gl.DeleteTextures(1, &read);
    gl.DeleteTextures(1, &written);
    context_free(context);
}

TEST(messages) {
    check_messages(&egl_desc);
}

TEST(messages_osmesa) {
    check_messages(&osmesa_desc);
}

/* Objects of the same name in two contexts: each context sees its own. */
static void check_alternation(const struct context_desc *first, const struct context_desc *second) {
    struct context *a = open_context(first);
    GLuint texture_a = make_texel(orange);
    struct context *b = context_create(second);
    if (!b) {
        context_free(a);
        skip();
    }
    GLuint texture_b = make_texel(teal);
    assert_int_equal(texture_a, texture_b);
    for (int i = 0; i < 3; i++) {
        context_make_current(a);
        check_texel(texture_a, orange);
        context_make_current(b);
        check_texel(texture_b, teal);
    }
    context_free(a); /* not the current one: b goes on */
    check_texel(texture_b, teal);
    assert_int_equal(context_message_count(b), 0);
    context_free(b);
}

TEST(alternation) {
    check_alternation(&egl_desc, &egl_desc);
}

TEST(alternation_with_osmesa) {
    check_alternation(&egl_desc, &osmesa_desc);
    check_alternation(&osmesa_desc, &egl_desc);
}

/* A message of another context goes to its own counter. */
TEST(messages_of_two) {
    struct context *a = open_context(&egl_desc), *b = context_create(&egl_desc);
    gl.Enable(GL_VENDOR);
    context_make_current(a);
    assert_int_equal(context_message_count(a), 0);
    assert_int_equal(context_message_count(b), 1);
    context_free(b);
    context_free(a);
}

TEST(refusals) {
    char devices[4096];
    context_list_devices(devices, sizeof devices);
    printf("%s", devices);
    const struct context_desc no_such_device = {.kind = CONTEXT_EGL, .device = "99"};
    struct context *current = context_create(&(struct context_desc){.kind = CONTEXT_AUTO});
    assert_null(context_create(&no_such_device));
    printf("    %s\n", error_get());
    assert_non_null(strstr(error_get(), "no OpenGL 4.5 core context: "));
    if (!strstr(error_get(), "cannot open"))
        assert_non_null(strstr(error_get(), "no EGL device 99"));
    if (current)
        assert_int_equal(gl.GetError(), GL_NO_ERROR);
    context_free(current);
}

/* Devices by name: what is no device is refused, and hardware is never software. */
TEST(devices) {
    static const char *const good[] = {"0", "12", "cuda:0", "cuda:7", "hardware"};
    static const char *const bad[] = {"",      "-1",      "1x",       "cuda",
                                      "cuda:", "cuda:-1", "Hardware", "gpu"};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++)
        assert_true(context_check_device(good[i]));
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(context_check_device(bad[i]));
        assert_null(context_create(&(struct context_desc){.device = bad[i]}));
    }
    printf("    %s\n", error_get());
    struct context *context = context_create(&(struct context_desc){.device = "hardware"});
    if (context)
        assert_false(gl.software);
    else
        printf("    %s\n", error_get());
    context_free(context);
    if (!context)
        assert_non_null(strstr(error_get(), "no OpenGL 4.5 core context: "));
    context = context_create(&(struct context_desc){.device = "cuda:999"});
    assert_null(context);
    printf("    %s\n", error_get());
    assert_non_null(strstr(error_get(), "no EGL device is cuda:999"));
}

/* A machine without GPU drivers: the message tells what was tried. */
TEST(no_driver) {
    char output[4096];
    const char *command =
        form("__EGL_VENDOR_LIBRARY_DIRS=/nowhere %s info --context egl", binary_path());
    assert_int_equal(run_command(command, output, sizeof output), 1);
    assert_non_null(strstr(output, "manylight info: no OpenGL 4.5 core context: EGL: "));
}

static void *getproc_without_compute(const char *name) {
    return strcmp(name, "glDispatchCompute") == 0 ? NULL : (void *)name;
}

TEST(missing_function) {
    assert_null(context_adopt(getproc_without_compute, false));
    assert_string_equal(error_get(), "window: no function glDispatchCompute");
}

/* A driver that has all that is needed and nothing more; tests take from it. */
static struct driver {
    GLint version, block_bytes, buffer_texels;
    const char *extension;
} driver;

enum {
    VPL_BYTES = VPLS_PER_BLOCK * sizeof(struct vpl),
    BLOCK_BYTES = 1 << 16, /* for all blocks; no driver has more than what NVIDIA's has */
    BUFFER_TEXELS = VPLS_MAX * sizeof(struct vpl) / sizeof(vec4),
};

static const struct driver enough = {45, BLOCK_BYTES, BUFFER_TEXELS,
                                     "GL_ARB_shader_viewport_layer_array"};

static void APIENTRY get_integer(GLenum name, GLint *value) {
    switch (name) {
    case GL_MAJOR_VERSION:
        *value = driver.version / 10;
        break;
    case GL_MINOR_VERSION:
        *value = driver.version % 10;
        break;
    case GL_NUM_EXTENSIONS:
        *value = 2;
        break;
    case GL_MAX_UNIFORM_BLOCK_SIZE:
        *value = driver.block_bytes;
        break;
    case GL_MAX_TEXTURE_BUFFER_SIZE:
        *value = driver.buffer_texels;
        break;
    default:
        fail_msg("asks for 0x%x, which OpenGL 4.5 promises", name);
    }
}

static const GLubyte *APIENTRY get_extension(GLenum name, GLuint index) {
    assert_int_equal(name, GL_EXTENSIONS);
    return (const GLubyte *)(index == 0 ? "GL_ARB_any" : driver.extension);
}

static void expect_refusal(struct driver lacking, const char *message) {
    const struct gl_api api = {.GetIntegerv = get_integer, .GetStringi = get_extension};
    driver = lacking;
    check_refused(gl_needs_met(&api), "");
    assert_string_equal(error_get(), message);
    driver = enough;
    assert_true(gl_needs_met(&api));
}

TEST(needs) {
    char message[128];
    struct driver old = enough, layerless = enough, small = enough, brief = enough;
    old.version = 43;
    expect_refusal(old, "has OpenGL 4.3, and 4.5 is needed");
    layerless.extension = "GL_ARB_shader_viewport_layer";
    expect_refusal(layerless, "lacks GL_ARB_shader_viewport_layer_array, by which vertex shaders "
                              "pick the layer that they draw to");
    small.block_bytes = 16384;
    snprintf(message, sizeof message,
             "allows 16384 bytes in a uniform block, and %d are needed for virtual lights",
             VPL_BYTES);
    expect_refusal(small, message);
    brief.buffer_texels = 65536;
    snprintf(message, sizeof message,
             "allows 65536 texels in a buffer texture, and %d are needed for virtual lights",
             BUFFER_TEXELS);
    expect_refusal(brief, message);
}

RUN_TESTS(NULL, NULL)
