/* Lightcuts: what a tree and its cuts promise, over lights made at random, and the bound of a
 * picture's error at every pixel. */
#include "command_support.h"
#include "hand_made.h"

#include "base/file/image_file.h"
#include "reference/light_cut.h"
#include "reference/sampler.h"
#include "reference/vector.h"
#include "reference/vpl_sum.h"

enum { LIGHTS = 777 };

static float random_number(uint32_t *state) {
    *state = sampler_hash(*state, 1);
    return (float)(*state >> 8) * 0x1p-24f;
}

static vec3s random_place(uint32_t *state) {
    float x = random_number(state), y = random_number(state), z = random_number(state);
    return (vec3s){{x, y, z}};
}

static vec3s random_direction(uint32_t *state) {
    vec3s from = {{0.5f, 0.5f, 0.5f}}, v;
    do
        v = glms_vec3_sub(random_place(state), from);
    while (glms_vec3_norm2(v) > 0.25f || glms_vec3_norm2(v) < 1e-4f);
    return glms_vec3_normalize(v);
}

/* Lights on the walls of a unit cube and some anywhere, a tenth of which met nothing or are black. */
static struct vpl *scatter_lights(uint32_t seed) {
    struct vpl *vpls = mem_alloc(LIGHTS, sizeof *vpls);
    for (int i = 0; i < LIGHTS; i++) {
        struct vpl *vpl = &vpls[i];
        vec3s place = random_place(&seed), normal = random_direction(&seed),
              flux = random_place(&seed);
        if (i % 4) {
            normal = (vec3s){{0, 0, 0}};
            normal.raw[i % 3] = i % 2 ? 1 : -1;
            place.raw[i % 3] = i % 2 ? 0 : 1;
        }
        memcpy(vpl->position, place.raw, sizeof place.raw);
        memcpy(vpl->normal, normal.raw, sizeof normal.raw);
        memcpy(vpl->flux, flux.raw, sizeof flux.raw);
        vpl->area = 0.001f + 0.01f * random_number(&seed);
        vpl->reach = i % 20 ? 1 : 0;
        if (i % 20 == 1)
            memset(vpl->flux, 0, sizeof vpl->flux);
    }
    return vpls;
}

static bool is_lit(const struct vpl *vpl) {
    return vpl->reach > 0 && vpl->flux[0] + vpl->flux[1] + vpl->flux[2] > 0;
}

/* --- the tree --------------------------------------------------------------------------------- */

static void test_tree(void **state) {
    (void)state;
    struct vpl *vpls = scatter_lights(1);
    struct light_tree tree;
    int lit = 0, leaves = 0, unequal = 0, foreign = 0;
    light_tree_init(&tree, vpls, LIGHTS, 1);
    for (int i = 0; i < LIGHTS; i++)
        lit += is_lit(&vpls[i]);
    for (int i = 0; i < tree.count; i++) {
        const struct light_node *node = &tree.nodes[i], *a = &tree.nodes[node->children[0]],
                                *b = &tree.nodes[node->children[1]];
        if (light_node_is_leaf(node)) {
            leaves++;
            unequal += memcmp(&node->flux, vpls[node->representative].flux, sizeof node->flux) != 0;
            continue;
        }
        vec3s sum = glms_vec3_add(a->flux, b->flux);
        unequal += memcmp(&node->flux, &sum, sizeof sum) != 0;
        foreign +=
            node->representative != a->representative && node->representative != b->representative;
    }
    check_near("leaves", leaves, lit, 0);
    check_near("nodes", tree.count, 2 * lit - 1, 0);
    check_near("nodes whose flux is not their children's", unequal, 0, 0);
    check_near("representatives of neither child", foreign, 0, 0);
    light_tree_free(&tree);
    light_tree_init(&tree, vpls, 0, 1);
    check_near("nodes of no lights", tree.count, 0, 0);
    light_tree_free(&tree);
    free(vpls);
}

/* A light is picked as often as its share of the flux says. */
static void test_representatives(void **state) {
    (void)state;
    enum { SEEDS = 4096, COUNT = 5 };
    struct vpl vpls[COUNT] = {0};
    int picked[COUNT] = {0};
    for (int i = 0; i < COUNT; i++)
        vpls[i] = (struct vpl){.position = {(float)i, 0, 0},
                               .normal = {0, 0, 1},
                               .flux = {(float)i, 0, 1},
                               .reach = 1};
    for (uint32_t seed = 0; seed < SEEDS; seed++) {
        struct light_tree tree;
        light_tree_init(&tree, vpls, COUNT, seed);
        picked[tree.nodes[0].representative]++;
        light_tree_free(&tree);
    }
    for (int i = 0; i < COUNT; i++) /* within four standard deviations */
        check_near("share of the choices", picked[i] / (double)SEEDS, (i + 1) / 15., 0.03);
}

/* --- bounds ----------------------------------------------------------------------------------- */

static float term_of(const struct geometry_term *term, vec3s x, vec3s normal,
                     const struct vpl *vpl) {
    vec3s path = glms_vec3_sub(vector_of(vpl->position), x);
    float cos_x = glms_vec3_dot(normal, path), cos_i = -glms_vec3_dot(vector_of(vpl->normal), path),
          distance2 = glms_vec3_norm2(path);
    return cos_x > 0 && cos_i > 0
               ? geometry_term(term, cos_x * cos_i / distance2, distance2, vpl->area)
               : 0;
}

/* Points of a box of up to that size, and normals of a cone of up to half a turn. */
struct receivers {
    struct light_extent extent;
    vec3s turn; /* across the axis */
};

static struct receivers random_receivers(uint32_t *state, float size) {
    struct receivers made;
    vec3s low = random_place(state), normal = random_direction(state),
          sizes = glms_vec3_scale(random_place(state), size);
    float cosine = size > 0 ? 1 - 2 * random_number(state) * random_number(state) : 1;
    made.extent = (struct light_extent){low, glms_vec3_add(low, sizes), normal, cosine,
                                        sqrtf(1 - cosine * cosine)};
    made.turn = glms_vec3_normalize(glms_vec3_ortho(normal));
    return made;
}

/* One of the receivers, often at a corner of the box and at the rim of the cone. */
static void pick_receiver(const struct receivers *receivers, uint32_t *state, vec3s *x,
                          vec3s *normal) {
    const struct light_extent *extent = &receivers->extent;
    for (int c = 0; c < 3; c++) {
        float t = fminf(fmaxf(2 * random_number(state) - 0.5f, 0), 1);
        x->raw[c] = extent->low.raw[c] + t * (extent->high.raw[c] - extent->low.raw[c]);
        x->raw[c] = fminf(x->raw[c], extent->high.raw[c]);
    }
    float most = acosf(fminf(extent->cosine, 1)),
          angle = most * fminf(1.5f * random_number(state), 1);
    vec3s axis =
        glms_vec3_rotate(receivers->turn, 2 * GLM_PIf * random_number(state), extent->axis);
    *normal =
        extent->cosine >= 1 ? extent->axis : glms_vec3_rotate(extent->axis, 0.9999f * angle, axis);
}

/* A million triples of a node, a light below it, and a receiver of a box and a cone; a third of which
 * are points with one normal. */
static void test_bound(void **state) {
    (void)state;
    static const struct geometry_term terms[] = {
        {.bound = GEOMETRY_UNBOUNDED}, {GEOMETRY_CLAMPED, 25}, {.bound = GEOMETRY_DISK}};
    static const char *const names[] = {"unbounded", "clamped", "disk"};
    enum { TRIPLES = 1000000, EXTENTS = 4000 };
    struct vpl *vpls = scatter_lights(2);
    struct light_tree tree;
    uint32_t random = 3;
    light_tree_init(&tree, vpls, LIGHTS, 1);
    for (int bound = 0; bound < 3; bound++) {
        int above = 0, lit = 0;
        double tightness = 0;
        for (int e = 0; e < EXTENTS; e++) {
            struct receivers receivers = random_receivers(&random, (float)(e % 3) * 0.2f);
            for (int i = 0; i < TRIPLES / 3 / EXTENTS; i++) {
                int at = 0;
                vec3s x, normal;
                for (float depth = 12 * random_number(&random);
                     depth > 0 && !light_node_is_leaf(&tree.nodes[at]); depth--)
                    at = tree.nodes[at].children[random_number(&random) < 0.5f];
                float most = light_node_bound(&tree.nodes[at], &receivers.extent, &terms[bound]);
                int leaf = at;
                while (!light_node_is_leaf(&tree.nodes[leaf]))
                    leaf = tree.nodes[leaf].children[random_number(&random) < 0.5f];
                pick_receiver(&receivers, &random, &x, &normal);
                float term =
                    term_of(&terms[bound], x, normal, &vpls[tree.nodes[leaf].representative]);
                above += !(term <= most);
                lit += term > 0;
                tightness += term > 0 && most > 0 ? (double)(term / most) : 0;
            }
        }
        printf("    %s: %d of %d give light, %.2f of the bound in the mean\n", names[bound], lit,
               TRIPLES / 3, tightness / lit);
        check_near("above the bound", above, 0, 0);
        check_at_most("that give none", 1 - lit / (TRIPLES / 3.), 0.9);
    }
    light_tree_free(&tree);
    free(vpls);
}

/* --- cuts ------------------------------------------------------------------------------------- */

struct receiver {
    const struct vpl *vpls;
    struct geometry_term term;
    vec3s x, normal;
};

static float evaluate(const void *context, int vpl) {
    const struct receiver *receiver = context;
    return term_of(&receiver->term, receiver->x, receiver->normal, &receiver->vpls[vpl]);
}

static void mark_leaves(const struct light_tree *tree, int at, int *seen) {
    const struct light_node *node = &tree->nodes[at];
    if (light_node_is_leaf(node))
        seen[node->representative]++;
    else
        for (int i = 0; i < 2; i++)
            mark_leaves(tree, node->children[i], seen);
}

/* Each light is below one node; no node is off by more than the tolerance, nor the sum by more than
 * the nodes' bounds together. */
static void check_cut(const struct light_tree *tree, const struct light_cut *cut,
                      const struct receiver *receiver, double tolerance) {
    int seen[LIGHTS] = {0}, wrong = 0;
    double sum = 0, whole = 0, bounds = 0, greatest = 0;
    for (int i = 0; i < cut->count; i++) {
        const struct light_cut_node *node = &cut->nodes[i];
        mark_leaves(tree, node->node, seen);
        sum += (double)(node->term * tree->nodes[node->node].power);
        bounds += (double)node->bound;
        greatest = fmax(greatest, (double)node->bound);
    }
    for (int i = 0; i < LIGHTS; i++) {
        const struct vpl *vpl = &receiver->vpls[i];
        wrong += seen[i] != is_lit(vpl);
        if (is_lit(vpl))
            whole += (double)(evaluate(receiver, i) * (vpl->flux[0] + vpl->flux[1] + vpl->flux[2]));
    }
    assert_int_equal(wrong, 0);
    assert_true(greatest <= tolerance * sum * (1 + 1e-6));
    assert_true(fabs(sum - whole) <= bounds + 1e-6 * whole);
}

static void test_cut(void **state) {
    (void)state;
    static const float tolerances[] = {0, 0.005f, 0.02f, 0.1f};
    struct vpl *vpls = scatter_lights(4);
    struct light_cut cut = {0};
    uint32_t random = 5;
    double counts[4] = {0};
    for (uint32_t seed = 0; seed < 8; seed++) {
        struct light_tree tree;
        light_tree_init(&tree, vpls, LIGHTS, seed);
        for (int i = 0; i < 200; i++) {
            struct receiver receiver = {vpls,
                                        {i % 2 ? GEOMETRY_DISK : GEOMETRY_UNBOUNDED, 0},
                                        random_place(&random),
                                        random_direction(&random)};
            float tolerance = tolerances[i % 4];
            light_cut_find(&cut,
                           &(struct light_cut_desc){
                               .tree = &tree,
                               .receiver = {receiver.x, receiver.x, receiver.normal, .cosine = 1},
                               .term = receiver.term,
                               .tolerance = tolerance,
                               .evaluate = evaluate,
                               .context = &receiver,
                           });
            check_cut(&tree, &cut, &receiver, (double)tolerance);
            counts[i % 4] += cut.count / 400.;
        }
        light_tree_free(&tree);
    }
    printf("    nodes at tolerances 0, .005, .02, .1: %.0f, %.0f, %.0f, %.0f of %d\n", counts[0],
           counts[1], counts[2], counts[3], LIGHTS);
    check_at_most("nodes of half a percent over all", counts[1] / counts[0], 0.9);
    check_at_most("nodes of 2 % over half a percent", counts[2] / counts[1], 0.8);
    check_at_most("nodes of 10 % over 2 %", counts[3] / counts[2], 0.7);
    light_cut_free(&cut);
    free(vpls);
}

/* --- pictures --------------------------------------------------------------------------------- */

/* A floor, two walls and a screen between them, under lights along the walls. */
static void set_room(struct world *world, struct vpl *vpls, int count) {
    uint32_t random = 6;
    world_init(world);
    add_rectangle(world, 0, (vec3s){{0, 0, 1}}, (vec3s){{1, 0, 0}}, (vec3s){{0, 0, -1}});
    add_rectangle(world, 0, (vec3s){{0, 0, 1}}, (vec3s){{0, 0, -1}}, (vec3s){{0, 1, 0}});
    add_rectangle(world, 0, (vec3s){{0, 0, 0}}, (vec3s){{1, 0, 0}}, (vec3s){{0, 1, 0}});
    add_rectangle(world, 0, (vec3s){{0.3f, 0, 0.8f}}, (vec3s){{0, 0.4f, 0}},
                  (vec3s){{0.2f, 0, -0.5f}});
    world_finish(world);
    look_down(world, 0, 0, 1, 3);
    for (int i = 0; i < count; i++) {
        vec3s place = random_place(&random), flux = random_place(&random);
        int wall = 2 * (i % 2);
        place.raw[wall] = 0;
        vpls[i] = (struct vpl){.area = 1.f / (float)count, .reach = i % 9 ? 1 : 0};
        vpls[i].normal[wall] = 1;
        memcpy(vpls[i].position, place.raw, sizeof place.raw);
        memcpy(vpls[i].flux, flux.raw, sizeof flux.raw);
    }
}

/* The most that a channel's error takes of its bound, and how many pixels are above it but for the
 * rounding of sums. */
struct excess {
    double most, pixels;
};

static struct excess compare_to_bound(const struct image *cut, const struct image *whole) {
    struct excess excess = {0};
    for (int y = 0; y < cut->height; y++)
        for (int x = 0; x < cut->width; x++)
            for (int c = 0; c < 3; c++) {
                const float *a = image_at(cut, x, y), *b = image_at(whole, x, y);
                double error = fabs((double)(a[CHANNEL_INDIRECT + c] - b[CHANNEL_INDIRECT + c])),
                       bound = (double)a[CHANNEL_BOUND + c];
                excess.most = fmax(excess.most, bound > 0 ? error / bound : 0);
                excess.pixels += error > bound + 1e-6 * (double)b[CHANNEL_INDIRECT + c];
            }
    return excess;
}

static void test_picture(void **state) {
    (void)state;
    enum { COUNT = 500, SIZE = 24, SEEDS = 5 };
    static const float tolerances[] = {0.005f, 0.02f, 0.1f};
    struct vpl vpls[COUNT];
    struct world world;
    struct image whole, image;
    set_room(&world, vpls, COUNT);
    struct vpl_sum_cuts cuts = {0};
    struct vpl_sum_desc desc = {.scene = &world.scene,
                                .geometry = &world.geometry,
                                .camera = &world.camera,
                                .vpls = vpls,
                                .vpl_count = COUNT,
                                .width = SIZE,
                                .height = SIZE,
                                .term = {.bound = GEOMETRY_DISK}};
    check_ok("sum", vpl_sum_render(&desc, &whole));
    desc.cuts = &cuts;
    check_ok("cut", vpl_sum_render(&desc, &image));
    int other = 0;
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++)
            other += memcmp(image_at(&image, x, y), image_at(&whole, x, y),
                            CHANNEL_COMMON_END * sizeof(float)) != 0;
    check_near("pixels of tolerance 0 with other bits", other, 0, 0);
    image_free(&image);
    double last = COUNT;
    for (int t = 0; t < 3; t++) {
        double nodes = 0;
        struct excess excess = {0};
        cuts.tolerance = tolerances[t];
        for (cuts.seed = 0; cuts.seed < SEEDS; cuts.seed++) {
            check_ok("cut", vpl_sum_render(&desc, &image));
            struct excess found = compare_to_bound(&image, &whole);
            excess = (struct excess){fmax(excess.most, found.most), excess.pixels + found.pixels};
            nodes += mean_of(&image, CHANNEL_NODES) / SEEDS;
            image_free(&image);
        }
        printf("    tolerance %g: %.0f nodes\n", (double)tolerances[t], nodes);
        check_near("pixels above the bound", excess.pixels, 0, 0);
        check_at_most("error over the bound", excess.most, 1);
        check_at_most("that there is one", 0.01, excess.most);
        check_at_most("nodes", nodes, 0.9 * last);
        last = nodes;
    }
    image_free(&whole);
    world_free(&world);
}

static void reference(const char *arguments, const char *path, struct image *image) {
    if (run_program("reference scenes/cornell-box.glb --size 32x32 --set vpls=1024 -q -o %s %s",
                    path, arguments) != 0)
        fail_msg("%s", output);
    check_ok("read", image_read(image, path));
}

/* From file to file, where colours have half floats. */
static void test_app(void **state) {
    (void)state;
    struct image whole, cut;
    int a[3], b[3], bound[3], above = 0;
    reference("--technique vpl-raytraced", scratch("whole.exr"), &whole);
    reference("--technique lightcuts --tolerance 5% --seed 3", scratch("cut.exr"), &cut);
    int nodes = image_find_channel(&cut, "nodes.G");
    check_ok("layers", image_find_layer(&whole, "indirect", a) &&
                           image_find_layer(&cut, "indirect", b) &&
                           image_find_layer(&cut, "bound", bound) && nodes >= 0);
    for (int i = 0; i < 32 * 32 * 3; i++) {
        const float *of_cut = image_at(&cut, i / 3 % 32, i / 3 / 32);
        double exact = (double)image_at(&whole, i / 3 % 32, i / 3 / 32)[a[i % 3]];
        above += fabs((double)of_cut[b[i % 3]] - exact) >
                 1.001 * (double)of_cut[bound[i % 3]] + 1e-3 * exact;
    }
    check_near("colours above the bound", above, 0, 0);
    check_at_most("nodes", mean_of(&cut, nodes), 300);
    check_at_most("at least", 20, mean_of(&cut, nodes));
    image_free(&whole);
    image_free(&cut);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_tree),    cmocka_unit_test(test_representatives),
        cmocka_unit_test(test_bound),   cmocka_unit_test(test_cut),
        cmocka_unit_test(test_picture), cmocka_unit_test(test_app),
    };
    return cmocka_run_group_tests_name("lightcuts", tests, NULL, NULL);
}
