/* What filters of soft shadows read instead of many texels, against brute force: summed area tables, bit for
 * bit, also where they wrap; nearest and farthest depths of windows. */
#include "render_support.h"

#include "base/memory.h"
#include "passes/visibility/depth_bounds.h"
#include "passes/visibility/sums.h"
#include "shared/depth_bounds.h"
#include "shared/sums.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { LAYERS_TESTED = 2 };

struct depths {
    int size;
    float *texels; /* of all layers */
    struct texture map;
};

/* Deep, so that the sums of a map wrap around; and some that are no depths. */
static void open_depths(struct depths *depths, int size) {
    int count = size * size * LAYERS_TESTED;
    *depths = (struct depths){.size = size, .texels = mem_alloc((size_t)count, sizeof(float))};
    srand(5);
    for (int i = 0; i < count; i++)
        depths->texels[i] = .5F + .5F * (float)rand() / (float)RAND_MAX;
    depths->texels[size + 3] = NAN;
    depths->texels[size + 4] = -1;
    depths->texels[size + 5] = 1e30F;
    check_ok("map", texture_init(&depths->map, &(struct texture_desc){.label = "depths",
                                                                      .target = GL_TEXTURE_2D_ARRAY,
                                                                      .format = GL_R32F,
                                                                      .width = size,
                                                                      .height = size,
                                                                      .layers = LAYERS_TESTED}));
    gl.TextureSubImage3D(depths->map.id, 0, 0, 0, 0, size, size, LAYERS_TESTED, GL_RED, GL_FLOAT,
                         depths->texels);
}

static void close_depths(struct depths *depths) {
    texture_free(&depths->map);
    free(depths->texels);
}

static double depth_at(const struct depths *depths, int x, int y, int layer) {
    return (double)
        depths->texels[((size_t)layer * (size_t)depths->size + (size_t)y) * (size_t)depths->size +
                       (size_t)x];
}

static struct frame untimed_frame(struct timers *timers) {
    *timers = (struct timers){0};
    return (struct frame){.timers = timers};
}

/* --- summed area tables ----------------------------------------------------------------------- */

static uint32_t fixed(double depth, int power) {
    float z = depth > 0 ? (float)fmin(depth, 1) : 0, z2 = z * z;
    float powers[] = {z, z2, z2 * z, z2 * z2};
    return (uint32_t)rintf(powers[power] * (float)SUM_ONE);
}

/* How many of the boxes have another sum than their texels. */
static int wrong_boxes(const struct depths *depths, const uint32_t *sums, int moments) {
    int side = depths->size + 1, wrong = 0;
    for (int i = 0; i < 300; i++) {
        int x0 = rand() % side, y0 = rand() % side, layer = i % LAYERS_TESTED;
        int widest = depths->size < SUM_BOX_MAX ? depths->size : SUM_BOX_MAX;
        int x1 = x0 + rand() % (widest + 1), y1 = y0 + rand() % (widest + 1);
        x1 = x1 < side ? x1 : side - 1;
        y1 = y1 < side ? y1 : side - 1;
        if (i < 8) /* around what is no depth */
            x0 = i / 4, y0 = 0, x1 = 3 + i % 4, y1 = 3, layer = 0;
        for (int m = 0; m < moments; m++) {
#define SUM_AT(x, y) sums[((layer * side + (y)) * side + (x)) * moments + m]
            uint32_t box = SUM_AT(x1, y1) - SUM_AT(x0, y1) - SUM_AT(x1, y0) + SUM_AT(x0, y0);
            uint64_t expected = 0;
            for (int y = y0; y < y1; y++)
                for (int x = x0; x < x1; x++)
                    expected += fixed(depth_at(depths, x, y, layer), m);
            wrong += expected != box;
        }
    }
    return wrong;
}

static void check_sums(int size, int moments) {
    struct depths depths;
    struct sums_pass pass;
    struct timers timers;
    struct frame frame = untimed_frame(&timers);
    size_t count = (size_t)((size + 1) * (size + 1) * LAYERS_TESTED * moments);
    uint32_t *sums = mem_alloc(count, sizeof *sums);
    open_depths(&depths, size);
    check_ok("pass", sums_pass_init(&pass, &(struct sums_desc){size, LAYERS_TESTED, moments}));
    sums_pass_render(&pass, &frame, &depths.map);
    gl.GetTextureImage(pass.maps.sums.id, 0, moments == 2 ? GL_RG_INTEGER : GL_RGBA_INTEGER,
                       GL_UNSIGNED_INT, (GLsizei)(count * sizeof *sums), sums);
    double total = 0;
    for (int i = 0; i < size * size; i++)
        total += fixed((double)depths.texels[i], 0);
    printf("    %d^2 texels, %d moments: %.1f times 2^32 in all\n", size, moments,
           total / 4294967296.);
    check_at_most("boxes whose sum is another", wrong_boxes(&depths, sums, moments), 0);
    sums_pass_free(&pass);
    close_depths(&depths);
    free(sums);
}

static void test_sums(void **state) {
    (void)state;
    check_sums(16, 2);
    check_sums(301, 2);
    check_sums(301, 4);
}

/* --- bounds ----------------------------------------------------------------------------------- */

/* How many bounds of a layer are not those of the texels that they are said to be of. Texel (x, y) lies in the
 * square of its place over 2^(level + 1), or in the last. */
static int wrong_squares(const struct depths *depths, const struct depth_bounds *maps,
                         const float *bounds, int level, int layer) {
    int size = depths->size, base = size / 2, side = bounds_side(base, level), wrong = 0;
    const struct texture_desc *desc = &maps->bounds.desc;
    float *found = mem_alloc((size_t)(side * side * 2), sizeof *found);
    for (int i = 0; i < side * side * 2; i++)
        found[i] = i % 2 ? -INFINITY : INFINITY;
    for (int i = 0; i < size * size; i++) {
        int x = i % size >> (level + 1), y = i / size >> (level + 1);
        float *square = found + 2 * ((y < side ? y : side - 1) * side + (x < side ? x : side - 1));
        float z = (float)depth_at(depths, i % size, i / size, layer);
        square[0] = fminf(square[0], z);
        square[1] = fmaxf(square[1], z);
    }
    for (int i = 0; i < side * side * 2; i++) {
        int x = i / 2 % side + bounds_x(base, level), y = i / 2 / side + bounds_y(base, level);
        wrong += bounds[((layer * desc->height + y) * desc->width + x) * 2 + i % 2] != found[i];
    }
    free(found);
    return wrong;
}

static void test_bounds(void **state) {
    (void)state;
    static const int sizes[] = {2, 16, 37, 300};
    struct timers timers;
    struct frame frame = untimed_frame(&timers);
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        struct depths depths;
        struct depth_bounds_pass pass;
        size_t count = (size_t)(sizes[s] * sizes[s] * LAYERS_TESTED);
        float *bounds = mem_alloc(count, 2 * sizeof *bounds);
        open_depths(&depths, sizes[s]);
        check_ok("pass", depth_bounds_pass_init(&pass, sizes[s], LAYERS_TESTED));
        depth_bounds_pass_render(&pass, &frame, &depths.map);
        int wrong = 0, levels = pass.maps.levels;
        gl.GetTextureImage(pass.maps.bounds.id, 0, GL_RG, GL_FLOAT,
                           (GLsizei)(count * 2 * sizeof *bounds), bounds);
        for (int level = 0; level < levels; level++)
            for (int layer = 1; layer < LAYERS_TESTED; layer++) /* all of it depths */
                wrong += wrong_squares(&depths, &pass.maps, bounds, level, layer);
        printf("    %d^2 texels, %d levels\n", sizes[s], levels);
        check_at_most("bounds that are others", wrong, 0);
        depth_bounds_pass_free(&pass);
        close_depths(&depths);
        free(bounds);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sums),
        cmocka_unit_test(test_bounds),
    };
    return cmocka_run_group_tests_name("prefilter", tests, open_group_context, close_group_context);
}
