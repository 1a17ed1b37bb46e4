/* Lookups in maps of depth: each projection and each filter against a second implementation in
 * doubles, over a small map that is made by hand; and each of one with each of the other. */
#include "base/unit.h"
#include "lookup_direct.h"
#include "render_support.h"

#include "shared/maps.h"
#include "shared/view.h"

static const char *const projection_names[] = {"paraboloid", "perspective", "orthographic"};
static const char *const filter_names[] = {"none", "hard", "cssm", "pcss", "pcf"};

/* --- the map ---------------------------------------------------------------------------------- */

/* A tilted blocker with a wavy edge before nothing; or a plate as wide as the map. */
static void make_depths(struct lookups *lookups) {
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            double edge = SIZE / 2 + 6 * sin(y * .2);
            lookups->depths[y][x] = lookups->plate > 0 ? lookups->plate
                                    : x < edge         ? .25 + .1 * y / SIZE
                                                       : 2;
        }
}

/* As the projection stores it. */
static float stored_of(int projection, double depth) {
    if (projection == PROJECTION_PARABOLOID)
        return (float)fmin(depth, 1);
    if (depth > 1)
        return 0;
    return (float)(projection == PROJECTION_PERSPECTIVE ? near / (depth * unit) : 1 - depth);
}

static void open_texture(struct texture *texture, GLenum format, int levels, GLenum channels,
                         const float *texels) {
    check_ok("texture",
             texture_init(texture,
                          &FILLED(texture_desc, .label = "lookup", .target = GL_TEXTURE_2D_ARRAY,
                                  .format = format, .width = SIZE, .height = SIZE, .levels = levels,
                                  .filter = levels > 1 ? FILTER_TRILINEAR : FILTER_NEAREST)));
    gl.TextureSubImage3D(texture->id, 0, 0, 0, 0, SIZE, SIZE, 1, channels, GL_FLOAT, texels);
    if (levels > 1)
        gl.GenerateTextureMipmap(texture->id);
}

static void open_map(struct lookups *lookups) {
    float texels[SIZE * SIZE];
    for (int i = 0; i < SIZE * SIZE; i++)
        texels[i] = stored_of(lookups->projection, lookups->depths[i / SIZE][i % SIZE]);
    open_texture(&lookups->map, GL_R32F, 1, GL_RED, texels);
}

/* cos, sin as (b + 1) / 2, a cos, a sin, a. */
static void open_bases(struct lookups *lookups) {
    float(*texels)[4] = mem_alloc(SIZE * SIZE, sizeof *texels);
    float plain[SIZE * SIZE];
    for (int b = 0; b < 4; b++) {
        for (int i = 0; i < SIZE * SIZE; i++) {
            double a = texel_argument(lookups->depths[i / SIZE][i % SIZE]);
            plain[i] = (float)a;
            for (int k = 0; k < TERMS; k++) {
                double value = basis_of(a, k, b % 2, b >= 2);
                texels[i][k] = (float)(b < 2 ? value / 2 + .5 : value);
            }
        }
        open_texture(&lookups->bases[b], GL_RGBA32F, LEVELS, GL_RGBA, &texels[0][0]);
    }
    open_texture(&lookups->bases[4], GL_R32F, LEVELS, GL_RED, plain);
    free(texels);
}

/* --- on the GPU ------------------------------------------------------------------------------- */

/* Random places within the middle of the map, on surfaces that mostly face the light. */
static void make_points(struct lookups *lookups) {
    srand(7);
#define RANDOM ((float)rand() / (float)RAND_MAX)
    for (int i = 0; i < POINTS; i++) {
        float z = .5f + 3 * RANDOM, spread = lookups->projection == PROJECTION_ORTHOGRAPHIC ? 1 : z;
        float x = spread * .4f * (2 * RANDOM - 1), y = spread * .4f * (2 * RANDOM - 1);
        vec3s at = lookups->origin;
        at = glms_vec3_muladds(lookups->axes[0], x, at);
        at = glms_vec3_muladds(lookups->axes[1], y, at);
        at = glms_vec3_muladds(lookups->axes[2], z, at);
        vec3s n = glms_vec3_scale(lookups->axes[2], -1);
        n = glms_vec3_muladds(lookups->axes[0], 1.2f * (RANDOM - .5f), n);
        n = vec3s_unit(glms_vec3_muladds(lookups->axes[1], 1.2f * (RANDOM - .5f), n));
        memcpy(lookups->points[i][0], at.raw, sizeof at.raw);
        memcpy(lookups->points[i][1], n.raw, sizeof n.raw);
    }
}

static void copy(vec3s from, float scale, vec3 to) {
    glm_vec3_scale(from.raw, scale, to);
}

/* The view, and the light's extent. */
struct paraboloid_view {
    struct map_view view;
    vec4 extent;
};

struct flat_view {
    struct view view;
    vec4 extent;
};

static struct paraboloid_view paraboloid_of(const struct lookups *lookups) {
    struct paraboloid_view paraboloid = {{.z_far = (float)unit}, {(float)extent}};
    copy(lookups->origin, 1, paraboloid.view.center);
    copy(lookups->axes[0], 1, paraboloid.view.tangent);
    copy(lookups->axes[2], 1, paraboloid.view.axis);
    return paraboloid;
}

static struct flat_view flat_of(const struct lookups *lookups) {
    struct flat_view flat = {{.near = (float)near, .far = (float)unit}, {(float)extent}};
    copy(lookups->origin, 1, flat.view.origin);
    copy(lookups->axes[0], (float)half, flat.view.right);
    copy(lookups->axes[1], (float)half, flat.view.up);
    copy(lookups->axes[2], 1, flat.view.forward);
    bool orthographic = lookups->projection == PROJECTION_ORTHOGRAPHIC;
    flat.view.orthographic = orthographic;
    for (int axis = 0; axis < 2; axis++)
        for (int c = 0; c < 4; c++)
            flat.view.world_to_clip[c][axis] =
                (c < 3 ? lookups->axes[axis].raw[c]
                       : -glms_vec3_dot(lookups->axes[axis], lookups->origin)) /
                (float)half;
    for (int c = 0; c < 4; c++)
        flat.view.world_to_clip[c][3] = orthographic ? (c == 3)
                                        : c < 3      ? lookups->axes[2].raw[c]
                                                : -glms_vec3_dot(lookups->axes[2], lookups->origin);
    return flat;
}

static void run(struct lookups *lookups) {
    struct lookup_params params = {.bias = (float)bias,
                                   .map_size = SIZE,
                                   .map_bias = (float)map_bias,
                                   .shift = (float)shift,
                                   .gain = (float)gain};
    struct series_range ranges[SERIES_RANGES_MAX] = {
        {(float)nearest, (float)farthest, (float)knee,
         (float)(argument_of(farthest) / (farthest - nearest) * (farthest - nearest + knee))}};
    struct paraboloid_view paraboloid = paraboloid_of(lookups);
    struct flat_view flat = flat_of(lookups);
    bool is_flat = lookups->projection != PROJECTION_PARABOLOID;
    ask_shader(&FILLED(
        questions, .shader = "lookup.comp",
        .defines = form("PROJECTION %d;FILTER %d;JACOBIAN 1;SHARPEN 0;MAP_COUNT 1;BASIS_TERMS %d;"
                        "BASIS_GROUPS 1;FILTER_TAPS %d;SEARCH_TAPS %d",
                        lookups->projection, lookups->filter, TERMS, TAPS, SEARCH),
        .asked = lookups->points, .asked_bytes = sizeof lookups->points,
        .answers = lookups->answers, .answer_bytes = POINTS * sizeof *lookups->answers,
        .groups = {(POINTS + 63) / 64},
        .textures = {{UNIT_MAP_DEPTH, lookups->map.id},
                     {UNIT_BASIS_COS, lookups->bases[0].id},
                     {UNIT_BASIS_SIN, lookups->bases[1].id},
                     {UNIT_BASIS_Z_COS, lookups->bases[2].id},
                     {UNIT_BASIS_Z_SIN, lookups->bases[3].id},
                     {UNIT_BASIS_Z, lookups->bases[4].id}},
        .blocks = {{BLOCK_PASS, is_flat ? (void *)&flat : &paraboloid,
                    is_flat ? sizeof flat : sizeof paraboloid},
                   {BLOCK_LOOKUP, &params, sizeof params},
                   {BLOCK_SERIES_RANGES, ranges, sizeof ranges}}));
}

static struct lookups *open_lookups(int projection, int filter, double plate) {
    struct lookups *lookups = mem_alloc(1, sizeof *lookups);
    lookups->projection = projection;
    lookups->filter = filter;
    lookups->plate = plate;
    lookups->origin = (vec3s){{.3f, 2, -.7f}};
    lookups->axes[2] = vec3s_unit((vec3s){{.2f, -1, .4f}});
    lookups->axes[0] = vec3s_unit(glms_vec3_cross(lookups->axes[2], (vec3s){{0, 0, 1}}));
    lookups->axes[1] = glms_vec3_cross(lookups->axes[2], lookups->axes[0]);
    lookups->answers = mem_alloc(POINTS, sizeof *lookups->answers);
    make_depths(lookups);
    make_points(lookups);
    open_map(lookups);
    open_bases(lookups);
    run(lookups);
    return lookups;
}

static void close_lookups(struct lookups *lookups) {
    texture_free(&lookups->map);
    for (int b = 0; b < 5; b++)
        texture_free(&lookups->bases[b]);
    mem_free(lookups->answers, lookups);
}

/* --- tests ------------------------------------------------------------------------------------ */

static double off(double value, double expected) {
    return fabs(value - expected);
}

static double map_depth_of(int projection, double stored) {
    return projection == PROJECTION_PARABOLOID    ? stored
           : projection == PROJECTION_PERSPECTIVE ? near / stored / unit
                                                  : 1 - stored;
}

static void check_projection(int projection) {
    struct lookups *lookups = open_lookups(projection, FILTER_NONE, 0);
    double uv = 0, depth = 0, plane = 0, texel = 0, light = 0, penumbra = 0, width = 0;
    int wrong = 0;
    for (int i = 0; i < POINTS; i++) {
        const struct answer *a = &lookups->answers[i];
        struct c_receiver r = receiver_of(lookups, lookups->points[i]);
        int x = (int)((double)a->uv[0] * SIZE) + 1, y = (int)((double)a->uv[1] * SIZE);
        wrong += (a->seen > 0) != r.seen;
        uv = fmax(uv, fmax(off(a->uv[0], r.uv[0]), off(a->uv[1], r.uv[1])));
        depth = fmax(depth, off(a->depth, r.distance / unit));
        plane = fmax(plane, off(a->plane, plane_of(lookups, &r, x, y) / unit));
        texel = fmax(texel, off(a->texel, map_depth_of(projection, .25)));
        light = fmax(light, off(a->light, light_of(projection, &r)));
        penumbra =
            fmax(penumbra, off(a->penumbra, penumbra_of(projection, r.distance, .6 * r.distance)));
        width = fmax(width, off(a->width, width_of(projection, &r, .01)));
    }
    printf("  %s\n", projection_names[projection]);
    check_at_most("points that are seen, or not, unduly", wrong, 0);
    check_at_most("places", uv, 1e-5);
    check_at_most("distances", depth, 1e-6);
    check_at_most("distances of planes", plane, 1e-5);
    check_at_most("depths of a texel", texel, 1e-6);
    check_at_most("the light's angles", light, 1e-6);
    check_at_most("penumbrae", penumbra, 1e-6);
    check_at_most("widths of an angle of .01", width, 1e-6);
    close_lookups(lookups);
}

TEST(paraboloid) {
    check_projection(PROJECTION_PARABOLOID);
}

TEST(perspective) {
    check_projection(PROJECTION_PERSPECTIVE);
}

TEST(orthographic) {
    check_projection(PROJECTION_ORTHOGRAPHIC);
}

/* Texture units have 8 bits for the weights across, up and between levels: each errs by 1 / 512, of
 * the terms of a step, 1.07 together, times the gain, 2. */
static double tolerance_of(int filter) {
    return filter == FILTER_CSSM ? 3. / 512 * 1.07 * 2 : 5e-3;
}

/* With every projection. Where a distance is a texel's but for rounding either answer is right, and
 * a tap more or less is a sixteenth. */
static void check_filter(int filter, double (*expected)(const struct lookups *lookups,
                                                        const struct c_receiver *r)) {
    for (int projection = 0; projection < 3; projection++) {
        struct lookups *lookups = open_lookups(projection, filter, 0);
        int wrong = 0, between = 0;
        double sum = 0;
        for (int i = 0; i < POINTS; i++) {
            struct c_receiver r = receiver_of(lookups, lookups->points[i]);
            double share = lookups->answers[i].share;
            wrong += off(share, expected(lookups, &r)) > tolerance_of(filter);
            between += share > .01 && share < .99;
            sum += share / POINTS;
        }
        printf("  %s, %s: %.3f arrives, penumbra %d\n", filter_names[filter],
               projection_names[projection], sum, between);
        check_at_most("wrong answers", wrong, POINTS / 200);
        assert_true(sum > .2 && sum < .9 && (between > 100) == (filter != FILTER_HARD));
        close_lookups(lookups);
    }
}

TEST(hard) {
    check_filter(FILTER_HARD, filter_hard);
}

TEST(pcf) {
    check_filter(FILTER_PCF, filter_pcf);
}

TEST(pcss) {
    check_filter(FILTER_PCSS, filter_pcss);
}

TEST(cssm) {
    check_filter(FILTER_CSSM, filter_cssm);
}

/* A plate as wide as the map: whatever the filter, the answer is that of the step itself, the sum
 * of K sines of what lies between receiver and plate. All before the plate is lit, all that is more
 * than the step behind it is dark, as far off as it may be: also behind the farthest caster, where
 * the series, unclamped, would begin again. */
TEST(step) {
    const double plate = nearest, dark_from = .52 / (2 * TERMS);
    struct lookups *lookups = open_lookups(PROJECTION_PARABOLOID, FILTER_CSSM, plate);
    double worst = 0, least_before = 1, most_behind = 0, farthest_behind = 0;
    for (int i = 0; i < POINTS; i++) {
        struct c_receiver r = receiver_of(lookups, lookups->points[i]);
        double d = r.distance / unit, z = fmin(d, plate);
        double angle = atan(penumbra_of(PROJECTION_PARABOLOID, d * unit, z * unit));
        double tilt = 1 - fmin(angle / 8 * slope_of(PROJECTION_PARABOLOID, &r), .5);
        double t = argument_of(d * tilt) - argument_of(plate), blocked = .5;
        double share = lookups->answers[i].share;
        for (int k = 0; k < TERMS; k++)
            blocked += 2 * sin(acos(-1) * (2 * k + 1) * (t - shift)) / (acos(-1) * (2 * k + 1));
        if (d <= farthest)
            worst = fmax(worst, off(share, fmax(fmin(.5 - (blocked - .5) * gain, 1), 0)));
        if (d <= plate)
            least_before = fmin(least_before, share);
        if (t > dark_from) {
            most_behind = fmax(most_behind, share);
            farthest_behind = fmax(farthest_behind, d);
        }
    }
    check_at_most("difference from the sum of sines", worst, .01);
    check_at_most("the least light before the plate, from 1", 1 - least_before, .05);
    check_at_most("light more than a step behind it", most_behind, .001);
    check_at_most("the farthest caster, over the farthest receiver", farthest / farthest_behind,
                  .7);
    close_lookups(lookups);
}

/* --- what lies behind a VAL's plane ----------------------------------------------------------- */

static struct map_view view_of(float x, float y, float axis_x, float axis_y, float near_clip) {
    return (struct map_view){
        .center = {x, y, 0}, .axis = {axis_x, axis_y, 0}, .tangent = {0, 0, 1}, .near = near_clip};
}

/* VAL 0 looks along +x. The nearest of the others is empty, and the next looks away from it. Two on
 * the left look back at it and see what is behind it. Another has its back to everything. */
TEST(map_in_front) {
    enum { VALS = 6, ASKED = 4 };
    struct map_view views[MAP_VIEWS_MAX] = {
        view_of(0, 0, 1, 0, .01F),      view_of(-1, 0, 1, 0, MAP_VIEW_EMPTY),
        view_of(-1.5F, 0, -1, 0, .01F), view_of(-3, 0, 1, 0, .01F),
        view_of(-2, 0, 1, 0, .01F),     view_of(0, -1, 0, -1, .01F),
    };
    static const float points[ASKED][4] = {
        {1, 2, 0, 0},        /* in front: its own */
        {-.5F, 4, 0, 0},     /* behind: the nearest that sees it */
        {-2.5F, 3.5F, 0, 0}, /* behind that one, too: the next */
        {-.5F, 1, 0, 0},     /* nearer to VAL 0 than any: its own */
    };
    static const int expected[ASKED] = {0, 4, 3, 0};
    int answers[ASKED];
    struct lookup_params params = {.map_count = VALS};
    ask_shader(&FILLED(
        questions, .shader = "map_in_front.comp", .asked = points, .asked_bytes = sizeof points,
        .answers = answers, .answer_bytes = sizeof answers, .groups = {ASKED},
        .blocks = {{BLOCK_MAPS, views, sizeof views}, {BLOCK_LOOKUP, &params, sizeof params}}));
    for (int i = 0; i < ASKED; i++) {
        printf("    point %d is known by map %d\n", i, answers[i]);
        assert_int_equal(answers[i], expected[i]);
    }
}

RUN_TESTS(open_group_context, close_group_context)
