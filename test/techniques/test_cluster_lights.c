/* Area lights of clusters: rectangles against closed forms and sums, clusters' shapes and fluxes,
 * and pictures against the sum over all VPLs. */
#include "base/unit.h"
#include "render_support.h"

#include "base/halton.h"
#include "gl/framebuffer.h"
#include "passes/frame.h"
#include "passes/lights/cluster.h"
#include "passes/lights/cluster_light.h"
#include "shared/cluster.h"
#include "shared/gather.h"
#include "shared/vpl.h"

/* --- rectangles ------------------------------------------------------------------------------- */

enum { CASES_MAX = 64 };

/* A rectangle and a receiver in the origin. */
struct form_case {
    vec3 middle, right, up, normal;
};

static struct form_case case_of(vec3 middle, vec3 right, vec3 up, vec3 normal) {
    struct form_case c;
    glm_vec3_copy(middle, c.middle);
    glm_vec3_copy(right, c.right);
    glm_vec3_copy(up, c.up);
    vec3_unit_to(normal, c.normal);
    return c;
}

static float area_of(const struct form_case *c) {
    return 4 * glm_vec3_norm((float *)c->right) * glm_vec3_norm((float *)c->up);
}

/* Form factors, by the shader. */
static void shaded(const struct form_case *cases, int count, double *factors) {
    static struct vpl vpls[VPLS_PER_BLOCK];
    static struct light_rectangle rectangles[LIGHT_RECTANGLES_MAX];
    vec4 normals[CASES_MAX] = {0};
    float answers[CASES_MAX];
    for (int i = 0; i < count; i++) {
        vpls[i] = (struct vpl){.area = area_of(&cases[i]), .flux = {1, 1, 1}, .reach = 1};
        glm_vec3_copy((float *)cases[i].middle, vpls[i].position);
        vec3_unit_cross((float *)cases[i].right, (float *)cases[i].up, vpls[i].normal);
        glm_vec3_copy((float *)cases[i].right, rectangles[i].right);
        glm_vec3_copy((float *)cases[i].up, rectangles[i].up);
        glm_vec3_copy((float *)cases[i].normal, normals[i]);
    }
    ask_shader(&FILLED(questions, .shader = "rectangle.comp", .asked = normals,
                       .asked_bytes = (size_t)count * sizeof *normals, .answers = answers,
                       .answer_bytes = sizeof answers, .groups = {1},
                       .blocks = {{BLOCK_VPLS, vpls, sizeof vpls},
                                  {BLOCK_LIGHT_RECTANGLES, rectangles, sizeof rectangles}}));
    for (int i = 0; i < count; i++)
        factors[i] = (double)(answers[i] * area_of(&cases[i])) / GLM_PI;
}

/* A corner of a parallel rectangle of sides a and b, at height h, X = a / h, Y = b / h. */
static double quarter(double x, double y) {
    return (x / sqrt(1 + x * x) * atan(y / sqrt(1 + x * x)) +
            y / sqrt(1 + y * y) * atan(x / sqrt(1 + y * y))) /
           (2 * GLM_PI);
}

TEST(squares) {
    struct form_case cases[4];
    double factors[4];
    /* Half a side over the height: 1, 1/2, 1/8, 1/100; the light shines down, we look up. */
    const float half_sides[4] = {1, .5f, .125f, .01f};
    for (int i = 0; i < 4; i++) {
        float s = half_sides[i];
        cases[i] = case_of((vec3){0, 0, 1}, (vec3){0, s, 0}, (vec3){s, 0, 0}, (vec3){0, 0, 1});
    }
    shaded(cases, 4, factors);
    check_near("square at half its side, F", factors[0], .5541, 5e-5);
    check_near("at its side", factors[1], 4 * quarter(.5, .5), 1e-5);
    check_near("at four times its side", factors[2], 4 * quarter(.125, .125), 1e-4 * factors[2]);
    check_near("far off", factors[3], 4 * quarter(.01, .01), 1e-4 * factors[3]);
}

/* Midpoints. */
static double summed(const struct form_case *c) {
    enum { SIDE = 800 };
    vec3 light_normal;
    double sum = 0;
    vec3_unit_cross((float *)c->right, (float *)c->up, light_normal);
    for (int i = 0; i < SIDE * SIDE; i++) {
        vec3 to;
        glm_vec3_copy((float *)c->middle, to);
        glm_vec3_muladds((float *)c->right, ((float)(i % SIDE) + .5f) * 2 / SIDE - 1, to);
        glm_vec3_muladds((float *)c->up, ((float)(i / SIDE) + .5f) * 2 / SIDE - 1, to);
        double d2 = (double)glm_vec3_norm2(to);
        double cosines = fmax((double)glm_vec3_dot((float *)c->normal, to), 0) *
                         fmax(-(double)glm_vec3_dot(light_normal, to), 0);
        sum += cosines / (d2 * d2);
    }
    return sum / (SIDE * SIDE) * (double)area_of(c) / GLM_PI;
}

/* The next corner is the first. */
static struct form_case turned(const struct form_case *c) {
    vec3 left;
    glm_vec3_negate_to((float *)c->right, left);
    return case_of((float *)c->middle, (float *)c->up, left, (float *)c->normal);
}

/* Aslant, through the horizon, from behind, far: against sums; where the rectangle is cut in two;
 * and turned. */
TEST(any) {
    struct form_case cases[16];
    double factors[16];
    vec3 right = {.1f, .8f, .1f}, up = {.6f, -.1f, .2f}, across;
    vec3_unit_cross(right, up, across);
    glm_vec3_cross(across, right, up);
    const struct {
        vec3 middle, normal;
    } places[4] = {
        {{.3f, .2f, 1}, {.2f, .1f, 1}},
        {{.3f, .2f, .6f}, {1, .1f, .1f}},
        {{2, -4, 9}, {.3f, .2f, 1}},
        {{.3f, .2f, -1}, {0, 0, -1}},
    };
    for (int i = 0; i < 4; i++) {
        vec3 half;
        glm_vec3_scale(right, .5f, half);
        cases[3 * i] = case_of((float *)places[i].middle, right, up, (float *)places[i].normal);
        cases[12 + i] = turned(&cases[3 * i]);
        for (int k = 0; k < 2; k++) {
            vec3 middle;
            glm_vec3_copy((float *)places[i].middle, middle);
            glm_vec3_muladds(half, k == 0 ? -1 : 1, middle);
            cases[3 * i + 1 + k] = case_of(middle, half, up, (float *)places[i].normal);
        }
    }
    shaded(cases, 16, factors);
    for (int i = 0; i < 4; i++) {
        double sum = summed(&cases[3 * i]);
        check_near("against a sum", factors[3 * i], sum, 2e-3 * sum + 1e-6);
        check_near("two halves", factors[3 * i + 1] + factors[3 * i + 2], factors[3 * i],
                   2e-3 * sum + 1e-6);
        check_near("from another corner on", factors[12 + i], factors[3 * i], 1e-4 * sum + 1e-6);
    }
    assert_true(factors[9] == 0);
}

/* --- shapes ----------------------------------------------------------------------------------- */

/* Clusters and their lights, of points that a test makes. */
struct maker {
    struct vpl_buffer vpls;
    struct cluster_pass cluster;
    struct cluster_light_pass shape;
    struct frame frame;
    struct timers untimed;
    struct vpl lights[LIGHT_RECTANGLES_MAX];
    struct light_rectangle rectangles[LIGHT_RECTANGLES_MAX];
};

static const struct geometry no_bounds;

static void open_maker(struct maker *maker, int vpl_count, const struct cluster_desc *desc) {
    *maker = (struct maker){0};
    struct cluster_desc cluster = *desc;
    cluster.vpl_count = vpl_count;
    cluster.metric = CLUSTER_METRIC_SQUARES;
    cluster.means_of_map = true;
    maker->frame.timers = &maker->untimed;
    maker->frame.geometry = &no_bounds;
    check_ok("points", vpl_buffer_init(&maker->vpls, "points", vpl_count));
    check_ok("clusters", cluster_pass_init(&maker->cluster, &cluster));
    check_ok("lights", cluster_light_pass_init(
                           &maker->shape, &(struct cluster_light_desc){.count = desc->val_count}));
    /* Lengths over one metre. */
    framebuffer_clear_color(maker->vpls.sums_framebuffer, 0, (float[]){0, 1, 0, 0});
}

static void close_maker(struct maker *maker) {
    vpl_buffer_free(&maker->vpls);
    cluster_pass_free(&maker->cluster);
    cluster_light_pass_free(&maker->shape);
}

static void make_lights(struct maker *maker, const struct vpl *vpls) {
    size_t count = (size_t)maker->shape.desc.count;
    buffer_write(&maker->vpls.buffer, 0, (size_t)maker->vpls.count * sizeof *vpls, vpls);
    cluster_pass_render(&maker->cluster, &maker->frame, &maker->vpls);
    cluster_light_pass_render(&maker->shape, &maker->frame, &maker->cluster.vpls,
                              cluster_pass_centers(&maker->cluster));
    buffer_read(&maker->shape.lights.buffer, 0, count * sizeof *maker->lights, maker->lights);
    buffer_read(&maker->shape.rectangles, 0, count * sizeof *maker->rectangles, maker->rectangles);
}

enum { POINTS = 10000 };

static const float half_length = 1.5f, half_width = .4f;

/* Even over a rectangle that is turned and far off, each with an area of 1 / POINTS of it. */
static void scatter_points(struct vpl *vpls) {
    vec3 along, across = {.2f, 1, -.4f}, normal = {1, .3f, .9f}, middle = {5, -2, 7};
    vec3_unit(normal);
    vec3_unit_cross(across, normal, along);
    glm_vec3_cross(normal, along, across);
    for (int i = 0; i < POINTS; i++) {
        float s = 2 * (float)radical_inverse(2, (uint32_t)i) - 1;
        float t = 2 * (float)radical_inverse(3, (uint32_t)i) - 1;
        vpls[i] = (struct vpl){
            .area = 4 * half_length * half_width / POINTS, .flux = {2, 1 + s / 4, 1}, .reach = 5};
        glm_vec3_copy(middle, vpls[i].position);
        glm_vec3_muladds(along, s * half_length, vpls[i].position);
        glm_vec3_muladds(across, t * half_width, vpls[i].position);
        glm_vec3_copy(normal, vpls[i].normal);
    }
}

static double summed_flux(const struct vpl *vpls, int count, int channel) {
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += (double)vpls[i].flux[channel];
    return sum;
}

TEST(sides) {
    static struct maker maker;
    struct vpl *vpls = mem_alloc(POINTS, sizeof *vpls);
    open_maker(&maker, POINTS, &(struct cluster_desc){.val_count = 1, .iterations = 2});
    scatter_points(vpls);
    for (int i = 0; i < POINTS; i++)
        vpls[i].flux[1] = 1;
    make_lights(&maker, vpls);
    const struct light_rectangle *r = maker.rectangles;
    check_near("half its length", (double)glm_vec3_norm((float *)r->right), 1.5, .015);
    check_near("half its width", (double)glm_vec3_norm((float *)r->up), .4, .004);
    vec3 normal;
    vec3_unit_cross((float *)r->right, (float *)r->up, normal);
    check_near("sides across the normal",
               (double)glm_vec3_dot(normal, (float *)maker.lights[0].normal), 1, 1e-5);
    check_near("area", (double)maker.lights[0].area, 2.4, .04);
    check_near("flux", (double)maker.lights[0].flux[0], 2 * POINTS, 1e-6 * POINTS);
    close_maker(&maker);
    free(vpls);
}

/* Two frames of 24 lights, the second from the means of the first; its points in the opposite
 * order. */
enum { LIGHTS = 24 };

static void make_twice(const struct vpl *vpls, bool turned, struct vpl lights[LIGHTS]) {
    static struct maker maker;
    struct vpl *second = mem_alloc(POINTS, sizeof *second);
    for (int i = 0; i < POINTS; i++)
        second[i] = vpls[turned ? POINTS - 1 - i : i];
    open_maker(&maker, POINTS,
               &FILLED(cluster_desc, .val_count = LIGHTS, .iterations = 3,
                       .start = CLUSTER_START_WARM, .weight_position = 1, .weight_normal = .1f,
                       .weight_flux = .5f));
    make_lights(&maker, vpls);
    make_lights(&maker, second);
    memcpy(lights, maker.lights, LIGHTS * sizeof *lights);
    close_maker(&maker);
    free(second);
}

/* No flux is lost, and the order of the points counts for nothing. */
TEST(sums) {
    struct vpl *vpls = mem_alloc(POINTS, sizeof *vpls), lights[LIGHTS], turned[LIGHTS];
    scatter_points(vpls);
    make_twice(vpls, false, lights);
    make_twice(vpls, true, turned);
    for (int c = 0; c < 3; c++)
        check_near("flux of all lights over that of all points, in floats",
                   summed_flux(lights, LIGHTS, c) / summed_flux(vpls, POINTS, c), 1, 1e-5);
    double moved = 0, grown = 0;
    for (int i = 0; i < LIGHTS; i++) {
        moved = fmax(moved, (double)glm_vec3_distance(lights[i].position, turned[i].position));
        grown = fmax(grown, fabs((double)(lights[i].area / turned[i].area) - 1));
    }
    /* Rounding may decide about a point between two clusters: one of some 400. */
    check_at_most("light moved by another order, metres", moved, 2e-3);
    check_at_most("and grown", grown, 1e-2);
    free(vpls);
}

/* As many lights as points: each is its point, on its patch. */
TEST(one_each) {
    enum { COUNT = 256 };
    static struct maker maker;
    struct vpl *vpls = mem_alloc(POINTS, sizeof *vpls);
    scatter_points(vpls);
    open_maker(&maker, COUNT,
               &(struct cluster_desc){.val_count = COUNT, .iterations = 1, .weight_position = 1});
    make_lights(&maker, vpls);
    double apart = 0, area = 0;
    for (int i = 0; i < COUNT; i++) {
        apart = fmax(apart, (double)glm_vec3_distance(maker.lights[i].position, vpls[i].position));
        apart = fmax(apart, (double)glm_vec3_distance(maker.lights[i].flux, vpls[i].flux));
        area = fmax(area, fabs((double)(maker.lights[i].area / vpls[i].area) - 1));
    }
    check_at_most("places and fluxes apart", apart, 1e-5);
    check_at_most("areas", area, 1e-3);
    close_maker(&maker);
    free(vpls);
}

/* --- pictures --------------------------------------------------------------------------------- */

#define EVERY_VPL "interleave=1 blur-radius=0 near-samples=256"

/* Against all VPLs at each pixel, as more lights take their places. */
static void check_falls(const char *scene, double of_128) {
    OWNED(stage) stage = open_stage(scene);
    OWNED(image) all = render_stage(&stage, "unshadowed", EVERY_VPL, 48);
    double last = 1;
    for (int lights = 8; lights <= 128; lights *= 4) {
        const char *settings = form("shadows=none area-lights=%d", lights);
        OWNED(image) image = render_stage(&stage, "cluster-lights", settings, 48);
        double error = relative_rmse(&image, &all, "indirect");
        printf("  %s: %d lights: %.2f %%\n", scene, lights, 100 * error);
        check_at_most("than of fewer lights", error, last);
        last = error;
    }
    check_at_most("of 128 lights", last, of_128);
}

TEST(falls) {
    check_falls("scenes/cornell-box.glb", .04);
    check_falls("scenes/cornell-animal.glb", .06);
    check_falls("scenes/metaballs.glb", .06);
}

/* As many lights as VPLs, as disks: each is its VPL, and so is the picture. */
TEST(all_lights) {
    OWNED(stage) stage = open_stage("scenes/cornell-animal.glb");
    OWNED(image) all = render_stage(&stage, "unshadowed", EVERY_VPL " vpls=64 clamp=disk", 48);
    OWNED(image) disks = render_stage(
        &stage, "cluster-lights", "vpls=64 area-lights=64 shadows=none form=disk adaptive=0", 48);
    check_at_most("64 lights of 64 VPLs", relative_rmse(&disks, &all, "indirect"), 1e-5);
}

/* --- as published ----------------------------------------------------------------------------- */

enum { PIXELS = 256 };

/* A renderer's area lights, and what its camera sees, here and there. */
struct published {
    struct vpl *vpls, lights[LIGHT_RECTANGLES_MAX];
    int vpl_count, light_count;
    vec3 positions[PIXELS], normals[PIXELS];
};

static void see_pixels(struct published *p, const struct renderer *renderer,
                       const struct image *layers) {
    int channel = image_find_channel(layers, "normal.X");
    for (int i = 0; i < PIXELS; i++) {
        int x = (int)(radical_inverse(2, (uint32_t)i) * layers->width);
        int y = (int)(radical_inverse(3, (uint32_t)i) * layers->height);
        pixel_position(renderer, layers, x, y, p->positions[i]);
        glm_vec3_copy((float *)image_at(layers, x, y) + channel, p->normals[i]);
    }
}

static void open_published(struct published *p, const struct stage *stage, const char *settings) {
    OWNED(renderer) renderer;
    struct output_list outputs;
    OWNED(image) layers;
    open_renderer(&renderer, desc_of(stage, "cluster-lights", settings, 64, 64));
    check_ok("layers", renderer_read_layers(&renderer, &layers));
    renderer_outputs(&renderer, &outputs);
    const struct vpl_buffer *lights = output_find(&outputs, "light")->source;
    p->vpl_count = output_vpls(&outputs)->count;
    p->vpls = read_vpls(&renderer);
    p->light_count = lights->count;
    buffer_read(&lights->buffer, 0, (size_t)lights->count * sizeof *p->lights, p->lights);
    see_pixels(p, &renderer, &layers);
}

/* What a light gives to the pixels where nothing is between. */
static double importance(const struct published *p, const struct vpl *light) {
    double sum = 0;
    for (int j = 0; j < PIXELS; j++) {
        vec3 to;
        glm_vec3_sub((float *)light->position, (float *)p->positions[j], to);
        double d2 = (double)glm_vec3_norm2(to);
        double cosines = fmax((double)glm_vec3_dot((float *)p->normals[j], to), 0) *
                         fmax(-(double)glm_vec3_dot((float *)light->normal, to), 0);
        sum += fmin(cosines / (d2 * d2), 5);
    }
    return sum * (double)glm_vec3_norm((float *)light->flux);
}

/* As many lights of equal importance would be as even. */
static double even_count(const struct published *p) {
    double sum = 0, squares = 0;
    for (int i = 0; i < p->light_count; i++) {
        double of_light = importance(p, &p->lights[i]);
        sum += of_light;
        squares += of_light * of_light;
    }
    return sum * sum / squares;
}

/* Table 1 of [Prutkin 2012] has 75 of 256 clusters in use in its box. */
TEST(published) {
    static struct published paper, even;
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    open_published(&paper, &stage, "path=paper");
    open_published(&even, &stage, "path=paper cluster-lights.seeds=even");
    int used = 0;
    for (int i = 0; i < paper.light_count; i++)
        used += glm_vec3_norm(paper.lights[i].flux) > 0;
    printf("  clusters in use: %d of %d\n", used, paper.light_count);
    assert_true(used > 64);
    for (int c = 0; c < 3; c++)
        check_near("flux of all lights over that of all VPLs",
                   summed_flux(paper.lights, paper.light_count, c) /
                       summed_flux(paper.vpls, paper.vpl_count, c),
                   1, 1e-4);
    check_at_most("lights of equal importance, of even seeds over those by importance",
                  even_count(&even) / even_count(&paper), .9);
    mem_free(paper.vpls, even.vpls);
}

RUN_TESTS(open_group_context, close_group_context)
