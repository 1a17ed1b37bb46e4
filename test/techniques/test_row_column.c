/* Matrix row-column sampling: clusters of columns and what they promise, rows against pictures, and
 * pictures against those of all VPLs. */
#include "render_support.h"

#include "passes/frame.h"
#include "passes/visibility/vpl_views.h"
#include "shared/gather.h"
#include "techniques/row-column/columns.h"
#include "techniques/row-column/rows.h"

static const char name[] = "row-column";

/* --- columns ---------------------------------------------------------------------------------- */

enum { LIGHTS = 60, ROWS = 12 };

/* A matrix with lights of `kinds` directions, some of them black, and some that no row sees. */
struct sample {
    struct columns columns;
    float matrix[ROWS][LIGHTS][4], powers[LIGHTS];
};

static float random_number(void) {
    return (float)rand() / (float)RAND_MAX;
}

static bool is_black(int light) {
    return light % 10 == 3;
}

static bool is_unseen(int light) {
    return light % 20 == 5;
}

static void open_sample(struct sample *sample, int kinds, int count) {
    float directions[LIGHTS][ROWS][3];
    srand(3);
    for (int k = 0; k < kinds; k++)
        for (int r = 0; r < ROWS; r++)
            for (int c = 0; c < 3; c++)
                directions[k][r][c] = rand() % 3 ? random_number() : 0;
    for (int i = 0; i < LIGHTS; i++) {
        float length = is_black(i) ? 0 : .2f + random_number();
        sample->powers[i] = length;
        for (int r = 0; r < ROWS; r++)
            for (int c = 0; c < 3; c++)
                sample->matrix[r][i][c] = is_unseen(i) ? 0 : length * directions[i % kinds][r][c];
    }
    columns_init(&sample->columns, &(struct columns_desc){LIGHTS, ROWS, count});
    columns_cluster(&sample->columns, &sample->matrix[0][0], ROWS, sample->powers, 1);
}

static double error_of_clusters(const struct columns *columns) {
    double error = 0;
    for (int c = 0; c < columns->cluster_count; c++)
        error += columns->clusters[c].error;
    return error;
}

static double exact_sum(const struct sample *sample, int row, int channel) {
    double sum = 0;
    for (int i = 0; i < LIGHTS; i++)
        sum += (double)sample->matrix[row][i][channel];
    return sum;
}

/* The squared error of the rows' sums by one choice; adds the sums up. */
static double error_of_choice(const struct sample *sample, uint32_t seed, double sums[ROWS][3]) {
    struct column chosen[LIGHTS];
    int count = columns_choose(&sample->columns, seed, chosen);
    double error = 0;
    for (int r = 0; r < ROWS; r++)
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            for (int i = 0; i < count; i++)
                sum += (double)(chosen[i].weight * sample->matrix[r][chosen[i].light][c]);
            sums[r][c] += sum;
            error += pow(sum - exact_sum(sample, r, c), 2);
        }
    return error;
}

/* Over many choices the rows' mean is their sum, and their mean squared error what the clusters
 * tell. */
TEST(expectation) {
    enum { CHOICES = 20000 };
    static struct sample sample;
    double sums[ROWS][3] = {{0}}, errors = 0, squares = 0, worst = 0;
    open_sample(&sample, LIGHTS, 10);
    assert_int_equal(sample.columns.cluster_count, 10);
    double expected = error_of_clusters(&sample.columns);
    for (uint32_t seed = 0; seed < CHOICES; seed++) {
        double error = error_of_choice(&sample, seed, sums);
        errors += error;
        squares += error * error;
    }
    double mean = errors / CHOICES, sigma = sqrt((squares / CHOICES - mean * mean) / CHOICES);
    printf("  expected error %.5g, measured %.5g, of which 3 sigma are %.2g\n", expected, mean,
           3 * sigma);
    check_near("measured error, over the expected one", mean / expected, 1, 3 * sigma / expected);
    for (int r = 0; r < ROWS; r++)
        for (int c = 0; c < 3; c++)
            worst = fmax(worst, fabs(sums[r][c] / CHOICES - exact_sum(&sample, r, c)));
    check_at_most("worst mean of a row, off its sum, in standard errors",
                  worst / sqrt(expected / CHOICES), 3);
    columns_free(&sample.columns);
}

/* Black lights are never chosen, and those that no row sees are in the end; weights are what
 * clusters hold. */
TEST(choice) {
    static struct sample sample;
    struct column chosen[LIGHTS];
    int times[LIGHTS] = {0};
    open_sample(&sample, LIGHTS, 10);
    for (uint32_t seed = 0; seed < 5000; seed++) {
        int count = columns_choose(&sample.columns, seed, chosen);
        assert_int_equal(count, 10);
        for (int i = 0; i < count; i++) {
            times[chosen[i].light]++;
            assert_true(chosen[i].weight >= 1);
            assert_true(i == 0 || chosen[i - 1].light < chosen[i].light);
        }
    }
    for (int i = 0; i < LIGHTS; i++)
        if (is_black(i) != (times[i] == 0))
            fail_msg("light %d was chosen %d times", i, times[i]);
    columns_free(&sample.columns);
}

/* As many clusters as there are lights, or directions of columns, leave no error; more
 * leave less. */
TEST(clusters) {
    static struct sample sample;
    struct column chosen[LIGHTS];
    double before = INFINITY;
    for (int count = 1; count <= 32; count *= 2) {
        open_sample(&sample, LIGHTS, count);
        double error = error_of_clusters(&sample.columns);
        printf("  %d clusters: %.5g\n", count, error);
        assert_int_equal(sample.columns.cluster_count, count);
        check_at_most("error, over that of half as many", error / before, .9);
        before = error;
        columns_free(&sample.columns);
    }
    open_sample(&sample, LIGHTS, LIGHTS);
    int count = columns_choose(&sample.columns, 1, chosen);
    assert_int_equal(count, LIGHTS - LIGHTS / 10);
    for (int i = 0; i < count; i++)
        assert_true(chosen[i].weight == 1);
    columns_free(&sample.columns);
    for (int kinds = 2; kinds <= 8; kinds *= 2) {
        open_sample(&sample, kinds, 10);
        /* What no row sees has a cluster, too. */
        double squares = 0;
        for (int r = 0; r < ROWS; r++)
            for (int c = 0; c < 3; c++)
                squares += pow(exact_sum(&sample, r, c), 2);
        check_at_most("error of few directions, over the squared sums",
                      error_of_clusters(&sample.columns) / squares, 1e-5);
        columns_free(&sample.columns);
    }
}

/* --- rows ------------------------------------------------------------------------------------- */

/* With a row for each pixel: sum over VPLs, over pi for the layer's sake and pi for that of
 * Lambert. */
static void compare_rows(const float (*matrix)[4], int vpls, const struct image *picture) {
    int channel = image_find_channel(picture, "indirect.R"), size = picture->width;
    double worst = 0, most = 0;
    for (int y = 0; y < size; y++)
        for (int x = 0; x < size; x++) {
            const float(*row)[4] = &matrix[((size - 1 - y) * size + x) * vpls];
            double sum = 0, expected = (double)image_at(picture, x, y)[channel];
            for (int i = 0; i < vpls; i++)
                sum += (double)row[i][0] / (GLM_PI * GLM_PI);
            worst = fmax(worst, fabs(sum - expected));
            most = fmax(most, expected);
        }
    check_at_most("worst row's sum off its pixel, over the brightest pixel", worst / most, 1e-4);
}

/* All rows are the picture: what a row has of a VPL is what the gather takes. */
TEST(rows) {
    enum { SIZE = 16, VPLS = 64 };
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    struct output_list outputs;
    struct rows_pass rows;
    struct vpl_views_pass views;
    struct buffer gather_params;
    OWNED(image) picture;
    static const struct gather_params zeros;
    open_renderer(&renderer, desc_of(&stage, "unshadowed",
                                     "vpls=64 interleave=1 clamp=none blur-radius=0", SIZE, SIZE));
    check_ok("layers", renderer_read_layers(&renderer, &picture));
    renderer_outputs(&renderer, &outputs);
    const struct vpl_buffer *vpls = output_vpls(&outputs);
    check_ok("rows", rows_pass_init(&rows, &(struct rows_desc){.rows = SIZE * SIZE,
                                                               .lights = VPLS,
                                                               .visibility.map_count = 1}));
    check_ok("views", vpl_views_pass_init(&views, 0));
    check_ok("params", buffer_init(&gather_params, "params", sizeof zeros, &zeros));
    struct frame frame = renderer_frame(&renderer);
    rows_pass_pick(&rows, &frame, &renderer.gbuffer, 7);
    assert_int_equal(rows.pixels.count, SIZE * SIZE);
    struct vpl_buffer pixels = rows.pixels;
    pixels.sums = vpls->sums;
    vpl_views_pass_render(&views, &frame, &pixels, 0, pixels.count);
    rows_pass_render(&rows, &frame,
                     &FILLED(rows_inputs, .vpls = vpls, .count = pixels.count,
                             .gather_params = &gather_params, .visibility.views = &views.views));
    float(*matrix)[4] = mem_alloc(SIZE * SIZE * VPLS, sizeof *matrix);
    rows_pass_read(&rows, matrix);
    compare_rows((const float(*)[4])matrix, VPLS, &picture);
    free(matrix);
    buffer_free(&gather_params);
    vpl_views_pass_free(&views);
    rows_pass_free(&rows);
}

/* --- pictures --------------------------------------------------------------------------------- */

#define PLAIN "vpls=64 interleave=1 near-samples=16 map-size=128 "

/* As many columns as VPLs are all of them, whatever the rows; of two bounces, too. */
TEST(all_columns) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    static const char *const more[] = {"", "bounces=2 paths=256"};
    for (int i = 0; i < 2; i++) {
        char settings[160];
        snprintf(settings, sizeof settings, PLAIN "%s", more[i]);
        OWNED(image) reference = render_stage(&stage, "instant-radiosity", settings, 48);
        snprintf(settings, sizeof settings, PLAIN "columns=320 rows=%d %s", i ? 10 : 1, more[i]);
        OWNED(image) all = render_stage(&stage, name, settings, 48);
        check_at_most("all columns, against instant radiosity",
                      relative_rmse(&all, &reference, "indirect"), 1e-4);
    }
}

/* The mean over choices is the picture of all VPLs; and the more columns, the less each is off. */
TEST(mean) {
    enum { CHOICES = 12 };
    double sum = 0, squares = 0, errors[2] = {0};
    OWNED(stage) stage = open_stage("scenes/cornell-animal.glb");
    for (int i = 0; i < 2 * CHOICES; i++) {
        const char *all = form(PLAIN "seed=%d ", i);
        const char *settings = form("%scolumns=%d rows=36", all, i < CHOICES ? 12 : 32);
        OWNED(image) reference = render_stage(&stage, "instant-radiosity", all, 32);
        OWNED(image) image = render_stage(&stage, name, settings, 32);
        double mean = layer_mean(&image, "indirect") / layer_mean(&reference, "indirect");
        if (i < CHOICES) {
            sum += mean;
            squares += mean * mean;
        }
        errors[i / CHOICES] += relative_rmse(&image, &reference, "indirect") / CHOICES;
    }
    double mean = sum / CHOICES;
    double sigma = sqrt((squares / CHOICES - mean * mean) / (CHOICES - 1));
    printf("  12 columns: mean %.4f, standard error %.4f, relative RMSE %.4f; 32: %.4f\n", mean,
           sigma, errors[0], errors[1]);
    check_near("mean of pictures, over that of all VPLs", mean, 1, 3 * sigma);
    check_at_most("32 columns, over 12", errors[1] / errors[0], .75);
}

/* In a diffuse box chosen VPLs are as good as as many plain ones: all of them do alike. */
TEST(against_plain) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    struct image plain =
        render_stage(&stage, "instant-radiosity", "vpls=40 interleave=1 map-size=64", 48);
    /* A driver that rounds sums otherwise makes another choice: the bound is of the mean of
     * several. */
    enum { CHOICES = 6 };
    double error = 0;
    for (int i = 0; i < CHOICES; i++) {
        const char *all = form("vpls=256 interleave=1 map-size=64 seed=%d ", i);
        const char *settings = form("%srows=64 columns=40", all);
        OWNED(image) reference = render_stage(&stage, "instant-radiosity", all, 48);
        OWNED(image) chosen = render_stage(&stage, name, settings, 48);
        double own = relative_rmse(&chosen, &reference, "indirect");
        if (i == 0)
            printf("  40 plain VPLs %.4f\n", relative_rmse(&plain, &reference, "indirect"));
        printf("  choice %d: %.4f\n", i, own);
        error += own / CHOICES;
    }
    check_at_most("40 columns of 256 VPLs", error, .15);
    image_free(&plain);
}

RUN_TESTS(open_group_context, close_group_context)
