/* k-means of VPLs, step by step, against a second implementation on the CPU: criteria, starts,
 * seeds, lost clusters, the mapping of other lights, and the views of VALs. */
#include "base/unit.h"
#include "render_support.h"

#include "base/halton.h"
#include "gl/framebuffer.h"
#include "passes/frame.h"
#include "passes/lights/cluster.h"
#include "shared/cluster.h"
#include "shared/maps.h"
#include "shared/vpl.h"

enum { POINTS = 60, CLUSTERS = 7, CLOUDS_MAX = 400 };

/* What the buffer of VPLs has of their spread: sum of logarithms, pairs. */
static const float pairs[4] = {3, 2, 0, 0};

/* --- points ----------------------------------------------------------------------------------- */

/* Lights on three sides of a room, of many hues and areas. Every seventh met nothing. */
static void scatter(struct vpl vpls[POINTS], int cloud) {
    for (int i = 0; i < POINTS; i++) {
        uint32_t at = (uint32_t)(cloud * POINTS + i + 1);
        float u = (float)radical_inverse(2, at) * 4 - 2, v = (float)radical_inverse(3, at) * 4 - 2;
        float w = (float)radical_inverse(5, at);
        vec3 places[3] = {{u, v, w}, {2 + w, u, v}, {u, 2 + w, v}};
        vec3 normals[3] = {{u / 5, v / 5, 1}, {-1, u / 5, v / 5}, {u / 5, -1, v / 5}};
        vpls[i] = (struct vpl){.area = .1f + w, .flux = {1 + w, .2f + w * w, 2 - w}, .reach = 3};
        if (i % 7 == 0 || i >= POINTS - 2)
            vpls[i].reach = 0;
        if (i % 7 == 0)
            glm_vec3_zero(vpls[i].flux);
        glm_vec3_copy(places[i % 3], vpls[i].position);
        vec3_unit_to(normals[i % 3], vpls[i].normal);
    }
}

/* --- the second implementation ---------------------------------------------------------------- */

struct means {
    double position[CLUSTERS][3], normal[CLUSTERS][3], flux[CLUSTERS][3], count[CLUSTERS];
    bool started;
    int nearest[POINTS];
    double margin; /* the least by which a VPL was nearer to its cluster than to the next */
    int empty;     /* clusters that were, in any step */
};

/* seeds: numbers of VPLs, or NULL. values: importance of each VPL; NULL: all count alike. */
struct expected {
    const struct cluster_desc *desc;
    const float *seeds, *values;
    struct means means;
};

static int seed_of(const struct expected *e, const struct vpl *vpls, int k) {
    int i = e->desc->metric == CLUSTER_METRIC_SQUARES ? k : k * POINTS / CLUSTERS;
    if (e->seeds && e->seeds[k] >= 0)
        i = (int)e->seeds[k];
    while (vpls[i].reach == 0)
        i = (i + 1) % POINTS;
    return i;
}

static void copy3(const float from[3], double to[3]) {
    for (int c = 0; c < 3; c++)
        to[c] = (double)from[c];
}

static void start(struct expected *e, const struct vpl *vpls) {
    for (int k = 0; k < CLUSTERS; k++) {
        const struct vpl *seed = &vpls[seed_of(e, vpls, k)];
        copy3(seed->position, e->means.position[k]);
        copy3(seed->normal, e->means.normal[k]);
        copy3(seed->flux, e->means.flux[k]);
        if (e->seeds && (double)e->seeds[k] <= VAL_SEED_NOWHERE)
            for (int c = 0; c < 3; c++)
                e->means.position[k][c] = 1e15;
    }
}

static double length(const double v[3]) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static double criterion(const struct expected *e, const struct vpl *vpl, int k) {
    const struct cluster_desc *desc = e->desc;
    double apart = 0, cosine = 0, hues = 0, flux[3];
    copy3(vpl->flux, flux);
    for (int c = 0; c < 3; c++) {
        apart += pow((double)vpl->position[c] - e->means.position[k][c], 2);
        cosine += (double)vpl->normal[c] * e->means.normal[k][c];
        hues += pow(flux[c] / fmax(length(flux), 1e-30) -
                        e->means.flux[k][c] / fmax(length(e->means.flux[k]), 1e-30),
                    2);
    }
    double by_place = (double)desc->weight_position / exp2((double)(pairs[0] / pairs[1]));
    if (desc->metric == CLUSTER_METRIC_SQUARES)
        return by_place * by_place * apart + (double)desc->weight_normal * (1 - cosine) +
               (double)desc->weight_flux * hues;
    double angle = acos(fmax(-1, fmin(1, cosine)));
    return by_place * sqrt(apart) + (double)desc->weight_normal / GLM_PI * angle;
}

static void map(struct expected *e, const struct vpl *vpls) {
    for (int i = 0; i < POINTS; i++) {
        double least = INFINITY, second = INFINITY;
        for (int k = 0; k < CLUSTERS; k++) {
            double d = criterion(e, &vpls[i], k);
            second = fmin(second, fmax(d, least));
            if (d < least) {
                least = d;
                e->means.nearest[i] = k;
            }
        }
        /* Clusters of one seed are as near; those of points that met nothing are not asked for. */
        if (vpls[i].reach > 0 && second > least)
            e->means.margin = fmin(e->means.margin, second - least);
    }
}

/* By its value, and a tenth by the mean of those that have light. */
static double weight_of(const struct expected *e, const struct vpl *vpls, int i) {
    double sum = 0, count = 0;
    if (e->desc->metric == CLUSTER_METRIC_SQUARES)
        return (double)(vpls[i].flux[0] + vpls[i].flux[1] + vpls[i].flux[2]);
    if (!e->values)
        return 1;
    for (int k = 0; k < POINTS; k++)
        if (vpls[k].reach > 0) {
            sum += (double)e->values[k];
            count++;
        }
    return .9 * (double)e->values[i] + .1 * sum / count;
}

static void mean_of(struct expected *e, const struct vpl *vpls, int k) {
    double sums[2][3] = {{0}}, flux[3] = {0}, weights = 0, count = 0;
    for (int i = 0; i < POINTS; i++) {
        const struct vpl *v = &vpls[i];
        if (v->reach == 0 || e->means.nearest[i] != k)
            continue;
        double weight = weight_of(e, vpls, i);
        for (int c = 0; c < 3; c++) {
            sums[0][c] += weight * (double)v->position[c];
            sums[1][c] += weight * (double)v->normal[c];
            flux[c] += (double)v->flux[c];
        }
        weights += weight;
        count++;
    }
    const struct vpl *seed = &vpls[seed_of(e, vpls, k)];
    bool again = e->desc->start == CLUSTER_START_RESEED;
    e->means.empty += count == 0;
    for (int c = 0; c < 3; c++) {
        if (count > 0) {
            e->means.position[k][c] = sums[0][c] / weights;
            e->means.normal[k][c] = sums[1][c] / length(sums[1]);
        } else if (again) {
            e->means.position[k][c] = (double)seed->position[c];
            e->means.normal[k][c] = (double)seed->normal[c];
        }
        e->means.flux[k][c] = flux[c];
    }
    e->means.count[k] = count;
}

static void expect(struct expected *e, const struct vpl *vpls) {
    e->means.margin = INFINITY;
    e->means.empty = 0;
    if (e->desc->start == CLUSTER_START_SEEDS || !e->means.started)
        start(e, vpls);
    e->means.started = true;
    for (int i = 0; i < e->desc->iterations; i++) {
        map(e, vpls);
        for (int k = 0; k < CLUSTERS; k++)
            mean_of(e, vpls, k);
    }
    if (!e->desc->means_of_map)
        map(e, vpls);
}

/* The next points of which each is so much nearer to its cluster than to any other that rounding
 * decides nothing: acos of a float near 1 is right to 4e-4 alone. e is what it is after them. */
static void expect_clear(struct expected *e, struct vpl vpls[POINTS], int *cloud) {
    const struct means before = e->means;
    for (int i = 0; i < CLOUDS_MAX; i++) {
        scatter(vpls, (*cloud)++);
        e->means = before;
        expect(e, vpls);
        if (e->means.margin > 1e-3)
            return;
    }
    fail_msg("no points are clear");
}

/* --- the passes ------------------------------------------------------------------------------- */

struct clustering {
    struct vpl_buffer vpls;
    struct texture seeds;
    struct vpl_weights weights;
    struct cluster_desc desc;
    struct cluster_pass pass;
    struct expected expected;
};

static const struct cluster_desc lengths = {
    .vpl_count = POINTS,
    .val_count = CLUSTERS,
    .iterations = 3,
    .metric = CLUSTER_METRIC_LENGTHS,
    .weight_position = .8f,
    .weight_normal = 1.5f,
    .near_clip = .25f,
    .has_views = true,
};

static const struct cluster_desc squares = {
    .vpl_count = POINTS,
    .val_count = CLUSTERS,
    .iterations = 3,
    .metric = CLUSTER_METRIC_SQUARES,
    .weight_position = .7f,
    .weight_normal = .5f,
    .weight_flux = .9f,
    .start = CLUSTER_START_WARM,
    .means_of_map = true,
};

static void open_row(struct texture *row, const char *label, GLenum format, int width) {
    check_ok(label, texture_init(row, &(struct texture_desc){
                                          .label = label, .format = format, .width = width}));
}

/* Of VPLs without light there is nothing, and they are no part of the mean. */
static void write_weights(const struct clustering *c, const struct vpl *vpls) {
    float values[POINTS], sum[4] = {0};
    for (int i = 0; i < POINTS; i++) {
        values[i] = vpls[i].reach > 0 ? c->expected.values[i] : 0;
        sum[0] += values[i];
        sum[1] += vpls[i].reach > 0 ? 1 : 0;
    }
    gl.TextureSubImage2D(c->weights.values.id, 0, 0, 0, POINTS, 1, GL_RED, GL_FLOAT, values);
    gl.TextureSubImage2D(c->weights.sum.id, 0, 0, 0, 1, 1, GL_RGBA, GL_FLOAT, sum);
}

static void open_clustering(struct clustering *c, const struct cluster_desc *desc,
                            const float *seeds, const float *values) {
    *c = (struct clustering){.desc = *desc};
    check_ok("points", vpl_buffer_init(&c->vpls, "points", POINTS));
    framebuffer_clear_color(c->vpls.sums_framebuffer, 0, pairs);
    if (seeds) {
        open_row(&c->seeds, "seeds", GL_R32F, CLUSTERS);
        gl.TextureSubImage2D(c->seeds.id, 0, 0, 0, CLUSTERS, 1, GL_RED, GL_FLOAT, seeds);
        c->desc.seeds = &c->seeds;
    }
    if (values) {
        open_row(&c->weights.values, "values", GL_R32F, POINTS);
        open_row(&c->weights.sum, "sum of values", GL_RGBA32F, 1);
        c->desc.weights = &c->weights;
    }
    c->expected = (struct expected){.desc = &c->desc, .seeds = seeds, .values = values};
    check_ok("clusters", cluster_pass_init(&c->pass, &c->desc));
}

static void close_clustering(struct clustering *c) {
    cluster_pass_free(&c->pass);
    textures_free(&c->seeds, &c->weights.values, &c->weights.sum);
    vpl_buffer_free(&c->vpls);
}

static double worst_of(const struct texture *row, double expected[CLUSTERS][3]) {
    float texels[CLUSTERS][4];
    double worst = 0;
    gl.GetTextureImage(row->id, 0, GL_RGBA, GL_FLOAT, sizeof texels, texels);
    for (int k = 0; k < CLUSTERS; k++)
        for (int c = 0; c < 3; c++)
            worst = fmax(worst, fabs((double)texels[k][c] - expected[k][c]) /
                                    fmax(fabs(expected[k][c]), 1));
    return worst;
}

static void check_mapping(const struct vpl_buffer *written, const struct vpl *vpls,
                          const int *nearest) {
    struct vpl mapped[POINTS];
    int wrong = 0, changed = 0;
    buffer_read(&written->buffer, 0, sizeof mapped, mapped);
    for (int i = 0; i < POINTS; i++) {
        wrong += vpls[i].reach > 0 && (int)mapped[i].val != nearest[i];
        mapped[i].val = vpls[i].val;
        changed += memcmp(&mapped[i], &vpls[i], sizeof *mapped) != 0;
    }
    printf("    of other clusters: %d, changed: %d\n", wrong, changed);
    assert_int_equal(wrong, 0);
    assert_int_equal(changed, 0);
}

static struct timers untimed;
static const struct geometry bounds = {.bounds_min = {-2, -2, -2}, .bounds_max = {3, 3, 2.5f}};
static const struct frame frame = {.timers = &untimed, .geometry = &bounds};

/* Renders a frame of points, and compares all that it leaves with what is expected. */
static void check_frame(struct clustering *c, const struct vpl *vpls) {
    const struct means *means = &c->expected.means;
    buffer_write(&c->vpls.buffer, 0, POINTS * sizeof *vpls, vpls);
    if (c->expected.values)
        write_weights(c, vpls);
    cluster_pass_render(&c->pass, &frame, &c->vpls);
    const struct val_targets *found = cluster_pass_centers(&c->pass);
    check_at_most("positions", worst_of(&found->position, (double(*)[3])means->position), 1e-5);
    check_at_most("normals", worst_of(&found->normal, (double(*)[3])means->normal), 1e-5);
    check_at_most("fluxes", worst_of(&found->flux, (double(*)[3])means->flux), 1e-5);
    float texels[CLUSTERS][4];
    gl.GetTextureImage(found->position.id, 0, GL_RGBA, GL_FLOAT, sizeof texels, texels);
    for (int k = 0; k < CLUSTERS; k++)
        assert_true((double)texels[k][3] == means->count[k]);
    check_mapping(&c->pass.vpls, vpls, means->nearest);
}

/* --- tests ------------------------------------------------------------------------------------ */

static void check_frames(const struct cluster_desc *desc, const float *values) {
    struct clustering c;
    struct vpl vpls[POINTS];
    int cloud = 0;
    open_clustering(&c, desc, NULL, values);
    for (int i = 0; i < 3; i++) {
        expect_clear(&c.expected, vpls, &cloud);
        check_frame(&c, vpls);
    }
    close_clustering(&c);
}

/* As the paper has it: the same seeds each frame. */
TEST(lengths) {
    check_frames(&lengths, NULL);
}

/* The same with VPLs weighted by importance: few have a high one, some none. */
TEST(weights) {
    float values[POINTS];
    for (int i = 0; i < POINTS; i++)
        values[i] = i % 5 == 0 ? 0 : powf((float)radical_inverse(2, (uint32_t)i + 1), 4);
    check_frames(&lengths, values);
}

/* By squares, weighted by flux, each frame from the means of the one before. */
TEST(squares) {
    check_frames(&squares, NULL);
}

/* Two that take turns, each with seeds of its own: some alike, so that one of them is lost, some
 * nowhere, some not told. Those that are lost begin again, or stay where they were. */
static void check_turns(const struct cluster_desc *desc) {
    static const float seeds[2][CLUSTERS] = {{5, 5, -1, 30, -2, 7, 57}, {40, 2, 2, 2, -1, -2, 11}};
    struct clustering c[2];
    struct vpl vpls[POINTS];
    int cloud = 0, empty = 0;
    for (int i = 0; i < 2; i++)
        open_clustering(&c[i], desc, seeds[i], NULL);
    for (int i = 0; i < 6; i++) {
        expect_clear(&c[i % 2].expected, vpls, &cloud);
        check_frame(&c[i % 2], vpls);
        empty += c[i % 2].expected.means.empty;
    }
    printf("    clusters that were empty: %d\n", empty);
    assert_true(empty > 0);
    for (int i = 0; i < 2; i++)
        close_clustering(&c[i]);
}

TEST(lost) {
    struct cluster_desc desc = squares;
    check_turns(&desc);
    desc.start = CLUSTER_START_RESEED;
    desc.iterations = 1;
    check_turns(&desc);
    desc = lengths;
    desc.start = CLUSTER_START_RESEED;
    check_turns(&desc);
}

/* Other lights are mapped to the clusters that these have. */
TEST(others) {
    struct clustering c;
    struct vpl vpls[POINTS], others[POINTS];
    struct vpl_buffer there;
    int cloud = 0;
    open_clustering(&c, &lengths, NULL, NULL);
    expect_clear(&c.expected, vpls, &cloud);
    check_frame(&c, vpls);
    do {
        scatter(others, cloud++);
        c.expected.means.margin = INFINITY;
        map(&c.expected, others);
    } while (c.expected.means.margin < 1e-3 && cloud < CLOUDS_MAX);
    check_ok("others", vpl_buffer_init(&there, "others", POINTS));
    buffer_write(&there.buffer, 0, sizeof others, others);
    cluster_pass_map(&c.pass, &there, &c.pass.vpls);
    check_mapping(&c.pass.vpls, others, c.expected.means.nearest);
    vpl_buffer_free(&there);
    close_clustering(&c);
}

/* Only the first clusters have seeds. */
static const float first_seeds[CLUSTERS] = {0, 1, 2, -2, -2, -2, -2};

static void render_lights(struct clustering *c, const struct vpl *lights, size_t size) {
    struct vpl vpls[POINTS] = {{.reach = 0}};
    memcpy(vpls, lights, size);
    buffer_write(&c->vpls.buffer, 0, sizeof vpls, vpls);
    cluster_pass_render(&c->pass, &frame, &c->vpls);
}

/* Three that surround a mean, at whose side stands the second cluster's first one, nearer to the
 * mean than all three, as is one that met nothing; and a third far off. The view looks from the
 * plane of the nearest of the three, below which the mean lies. That of the second's two lies above
 * the first's plane: the view looks from above that one. */
TEST(views) {
    static const struct vpl before[] = {
        {.position = {0, 0, 0}, .normal = {0, 0, 1}, .area = 1, .flux = {1}, .reach = 1},
        {.position = {.1f, .25f, .1f}, .normal = {0, 0, 1}, .area = 1, .flux = {1}, .reach = 1},
        {.position = {0, -2, 0}, .normal = {0, 1, 0}, .area = 1, .flux = {1}, .reach = 1},
    };
    static const struct vpl lights[] = {
        {.position = {-1, .2f, 0}, .normal = {0, 0, 1}, .area = .25f, .flux = {1}, .reach = 1},
        {.position = {1, -.3f, -.25f}, .normal = {0, 0, 1}, .area = .09f, .flux = {1}, .reach = 1},
        {.position = {.3f, -.2f, .4f}, .normal = {0, 0, 1}, .area = .04f, .flux = {1}, .reach = 1},
        {.position = {.1f, .25f, .1f}, .normal = {0, 0, 1}, .area = 4, .flux = {1}, .reach = 1},
        {.position = {0, -2, 0}, .normal = {0, 1, 0}, .area = 9, .flux = {1}, .reach = 1},
        {.position = {.1f, -.15f, .3f}, .normal = {0, 0, 1}, .area = .01f, .flux = {1}},
        {.position = {.1f, .49f, .22f}, .normal = {0, 0, 1}, .area = 4, .flux = {.5f}, .reach = 1},
    };
    /* Nothing nearer counts than a quarter of the spread, or a spacing. */
    const double clip = .25 * exp2(1.5);
    const struct {
        double center[3], axis[3], extent, near;
    } expected[] = {
        {{.1, -.1, .4}, {0, 0, 1}, 1, .2},
        {{.1, .25, .16}, {0, 0, 1}, 0, clip},
        {{0, -2, 0}, {0, 1, 0}, 0, clip},
    };
    struct clustering c;
    struct map_view views[CLUSTERS];
    struct cluster_desc desc = lengths;
    desc.iterations = 1;
    desc.start = CLUSTER_START_WARM;
    desc.means_of_map = true;
    open_clustering(&c, &desc, first_seeds, NULL);
    render_lights(&c, before, sizeof before);
    render_lights(&c, lights, sizeof lights);
    buffer_read(&c.pass.views.buffer, 0, sizeof views, views);
    for (int k = 0; k < 3; k++) {
        double far = 0, across = 0;
        for (int a = 0; a < 3; a++) {
            double at = expected[k].center[a];
            check_near("place of a view", (double)views[k].center[a], at, 1e-6);
            check_near("axis", (double)views[k].axis[a], expected[k].axis[a], 1e-6);
            far +=
                pow(fmax(at - (double)bounds.bounds_min[a], (double)bounds.bounds_max[a] - at), 2);
            across += (double)(views[k].axis[a] * views[k].tangent[a]);
        }
        check_near("extent", (double)views[k].extent, expected[k].extent, 1e-6);
        check_near("near", (double)views[k].near, expected[k].near, 1e-6);
        check_near("far", (double)views[k].z_far, sqrt(far), 1e-5);
        check_near("tangent along the axis", across, 0, 1e-6);
        check_near("tangent", (double)glm_vec3_norm(views[k].tangent), 1, 1e-6);
    }
    for (int k = 3; k < CLUSTERS; k++)
        assert_true((double)views[k].near >= .99 * MAP_VIEW_EMPTY);
    close_clustering(&c);
}

/* Normals that cancel out have no mean: the one before stays. */
TEST(opposed) {
    static const struct vpl lights[] = {
        {.position = {0, 0, 0}, .normal = {0, .6f, .8f}, .area = 1, .flux = {1}, .reach = 1},
        {.position = {1, 0, 2}, .normal = {0, -.6f, -.8f}, .area = 1, .flux = {2}, .reach = 1},
    };
    struct clustering c;
    struct cluster_desc desc = lengths;
    float normals[CLUSTERS][4], positions[CLUSTERS][4];
    static const float seeds[CLUSTERS] = {0, -2, -2, -2, -2, -2, -2};
    open_clustering(&c, &desc, seeds, NULL);
    render_lights(&c, lights, sizeof lights);
    const struct val_targets *found = cluster_pass_centers(&c.pass);
    gl.GetTextureImage(found->normal.id, 0, GL_RGBA, GL_FLOAT, sizeof normals, normals);
    gl.GetTextureImage(found->position.id, 0, GL_RGBA, GL_FLOAT, sizeof positions, positions);
    check_near("lights of one cluster", (double)positions[0][3], 2, 0);
    check_near("between them", (double)positions[0][2], 1, 1e-6);
    check_near("its normal", (double)normals[0][1], .6, 1e-6);
    check_near("its normal", (double)normals[0][2], .8, 1e-6);
    close_clustering(&c);
}

/* More lights than a dispatch takes, more sums than invocations; light i is of cluster i % MANY. */
TEST(many) {
    enum { MANY = CLUSTER_GROUP / 2, LIGHTS = 60 * CLUSTER_GROUP + 3 };
    struct cluster_desc desc = squares;
    struct cluster_pass pass;
    struct vpl_buffer vpls;
    static struct vpl lights[LIGHTS];
    static float found[MANY][4], expected[MANY];
    desc.vpl_count = LIGHTS;
    desc.val_count = MANY;
    for (int i = 0; i < LIGHTS; i++) {
        lights[i] = (struct vpl){.normal = {0, 0, 1}, .area = 1, .reach = 1};
        lights[i].position[0] = (float)(i % MANY);
        lights[i].flux[0] = (float)(i + 1);
        expected[i % MANY] += (float)(i + 1);
    }
    check_ok("passes", vpl_buffer_init(&vpls, "points", LIGHTS) && cluster_pass_init(&pass, &desc));
    framebuffer_clear_color(vpls.sums_framebuffer, 0, pairs);
    buffer_write(&vpls.buffer, 0, sizeof lights, lights);
    cluster_pass_render(&pass, &frame, &vpls);
    gl.GetTextureImage(pass.vals.flux.id, 0, GL_RGBA, GL_FLOAT, sizeof found, found);
    for (int k = 0; k < MANY; k++)
        assert_true(found[k][0] == expected[k]);
    cluster_pass_free(&pass);
    vpl_buffer_free(&vpls);
}

RUN_TESTS(open_group_context, close_group_context)
