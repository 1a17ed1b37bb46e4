/* Edges: the samples of a pixel against areas that are known, and against a picture of many more
 * pixels. */
#include "gltf_parts.h"
#include "render_support.h"

#include "passes/frame.h"
#include "passes/picture/antialias.h"

#include <cglm/cglm.h>

enum { SIZE = 48, FINER = 8 };

/* --- coverage of an outline ------------------------------------------------------------------- */

struct polygon {
    int count;
    double at[16][2];
};

/* The part of a polygon where x (axis 0) or y, times sign, is at most bound times sign. */
static struct polygon clip(const struct polygon *polygon, int axis, double sign, double bound) {
    struct polygon kept = {0};
    for (int i = 0; i < polygon->count; i++) {
        const double *a = polygon->at[i], *b = polygon->at[(i + 1) % polygon->count];
        double inside_a = sign * (bound - a[axis]), inside_b = sign * (bound - b[axis]);
        if (inside_a >= 0)
            memcpy(kept.at[kept.count++], a, sizeof *kept.at);
        if ((inside_a < 0) != (inside_b < 0)) {
            double t = inside_a / (inside_a - inside_b);
            for (int c = 0; c < 2; c++)
                kept.at[kept.count][c] = a[c] + t * (b[c] - a[c]);
            kept.count++;
        }
    }
    return kept;
}

static double area(const struct polygon *polygon) {
    double sum = 0;
    for (int i = 0; i < polygon->count; i++) {
        const double *a = polygon->at[i], *b = polygon->at[(i + 1) % polygon->count];
        sum += a[0] * b[1] - a[1] * b[0];
    }
    return fabs(sum) / 2;
}

static double covered(const struct polygon *outline, int x, int y) {
    struct polygon p = clip(outline, 0, -1, x);
    p = clip(&p, 0, 1, x + 1);
    p = clip(&p, 1, -1, y);
    p = clip(&p, 1, 1, y + 1);
    return area(&p);
}

/* The corners of the box's open front, as the picture shows them, row 0 at the top. */
static struct polygon front_outline(const struct renderer *renderer) {
    const struct geometry *geometry = renderer->desc.geometry;
    const float *low = geometry->bounds_min, *high = geometry->bounds_max;
    struct polygon outline = {.count = 4};
    for (int i = 0; i < 4; i++) {
        vec4 corner = {i == 0 || i == 3 ? low[0] : high[0], i < 2 ? low[1] : high[1], high[2], 1};
        vec4 at;
        glm_mat4_mulv((vec4 *)renderer->camera_view.world_to_clip, corner, at);
        outline.at[i][0] = (at[0] / at[3] * .5 + .5) * SIZE;
        outline.at[i][1] = (.5 - at[1] / at[3] * .5) * SIZE;
    }
    return outline;
}

/* RMS over the pixels that an edge goes through. */
static double coverage_error(const struct stage *stage, const char *settings) {
    struct renderer renderer;
    struct image image;
    open_renderer(&renderer, desc_of(stage, "unshadowed", settings, SIZE, SIZE));
    check_ok("layers", renderer_read_layers(&renderer, &image));
    struct polygon outline = front_outline(&renderer);
    int channel = image_find_channel(&image, "A"), edges = 0;
    double sum = 0;
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            double exact = covered(&outline, x, y), error;
            error = (double)image_at(&image, x, y)[channel] - exact;
            if (exact > 0 && exact < 1) {
                edges++;
                sum += error * error;
            } else {
                assert_true(fabs(error) < 1e-6);
            }
        }
    image_free(&image);
    renderer_free(&renderer);
    assert_true(edges > SIZE);
    return sqrt(sum / edges);
}

/* A pixel that an edge crosses along x or y is off by sqrt(1/12) = .29 at its centre, and one that
 * it crosses aslant by .22. Of the patterns of 4, 8, 12 and 16 samples the worst slope is off by
 * .128, .100, .086 and .069; a tenth is for where these edges happen to fall. */
TEST(coverage) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    for (int axis = 0; axis < 3; axis++) { /* rolled, so that edges are at all slopes and places */
        float *right = stage.camera.right, *up = stage.camera.up;
        for (int c = 0; c < 3; c++) {
            float r = right[c], u = up[c];
            right[c] = r * .9553F + u * .2955F; /* .3 rad */
            up[c] = u * .9553F - r * .2955F;
        }
        printf("  rolled by %.1f\n", .3 * (axis + 1));
        check_near("coverage by the centre alone", coverage_error(&stage, "samples=1"), .25, .05);
        check_at_most("coverage by 4 samples", coverage_error(&stage, "samples=4"), .14);
        check_near("5 samples, of which there are 8", coverage_error(&stage, "samples=5"),
                   coverage_error(&stage, "samples=8"), 0);
        check_at_most("coverage by 8 samples", coverage_error(&stage, "samples=8"), .11);
        check_at_most("coverage by 12 samples", coverage_error(&stage, "samples=12"), .095);
        check_at_most("coverage by 16 samples", coverage_error(&stage, "samples=16"), .085);
    }
}

/* Pixels that the outline covers from the side by so much of their width, and those of them that
 * see nothing. */
static void count_slivers(struct renderer *renderer, int *slivers, int *missed) {
    OWNED(image) image;
    renderer_render(renderer);
    check_ok("layers", renderer_read_layers(renderer, &image));
    struct polygon outline = front_outline(renderer);
    int channel = image_find_channel(&image, "A");
    for (int y = 1; y < SIZE - 1; y++)
        for (int x = 1; x < SIZE - 1; x++) {
            double here = covered(&outline, x, y), left = covered(&outline, x - 1, y),
                   right = covered(&outline, x + 1, y), below = covered(&outline, x, y - 1),
                   above = covered(&outline, x, y + 1);
            bool even = fabs(left + right - 2 * here) < .01 || fabs(below + above - 2 * here) < .01;
            if (here < .01 || here > .03 || !even)
                continue;
            ++*slivers;
            *missed += image_at(&image, x, y)[channel] == 0;
        }
}

/* A layer of light tells of a sliver what it tells of a whole pixel: none of a hundredth of a
 * pixel's width is black. */
TEST(slivers) {
    enum { ZOOMS = 32 };
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(renderer) renderer;
    int slivers = 0, missed = 0;
    struct renderer_desc desc = desc_of(&stage, "unshadowed", "vpls=64 samples=12", SIZE, SIZE);
    open_renderer(&renderer, desc);
    for (int i = 0; i < ZOOMS; i++) {
        desc.camera.fov_y = stage.camera.fov_y * (1 + .002F * (float)i);
        check_ok("zoom", renderer_follow(&renderer, &desc));
        count_slivers(&renderer, &slivers, &missed);
    }
    printf("    of %d slivers %d are not seen\n", slivers, missed);
    assert_true(slivers > 32);
    assert_int_equal(missed, 0);
}

/* --- the layers at edges ---------------------------------------------------------------------- */

/* Each pixel the mean of FINER x FINER; all channels. */
static struct image shrink(const struct image *fine) {
    struct image image;
    image_init(&image, fine->width / FINER, fine->height / FINER, fine->names[0]);
    for (int c = 1; c < fine->channel_count; c++)
        image_add_channels(&image, fine->names[c]);
    for (int y = 0; y < fine->height; y++)
        for (int x = 0; x < fine->width; x++)
            for (int c = 0; c < fine->channel_count; c++)
                image_at(&image, x / FINER, y / FINER)[c] +=
                    image_at(fine, x, y)[c] / (FINER * FINER);
    return image;
}

/* Files have layers of light weighted by albedo, so that R = albedo (direct + indirect) at edges
 * too. */
static double worst_of_sum(const struct image *image) {
    int albedo[3], direct[3], indirect[3];
    double worst = 0;
    check_ok("albedo", image_find_layer(image, "albedo", albedo));
    check_ok("direct", image_find_layer(image, "direct", direct));
    check_ok("indirect", image_find_layer(image, "indirect", indirect));
    for (int i = 0; i < image->width * image->height * 3; i++) {
        const float *pixel = image_at(image, i / 3 % image->width, i / 3 / image->width);
        float sum = pixel[albedo[i % 3]] * (pixel[direct[i % 3]] + pixel[indirect[i % 3]]);
        worst = fmax(worst, fabs((double)(pixel[i % 3] - sum)));
    }
    return worst;
}

/* Without interleaving and clusters, whose noise would differ between the sizes. */
#define SMOOTH "interleave=1 blur-radius=0 clamp=disk vpls=64 "

static void check_layer(const struct image *center, const struct image *edges,
                        const struct image *reference, const char *layer, double bound) {
    double before = relative_rmse(center, reference, layer),
           after = relative_rmse(edges, reference, layer);
    printf("    %s: error %.4f with the centre alone, %.4f with 8 samples\n", layer, before, after);
    check_at_most("their ratio", after / before, bound);
}

/* Bounds of the error that is left, of the albedo and of the picture, whose shadows have
 * edges too. */
static void check_layers(const char *path, double albedo, double beauty) {
    OWNED(stage) stage = open_stage(path);
    printf("  %s\n", path);
    OWNED(image) fine = render_stage(&stage, "unshadowed", SMOOTH "samples=1", SIZE * FINER);
    OWNED(image) reference = shrink(&fine);
    OWNED(image) center = render_stage(&stage, "unshadowed", SMOOTH "samples=1", SIZE);
    OWNED(image) edges = render_stage(&stage, "unshadowed", SMOOTH "samples=8", SIZE);
    check_layer(&center, &edges, &reference, "albedo", albedo);
    check_layer(&center, &edges, &reference, "beauty", beauty);
    check_at_most("R - albedo (direct + indirect)", worst_of_sum(&edges), 1e-4);
}

TEST(layers) {
    check_layers("scenes/cornell-box.glb", .35, .8);
    check_layers("scenes/cornell-animal.glb", .35, 1);
    /* Much of it is thinner than a pixel, and some of that no pixel's centre has seen. */
    check_layers("scenes/atrium.glb", .75, .9);
}

/* --- edge samples ---------------------------------------------------------------------------- */

/* All VPLs at what lists have, and a quarter elsewhere, blurred over as many pixels. */
#define DETAIL "interleave=2 blur-radius=1 adaptive=1 clamp=disk vpls=64 samples=8 "

/* Things thinner than a pixel are lit as they are, not as what lies beside or behind them. */
TEST(edge_samples) {
    OWNED(stage) stage = open_stage("scenes/atrium.glb");
    OWNED(image) fine = render_stage(&stage, "unshadowed", SMOOTH "samples=1", SIZE * FINER);
    OWNED(image) reference = shrink(&fine);
    OWNED(image) without = render_stage(&stage, "unshadowed", DETAIL "edge-samples=off", SIZE);
    OWNED(image) with = render_stage(&stage, "unshadowed", DETAIL, SIZE);
    double before = relative_rmse(&without, &reference, "indirect"),
           after = relative_rmse(&with, &reference, "indirect");
    printf("    error of indirect light %.4f without edge samples, %.4f with them\n", before,
           after);
    check_at_most("their ratio", after / before, .9);
    check_at_most("R - albedo (direct + indirect)", worst_of_sum(&with), 1e-4);
}

/* As few layers as can be: no other number of samples that a driver has in one gives fewer, or as
 * many with fewer samples in all. */
TEST(sample_layers) {
    static const int sizes[] = {4, 8, 16};
    for (int samples = 2; samples <= 16; samples++)
        for (int most = 4; most <= 64; most++) {
            struct sample_layers found = sample_layers(samples, most);
            assert_true(found.samples_of_layer <= most);
            assert_true(found.layers * found.samples_of_layer >= samples);
            for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
                int layers = (samples + sizes[i] - 1) / sizes[i];
                if (sizes[i] <= most)
                    assert_true(found.layers < layers ||
                                (found.layers == layers && found.samples_of_layer <= sizes[i]));
            }
        }
    const struct {
        int most, layers, of_layer;
    } rows[] = {{4, 3, 4}, {6, 3, 4}, {8, 2, 8}, {16, 1, 16}, {32, 1, 16}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct sample_layers found = sample_layers(12, rows[i].most);
        printf("    12 samples, at most %2d a layer: %d of %d\n", rows[i].most, found.layers,
               found.samples_of_layer);
        assert_int_equal(found.layers, rows[i].layers);
        assert_int_equal(found.samples_of_layer, rows[i].of_layer);
    }
}

RUN_TESTS(open_group_context, close_group_context)
