/* Visibility by rays through the scene's triangles, on the GPU: against Embree, in scenes that move
 * too; and a frame against the sum over its VPLs by Embree. */
#include "render_support.h"

#include "base/halton.h"
#include "scene/gpu/caster_pool.h"
#include "shared/vpl.h"

enum { PAIRS = 8192 };

struct pair {
    float from[4], normal[4], to[4];
};

/* --- rays ------------------------------------------------------------------------------------- */

static vec3s place_within(const struct geometry *geometry, uint32_t number,
                          const uint32_t bases[3]) {
    vec3s place;
    for (int c = 0; c < 3; c++)
        place.raw[c] = glm_lerp(geometry->bounds_min[c], geometry->bounds_max[c],
                                (float)radical_inverse(bases[c], number));
    return place;
}

/* What is seen from a place within in a direction. */
static bool surface_at(const struct rays *rays, const struct geometry *geometry, uint32_t number,
                       struct hit *hit) {
    static const uint32_t bases[2][3] = {{2, 3, 5}, {7, 11, 13}};
    vec3s from = place_within(geometry, number, bases[0]);
    vec3s towards = glms_vec3_sub(place_within(geometry, number, bases[1]), from);
    return ray_scene_hit(&rays->scene, from, vec3s_unit(towards), hit);
}

/* From a surface to another one, as from pixels to VPLs; or between places in the air. */
static struct pair pair_of(const struct rays *rays, const struct geometry *geometry,
                           uint32_t number) {
    static const uint32_t bases[2][3] = {{2, 3, 5}, {7, 11, 13}};
    vec3s from = place_within(geometry, number, bases[0]), normal = glms_vec3_zero();
    vec3s to = place_within(geometry, number, bases[1]);
    struct hit hit, other;
    if (number % 4 && surface_at(rays, geometry, 2 * number, &hit) &&
        surface_at(rays, geometry, 2 * number + 1, &other)) {
        from = hit.position;
        normal = hit.geometric_normal;
        to = other.position;
    }
    return (struct pair){.from = {from.x, from.y, from.z},
                         .normal = {normal.x, normal.y, normal.z},
                         .to = {to.x, to.y, to.z}};
}

static void ask(const struct caster_bvh *tree, const struct pair *pairs, uint32_t *answers) {
    ask_shader(&FILLED(questions, .shader = "traced.comp", .asked = pairs,
                       .asked_bytes = PAIRS * sizeof *pairs, .answers = answers,
                       .answer_bytes = PAIRS * sizeof *answers, .groups = {(PAIRS + 63) / 64},
                       .textures = {{UNIT_BVH, tree->buffer.texels}}));
}

static void check_rays(const char *path, const struct stage *stage, const struct caster_bvh *tree) {
    struct pair *pairs = mem_alloc(PAIRS, sizeof *pairs);
    uint32_t *answers = mem_alloc(PAIRS, sizeof *answers);
    struct rays rays;
    int blocked = 0, other = 0;
    open_rays(&rays, stage);
    for (uint32_t i = 0; i < PAIRS; i++)
        pairs[i] = pair_of(&rays, &stage->geometry, i + 1);
    ask(tree, pairs, answers);
    for (int i = 0; i < PAIRS; i++) {
        vec3s from =
            ray_scene_above(&rays.scene, to_vec3s(pairs[i].from), to_vec3s(pairs[i].normal));
        bool visible = ray_scene_visible(&rays.scene, from, to_vec3s(pairs[i].to));
        blocked += !visible;
        other += visible == (answers[i] != 0);
    }
    printf("  %s: %d of %d rays are blocked, %d otherwise than Embree's\n", path, blocked, PAIRS,
           other);
    assert_true(blocked > PAIRS / 20 && blocked < PAIRS * 19 / 20);
    check_at_most("rays that differ", other, PAIRS / 500.);
    close_rays(&rays);
    mem_free(pairs, answers);
}

/* At times one after the other, as a clip plays: the tree follows, and comes back to what it was */
static void check_scene(const char *path, const double *times, int count) {
    const struct caster_bvh *tree;
    OWNED(stage) stage = open_stage(path);
    struct caster_pool *pool = caster_pool_create(&stage.scene, &stage.geometry);
    check_ok("tree", caster_pool_acquire_tree(pool, &tree));
    for (int i = 0; i < count; i++) {
        check_ok("pose", geometry_pose(&stage.geometry, &stage.scene, times[i]));
        check_ok("update", caster_pool_update(pool));
        check_rays(path, &stage, tree);
    }
    caster_pool_release_tree(pool, &tree);
    caster_pool_free(pool);
}

TEST(rays) {
    static const double times[] = {0, 1.5, 3};
    check_scene("scenes/cornell-animal.glb", times, 1);
    check_scene("scenes/atrium.glb", times, 1);
    check_scene("scenes/door.glb", times, 3);
    check_scene("scenes/creatures.glb", times, 2);
    check_scene("scenes/metaballs.glb", times, 2);
    check_scene("scenes/plant.glb", times, 1);
}

/* --- masks ------------------------------------------------------------------------------------ */

static uint32_t count_masked(const struct stage *stage) {
    return (stage->geometry.blocking_index_count - stage->geometry.opaque_index_count) / 3;
}

/* Straight through a place of a triangle with a mask. */
static struct pair pair_through(const struct rays *rays, const struct stage *stage,
                                uint32_t number) {
    const struct geometry *geometry = &stage->geometry;
    float u = (float)radical_inverse(2, number), v = (float)radical_inverse(3, number);
    bool turned = u + v > 1;
    struct triangle_point point = {geometry->opaque_index_count / 3 + number % count_masked(stage),
                                   turned ? 1 - u : u, turned ? 1 - v : v};
    /* Alpha that varies blends by chance in the path tracer, and is a mask here. */
    if (hit_material(&rays->table, point.triangle)->blends)
        return pair_through(rays, stage, number + 1);
    vec3s at = hit_position(&rays->table, &point),
          normal = hit_winding_normal(&rays->table, point.triangle);
    vec3s from = glms_vec3_muladds(normal, 5 * rays->scene.clearance, at);
    vec3s to = glms_vec3_muladds(normal, -5 * rays->scene.clearance, at);
    return (struct pair){.from = {from.x, from.y, from.z}, .to = {to.x, to.y, to.z}};
}

/* As holes are for Embree, but for their rims, which are a part wide. */
TEST(masks) {
    struct rays rays;
    const struct caster_bvh *tree;
    static struct pair pairs[PAIRS];
    static uint32_t answers[PAIRS];
    int blocked = 0, other = 0;
    OWNED(stage) stage = open_stage("scenes/materials.glb");
    open_rays(&rays, &stage);
    struct caster_pool *pool = caster_pool_create(&stage.scene, &stage.geometry);
    check_ok("tree", caster_pool_acquire_tree(pool, &tree));
    for (uint32_t i = 0; i < PAIRS; i++)
        pairs[i] = pair_through(&rays, &stage, i + 1);
    ask(tree, pairs, answers);
    for (int i = 0; i < PAIRS; i++) {
        bool visible =
            ray_scene_visible(&rays.scene, to_vec3s(pairs[i].from), to_vec3s(pairs[i].to));
        blocked += !visible;
        other += visible == (answers[i] != 0);
    }
    printf("  %u masked triangles: %d of %d rays are blocked, %d otherwise than Embree's\n",
           count_masked(&stage), blocked, PAIRS, other);
    assert_true(blocked > PAIRS / 10 && blocked < PAIRS * 9 / 10);
    check_at_most("rays that differ", other, PAIRS / 50.);
    caster_pool_release_tree(pool, &tree);
    caster_pool_free(pool);
    close_rays(&rays);
}

/* --- a frame ---------------------------------------------------------------------------------- */

struct bench {
    struct stage stage;
    struct rays rays;
    struct renderer renderer;
    struct image layers;
};

static vec3s layer_at(const struct image *layers, const char *first, int x, int y) {
    return to_vec3s(image_at(layers, x, y) + image_find_channel(layers, first));
}

/* What a VPL sends to a point, of red, over pi; 0 where something is between. */
static double light_of(const struct bench *bench, const struct vpl *vpl, vec3s position,
                       vec3s normal) {
    vec3s to = to_vec3s(vpl->position), way = glms_vec3_sub(to, position);
    double distance2 = (double)glms_vec3_norm2(way);
    double cosines = fmax(0, (double)glms_vec3_dot(normal, way)) *
                     fmax(0, -(double)glms_vec3_dot(to_vec3s(vpl->normal), way));
    vec3s from = ray_scene_above(&bench->rays.scene, position, normal);
    bool arrives = cosines > 0 && ray_scene_visible(&bench->rays.scene, from, to);
    return arrives ? (double)vpl->flux[0] * cosines / (distance2 * distance2) / (GLM_PI * GLM_PI)
                   : 0;
}

/* Each pixel is the sum over the VPLs that it sees. */
static void check_frame(const char *path, int size, int vpl_count) {
    const char *settings = form("trace=on vpls=%d interleave=1 clamp=none blur-radius=0 "
                                "gather.adaptive=0 materials=diffuse",
                                vpl_count);
    struct bench bench;
    bench.stage = open_stage(path);
    open_rays(&bench.rays, &bench.stage);
    open_renderer(&bench.renderer, desc_of(&bench.stage, "clustered", settings, size, size));
    check_ok("layers", renderer_read_layers(&bench.renderer, &bench.layers));
    struct vpl *vpls = read_vpls(&bench.renderer);
    int alpha = image_find_channel(&bench.layers, "A"), wrong = 0, count = 0;
    double mean = layer_mean(&bench.layers, "indirect");
    for (int i = 0; i < size * size; i++) {
        int x = i % size, y = i / size;
        float position[3];
        if (image_at(&bench.layers, x, y)[alpha] <= 0)
            continue;
        pixel_position(&bench.renderer, &bench.layers, x, y, position);
        double expected = 0, got = (double)layer_at(&bench.layers, "indirect.R", x, y).x;
        for (int v = 0; v < vpl_count; v++)
            expected += light_of(&bench, &vpls[v], to_vec3s(position),
                                 layer_at(&bench.layers, "normal.X", x, y));
        wrong += fabs(got - expected) > .01 * (expected + .1 * mean);
        count++;
    }
    printf("  %s: %d of %d pixels are not their sums\n", path, wrong, count);
    assert_true(count > size * size / 4);
    check_at_most("such pixels", wrong / (double)count, .01);
    free(vpls);
    renderer_free(&bench.renderer);
    image_free(&bench.layers);
    close_rays(&bench.rays);
    stage_free(&bench.stage);
}

TEST(frame) {
    check_frame("scenes/cornell-animal.glb", 32, 64);
    check_frame("scenes/door.glb", 32, 64);
    check_frame("scenes/atrium.glb", 16, 1024); /* llvmpipe has an end to a shader's loops */
}

/* Of red light, over its mean: how far means over blocks are apart. */
static double block_difference(const struct image *a, const struct image *b) {
    enum { BLOCK = 16 };
    int channel = image_find_channel(a, "indirect.R");
    double worst = 0;
    for (int y = 0; y < a->height; y += BLOCK)
        for (int x = 0; x < a->width; x += BLOCK) {
            double sum = 0;
            for (int i = 0; i < BLOCK * BLOCK; i++)
                sum += (double)(image_at(a, x + i % BLOCK, y + i / BLOCK)[channel] -
                                image_at(b, x + i % BLOCK, y + i / BLOCK)[channel]);
            worst = fmax(worst, fabs(sum) / (BLOCK * BLOCK));
        }
    return worst / layer_mean(b, "indirect");
}

/* Of the same VPLs: where two of twelve ask for all, the mean is that of all that ask, in shadows
 * of coloured light too, and it is not the same picture. */
TEST(together) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(image) each = render_stage(&stage, "clustered",
                                     "trace=on vpls=64 interleave=1 "
                                     "clamp=disk blur-radius=0 gather.adaptive=0",
                                     96);
    OWNED(image) few = render_stage(
        &stage, "instant-radiosity",
        "instant-radiosity.traced=on vpls=64 interleave=1 clamp=disk blur-radius=0", 96);
    assert_false(same_pixels(&each, &few));
    check_near("mean of those that ask together",
               layer_mean(&few, "indirect") / layer_mean(&each, "indirect"), 1, .005);
    check_at_most("worst block of red light", block_difference(&few, &each), .05);
}

static void check_same(const struct stage *stage, const char *a, const char *b) {
    OWNED(image) first = render_stage(stage, "clustered", a, 64),
                 second = render_stage(stage, "clustered", b, 64);
    printf("    '%s' as '%s'\n", a, b);
    assert_true(same_pixels(&first, &second));
}

/* The default is a frame by rays, unless something that maps alone read is set. */
TEST(default) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    check_same(&stage, "", "trace=on vpls=512 adaptive=3 adaptive-factor=1");
    check_same(&stage, "path=maps", "trace=off vpls=1024 adaptive=4 adaptive-factor=4");
    check_same(&stage, "vals=8", "path=maps vals=8");
    check_same(&stage, "vals=8 trace=on", "");
}

/* The first row of the floor, where it meets the wall behind, has little grain in a large picture:
 * differences of pixels side by side, RMS over their mean (path tracer: .02). */
TEST(grain) {
    enum { BEGIN = 180, END = 216, SIZE = 800 };
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(image) layers = render_stage(&stage, "clustered", "", SIZE);
    double sum = 0, squares = 0;
    int y = SIZE / 2;
    while (layer_at(&layers, "normal.X", BEGIN, y).y < .9f)
        y++;
    for (int x = BEGIN; x < END; x++) {
        vec3s here = layer_at(&layers, "indirect.R", x, y);
        double step = (double)(here.y - layer_at(&layers, "indirect.R", x + 1, y).y);
        sum += (double)here.y;
        squares += step * step;
    }
    check_at_most("grain along the floor's edge", sqrt(squares * (END - BEGIN)) / sum, .06);
}

RUN_TESTS(open_group_context, close_group_context)
