/* Casters on the GPU that are shared, kept and moved: what their buffers hold. */
#include "render_support.h"

#include "gl/memory.h"
#include "scene/gpu/caster_pool.h"
#include "scene/shapes/metaballs.h"

static const struct caster_desc coarse = {.error = .002F, .long_count = 500};
static const struct caster_desc few_long = {.error = .002F, .long_count = 4};
static const struct caster_desc exact = {.long_count = 500};

/* What is on the GPU is what the caster has at the present pose. */
static void check_buffer(const struct buffer *buffer, size_t offset, size_t size,
                         const void *expected) {
    char *got = mem_alloc(size, 1);
    buffer_read(buffer, offset, size, got);
    assert_memory_equal(got, expected, size);
    free(got);
}

static void check_buffers(const struct caster_gpu *gpu, const struct geometry *geometry) {
    const struct caster_list *list = gpu->caster.list;
    size_t size = sizeof *list->indices;
    assert_int_equal(gpu->caster.vertex_count, geometry->vertex_count);
    for (size_t l = 0, offset = 0; l < CASTER_KIND_COUNT; offset += list[l].index_count * size, l++)
        check_buffer(&gpu->indices, offset, list[l].index_count * size, list[l].indices);
}

static uint32_t triangles(const struct caster_gpu *gpu, enum caster_kind first) {
    uint32_t indices = 0;
    for (int l = (int)first; l < CASTER_KIND_COUNT; l++)
        indices += gpu->caster.list[l].index_count;
    return indices / 3;
}

static const struct caster_gpu *acquire(struct caster_pool *pool, const struct caster_desc *desc) {
    const struct caster_gpu *caster;
    check_ok("acquire", caster_pool_acquire(pool, &caster, desc));
    return caster;
}

/* Who asks for the same gets the same, and one that nobody uses stays until another is made. */
TEST(shared_and_kept) {
    OWNED(stage) stage = open_stage("scenes/cornell-animal.glb");
    size_t before = gpu_memory_total();
    struct caster_pool *pool = caster_pool_create(&stage.scene, &stage.geometry);
    const struct caster_gpu *a = acquire(pool, &coarse), *same = acquire(pool, &coarse);
    size_t one = gpu_memory_total() - before;
    assert_ptr_equal(a, same);
    const struct caster_gpu *b = acquire(pool, &exact);
    printf("    %u and %u triangles\n", triangles(a, CASTER_SHORT), triangles(b, CASTER_SHORT));
    assert_true(triangles(a, CASTER_SHORT) < triangles(b, CASTER_SHORT));
    check_buffers(a, &stage.geometry);
    check_buffers(b, &stage.geometry);

    caster_pool_release(pool, &same);
    assert_null(same);
    caster_pool_release(pool, &a);
    assert_true(caster_pool_has(pool, &coarse));
    a = acquire(pool, &coarse);
    caster_pool_release(pool, &b); /* this one is kept now */
    assert_true(caster_pool_has(pool, &exact));
    caster_pool_release(pool, &a); /* and now that one */
    assert_false(caster_pool_has(pool, &exact));
    assert_true(caster_pool_has(pool, &coarse));
    assert_int_equal(gpu_memory_total() - before, one);
    a = acquire(pool, &few_long);
    assert_false(caster_pool_has(pool, &coarse));
    caster_pool_release(pool, &a);
    caster_pool_free(pool);
    assert_int_equal(gpu_memory_total(), before);
}

/* Solids are told where nothing moves, a camera stands and casters may stray; metaballs close as
 * they move. */
TEST(solid) {
    static const struct {
        const char *path;
        const struct caster_desc *desc;
        bool solid, has_camera;
    } rows[] = {{"scenes/cornell-animal.glb", &coarse, true, true},
                {"scenes/cornell-animal.glb", &coarse, false, false},
                {"scenes/cornell-animal.glb", &exact, false, true},
                {"scenes/door.glb", &coarse, false, true},
                {"scenes/metaballs.glb", &coarse, true, true},
                {"scenes/metaballs.glb", &exact, false, true}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(stage) stage = open_stage(rows[i].path);
        for (int n = 0; n < stage.scene.node_count && !rows[i].has_camera; n++)
            stage.scene.nodes[n].camera = -1;
        struct caster_pool *pool = caster_pool_create(&stage.scene, &stage.geometry);
        const struct caster_gpu *caster = acquire(pool, rows[i].desc);
        uint32_t all = triangles(caster, CASTER_SHORT),
                 solid = triangles(caster, CASTER_SHORT_SOLID);
        printf("    %s: %u of %u triangles are of solids\n", rows[i].path, solid, all);
        assert_true(rows[i].solid ? solid > all / 2 : solid == 0);
        caster_pool_release(pool, &caster);
        caster_pool_free(pool);
    }
}

static void pose(struct stage *stage, double time) {
    check_ok("pose", geometry_pose(&stage->geometry, &stage->scene, time));
}

/* Casters follow what moves, also those that were not in use meanwhile. */
static void check_moved(struct stage *stage, float cell) {
    static const double times[] = {.3, 1, 2.5, 4, 6};
    struct caster_pool *pool = caster_pool_create(&stage->scene, &stage->geometry);
    const struct caster_gpu *used = acquire(pool, &coarse), *unused = acquire(pool, &few_long);
    caster_pool_release(pool, &unused);
    for (int i = 0; i < stage->scene.metaballs_count; i++)
        stage->scene.metaballs[i].cell = cell;
    for (size_t i = 0; i < sizeof times / sizeof *times; i++) {
        pose(stage, times[i]);
        check_ok("update", caster_pool_update(pool));
        check_buffers(used, &stage->geometry);
    }
    assert_true(caster_pool_has(pool, &few_long));
    unused = acquire(pool, &few_long);
    check_buffers(unused, &stage->geometry);
    caster_pool_release(pool, &unused);
    caster_pool_release(pool, &used);
    caster_pool_free(pool);
}

TEST(moved) {
    OWNED(stage) stage = open_stage("scenes/door.glb");
    check_moved(&stage, 0);
}

/* Metaballs outgrow their room, and all is laid out anew. */
TEST(laid_out_anew) {
    OWNED(stage) stage = open_stage("scenes/metaballs.glb");
    float cell = stage.scene.metaballs[0].cell;
    stage.scene.metaballs[0].cell = .5F;
    pose_stage(&stage);
    check_moved(&stage, cell);
    assert_true(stage.geometry.laid_out > 1);
}

/* Where there is an alpha mask casters have texture coordinates. */
TEST(masked) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    stage.scene.materials[0].alpha_mask = true;
    pose_stage(&stage);
    for (uint32_t i = 0; i < stage.geometry.vertex_count; i++)
        stage.geometry.uv[0][i][0] = stage.geometry.uv[0][i][1] = (float)i;
    struct caster_pool *pool = caster_pool_create(&stage.scene, &stage.geometry);
    const struct caster_gpu *caster = acquire(pool, &few_long);
    assert_true(caster_gpu_has_masked(caster));
    check_buffers(caster, &stage.geometry);
    caster_pool_release(pool, &caster);
    caster_pool_free(pool);
}

RUN_TESTS(open_group_context, close_group_context)
