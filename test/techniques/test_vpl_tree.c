/* The tree over VPLs that the GPU builds, and cuts through it: what each promises, and the error of
 * a cut against its bound at every pixel. */
#include "light_node.h"
#include "render_support.h"

#include "passes/frame.h"
#include "passes/gather/gather.h"
#include "passes/gather/vpl_cut.h"
#include "passes/lights/vpl_tree.h"
#include "reference/sampler.h"
#include "reference/vector.h"
#include "shared/gather.h"
#include "shared/vpl.h"

/* No power of two. */
enum { VPLS = 300, LEAVES = 512, SETS = 16, SIZE = 40, BLOCK = 8, BLOCKS = 5 };

/* A frame of a small picture, and a tree over its VPLs. */
struct bench {
    struct stage stage;
    struct renderer renderer;
    struct image layers;
    struct vpl *vpls;
    struct vpl_tree_pass tree;
    float rows[TREE_ROWS][2 * LEAVES][4];
    GLuint representatives[SETS][2 * LEAVES];
};

static struct bench *open_bench(void) {
    struct bench *bench = mem_alloc(1, sizeof *bench);
    struct output_list outputs;
    bench->stage = open_stage("scenes/cornell-animal.glb");
    open_renderer(&bench->renderer, desc_of(&bench->stage, "unshadowed",
                                            "vpls=300 interleave=1 adaptive=0", SIZE, SIZE));
    check_ok("layers", renderer_read_layers(&bench->renderer, &bench->layers));
    bench->vpls = read_vpls(&bench->renderer);
    renderer_outputs(&bench->renderer, &outputs);
    check_ok("tree", vpl_tree_pass_init(&bench->tree, &(struct vpl_tree_desc){VPLS, SETS}));
    struct frame frame = renderer_frame(&bench->renderer);
    vpl_tree_pass_render(&bench->tree, &frame, output_vpls(&outputs));
    gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
    gl.GetTextureImage(bench->tree.tree.nodes.id, 0, GL_RGBA, GL_FLOAT, sizeof bench->rows,
                       bench->rows);
    gl.GetTextureImage(bench->tree.tree.representatives.id, 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                       sizeof bench->representatives, bench->representatives);
    return bench;
}

static void close_bench(struct bench *bench) {
    vpl_tree_pass_free(&bench->tree);
    renderer_free(&bench->renderer);
    stage_free(&bench->stage);
    image_free(&bench->layers);
    mem_free(bench->vpls, bench);
}

static float power(const struct bench *bench, int node) {
    return bench->rows[TREE_FLUX][node][3];
}

static struct light_node node_at(const struct bench *bench, int node) {
    const float *low = bench->rows[TREE_LOW][node], *high = bench->rows[TREE_HIGH][node],
                *cone = bench->rows[TREE_CONE][node];
    return FILLED(light_node,
                  .extent = {vector_of(low), vector_of(high), vector_of(cone), cone[3],
                             sqrtf(fmaxf(1 - cone[3] * cone[3], 0))},
                  .flux = vector_of(bench->rows[TREE_FLUX][node]), .power = power(bench, node),
                  .area = high[3]);
}

/* --- the tree --------------------------------------------------------------------------------- */

/* Whether the light is within what a node says of those below it. */
static bool holds(const struct light_node *node, const struct vpl *vpl) {
    bool inside = vpl->area >= node->area;
    for (int c = 0; c < 3; c++)
        inside = inside && vpl->position[c] >= node->extent.low.raw[c] &&
                 vpl->position[c] <= node->extent.high.raw[c];
    return inside &&
           glms_vec3_dot(node->extent.axis, vector_of(vpl->normal)) >= node->extent.cosine;
}

/* Each lit VPL is a leaf once, all that are above it hold it, and fluxes add up. */
TEST(tree) {
    struct bench *bench = open_bench();
    int seen[VPLS] = {0}, lit = 0, leaves = 0, outside = 0, unequal = 0, order = 0;
    for (int i = 0; i < VPLS; i++)
        lit += bench->vpls[i].reach > 0;
    for (int k = LEAVES; k < 2 * LEAVES; k++) {
        if (power(bench, k) == 0)
            continue;
        const struct vpl *vpl = &bench->vpls[bench->representatives[0][k]];
        leaves++;
        order += k - LEAVES >= lit;
        seen[bench->representatives[0][k]]++;
        for (int above = k; above > 0; above /= 2) {
            struct light_node node = node_at(bench, above);
            outside += !holds(&node, vpl);
        }
    }
    for (int k = 1; k < LEAVES; k++)
        for (int c = 0; c < 4; c++) {
            const float(*flux)[4] = bench->rows[TREE_FLUX];
            unequal += flux[k][c] != flux[2 * k][c] + flux[2 * k + 1][c];
        }
    check_near("leaves", leaves, lit, 0);
    check_near("leaves behind empty ones", order, 0, 0);
    check_near("VPLs outside of nodes above them", outside, 0, 0);
    check_near("fluxes that do not add up", unequal, 0, 0);
    for (int i = 0; i < VPLS; i++)
        assert_int_equal(seen[i], bench->vpls[i].reach > 0);
    close_bench(bench);
}

/* How wide nodes are tells whether what is near comes together: boxes of the last levels over that
 * of all. */
static double mean_width(const struct bench *bench, int level) {
    double sum = 0, count = 0;
    for (int k = level; k < 2 * level; k++) {
        struct light_node node = node_at(bench, k);
        if (node.power <= 0)
            continue;
        sum += (double)glms_vec3_distance(node.extent.low, node.extent.high);
        count++;
    }
    return sum / count;
}

TEST(order) {
    struct bench *bench = open_bench();
    check_at_most("width of sixteenths over all", mean_width(bench, 16) / mean_width(bench, 1), .5);
    check_at_most("of pairs", mean_width(bench, LEAVES / 2) / mean_width(bench, 1), .12);
    close_bench(bench);
}

/* A VPL of the node, and over the sets about as often as its share of the flux. */
TEST(representatives) {
    struct bench *bench = open_bench();
    int foreign = 0, parents[VPLS];
    double apart = 0;
    for (int k = LEAVES; k < 2 * LEAVES; k++)
        if (power(bench, k) > 0)
            parents[bench->representatives[0][k]] = k;
    for (int k = 1; k < LEAVES; k++) {
        int left = 0;
        if (power(bench, k) == 0)
            continue;
        for (int set = 0; set < SETS; set++) {
            int above = parents[bench->representatives[set][k]], child = above;
            for (; above > k; above /= 2)
                child = above;
            foreign += above != k;
            left += child == 2 * k;
        }
        double share = (double)(power(bench, 2 * k) / power(bench, k));
        apart = fmax(apart, fabs((double)left / SETS - share));
    }
    check_near("representatives of other nodes", foreign, 0, 0);
    check_at_most("a child's share of representatives, off its flux's", apart, 1. / SETS + 1e-3);
    close_bench(bench);
}

/* --- bounds ----------------------------------------------------------------------------------- */

enum { QUESTIONS = 10000 };

struct question {
    vec4 receiver[3], node[3], area_and_clamp; /* test/support/cut_bound.comp */
};

static void put_extent(const struct light_extent *extent, vec4 rows[3]) {
    memcpy(rows[0], extent->low.raw, sizeof extent->low);
    memcpy(rows[1], extent->high.raw, sizeof extent->high);
    memcpy(rows[2], extent->axis.raw, sizeof extent->axis);
    rows[2][3] = extent->cosine;
}

static struct light_extent any_extent(uint32_t i, uint32_t pair) {
    struct sampler sampler = {.seed = 5, .index = i, .pair = pair};
    vec2s a = sampler_next(&sampler), b = sampler_next(&sampler), c = sampler_next(&sampler),
          d = sampler_next(&sampler), e = sampler_next(&sampler);
    vec3s low = {{a.x, a.y, b.x}}, sides = {{b.y, c.x, c.y}};
    float z = 2 * d.x - 1, turn = 2 * GLM_PIf * d.y, sine = sqrtf(1 - z * z);
    float cosine = 1 - 2 * e.x * e.x;
    return (struct light_extent){low,
                                 glms_vec3_add(low, glms_vec3_scale(sides, .3f * e.y)),
                                 {{sine * cosf(turn), sine * sinf(turn), z}},
                                 cosine,
                                 sqrtf(1 - cosine * cosine)};
}

static void ask(int clamp, const struct question *questions, float *answers) {
    ask_shader(&FILLED(questions, .shader = "cut_bound.comp", .defines = form("CLAMP %d", clamp),
                       .asked = questions, .asked_bytes = QUESTIONS * sizeof *questions,
                       .answers = answers, .answer_bytes = QUESTIONS * sizeof *answers,
                       .groups = {QUESTIONS}));
}

/* GLSL's bound is C's, which test_lightcuts.c holds against a million terms. */
TEST(same_bounds) {
    static const struct {
        const char *name;
        int clamp;
        struct geometry_term term;
    } rows[] = {{"value", GATHER_CLAMP_VALUE, {GEOMETRY_CLAMPED, 3}},
                {"disk", GATHER_CLAMP_DISK, {.bound = GEOMETRY_DISK}}};
    static struct question questions[QUESTIONS];
    static float answers[QUESTIONS];
    for (int r = 0; r < 2; r++) {
        double worst = 0;
        int zeros = 0;
        for (uint32_t i = 0; i < QUESTIONS; i++) {
            struct light_extent receiver = any_extent(i, 0), node = any_extent(i, 5);
            put_extent(&receiver, questions[i].receiver);
            put_extent(&node, questions[i].node);
            questions[i].area_and_clamp[0] = .01f;
            questions[i].area_and_clamp[1] = rows[r].term.clamp_value;
        }
        ask(rows[r].clamp, questions, answers);
        for (uint32_t i = 0; i < QUESTIONS; i++) {
            struct light_extent receiver = any_extent(i, 0);
            struct light_node node = {.extent = any_extent(i, 5), .area = .01f};
            double expected = (double)light_node_bound(&node, &receiver, &rows[r].term);
            zeros += expected == 0;
            worst = fmax(worst, fabs((double)answers[i] - expected) / (expected + 1e-3));
        }
        printf("    %s: %d of %d are 0\n", rows[r].name, zeros, QUESTIONS);
        check_near("apart at worst, over the bound", worst, 0, 1e-3);
    }
}

/* As src/passes/gather/vpl_terms.glsl has it: cos cos / d^2 where both are 1. */
static double patch_of(double distance2, double area) {
    const double c = (GLM_PI - 6) / (GLM_PI - 2), t = distance2 / (6.5 * area);
    double rest = 1 + t * t;
    return (1 - (1 - (3 - c) * t - c * t * t) / (rest * rest)) / distance2;
}

/* A place of the box, of three numbers of which one is taken twice. */
static vec3s place_in(const struct light_extent *extent, vec2s number) {
    vec3s share = {{number.x, number.y, number.x}};
    return glms_vec3_add(extent->low,
                         glms_vec3_mul(share, glms_vec3_sub(extent->high, extent->low)));
}

/* No patch of at least the node's area sends more from a place of its box to one of the receiver's.
 * From a single place near by a patch of that area sends as much. */
TEST(patch_bounds) {
    static struct question questions[QUESTIONS];
    static float answers[QUESTIONS];
    double most = 0, apart = 0;
    for (uint32_t i = 0; i < QUESTIONS; i++) {
        struct light_extent receiver = any_extent(i, 0), node = any_extent(i, 5);
        receiver.cosine = node.cosine = -1; /* all directions */
        if (i % 2) {
            receiver.high = receiver.low;
            node.high = node.low;
        }
        put_extent(&receiver, questions[i].receiver);
        put_extent(&node, questions[i].node);
        questions[i].area_and_clamp[0] = powf(10, -3 + 3 * (float)i / QUESTIONS);
    }
    ask(GATHER_CLAMP_PATCH, questions, answers);
    for (uint32_t i = 0; i < QUESTIONS; i++) {
        struct sampler sampler = {.seed = 6, .index = i};
        struct light_extent receiver = any_extent(i, 0), node = any_extent(i, 5);
        vec2s larger = sampler_next(&sampler);
        double area = (double)questions[i].area_and_clamp[0], bound = (double)answers[i];
        if (i % 2) {
            receiver.high = receiver.low;
            node.high = node.low;
        }
        double distance2 = (double)glms_vec3_distance2(place_in(&receiver, sampler_next(&sampler)),
                                                       place_in(&node, sampler_next(&sampler)));
        most = fmax(most, patch_of(distance2, area * (1 + 9 * (double)larger.x)) / bound);
        if (i % 2 && distance2 < 3.9 * area)
            apart = fmax(apart, fabs(patch_of(distance2, area) / bound - 1));
    }
    check_at_most("of the bound at most", most, 1 + 1e-3);
    check_near("off it where it is reached", apart, 0, 1e-3);
}

/* --- cuts ------------------------------------------------------------------------------------- */

static float term_of(const struct geometry_term *term, vec3s x, vec3s normal,
                     const struct vpl *vpl) {
    vec3s path = glms_vec3_sub(vector_of(vpl->position), x);
    float cos_x = glms_vec3_dot(normal, path), cos_i = -glms_vec3_dot(vector_of(vpl->normal), path),
          distance2 = glms_vec3_norm2(path);
    return cos_x > 0 && cos_i > 0
               ? geometry_term(term, cos_x * cos_i / distance2, distance2, vpl->area)
               : 0;
}

struct cut {
    int count;
    GLuint nodes[CUT_NODES_MAX];
};

/* Blocks from the bottom up, as GL has them. */
static void find_cuts(struct bench *bench, int nodes, float tolerance,
                      struct cut cuts[BLOCKS][BLOCKS]) {
    struct vpl_cut_pass pass;
    static GLuint texels[2 * (1 + CUT_NODES_MAX)][BLOCKS][BLOCKS];
    check_ok("cuts",
             vpl_cut_pass_init(&pass, &FILLED(vpl_cut_desc, .width = SIZE, .height = SIZE,
                                              .block = BLOCK, .nodes = nodes,
                                              .tolerance = tolerance, .clamp = GATHER_CLAMP_DISK)));
    struct frame frame = renderer_frame(&bench->renderer);
    vpl_cut_pass_render(&pass, &frame, &bench->renderer.gbuffer, &bench->tree.tree, false);
    gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
    gl.GetTextureImage(pass.cuts.texture.id, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, sizeof texels,
                       texels);
    for (int y = 0; y < BLOCKS; y++)
        for (int x = 0; x < BLOCKS; x++) {
            struct cut *cut = &cuts[y][x];
            cut->count = (int)texels[0][y][x];
            assert_true(cut->count >= 0 && cut->count <= nodes);
            for (int i = 0; i < cut->count; i++)
                cut->nodes[i] = texels[1 + i][y][x];
        }
    vpl_cut_pass_free(&pass);
}

static bool sees_surface(const struct bench *bench, int x, int y) {
    return image_at(&bench->layers, x, y)[image_find_channel(&bench->layers, "A")] > 0;
}

static void surface_at(const struct bench *bench, int x, int y, vec3s *place, vec3s *normal) {
    int channel = image_find_channel(&bench->layers, "normal.X");
    pixel_position(&bench->renderer, &bench->layers, x, y, place->raw);
    *normal = vec3s_unit(vector_of(image_at(&bench->layers, x, y) + channel));
}

/* How often leaves that have light are below a node of the cut. */
static int count_wrong(const struct bench *bench, const struct cut *cut) {
    int wrong = 0;
    for (int k = LEAVES; k < 2 * LEAVES; k++) {
        int times = 0;
        for (int above = k; above > 0; above /= 2)
            for (int i = 0; i < cut->count; i++)
                times += (int)cut->nodes[i] == above;
        wrong += power(bench, k) > 0 && times != 1;
    }
    return wrong;
}

/* Of a pixel's cut: the light of all VPLs, by a set, and what it may be off at that pixel. */
struct sums {
    double all, cut, bound;
};

static struct sums sum_at(const struct bench *bench, const struct cut *cut, int x, int y, int set) {
    const struct geometry_term disk = {.bound = GEOMETRY_DISK};
    struct sums sums = {0};
    vec3s place, normal;
    surface_at(bench, x, y, &place, &normal);
    struct light_extent receiver = {place, place, normal, .cosine = 1};
    for (int i = 0; i < VPLS; i++) {
        const struct vpl *vpl = &bench->vpls[i];
        if (vpl->reach > 0)
            sums.all += (double)(term_of(&disk, place, normal, vpl) *
                                 (vpl->flux[0] + vpl->flux[1] + vpl->flux[2]));
    }
    for (int i = 0; i < cut->count; i++) {
        int k = (int)cut->nodes[i];
        struct light_node node = node_at(bench, k);
        const struct vpl *vpl = &bench->vpls[bench->representatives[set][k]];
        sums.cut += (double)(term_of(&disk, place, normal, vpl) * node.power);
        sums.bound +=
            k < LEAVES ? (double)(light_node_bound(&node, &receiver, &disk) * node.power) : 0;
    }
    return sums;
}

/* Relative RMSE of the sets, for comparison; checks each pixel's error. */
static double check_cuts(struct bench *bench, int nodes, float tolerance, double *mean_count) {
    static struct cut cuts[BLOCKS][BLOCKS];
    double squares = 0, sum = 0, count = 0;
    int wrong = 0, above = 0;
    find_cuts(bench, nodes, tolerance, cuts);
    *mean_count = 0;
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            const struct cut *cut = &cuts[(SIZE - 1 - y) / BLOCK][x / BLOCK];
            if (!sees_surface(bench, x, y))
                continue;
            if (x % BLOCK == BLOCK / 2 && y % BLOCK == BLOCK / 2)
                wrong += count_wrong(bench, cut);
            for (int set = 0; set < SETS; set += 5) {
                struct sums sums = sum_at(bench, cut, x, y, set);
                above += fabs(sums.cut - sums.all) > sums.bound + 1e-4 * sums.all;
                squares += pow(sums.cut - sums.all, 2);
                sum += sums.all;
                *mean_count += cut->count;
                count++;
            }
        }
    *mean_count /= count;
    double rmse = sqrt(squares / count) / (sum / count);
    printf("    %d nodes, tolerance %g: %.1f taken, relative RMSE %.4f\n", nodes, (double)tolerance,
           *mean_count, rmse);
    check_near("leaves not below one node", wrong, 0, 0);
    check_near("pixels above the bound", above, 0, 0);
    return rmse;
}

TEST(cuts) {
    struct bench *bench = open_bench();
    double taken, few, last = check_cuts(bench, 4, 0, &taken);
    for (int nodes = 16; nodes <= CUT_NODES_MAX; nodes *= 4) {
        double error = check_cuts(bench, nodes, 0, &taken);
        check_at_most("over that of a quarter of the nodes", error / last, .7);
        last = error;
    }
    check_cuts(bench, CUT_NODES_MAX, .2f, &few);
    check_at_most("nodes of a tolerance over those of none", few / taken, .7);
    close_bench(bench);
}

/* --- pictures --------------------------------------------------------------------------------- */

/* A cut of all leaves is the sum of all VPLs. */
TEST(all_leaves) {
    OWNED(stage) stage = open_stage("scenes/cornell-animal.glb");
    static const char *const plain = "vpls=64 vals=8 map.size=64 interleave=1 blur.radius=0 "
                                     "shadow-size=256 near-samples=16";
    char cuts[256];
    snprintf(cuts, sizeof cuts, "%s nodes=64 tolerance=0", plain);
    OWNED(image) all = render_stage(&stage, "clustered", plain, 32),
                 cut = render_stage(&stage, "lightcuts", cuts, 32);
    check_at_most("relative RMSE", relative_rmse(&cut, &all, "indirect"), 1e-3);
    image_free(&cut);
    snprintf(cuts, sizeof cuts, "%s nodes=8", plain);
    cut = render_stage(&stage, "lightcuts", cuts, 32);
    check_at_most("of few nodes, at least", .02, relative_rmse(&cut, &all, "indirect"));
}

RUN_TESTS(open_group_context, close_group_context)
