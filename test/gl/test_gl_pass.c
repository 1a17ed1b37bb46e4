/* Passes: that a state is whole, and that compute shaders run as drawing does. */
#define _POSIX_C_SOURCE 200809L
#include "render_support.h"

#include "gl/framebuffer.h"
#include "gl/glsl.h"
#include "gl/pass.h"
#include "gl/program.h"

#include <sys/stat.h>

static struct timers untimed;

/* --- shaders ---------------------------------------------------------------------------------- */

static const struct shader {
    const char *name, *text;
} shaders[] = {
    {"triangle.vert", "void main() {\n"
                      "    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;\n"
                      "    gl_Position = vec4(corner, 0.5, 1.0);\n"
                      "}\n"},
    {"points.vert", "void main() {\n"
                    "    gl_Position = vec4(0.0, 0.0, 0.5, 1.0);\n"
                    "    gl_PointSize = 4.0;\n"
                    "}\n"},
    {"ones.frag", "layout(location = 0) out vec4 color;\n"
                  "void main() { color = vec4(1.0); }\n"},
    {"block.frag", "layout(std140, binding = 2) uniform values { vec4 value; };\n"
                   "layout(location = 0) out vec4 color;\n"
                   "void main() { color = value; }\n"},
    {"ones.vert", "layout(xfb_buffer = 0, xfb_stride = 16) out;\n"
                  "layout(xfb_offset = 0) out vec4 captured;\n"
                  "void main() { captured = vec4(1.0); }\n"},
    {"ones.comp", "layout(local_size_x = 1) in;\n"
                  "layout(std430, binding = 1) writeonly buffer values { vec4 value; };\n"
                  "void main() { value = vec4(1.0); }\n"},
    {"nothing.frag", "layout(std430, binding = 1) buffer counts { uint count; };\n"
                     "void main() { atomicAdd(count, 1u); }\n"},
    /* Layers of coordinates, scaled by a uniform block. */
    {"fill.comp", "layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;\n"
                  "layout(std140, binding = 2) uniform scales { vec4 scale; };\n"
                  "layout(binding = 3, rgba16f) writeonly uniform image2DArray layers;\n"
                  "void main() {\n"
                  "    ivec3 at = ivec3(gl_GlobalInvocationID);\n"
                  "    if (any(greaterThanEqual(at, imageSize(layers))))\n"
                  "        return;\n"
                  "    imageStore(layers, at, vec4(vec3(at), 1.0) * scale);\n"
                  "}\n"},
    /* Reads the layers as a texture, into storage. */
    {"read.comp", "layout(local_size_x = 64) in;\n"
                  "layout(binding = 5) uniform sampler2DArray layers;\n"
                  "layout(std430, binding = 1) writeonly buffer texels { vec4 read[]; };\n"
                  "void main() {\n"
                  "    ivec3 size = textureSize(layers, 0);\n"
                  "    int i = int(gl_GlobalInvocationID.x);\n"
                  "    if (i < size.x * size.y * size.z)\n"
                  "        read[i] = texelFetch(layers, ivec3(i % size.x, i / size.x % size.y,\n"
                  "                                           i / (size.x * size.y)), 0);\n"
                  "}\n"},
};

static int open_shaders(void **state) {
    const char *folder = form("%s", scratch("pass_glsl"));
    mkdir(folder, 0777);
    for (size_t i = 0; i < sizeof shaders / sizeof *shaders; i++) {
        const char *path = form("%s/%s", folder, shaders[i].name);
        FILE *file = fopen(path, "w");
        if (!file || fputs(shaders[i].text, file) < 0 || fclose(file) != 0)
            return -1;
    }
    static char kept[512];
    snprintf(kept, sizeof kept, "%s", folder);
    glsl_set_folder(kept);
    return open_group_context(state);
}

static int close_shaders(void **state) {
    glsl_set_folder(NULL);
    return close_group_context(state);
}

static GLuint open_program(const char *vertex, const char *fragment, const char *compute) {
    GLuint program;
    check_ok("program", program_init(&program, &(struct program_desc){.vertex = vertex,
                                                                      .fragment = fragment,
                                                                      .compute = compute}));
    return program;
}

/* --- compute ---------------------------------------------------------------------------------- */

enum { WIDTH = 7, HEIGHT = 5, DEPTH = 3, TEXELS = WIDTH * HEIGHT * DEPTH };

static void fill_layers(GLuint program, const struct texture *layers, const struct buffer *scale) {
    pass_begin(&untimed,
               &FILLED(pass_state, .name = "fill", .program = program, .blocks = {{2, scale}},
                       .images = {{3, layers, 0, GL_WRITE_ONLY}}));
    pass_dispatch((WIDTH + 3) / 4, (HEIGHT + 3) / 4, (DEPTH + 3) / 4);
    pass_end(&untimed);
}

static void read_layers(GLuint program, const struct texture *layers, const struct buffer *texels) {
    pass_begin(&untimed, &FILLED(pass_state, .name = "read", .program = program,
                                 .textures = {{5, layers->id}}, .storages = {{1, texels}},
                                 .barriers = GL_TEXTURE_FETCH_BARRIER_BIT));
    pass_dispatch((TEXELS + 63) / 64, 1, 1);
    pass_end(&untimed);
}

/* One pass stores layers, the next reads it as a texture, and the host what that one stored. */
TEST(compute) {
    const float scale[4] = {1, .5F, .25F, 2};
    float texels[TEXELS][4];
    struct texture layers;
    struct buffer scales, stored;
    GLuint fill = open_program(NULL, NULL, "fill.comp");
    GLuint read = open_program(NULL, NULL, "read.comp");
    check_ok("layers",
             texture_init(&layers, &FILLED(texture_desc, .label = "layers",
                                           .target = GL_TEXTURE_2D_ARRAY, .format = GL_RGBA16F,
                                           .width = WIDTH, .height = HEIGHT, .layers = DEPTH)));
    check_ok("scales", buffer_init(&scales, "scales", sizeof scale, scale));
    check_ok("stored", buffer_init(&stored, "stored", sizeof texels, NULL));
    fill_layers(fill, &layers, &scales);
    read_layers(read, &layers, &stored);
    buffer_read(&stored, 0, sizeof texels, texels);
    int wrong = 0;
    for (int i = 0; i < TEXELS; i++) {
        int at[4] = {i % WIDTH, i / WIDTH % HEIGHT, i / (WIDTH * HEIGHT), 1};
        for (int c = 0; c < 4; c++)
            wrong += texels[i][c] != (float)at[c] * scale[c];
    }
    printf("    last texel: %g %g %g %g\n", (double)texels[TEXELS - 1][0],
           (double)texels[TEXELS - 1][1], (double)texels[TEXELS - 1][2],
           (double)texels[TEXELS - 1][3]);
    check_at_most("wrong values of the layers", wrong, 0);
    buffers_free(&stored, &scales);
    texture_free(&layers);
    programs_free(&read, &fill);
}

/* --- drawing ---------------------------------------------------------------------------------- */

struct target {
    struct texture texture;
    GLuint framebuffer;
};

static void open_target(struct target *target) {
    check_ok("texture",
             texture_init(&target->texture,
                          &(struct texture_desc){
                              .label = "target", .format = GL_RGBA8, .width = 8, .height = 8}));
    check_ok("framebuffer", framebuffer_init(&target->framebuffer,
                                             &(struct framebuffer_desc){
                                                 .label = "target", .colors = {&target->texture}}));
}

static void close_target(struct target *target) {
    framebuffer_free(&target->framebuffer);
    texture_free(&target->texture);
}

static void read_target(const struct target *target, unsigned char pixels[8][8][4]) {
    gl.GetTextureImage(target->texture.id, 0, GL_RGBA, GL_UNSIGNED_BYTE, 8 * 8 * 4, pixels);
}

static int drawn(const struct target *target) {
    unsigned char pixels[8][8][4];
    int count = 0;
    read_target(target, pixels);
    for (int i = 0; i < 64; i++)
        count += pixels[i / 8][i % 8][0] > 0;
    return count;
}

/* Points are as wide as their shader says where the state says so, and else a pixel. */
TEST(point_size) {
    static const float zero[4] = {0};
    struct target target;
    open_target(&target);
    GLuint program = open_program("points.vert", "ones.frag", NULL);
    struct pass_state wide = {.name = "points",
                              .program = program,
                              .framebuffer = target.framebuffer,
                              .width = 8,
                              .height = 8,
                              .point_size = true};
    struct pass_state narrow = wide;
    narrow.point_size = false;
    framebuffer_clear_color(target.framebuffer, 0, zero);
    pass_set_state(&wide);
    pass_draw(GL_POINTS, 1, 1);
    assert_int_equal(drawn(&target), 16);
    framebuffer_clear_color(target.framebuffer, 0, zero);
    pass_set_state(&narrow);
    pass_draw(GL_POINTS, 1, 1);
    assert_int_equal(drawn(&target), 1);
    program_free(&program);
    close_target(&target);
}

static void draw_block(GLuint program, const struct target *target, const struct buffer *values) {
    pass_set_state(&FILLED(pass_state, .name = "block", .program = program,
                           .framebuffer = target->framebuffer, .width = 8, .height = 8,
                           .blocks = {{2, values}}, .barriers = GL_UNIFORM_BARRIER_BIT));
    pass_draw_fullscreen(1);
}

/* With the target of the draw before: a change of targets would draw what is queued. */
static void write_by_feedback(GLuint program, const struct target *target,
                              const struct buffer *values) {
    pass_set_state(&(struct pass_state){
        .name = "feedback", .program = program, .framebuffer = target->framebuffer});
    pass_feedback(values->id, 0, 1);
}

static void write_by_dispatch(GLuint program, const struct target *target,
                              const struct buffer *values) {
    pass_set_state(&FILLED(pass_state, .name = "dispatch", .program = program,
                           .framebuffer = target->framebuffer, .storages = {{1, values}}));
    pass_dispatch(1, 1, 1);
}

/* A queued draw reads the block as it was when the draw was called. */
static void check_write(GLuint writer,
                        void (*write)(GLuint, const struct target *, const struct buffer *)) {
    const float zeros[4] = {0};
    unsigned char pixels[8][8][4];
    struct target before, after;
    struct buffer values;
    GLuint reader = open_program("triangle.vert", "block.frag", NULL);
    open_target(&before);
    open_target(&after);
    check_ok("values", buffer_init(&values, "values", sizeof zeros, zeros));
    draw_block(reader, &before, &values);
    write(writer, &before, &values);
    draw_block(reader, &after, &values);
    read_target(&before, pixels);
    check_near("value before the write", pixels[7][7][0], 0, 0);
    read_target(&after, pixels);
    check_near("value after it", pixels[7][7][0], 255, 0);
    buffer_free(&values);
    close_target(&after);
    close_target(&before);
    programs_free(&reader, &writer);
}

TEST(writes_wait_for_reads) {
    check_write(open_program("ones.vert", NULL, NULL), write_by_feedback);
    check_write(open_program(NULL, NULL, "ones.comp"), write_by_dispatch);
}

/* Without a target what is drawn still becomes fragments, as many as the viewport has pixels. */
TEST(no_target) {
    uint32_t count = 0;
    struct buffer counter;
    GLuint program = open_program("triangle.vert", "nothing.frag", NULL);
    check_ok("counter", buffer_init(&counter, "counter", sizeof count, &count));
    pass_set_state(&FILLED(pass_state, .name = "no target", .program = program, .width = 30,
                           .height = 20, .storages = {{1, &counter}}));
    pass_draw_fullscreen(1);
    buffer_read(&counter, 0, sizeof count, &count);
    check_near("fragments", count, 600, 0);
    buffer_free(&counter);
    program_free(&program);
}

RUN_TESTS(open_shaders, close_shaders)
