/* Soft shadows of direct light: each method on a plate between a light and a floor, all parallel,
 * where the share of the light that is seen has a closed form; and on a table, beside the path
 * tracer. */
#include "render_support.h"

#include "gltf_parts.h"

#include "direct/direct.h"
#include "reference/scene/emission.h"
#include "scene/placing.h"

#include <cglm/cglm.h>

enum { SIZE = 96 };

static const double light_height = 1.5, plate_height = .5, beyond_light = 9, below_floor = -1;

/* A light of that shape above a plate from low to high, in the file's JSON. */
struct stand {
    const char *what, *light;
    double width, height; /* height 0: a disk */
    double low[2], high[2];
};

/* The share of a side that a plate leaves out of sight: of the light's interval, what the plate's
 * two edges take as the receiver projects them there. */
static double overlap(double x, double low, double high, double side) {
    double toward = plate_height / light_height; /* of the way from the floor to the light */
    double from = (low - x * (1 - toward)) / toward, to = (high - x * (1 - toward)) / toward;
    return fmax(fmin(to, side / 2) - fmax(from, -side / 2), 0) / side;
}

/* The share of a disk beyond its middle by s radii. */
static double segment(double s) {
    s = fmax(fmin(s, 1), -1);
    return .5 - (s * sqrt(1 - s * s) + asin(s)) / acos(-1);
}

/* Of a disk only the first edge is near. */
static double seen_share(const struct stand *stand, const float p[3]) {
    double x = (double)p[0], y = (double)p[1];
    if (stand->height > 0)
        return 1 - overlap(x, stand->low[0], stand->high[0], stand->width) *
                       overlap(y, stand->low[1], stand->high[1], stand->height);
    double toward = plate_height / light_height;
    double edge = (stand->low[0] - x * (1 - toward)) / toward;
    return 1 - segment(edge / (stand->width / 2));
}

static void open_stand(struct stage *stage, const struct stand *stand, double height) {
    const char *more =
        form("extensionsUsed: [EXT_lights_area], cameras: [{type: perspective, perspective: {yfov: "
             "2.1, znear: 0.01}}], extensions: {EXT_lights_area: {lights: [%s]}},",
             stand->light);
    const char *nodes =
        form("[{mesh: 0, scale: [4, 4, 1], translation: [-2, -2, 0]}, {camera: 0, translation: [0, "
             "0, 0.45]}, {extensions: {EXT_lights_area: {light: 0}}, translation: [0, 0, %g]}, "
             "{mesh: 0, scale: [%g, %g, 1], translation: [%g, %g, %g]}]",
             light_height, stand->high[0] - stand->low[0], stand->high[1] - stand->low[1],
             stand->low[0], stand->low[1], height);
    const char *path = write_parts("stand.glb", &PARTS(.nodes = nodes, .more = more));
    *stage = open_stage(path);
}

static struct image render_method(const struct stage *stage, const char *method,
                                  const char *settings, struct renderer *renderer) {
    struct image layers;
    struct renderer_desc desc = desc_of(stage, "unshadowed", settings, SIZE, SIZE);
    desc.direct = direct_find(method);
    open_renderer(renderer, desc);
    check_ok("layers", renderer_read_layers(renderer, &layers));
    return layers;
}

/* RMS over the floor of the share that is seen, less what it should be. */
static double stand_error(const struct stand *stand, const char *method, const char *settings) {
    struct stage stage, bare;
    struct renderer renderer, bare_renderer;
    double squares = 0, worst = 0;
    open_stand(&stage, stand, plate_height);
    open_stand(&bare, stand, beyond_light);
    struct image shaded = render_method(&stage, method, settings, &renderer);
    struct image lit = render_method(&bare, method, settings, &bare_renderer);
    int direct = image_find_channel(&shaded, "direct.R");
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            float place[3];
            pixel_position(&renderer, &shaded, x, y, place);
            double share =
                (double)image_at(&shaded, x, y)[direct] / (double)image_at(&lit, x, y)[direct];
            double error = share - seen_share(stand, place);
            squares += error * error;
            worst = fmax(worst, fabs(error));
        }
    renderer_free(&renderer);
    renderer_free(&bare_renderer);
    images_free(&shaded, &lit);
    stage_free(&stage);
    stage_free(&bare);
    printf("    %-10s %-28s RMS %.4f, worst %.3f\n", method, stand->what, sqrt(squares) / SIZE,
           worst);
    return sqrt(squares) / SIZE;
}

#define RECTANGLE(size, aspect)                                                                    \
    "{type: rect, intensity: 50, size: " size ", rect: {aspect: " aspect "}}"

static const struct stand stands[] = {
    {"square", RECTANGLE("0.3", "1"), .3, .3, {-.3, -.3}, {.3, .3}},
    {"square, larger than the plate", RECTANGLE("0.8", "1"), .8, .8, {-.1, -.1}, {.1, .1}},
    {"strip", RECTANGLE("0.1", "5"), .5, .1, {-.3, -.3}, {.3, .3}},
    {"disk", "{type: disk, intensity: 50, size: 0.4}", .4, 0, {0, -1.5}, {1.5, 1.5}},
};

/* Of pcss where there is no BVH in time. */
#define BY_MAP "pcss.shadow-rays=0 "

/* What each method may be wrong by, and with what it is asked. Most of it is the receiver's bias,
 * which moves shadows: twice the map, and it is half. */
static const struct {
    const char *method, *settings;
    double bounds[4];
} rows[] = {
    {"samples", "samples.points=64 shadow-size=1024", {.02, .012, .022, .007}},
    {"pcss", "shadow-size=1024", {.02, .02, .02, .015}},
    {"pcss", BY_MAP "shadow-size=1024", {.02, .02, .02, .015}},
    {"vssm", "shadow-size=1024", {.009, .006, .01, .007}},
    {"msm", "shadow-size=1024", {.014, .009, .015, .008}},
    {"cssm", "shadow-size=1024", {.04, .05, .1, .06}},
    {"cssm", "shadow-size=1024 cssm.prefilter=sat", {.022, .018, .022, .013}},
};

TEST(stands) {
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++)
        for (size_t s = 0; s < sizeof stands / sizeof *stands; s++)
            if (is_tried_here(r + s, 2))
                check_at_most(stands[s].what,
                              stand_error(&stands[s], rows[r].method, rows[r].settings),
                              rows[r].bounds[s]);
}

/* What a method has more of makes it truer. */
TEST(more) {
    static const struct {
        const char *method, *few, *many;
    } steps[] = {
        {"samples", "samples.points=4 shadow-size=512", "samples.points=64 shadow-size=512"},
        {"samples", "samples.points=16 shadow-size=64", "samples.points=16 shadow-size=512"},
        {"pcss", "pcss.shadow-rays=4 shadow-size=512", "pcss.shadow-rays=64 shadow-size=512"},
        {"pcss", BY_MAP "light-taps=6 shadow-size=512", BY_MAP "light-taps=96 shadow-size=512"},
        {"pcss", BY_MAP "light-taps=96 shadow-size=32", BY_MAP "light-taps=96 shadow-size=512"},
        {"vssm", "texels=64", "texels=512"},
        {"msm", "texels=64", "texels=512"},
        {"cssm", "texels=64", "texels=512"},
        {"cssm", "texels=512 harmonics=2", "texels=512 harmonics=8"},
        {"cssm", "texels=512 prefilter=sat harmonics=2", "texels=512 prefilter=sat harmonics=8"},
    };
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        if (!is_tried_here(i, 2))
            continue;
        double few = stand_error(&stands[0], steps[i].method, steps[i].few);
        check_at_most(steps[i].many, stand_error(&stands[0], steps[i].method, steps[i].many),
                      .8 * few);
    }
}

/* A floor below a plate that fills the map, except for a thing far aside and near the light. The
 * plate's depth is then a part of the map's range: the series hides some of the light. */
static void open_cover(struct stage *stage, double plate) {
    const char *nodes =
        form("[{mesh: 0, scale: [4, 4, 1], translation: [-2, -2, 0]}, {camera: 0, translation: [0, "
             "0, 0.04]}, {extensions: {EXT_lights_area: {light: 0}}, translation: [0, 0, %g]}, "
             "{mesh: 0, scale: [4, 4, 1], translation: [-2, -2, %g]}, {mesh: 0, scale: [0.1, 0.1, "
             "1], translation: [1, 1, 1.2]}]",
             light_height, plate);
    const char *more =
        "extensionsUsed: [EXT_lights_area], cameras: [{type: perspective, perspective: {yfov: 1, "
        "znear: 0.001}}], extensions: {EXT_lights_area: {lights: [" RECTANGLE("0.3", "1") "]}},";
    const char *path = write_parts("cover.glb", &PARTS(.nodes = nodes, .more = more));
    *stage = open_stage(path);
}

static double light_below(double plate, const char *settings) {
    OWNED(stage) stage;
    OWNED(renderer) renderer;
    open_cover(&stage, plate);
    OWNED(image) layers = render_method(&stage, "cssm", settings, &renderer);
    double mean = layer_mean(&layers, "direct");
    return mean;
}

#define HALF_HIDDEN "harmonics=4"

/* Where a map is constant all of its windows have one mean, whether a MIP level or a summed area
 * table tells it. */
TEST(constant) {
    static const double plates[] = {.05, .1, .2};
    double lit = light_below(below_floor, HALF_HIDDEN);
    for (size_t i = 0; i < sizeof plates / sizeof *plates; i++) {
        double mips = light_below(plates[i], HALF_HIDDEN) / lit;
        double sums = light_below(plates[i], HALF_HIDDEN " prefilter=sat") / lit;
        printf("  a plate %g above the floor\n", plates[i]);
        check_near("by MIP maps some of the light", mips, .6, .35);
        check_near("by summed area tables the same", sums, mips, .01);
    }
}

/* --- a table ---------------------------------------------------------------------------------- */

/* Irradiance over pi of the only light where nothing hides it. */
static double unhidden(const struct emission *emission, const struct hit *hit) {
    enum { SIDE = 8 };
    double sum = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        struct arrival arrival;
        vec2s sample = {{((float)(i % SIDE) + .5F) / SIDE, ((float)(i / SIDE) + .5F) / SIDE}};
        vec2s place = emission_place(emission, 0, sample, hit);
        if (emission_reach(emission, 0, place, hit, &arrival))
            sum += (double)arrival.irradiance.x;
    }
    return sum / (SIDE * SIDE) / GLM_PI;
}

/* The brightest surface has about 1, irradiance over pi: where the light barely comes over the
 * horizon a share of it means nothing. */
static const double dim = .03;

/* RMS of the share that is seen over all surfaces that the light could reach, less the reference's,
 * or without one less 1. */
static double share_error(const struct stage *stage, const char *method, const char *settings,
                          const struct image *reference) {
    struct renderer renderer;
    struct emission emission;
    struct image layers = render_method(stage, method, settings, &renderer);
    double squares = 0, count = 0;
    int normal = image_find_channel(&layers, "normal.X"); /* Y and Z follow */
    int direct = image_find_channel(&layers, "direct.R");
    int true_direct = reference ? image_find_channel(reference, "direct.R") : 0;
    emission_init(&emission, &stage->emitters, &stage->geometry, NULL, 0);
    for (int i = 0; i < SIZE * SIZE; i++) {
        int x = i % SIZE, y = i / SIZE;
        const float *at = image_at(&layers, x, y);
        struct hit hit;
        for (int c = 0; c < 3; c++)
            hit.normal.raw[c] = hit.geometric_normal.raw[c] = at[normal + c];
        pixel_position(&renderer, &layers, x, y, hit.position.raw);
        double most = glms_vec3_norm(hit.normal) > .5F ? unhidden(&emission, &hit) : 0;
        if (most < dim)
            continue;
        double expected = reference ? (double)image_at(reference, x, y)[true_direct] : most;
        squares += pow(((double)at[direct] - expected) / most, 2);
        count++;
    }
    emission_free(&emission);
    renderer_free(&renderer);
    image_free(&layers);
    return sqrt(squares / count);
}

TEST(table) {
    static const struct {
        const char *method;
        double least, most;
    } methods[] = {{"hard", .08, .3}, {"pcss", 0, .03}, {"samples", 0, .02},
                   {"vssm", 0, .03},  {"msm", 0, .03},  {"cssm", 0, .2}};
    OWNED(stage) stage = open_stage("scenes/table.glb");
    OWNED(image) reference =
        TRACE(&stage, .width = SIZE, .height = SIZE, .samples = 64, .centers = true);
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        double error = share_error(&stage, methods[i].method, "", &reference);
        check_at_most(methods[i].method, error, methods[i].most);
        check_at_most("which is no less than", methods[i].least, error);
    }
}

/* --- other lights ----------------------------------------------------------------------------- */

/* A sphere, a disk of spots and a sun over the table, beside points of them. The cone of the spots
 * is taken from their middle, which is some of their error; the sun meets a lamp above a table, and
 * windows have one depth. */
TEST(types) {
    static const struct {
        const char *what;
        enum emitter_type type;
        float size[2], direction[3];
        double hard, most[4]; /* errors of direct light, relative RMSE */
    } lights[] = {
        {"sphere", EMITTER_POINT, {.4F, 0}, {0, -1, 0}, .12, {.06, .07, .06, .12}},
        {"disk of spots", EMITTER_SPOT, {.4F, 0}, {0, -1, 0}, .12, {.09, .09, .1, .16}},
        {"sun", EMITTER_DIRECTIONAL, {.15F, 0}, {.3F, -1, .2F}, .12, {.08, .11, .1, .17}}};
    OWNED(stage) stage = open_stage("scenes/table.glb");
    struct emitter *light = &stage.emitters.items[0];
    for (size_t i = 0; i < sizeof lights / sizeof *lights; i++) {
        enum { METHODS = 6 };
        struct renderer renderers[METHODS];
        struct image layers[METHODS];
        static const char *const methods[METHODS] = {"samples", "hard", "pcss",
                                                     "vssm",    "msm",  "cssm"};
        light->type = lights[i].type;
        light->cos_outer = .5F, light->cos_inner = .6F;
        light->position[1] = 1.9F; /* below the lamp, which would hide half of a sphere */
        memcpy(light->size, lights[i].size, sizeof light->size);
        emitter_aim(light, lights[i].direction);
        for (int m = 0; m < METHODS; m++) {
            layers[m] = render_method(&stage, methods[m], "shadow-size=1024", &renderers[m]);
            renderer_free(&renderers[m]);
        }
        printf("  %s\n", lights[i].what);
        check_at_most("hard is no better than", lights[i].hard,
                      relative_rmse(&layers[1], &layers[0], "direct"));
        for (int m = 2; m < METHODS; m++)
            check_at_most(methods[m], relative_rmse(&layers[m], &layers[0], "direct"),
                          lights[i].most[m - 2]);
        for (int m = 0; m < METHODS; m++)
            image_free(&layers[m]);
    }
}

/* --- extremes --------------------------------------------------------------------------------- */

static struct image render_lights(struct stage *stage, const char *light, const char *method) {
    OWNED(renderer) renderer;
    check_ok(light, emitters_from_text(&stage->emitters, &stage->scene, light, 0));
    struct image layers =
        render_method(stage, method, "samples.points=4 shadow-size=256 vpls=64 vals=4", &renderer);
    return layers;
}

/* Lights larger than all, next to nothing, touching a table and a wall, in a sphere larger than the
 * room: whatever the picture, it is one. */
TEST(extremes) {
    static const char *const lights[] = {"size=50,50",      "size=1e9,0",
                                         "size=1e-6,1e-6",  "size=0,0",
                                         "size=1e-6,3",     "position=0,0.76,0",
                                         "position=0,1,-2", "position=0,1,-1.9999 direction=0,0,-1",
                                         "direction=0,1,0"};
    static const char *const methods[] = {"hard", "pcss", "samples", "vssm", "msm", "cssm"};
    OWNED(stage) stage = open_stage("scenes/table.glb");
    for (size_t i = 0; i < sizeof lights / sizeof *lights; i++) {
        for (size_t m = 0; m < sizeof methods / sizeof *methods; m++) {
            if (!is_tried_here(i + m, 2))
                continue;
            OWNED(image) layers = render_lights(&stage, lights[i], methods[m]);
            check_finite(lights[i], &layers);
        }
        struct image reference =
            TRACE(&stage, .width = 16, .height = 16, .bounces = 1, .samples = 4);
        check_finite(lights[i], &reference);
        image_free(&reference);
    }
}

static const char *const soft_methods[] = {"pcss", "vssm", "msm", "cssm"};

enum { SOFT_METHODS = sizeof soft_methods / sizeof *soft_methods };

#define SMALL_MAPS "shadow-size=512 prefilter.texels=512"

static struct image render_with(const struct stage *stage, const char *method,
                                const char *settings) {
    struct renderer renderer;
    struct image layers = render_method(stage, method, settings, &renderer);
    renderer_free(&renderer);
    return layers;
}

static struct image render_soft(const struct stage *stage, const char *method) {
    return render_with(stage, method, SMALL_MAPS);
}

/* A light that is next to nothing has hard shadows, by rays those of a fine map; and one in two
 * halves is the one. */
TEST(limits) {
    static const double halves_most[SOFT_METHODS] = {.06, .06, .06, .2};
    struct emitter halves[2];
    OWNED(stage) stage = open_stage("scenes/table.glb");
    check_ok("point", emitters_from_text(&stage.emitters, &stage.scene, "size=0,0", 0));
    OWNED(image) hard = render_soft(&stage, "hard"),
                 fine = render_with(&stage, "hard", "shadow-size=4096");
    for (int m = 0; m < SOFT_METHODS; m++) {
        bool rays = strcmp(soft_methods[m], "pcss") == 0;
        check_ok("small", emitters_from_text(&stage.emitters, &stage.scene, "size=1e-5,1e-5", 0));
        OWNED(image) small = render_soft(&stage, soft_methods[m]);
        check_ok("whole", emitters_from_text(&stage.emitters, &stage.scene, "size=0.8,0.4", 0));
        OWNED(image) whole = render_soft(&stage, soft_methods[m]);
        for (int i = 0; i < 2; i++) {
            halves[i] = stage.emitters.items[0];
            halves[i].size[0] /= 2;
            glm_vec3_muladds(halves[i].right, i ? .2F : -.2F, halves[i].position);
            glm_vec3_scale(halves[i].intensity, .5F, halves[i].intensity);
        }
        struct emitters before = stage.emitters;
        stage.emitters = (struct emitters){.items = halves, .count = 2};
        OWNED(image) sum = render_soft(&stage, soft_methods[m]);
        stage.emitters = before;
        printf("  %s\n", soft_methods[m]);
        check_at_most("small light beside a hard shadow",
                      relative_rmse(&small, rays ? &fine : &hard, "direct"), .1);
        check_at_most("halves beside the whole", relative_rmse(&sum, &whole, "direct"),
                      halves_most[m]);
    }
}

/* Neither units nor axes mean anything: a table a thousand times as large, or turned. World-aligned
 * faces come back to themselves after a quarter turn; a light's own map turns with it. */
TEST(scale_and_turns) {
    for (int m = 0; m < SOFT_METHODS; m++) {
        OWNED(stage) stage = open_stage("scenes/table.glb");
        OWNED(image) plain = render_soft(&stage, soft_methods[m]);
        turn_stage(&stage, 90);
        OWNED(image) quarter = render_soft(&stage, soft_methods[m]);
        turn_stage(&stage, -60);
        OWNED(image) third = render_soft(&stage, soft_methods[m]);
        stage_free(&stage);
        stage = open_stage("scenes/table.glb");
        scale_scene(&stage.scene, 1000);
        pose_stage(&stage);
        OWNED(image) large = render_soft(&stage, soft_methods[m]);
        printf("  %s\n", soft_methods[m]);
        check_at_most("turned by 90 degrees", relative_rmse(&quarter, &plain, "direct"), .003);
        check_at_most("turned by 30 degrees", relative_rmse(&third, &plain, "direct"), .06);
        check_at_most("a thousand times as large", relative_rmse(&large, &plain, "direct"), .003);
    }
}

/* A plate behind the floor, and one beyond the light, hide nothing. */
TEST(idle_casters) {
    static const char *const methods[] = {"hard", "pcss", "vssm", "msm", "cssm"};
    OWNED(stage) below, beyond;
    open_stand(&below, &stands[0], below_floor);
    open_stand(&beyond, &stands[0], beyond_light);
    OWNED(image) lit = render_soft(&beyond, "hard");
    for (size_t m = 0; m < sizeof methods / sizeof *methods; m++) {
        OWNED(image) under = render_soft(&below, methods[m]),
                     above = render_soft(&beyond, methods[m]);
        printf("  %s\n", methods[m]);
        check_at_most("a plate behind the floor", relative_rmse(&under, &lit, "direct"), 1e-5);
        check_at_most("one beyond the light", relative_rmse(&above, &lit, "direct"), 1e-5);
    }
}

/* In an empty room nothing hides a light in the ceiling (CIE 171:2006, 5.3). */
TEST(empty_room) {
    static const char *const methods[] = {"pcss", "vssm", "msm", "cssm", "samples"};
    static const char *const lights[] = {
        "+area position=2,3,-2 direction=0,-1,0 size=1,1 intensity=10,10,10"};
    OWNED(stage) stage;
    stage = open_stage(write_parts(
        "room.glb",
        &PARTS(.nodes = "[{mesh: 0, scale: [4, 3, 1], translation: [0, 0, -4]}, {mesh: 0, scale: "
                        "[4, 3, 1], translation: [4, 0, 0], rotation: [0, 1, 0, 0]}, {mesh: 0, "
                        "scale: [4, 3, 1], rotation: [0, 0.70710678, 0, 0.70710678]}, {mesh: 0, "
                        "scale: [4, 3, 1], translation: [4, 0, -4], rotation: [0, -0.70710678, 0, "
                        "0.70710678]}, {mesh: 0, scale: [4, 4, 1], rotation: [-0.70710678, 0, 0, "
                        "0.70710678]}, {mesh: 0, scale: [4, 4, 1], translation: [0, 3, -4], "
                        "rotation: [0.70710678, 0, 0, 0.70710678]}]")));
    check_ok("camera", camera_from_text(&stage.camera, &stage.scene,
                                        "eye=2.1,1.4,-0.2 forward=0,0,-1 fov=2", 0, NULL));
    for (size_t l = 0; l < sizeof lights / sizeof *lights; l++) {
        check_ok(lights[l], emitters_from_text(&stage.emitters, &stage.scene, lights[l], 0));
        stage.emitters.items[0] = stage.emitters.items[stage.emitters.count - 1];
        stage.emitters.count = 1;
        for (size_t m = 0; m < sizeof methods / sizeof *methods; m++)
            if (is_tried_here(l + m, 2))
                check_at_most(methods[m], share_error(&stage, methods[m], "", NULL), .01);
    }
}

RUN_TESTS(open_group_context, close_group_context)
