/* What filters of soft shadows read instead of many texels, against brute force: summed area
 * tables, bit for bit, also where they wrap; nearest and farthest depths of windows. And what
 * filters make of them, where the answer is known. */
#include "render_support.h"

#include "passes/frame.h"
#include "passes/visibility/basis.h"
#include "passes/visibility/depth_bounds.h"
#include "passes/visibility/sums.h"
#include "shared/maps.h"

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
    check_ok("map", texture_init(&depths->map,
                                 &FILLED(texture_desc, .label = "depths",
                                         .target = GL_TEXTURE_2D_ARRAY, .format = GL_R32F,
                                         .width = size, .height = size, .layers = LAYERS_TESTED)));
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
    check_ok("pass",
             sums_pass_init(&pass, &(struct sums_desc){
                                       .size = size, .count = LAYERS_TESTED, .moments = moments}));
    sums_pass_render(&pass, &frame, &depths.map, NULL);
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

TEST(sums) {
    check_sums(16, 2);
    check_sums(301, 2);
    check_sums(301, 4);
}

/* --- sums of Fourier bases -------------------------------------------------------------------- */

enum { TERMS = 5, GROUPS = 2, BASIS_KINDS = 5 }; /* a group is not full */

/* cos, sin, and both times the argument, of term k; and that alone. */
static double basis_of(const struct series_range *range, double z, int kind, int k) {
    double beyond = fmax(z - (double)range->nearest, 0);
    double a = (double)range->scale * beyond / (beyond + (double)range->knee);
    double angle = acos(-1) * (2 * k + 1) * a;
    return (kind == 4 ? 1 : kind % 2 ? sin(angle) : cos(angle)) * (kind < 2 ? 1 : a);
}

/* The farthest that the mean over a box is from that of its texels, of any base. */
static double box_error(const struct depths *depths, const uint32_t *sums,
                        const struct series_range *range, const int box[4]) {
    int side = depths->size + 1, layer = 1; /* all of it depths */
    double worst = 0, texels = (box[2] - box[0]) * (box[3] - box[1]);
    for (int i = 0; i < (BASIS_KINDS - 1) * TERMS + 1; i++) {
        int kind = i / TERMS, k = i % TERMS, table = kind * GROUPS + k / 4;
        const uint32_t *at =
            sums + (size_t)(table * LAYERS_TESTED + layer) * (size_t)(side * side) * 4;
#define TABLE_AT(x, y) at[((y)*side + (x)) * 4 + k % 4]
        uint32_t sum = TABLE_AT(box[2], box[3]) - TABLE_AT(box[0], box[3]) -
                       TABLE_AT(box[2], box[1]) + TABLE_AT(box[0], box[1]);
        double expected = 0;
        for (int y = box[1]; y < box[3]; y++)
            for (int x = box[0]; x < box[2]; x++)
                expected += basis_of(range, depth_at(depths, x, y, layer), kind, k) / texels;
        worst = fmax(worst, fabs(2 * sum / (texels * SUM_BASIS_ONE) - 1 - expected));
    }
    return worst;
}

/* As exact as a texel's twelve bits, in boxes of all widths: that of all texels wraps in
 * no table. */
TEST(basis_sums) {
    enum { SIZE = 300, SIDE = SIZE + 1 };
    static const int boxes[][4] = {{0, 0, SIZE, SIZE},
                                   {7, 3, 8, 4},
                                   {299, 299, 300, 300},
                                   {17, 200, 217, 205},
                                   {1, 0, 299, 300}};
    struct depths depths;
    struct basis_pass basis;
    struct sums_pass pass;
    struct timers timers;
    struct frame frame = untimed_frame(&timers);
    struct series_range ranges[LAYERS_TESTED];
    open_depths(&depths, SIZE);
    check_ok("ranges",
             basis_pass_init(&basis, &FILLED(basis_desc, .size = SIZE, .count = LAYERS_TESTED,
                                             .terms = TERMS, .ranges_alone = true)));
    check_ok("sums",
             sums_pass_init(
                 &pass, &(struct sums_desc){.size = SIZE, .count = LAYERS_TESTED, .terms = TERMS}));
    basis_pass_render(&basis, &frame, &depths.map);
    sums_pass_render(&pass, &frame, &depths.map, &basis.maps.ranges);
    buffer_read(&basis.maps.ranges, 0, sizeof ranges, ranges);
    size_t count = (size_t)pass.maps.sums.desc.layers * SIDE * SIDE * 4;
    uint32_t *sums = mem_alloc(count, sizeof *sums);
    gl.GetTextureImage(pass.maps.sums.id, 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                       (GLsizei)(count * sizeof *sums), sums);
    for (size_t i = 0; i < sizeof boxes / sizeof *boxes; i++)
        check_at_most("mean of a box", box_error(&depths, sums, &ranges[1], boxes[i]),
                      1.01 / SUM_BASIS_ONE);
    basis_pass_free(&basis);
    sums_pass_free(&pass);
    close_depths(&depths);
    free(sums);
}

/* --- bounds ----------------------------------------------------------------------------------- */

/* How many bounds of a layer are not those of the texels that they are said to be of. Texel (x, y)
 * lies in the square of its place over 2^(level + 1), or in the last. */
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

TEST(bounds) {
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

/* --- filters ---------------------------------------------------------------------------------- */

enum { CELLS = 5 };

/* Of one cell, in and out; as in cells.comp. */
struct answer {
    float moments[4], plane, share, depth, unused;
};

/* A share of the cell is at one depth, the rest at another. */
static struct answer two_depths(double share, double near, double far, double plane) {
    struct answer answer = {.plane = (float)plane};
    for (int m = 0; m < 4; m++)
        answer.moments[m] = (float)(share * pow(near, m + 1) + (1 - share) * pow(far, m + 1));
    return answer;
}

static void ask(int filter, struct answer answers[CELLS]) {
    struct depths depths;
    open_depths(&depths, 16);
    ask_shader(&FILLED(questions, .shader = "cells.comp",
                       .defines = form("FILTER %d;SEARCH_PARTS 2;SHADOW_PARTS 2", filter),
                       .answers = answers, .answer_bytes = CELLS * sizeof *answers,
                       .groups = {CELLS}, .textures = {{UNIT_MAP_DEPTH, depths.map.id}}));
    close_depths(&depths);
}

static const int moment_filters[] = {FILTER_VSSM, FILTER_MSM};
static const char *const moment_names[] = {"vssm", "msm"};

/* One caster before a receiver that is in the map: both are exact, but for the bias of four
 * moments. */
TEST(two_depths) {
    static const double shares[CELLS] = {.1, .25, .5, .75, .9}, near[CELLS] = {.3, .5, .2, .6, .4};
    for (int f = 0; f < 2; f++) {
        struct answer answers[CELLS];
        double share = 0, depth = 0;
        for (int i = 0; i < CELLS; i++)
            answers[i] = two_depths(shares[i], near[i], .7, .7);
        ask(moment_filters[f], answers);
        for (int i = 0; i < CELLS; i++) {
            share = fmax(share, fabs((double)answers[i].share - shares[i]));
            depth = fmax(depth, fabs((double)answers[i].depth - near[i]));
        }
        printf("    %s\n", moment_names[f]);
        check_at_most("shares", share, f == 0 ? 1e-5 : 1e-4);
        check_at_most("depths of casters", depth, f == 0 ? 1e-5 : 1e-4);
    }
}

/* Two casters that hide all of the light, a apart, the receiver b behind the second: two moments
 * light it by Chebyshev's inequality, four do not. */
TEST(bleeding) {
    static const double behind[CELLS] = {.25, .5, 1, 2, 4}; /* b / a */
    static const double lit[CELLS] = {.308, .2, .1, .038, .012};
    const double a = .08;
    for (int f = 0; f < 2; f++) {
        struct answer answers[CELLS];
        double worst = 0;
        for (int i = 0; i < CELLS; i++)
            answers[i] = two_depths(.5, .4, .4 + a, .4 + a + behind[i] * a);
        ask(moment_filters[f], answers);
        for (int i = 0; i < CELLS; i++)
            worst = fmax(worst, fabs(1 - (double)answers[i].share - (f == 0 ? lit[i] : 0)));
        check_at_most(f == 0 ? "vssm, from what Chebyshev says" : "msm, light", worst,
                      f == 0 ? 6e-4 : .004);
    }
}

/* The straight part of a truncated series. */
TEST(steps) {
    static const struct {
        int terms;
        double zero, full;
    } rows[] = {{2, .6027, .9244}, {4, .6105, .9459}, {8, .6125, .9501}, {16, .6130, .9511}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct series_step step = series_step_of(rows[i].terms);
        printf("    %d terms\n", rows[i].terms);
        check_near("zero", 2 * rows[i].terms * step.zero, rows[i].zero, 1e-4);
        check_near("least behind the peak", step.full, rows[i].full, 1e-4);
    }
}

RUN_TESTS(open_group_context, close_group_context)
