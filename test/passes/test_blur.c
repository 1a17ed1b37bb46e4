/* The blur over a real G-buffer: what it keeps, and what it averages. */
#include "render_support.h"

#include "passes/frame.h"
#include "passes/gather/blur.h"

/* A blur of its own over a renderer's G-buffer, from a picture of RGB the test fills. */
struct blur_bench {
    struct stage stage;
    struct renderer renderer;
    struct image layers; /* of the frame */
    struct blur_pass blur;
    struct irradiance source;
    int width, height;
};

static void open_blur(struct blur_bench *bench, const struct blur_desc *desc, int interleave) {
    bench->width = desc->width;
    bench->height = desc->height;
    bench->stage = open_stage("scenes/cornell-box.glb");
    open_renderer(&bench->renderer, desc_of(&bench->stage, "unshadowed", "vpls=1 interleave=1",
                                            desc->width, desc->height));
    check_ok("layers", renderer_read_layers(&bench->renderer, &bench->layers));
    check_ok("blur", blur_pass_init(&bench->blur, desc));
    check_ok("source", irradiance_init(&bench->source, "source", GL_RGBA16F, desc->width,
                                       desc->height, interleave));
}

static void close_blur(struct blur_bench *bench) {
    image_free(&bench->layers);
    blur_pass_free(&bench->blur);
    irradiance_free(&bench->source);
    renderer_free(&bench->renderer);
    stage_free(&bench->stage);
}

/* Puts value(x, y) at each pixel's place in the tiles, blurs, and reads red, row 0 at the top. */
static float *run_blur(struct blur_bench *bench,
                       float (*value)(const struct blur_bench *bench, int x, int y)) {
    struct irradiance *source = &bench->source;
    int n = source->interleave, row = source->tile_width * n;
    float *texels = mem_alloc((size_t)row * (size_t)(source->tile_height * n), 4 * sizeof *texels);
    for (int y = 0; y < bench->height; y++)
        for (int x = 0; x < bench->width; x++) {
            int at_x = x % n * source->tile_width + x / n;
            int at_y = y % n * source->tile_height + y / n;
            texels[4 * (at_y * row + at_x)] = value(bench, x, bench->height - 1 - y);
        }
    gl.TextureSubImage2D(source->texture.id, 0, 0, 0, row, source->tile_height * n, GL_RGBA,
                         GL_FLOAT, texels);
    struct frame frame = renderer_frame(&bench->renderer);
    blur_pass_render(&bench->blur, &frame, &bench->renderer.gbuffer,
                     &(struct blur_inputs){.source = source});
    float *blurred = mem_alloc((size_t)bench->width * (size_t)bench->height, sizeof *blurred);
    texels = mem_resize(texels, (size_t)bench->width * (size_t)bench->height, sizeof *texels);
    gl.GetTextureImage(bench->blur.blurred.texture.id, 0, GL_RED, GL_FLOAT,
                       bench->width * bench->height * (GLsizei)sizeof *texels, texels);
    for (int y = 0; y < bench->height; y++)
        memcpy(blurred + y * bench->width, texels + (bench->height - 1 - y) * bench->width,
               (size_t)bench->width * sizeof *blurred);
    free(texels);
    return blurred;
}

static float constant(const struct blur_bench *bench, int x, int y) {
    (void)bench, (void)x, (void)y;
    return .75f;
}

/* Whatever the geometry, a mean of equal values is that value; also at the picture's edges, whose
 * sizes are no multiples of the pattern. */
TEST(blur_conserves) {
    for (int way = 0; way < 4; way++) {
        struct blur_bench bench;
        open_blur(&bench, &(struct blur_desc){61, 43, 4, .1f, .8f, .square = way & 1},
                  way & 2 ? 8 : 1);
        float *blurred = run_blur(&bench, constant);
        double worst = 0;
        int alpha = image_find_channel(&bench.layers, "A");
        for (int i = 0; i < 61 * 43; i++)
            if (image_at(&bench.layers, i % 61, i / 61)[alpha] > 0)
                worst = fmax(worst, fabs((double)blurred[i] - .75));
        check_at_most("a blurred constant", worst, 1e-3);
        free(blurred);
        close_blur(&bench);
    }
}

static float normal_code(const struct blur_bench *bench, int x, int y) {
    const float *normal =
        image_at(&bench->layers, x, y) + image_find_channel(&bench->layers, "normal.X");
    return 1 + .5f * normal[0] + .2f * normal[1] + .1f * normal[2];
}

/* Values that differ from wall to wall stay apart where normals must agree; the blocks are turned
 * by 17 degrees. */
TEST(blur_keeps_edges) {
    struct blur_bench bench;
    open_blur(&bench, &(struct blur_desc){64, 64, 6, 10, .99f, .square = false}, 1);
    float *blurred = run_blur(&bench, normal_code);
    double worst = 0;
    int alpha = image_find_channel(&bench.layers, "A");
    for (int i = 0; i < 64 * 64; i++)
        if (image_at(&bench.layers, i % 64, i / 64)[alpha] > 0)
            worst =
                fmax(worst, fabs((double)blurred[i] - (double)normal_code(&bench, i % 64, i / 64)));
    check_at_most("values of walls, blurred", worst, 2e-3);
    free(blurred);
    close_blur(&bench);
}

static float slot_code(const struct blur_bench *bench, int x, int y) {
    int row = bench->height - 1 - y; /* the pattern counts from the bottom */
    return (float)(row % 8 * 8 + x % 8);
}

/* Each of the 64 places of the pattern counts equally: their mean is 31.5 wherever the window lies
 * on one wall. */
TEST(blur_holds_every_slot) {
    struct blur_bench bench;
    open_blur(&bench, &(struct blur_desc){64, 64, 4, 10, .9f, .square = false}, 8);
    float *blurred = run_blur(&bench, slot_code);
    int whole = 0;
    double worst = 0;
    for (int y = 4; y < 60; y++)
        for (int x = 4; x < 60; x++) {
            float code = normal_code(&bench, x, y);
            bool flat = true;
            for (int i = 0; i < 81; i++)
                flat &= fabsf(normal_code(&bench, x + i % 9 - 4, y + i / 9 - 4) - code) < .01f;
            whole += flat;
            if (flat)
                worst = fmax(worst, fabs((double)blurred[y * 64 + x] - 31.5));
        }
    printf("    windows on one wall: %d\n", whole);
    assert_true(whole > 500);
    check_at_most("distance from the mean of all slots", worst, .05);
    free(blurred);
    close_blur(&bench);
}

RUN_TESTS(open_group_context, close_group_context)
