/* Casters on the GPU that are shared, kept and moved: what their buffers hold. */
#include "render_support.h"

#include "base/memory.h"
#include "gl/memory.h"
#include "scene/gpu/caster_pool.h"

#include <stdlib.h>
#include <string.h>

static const struct caster_desc coarse = {.max_edge = .5F, .error = .002F};
static const struct caster_desc fine = {.max_edge = .1F, .error = .002F};
static const struct caster_desc exact = {.max_edge = .5F};

/* What the indices on the GPU name is what the caster has at the present pose. */
static void check_vertices(const struct caster *caster, const struct buffer *buffer, size_t width,
                           const void *base, const void *extra) {
    size_t base_size = caster->base_count * width, extra_size = caster->extra_count * width;
    char *expected = mem_alloc(base_size + extra_size, 1),
         *got = mem_alloc(base_size + extra_size, 1);
    memcpy(expected, base, base_size);
    memcpy(expected + base_size, extra, extra_size);
    buffer_read(buffer, 0, base_size + extra_size, got);
    for (uint32_t k = 0; k < caster->index_count; k++)
        assert_memory_equal(got + caster->indices[k] * width, expected + caster->indices[k] * width,
                            width);
    free(expected);
    free(got);
}

static void check_buffers(const struct caster_gpu *gpu, const struct geometry *geometry) {
    const struct caster *caster = &gpu->caster;
    uint32_t *indices = mem_alloc(caster->index_count, sizeof *indices);
    float(*position)[3] = mem_alloc(caster->extra_count, sizeof *position);
    float(*uv)[2] = mem_alloc(caster->extra_count, sizeof *uv);
    assert_int_equal(caster->base_count, geometry->vertex_count);
    buffer_read(&gpu->indices, 0, caster->index_count * sizeof *indices, indices);
    assert_memory_equal(indices, caster->indices, caster->index_count * sizeof *indices);
    caster_fill(caster, geometry, position, uv);
    check_vertices(caster, &gpu->positions, sizeof *position, geometry->position, position);
    assert_true(caster_gpu_has_masked(gpu) == (gpu->uvs.id != 0));
    if (gpu->uvs.id)
        check_vertices(caster, &gpu->uvs, sizeof *uv, geometry->uv, uv);
    free(indices);
    free(position);
    free(uv);
}

static const struct caster_gpu *acquire(struct caster_pool *pool, const struct caster_desc *desc) {
    const struct caster_gpu *caster;
    check_ok("acquire", caster_pool_acquire(pool, &caster, desc));
    return caster;
}

/* Who asks for the same gets the same, and one that nobody uses stays until another is made. */
static void test_shared_and_kept(void **state) {
    (void)state;
    struct stage stage;
    open_stage(&stage, "scenes/cornell-animal.glb");
    size_t before = gpu_memory_total();
    struct caster_pool *pool = caster_pool_create(&stage.geometry);
    const struct caster_gpu *a = acquire(pool, &coarse), *same = acquire(pool, &coarse);
    size_t one = gpu_memory_total() - before;
    assert_ptr_equal(a, same);
    const struct caster_gpu *b = acquire(pool, &exact);
    printf("    %u and %u triangles\n", a->caster.index_count / 3, b->caster.index_count / 3);
    assert_true(a->caster.index_count < b->caster.index_count);
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
    a = acquire(pool, &fine);
    assert_false(caster_pool_has(pool, &coarse));
    caster_pool_release(pool, &a);
    caster_pool_free(pool);
    assert_int_equal(gpu_memory_total(), before);
    stage_free(&stage);
}

static void pose(struct stage *stage, double time) {
    check_ok("pose", geometry_pose(&stage->geometry, &stage->scene, time));
}

/* Casters follow what moves, also those that were not in use meanwhile. */
static void check_moved(struct stage *stage, float cell) {
    static const double times[] = {.3, 1, 2.5, 4, 6};
    struct caster_pool *pool = caster_pool_create(&stage->geometry);
    const struct caster_gpu *used = acquire(pool, &coarse), *unused = acquire(pool, &fine);
    caster_pool_release(pool, &unused);
    for (int i = 0; i < stage->scene.metaballs_count; i++)
        stage->scene.metaballs[i].cell = cell;
    for (size_t i = 0; i < sizeof times / sizeof *times; i++) {
        pose(stage, times[i]);
        check_ok("update", caster_pool_update(pool));
        check_buffers(used, &stage->geometry);
    }
    assert_true(caster_pool_has(pool, &fine));
    unused = acquire(pool, &fine);
    check_buffers(unused, &stage->geometry);
    caster_pool_release(pool, &unused);
    caster_pool_release(pool, &used);
    caster_pool_free(pool);
}

static void test_moved(void **state) {
    (void)state;
    struct stage stage;
    open_stage(&stage, "scenes/door.glb");
    check_moved(&stage, 0);
    stage_free(&stage);
}

/* Metaballs outgrow their room, and all is laid out anew. */
static void test_laid_out_anew(void **state) {
    (void)state;
    struct stage stage;
    open_stage(&stage, "scenes/metaballs.glb");
    float cell = stage.scene.metaballs[0].cell;
    stage.scene.metaballs[0].cell = .5F;
    pose_stage(&stage);
    check_moved(&stage, cell);
    assert_true(stage.geometry.laid_out > 1);
    stage_free(&stage);
}

/* Where there is an alpha mask casters have texture coordinates. */
static void test_masked(void **state) {
    (void)state;
    struct stage stage;
    open_stage(&stage, "scenes/cornell-box.glb");
    stage.scene.materials[0].alpha_mask = true;
    pose_stage(&stage);
    for (uint32_t i = 0; i < stage.geometry.vertex_count; i++)
        stage.geometry.uv[i][0] = stage.geometry.uv[i][1] = (float)i;
    struct caster_pool *pool = caster_pool_create(&stage.geometry);
    const struct caster_gpu *caster = acquire(pool, &fine);
    assert_true(caster_gpu_has_masked(caster));
    check_buffers(caster, &stage.geometry);
    caster_pool_release(pool, &caster);
    caster_pool_free(pool);
    stage_free(&stage);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shared_and_kept),
        cmocka_unit_test(test_moved),
        cmocka_unit_test(test_laid_out_anew),
        cmocka_unit_test(test_masked),
    };
    return cmocka_run_group_tests_name("caster pool", tests, open_group_context,
                                       close_group_context);
}
