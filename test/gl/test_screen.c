/* Screen passes (gl/screen.h): drawn and dispatched they have the same bits. */
#include "render_support.h"

#include "gl/framebuffer.h"
#include "gl/glsl.h"
#include "gl/memory.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "gl/screen.h"
#include "gl/screen_glsl.h"
#include "gl/screen_rows.h"

#include <pthread.h>
#include <stdatomic.h>
#include <sys/stat.h>

/* --- pictures --------------------------------------------------------------------------------- */

static const struct picture {
    const char *scene, *technique, *settings;
    int width, height;
} pictures[] = {
    {"cornell-animal", NULL, "samples=12", 97, 64},
    {"cornell-box", NULL, "samples=1 lights.bounces=3", 64, 97},
    {"cornell-box", NULL, "path=traced vpls=64 samples=8", 64, 32},
    {"cornell-box", NULL, "path=paper", 97, 64},
    {"cornell-box", NULL, "gather.adaptive=0 blur.separable=off samples=8", 97, 64},
    {"three-lights", NULL, "samples=8", 97, 64},
    {"courtyard", NULL, "samples=8", 97, 64},
    {"gloss", NULL, "samples=8", 97, 64},
    {"atrium", NULL, "samples=8", 203, 157},
    {"table", "unshadowed", "samples=8", 97, 64},
    {"table", "instant-radiosity", "vpls=64", 97, 64},
    {"table", "imperfect-shadow-maps", "vpls=64", 97, 64},
    {"table", "lightcuts", "vpls=256", 97, 64},
    {"table", "row-column", "vpls=256", 97, 64},
    {"table", "cluster-lights", "vpls=256", 97, 64},
    {"gloss", "implicit-visibility", "elements=300 radiosity.bins=4 radiosity.specular=indirect",
     97, 64},
};

/* All layers, and what a display shows. */
static struct image render(const struct renderer_desc *desc, enum screen_way way,
                           struct bitmap *display) {
    struct renderer renderer;
    struct image layers;
    screen_set_way(way);
    open_renderer(&renderer, *desc);
    texture_read_bitmap(&renderer.composite.display, display);
    check_ok("layers", renderer_read_layers(&renderer, &layers));
    renderer_free(&renderer);
    screen_set_way(SCREEN_AUTO);
    return layers;
}

static int differing(const void *a, const void *b, size_t size) {
    int count = 0;
    for (size_t i = 0; i < size; i++)
        count += ((const char *)a)[i] != ((const char *)b)[i];
    return count;
}

static void check_picture(const struct picture *picture) {
    const char *path = form("scenes/%s.glb", picture->scene);
    OWNED(stage) stage = open_stage(path);
    struct renderer_desc desc =
        desc_of(&stage, picture->technique, picture->settings, picture->width, picture->height);
    struct bitmap shown[2];
    OWNED(image) drawn = render(&desc, SCREEN_FRAGMENT, &shown[0]);
    OWNED(image) dispatched = render(&desc, SCREEN_COMPUTE, &shown[1]);
    size_t pixels = (size_t)picture->width * (size_t)picture->height;
    int count = differing(drawn.pixels, dispatched.pixels,
                          pixels * (size_t)drawn.channel_count * sizeof(float)),
        of_display = differing(shown[0].rgba, shown[1].rgba, pixels * 4);
    printf("    %-14s %-22s %-44s %dx%d: %d bytes of %d channels differ, %d of the display's\n",
           picture->scene, picture->technique ? picture->technique : "", picture->settings,
           picture->width, picture->height, count, drawn.channel_count, of_display);
    /* Other drivers may compile the two to other sums. */
    if (gl.software)
        assert_true(same_pixels(&drawn, &dispatched) && of_display == 0);
    bitmaps_free(&shown[0], &shown[1]);
}

TEST(pictures) {
    for (size_t i = 0; i < sizeof pictures / sizeof *pictures; i++)
        if (is_tried_here(i, 3))
            check_picture(&pictures[i]);
}

/* --- one pass --------------------------------------------------------------------------------- */

enum { WIDTH = 21, HEIGHT = 13, LAYERS_DRAWN = 3 };

static void read_texels(const struct texture *texture, float *texels) {
    gl.GetTextureImage(texture->id, 0, GL_RGBA, GL_FLOAT,
                       WIDTH * HEIGHT * LAYERS_DRAWN * 4 * (GLsizei)sizeof *texels, texels);
}

/* The probe's body over a part of a target that is clear. */
static void draw_part(enum screen_way way, float *texels) {
    struct texture target;
    struct pass_state state = {
        .name = "part", .x = 3, .y = 2, .width = WIDTH - 5, .height = HEIGHT - 4};
    const float clear[4] = {9, 8, 7, 6};
    screen_set_way(way);
    check_ok(
        "target",
        texture_init(&target, &FILLED(texture_desc, .label = "part", .format = GL_RGBA32F,
                                      .width = WIDTH, .height = HEIGHT)) &&
            framebuffer_init(&state.framebuffer,
                             &(struct framebuffer_desc){.label = "part", .colors = {&target}}) &&
            program_init(&state.program,
                         &(struct program_desc){.screen = {.body = "screen_probe.frag"}}));
    assert_int_equal(program_dispatched(state.program) != NULL, way == SCREEN_COMPUTE);
    framebuffer_clear_color(state.framebuffer, 0, clear);
    pass_set_state(&state);
    pass_draw_fullscreen(1);
    read_texels(&target, texels);
    program_free(&state.program);
    framebuffer_free(&state.framebuffer);
    texture_free(&target);
    screen_set_way(SCREEN_AUTO);
}

/* A dispatch keeps to the viewport as a triangle does. */
TEST(viewport) {
    static float drawn[WIDTH * HEIGHT * LAYERS_DRAWN * 4], dispatched[sizeof drawn / sizeof *drawn];
    int outside = 0;
    draw_part(SCREEN_FRAGMENT, drawn);
    draw_part(SCREEN_COMPUTE, dispatched);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        outside += dispatched[4 * i] == 9 && dispatched[4 * i + 3] == 6;
    printf("    %d texels of %d are clear, %d bytes differ\n", outside, WIDTH * HEIGHT,
           differing(drawn, dispatched, sizeof drawn));
    assert_int_equal(outside, WIDTH * HEIGHT - (WIDTH - 5) * (HEIGHT - 4));
    if (gl.software)
        assert_memory_equal(drawn, dispatched, sizeof drawn);
}

/* --- masks ------------------------------------------------------------------------------------ */

/* The first marks one pixel of EVERY; the second says where it ran. */
static const struct body {
    const char *name, *text;
} bodies[] = {
    {"fullscreen.vert", "void main() {\n"
                        "    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;\n"
                        "    gl_Position = vec4(corner, 0.0, 1.0);\n"
                        "}\n"},
    {"mark.frag", "void main() {\n"
                  "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
                  "    if ((pixel.x * 7 + pixel.y * 13) % EVERY != 0)\n"
                  "        discard;\n"
                  "}\n"},
    {"masked.frag", "layout(early_fragment_tests) in;\n"
                    "layout(location = 0) out uint place;\n"
                    "void main() {\n"
                    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
                    "    place = uint(pixel.x | pixel.y << 16);\n"
                    "}\n"},
};

static const char *write_bodies(void) {
    static char folder[512];
    snprintf(folder, sizeof folder, "%s", scratch("screen_glsl"));
    mkdir(folder, 0777);
    for (size_t i = 0; i < sizeof bodies / sizeof *bodies; i++) {
        const char *path = form("%s/%s", folder, bodies[i].name);
        FILE *file = fopen(path, "w");
        if (!file || fputs(bodies[i].text, file) < 0 || fclose(file) != 0)
            fail_msg("cannot write %s", path);
    }
    return folder;
}

struct masked_picture {
    struct pixel_mask mask;
    struct texture target;
    GLuint framebuffer, mark, masked;
};

static void open_masked(struct masked_picture *picture, int width, int height, int every) {
    const char *defines = form("EVERY %d", every);
    check_ok("masked picture",
             pixel_mask_init(&picture->mask, "marked", width, height) &&
                 texture_init(&picture->target,
                              &FILLED(texture_desc, .label = "places", .format = GL_R32UI,
                                      .width = width, .height = height)) &&
                 framebuffer_init(
                     &picture->framebuffer,
                     &(struct framebuffer_desc){.label = "places",
                                                .colors = {&picture->target},
                                                .depth = pixel_mask_depth(&picture->mask)}) &&
                 program_init(&picture->mark,
                              &(struct program_desc){.screen = {"mark.frag", .marks = true},
                                                     .defines = defines}) &&
                 program_init(&picture->masked,
                              &(struct program_desc){.screen = {"masked.frag", .masked = true}}));
}

static void close_masked(struct masked_picture *picture) {
    programs_free(&picture->mark, &picture->masked);
    framebuffer_free(&picture->framebuffer);
    texture_free(&picture->target);
    pixel_mask_free(&picture->mask);
}

/* All entries of the queue become a pixel that the last pass does not mark: it shows if more than
 * are marked run. */
static void fill_queue(const struct buffer *queue) {
    enum { HEAD = 4 };
    GLuint *entries = mem_alloc(queue->size / sizeof *entries, sizeof *entries);
    for (size_t i = 0; i < queue->size / sizeof *entries; i++)
        entries[i] = 1;
    buffer_write(queue, HEAD * sizeof *entries, queue->size - HEAD * sizeof *entries, entries);
    free(entries);
}

static void draw_masked(const struct masked_picture *picture, int x, int y) {
    static const GLuint nowhere[4] = {0xffffffffU};
    struct pass_state state = {.name = "masked",
                               .program = picture->mark,
                               .framebuffer = picture->mask.framebuffer,
                               .x = x,
                               .y = y,
                               .width = picture->target.desc.width - x,
                               .height = picture->target.desc.height - y,
                               .depth = PASS_DEPTH_LESS,
                               .mask = &picture->mask};
    framebuffer_clear_integers(picture->framebuffer, 0, nowhere);
    if (picture->mask.queue.id)
        fill_queue(&picture->mask.queue);
    pixel_mask_clear(&picture->mask);
    pass_set_state(&state);
    pass_draw_fullscreen(1);
    state.program = picture->masked;
    state.framebuffer = picture->framebuffer;
    state.depth = PASS_DEPTH_EQUAL;
    pass_set_state(&state);
    pass_draw_fullscreen(1);
}

/* Texels that have another value than they should. */
static int wrong_places(const GLuint *places, int width, int height, int every) {
    int wrong = 0;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            bool marked = x >= 2 && y >= 1 && (x * 7 + y * 13) % every == 0;
            wrong += places[y * width + x] != (marked ? (GLuint)(x | y << 16) : 0xffffffffU);
        }
    return wrong;
}

static void check_mask(enum screen_way way, int width, int height, int every) {
    struct masked_picture picture = {0};
    size_t pixels = (size_t)width * (size_t)height;
    GLuint *places = mem_alloc(pixels, sizeof *places), queue[4] = {0};
    screen_set_way(way);
    open_masked(&picture, width, height, every);
    draw_masked(&picture, 0, 0);
    draw_masked(&picture, 2, 1); /* nothing of the first is left */
    gl.GetTextureImage(picture.target.id, 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                       (GLsizei)(pixels * sizeof *places), places);
    if (picture.mask.queue.id)
        buffer_read(&picture.mask.queue, 0, sizeof queue, queue);
    int wrong = wrong_places(places, width, height, every);
    printf("    %s, %dx%d, one of %d: %u pixels queued for %u x %u groups, %d wrong\n",
           screen_way_names[way], width, height, every, queue[3], queue[0], queue[1], wrong);
    assert_int_equal(wrong, 0);
    close_masked(&picture);
    screen_set_way(SCREEN_AUTO);
    free(places);
}

/* The second pass runs at marked pixels and at no others: few, none, all, and more than a row of
 * groups has. */
TEST(masks) {
    static const struct {
        int width, height, every;
    } tried[] = {{97, 61, 5}, {97, 61, 100000}, {97, 61, 1}, {1500, 1450, 1}};
    glsl_set_folder(write_bodies());
    for (size_t i = 0; i < sizeof tried / sizeof *tried - !is_long_run(); i++)
        for (enum screen_way way = SCREEN_FRAGMENT; way <= SCREEN_COMPUTE; way++)
            check_mask(way, tried[i].width, tried[i].height, tried[i].every);
    glsl_set_folder(NULL);
}

/* A mask that the GPU has no memory for leaves nothing. */
TEST(mask_memory) {
    size_t memory = gl.memory, before = gpu_memory_total();
    for (enum screen_way way = SCREEN_FRAGMENT; way <= SCREEN_COMPUTE; way++) {
        struct pixel_mask mask;
        screen_set_way(way);
        gl.memory = 1 << 10;
        bool fits = pixel_mask_init(&mask, "marked", 64, 64);
        gl.memory = memory;
        printf("    %s: %s\n", screen_way_names[way], error_get());
        check_refused(fits, "'marked': out of GPU memory");
        assert_true(!mask.queue.id && !mask.depth.id && !mask.framebuffer);
        assert_int_equal(gpu_memory_total(), before);
    }
    screen_set_way(SCREEN_AUTO);
}

/* Messages name the body's file and line, whatever is written before. */
TEST(places) {
    static const char text[] = "#version 450 core\n"
                               "#ifndef INCLUDED_0\n#define INCLUDED_0\n"
                               "#line 1\n"
                               "layout(location = 0) out vec2 value;\n"
                               "void main() {\n"
                               "    value = gl_FragCoord.xy;\n"
                               "}\n"
                               "#endif\n";
    char *compute = screen_glsl(text, &(struct screen_desc){.body = "place"});
    const char *resumed = strstr(compute, "#line 2\nvoid screen_body() {\n"
                                          "    value = screen_coord.xy;\n");
    printf("%s", compute);
    assert_non_null(resumed);
    assert_null(strstr(compute, "gl_FragCoord"));
    free(compute);
}

/* The choice is the process's, and is made once; timing leaves it alone. */
TEST(auto) {
    struct screen_times times;
    screen_set_way(SCREEN_AUTO);
    check_ok("times", screen_time_ways(&times));
    enum screen_way way = screen_way();
    printf("    drawn %.2f ms, dispatched %.2f ms; auto: %s\n", times.drawn, times.dispatched,
           screen_way_names[way]);
    assert_true(times.drawn < HUGE_VAL && times.dispatched < HUGE_VAL);
    assert_true(way == SCREEN_FRAGMENT || (way == SCREEN_COMPUTE && !gl.software));
    assert_int_equal(screen_way(), way);
}

static atomic_bool is_timed;

/* Looks until the timing is over. */
static void *count_dispatched(void *count) {
    while (!atomic_load(&is_timed))
        *(int *)count += screen_way() != SCREEN_FRAGMENT;
    return NULL;
}

/* While one thread times both ways, what others make runs in the way that is chosen. */
TEST(timing_aside) {
    pthread_t other;
    struct screen_times times;
    int dispatched = 0;
    screen_set_way(SCREEN_FRAGMENT);
    assert_int_equal(pthread_create(&other, NULL, count_dispatched, &dispatched), 0);
    bool ok = screen_time_ways(&times);
    atomic_store(&is_timed, true);
    pthread_join(other, NULL);
    screen_set_way(SCREEN_AUTO);
    check_ok("times", ok);
    assert_int_equal(dispatched, 0);
}

/* --- rows ------------------------------------------------------------------------------------- */

static struct dispatched { int width, height, first, count; } dispatches[8];
static int dispatch_count;

static void note_dispatch(int width, int height, int first, int count, int stride) {
    (void)stride;
    dispatches[dispatch_count++] = (struct dispatched){width, height, first, count};
}

/* Rectangles that overlap are of later rounds, unless they are different parts. */
TEST(rounds) {
    static const struct {
        struct screen_rectangle rectangle;
        int part;
    } added[] = {
        {{0, 0, 10, 4}, 0}, {{10, 0, 10, 6}, 0}, {{0, 0, 10, 4}, 1}, /* round 0 */
        {{5, 3, 10, 4}, 0},                                          /* 1: over both */
        {{0, 0, 12, 4}, 1},                                          /* 1: over its own part's */
        {{14, 6, 2, 2}, 0},                                          /* 2: over the one of 1 */
    };
    static const struct dispatched expected[] = {{10, 6, 0, 3}, {12, 4, 3, 2}, {2, 2, 5, 1}};
    for (size_t i = 0; i < sizeof added / sizeof *added; i++)
        screen_rows_add(&added[i].rectangle, added[i].part);
    dispatch_count = 0;
    screen_rows_flush(note_dispatch);
    for (int i = 0; i < dispatch_count; i++)
        printf("    round %d: %d rows from %d on, at most %dx%d\n", i, dispatches[i].count,
               dispatches[i].first, dispatches[i].width, dispatches[i].height);
    assert_int_equal(dispatch_count, 3);
    assert_memory_equal(dispatches, expected, sizeof expected);
    assert_true(screen_rows_empty());
}

RUN_TESTS(open_group_context, close_group_context)
