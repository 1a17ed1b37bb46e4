/* Which casters are taken for those of something solid, and that a frame looks the same without
 * their backs. */
#include "render_support.h"

#include "scene/mesh/caster.h"
#include "scene/mesh/solid.h"

/* --- made shapes ------------------------------------------------------------------------------ */

enum { MOST = 64 };

/* Triangles with corners of their own. */
struct shape {
    float position[3 * MOST][3];
    uint32_t indices[3 * MOST];
    uint32_t triangles;
};

static void add_triangle(struct shape *shape, const float a[3], const float b[3],
                         const float c[3]) {
    const float *const corners[3] = {a, b, c};
    assert_true(shape->triangles < MOST);
    for (uint32_t i = 3 * shape->triangles; i < 3 * shape->triangles + 3; i++) {
        memcpy(shape->position[i], corners[i % 3], sizeof shape->position[i]);
        shape->indices[i] = i;
    }
    shape->triangles++;
}

enum { BOTTOM = 0, TOP = 1, FACES = 6 };

/* Faces of an upright box around (x, y, z), of half sides; seen from without. */
static void add_box(struct shape *shape, const float middle[3], const float half[3], int from) {
    static const int8_t faces[FACES][4] = {{0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2},
                                           {1, 3, 7, 5}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (int f = from; f < FACES; f++) {
        float corners[4][3];
        for (int i = 0; i < 4; i++)
            for (int c = 0; c < 3; c++) {
                bool high = faces[f][i] >> c & 1;
                corners[i][c] = middle[c] + (high ? half[c] : -half[c]);
            }
        add_triangle(shape, corners[0], corners[1], corners[2]);
        add_triangle(shape, corners[0], corners[2], corners[3]);
    }
}

/* A floor at y = 0, seen from above. */
static void add_floor(struct shape *shape, float half) {
    const float corners[4][3] = {
        {-half, 0, -half}, {-half, 0, half}, {half, 0, half}, {half, 0, -half}};
    add_triangle(shape, corners[0], corners[1], corners[2]);
    add_triangle(shape, corners[0], corners[2], corners[3]);
}

static const float unit[3] = {1, 1, 1}, origin[3] = {0, 0, 0}, away[3] = {5, 6, 7};

/* Of triangles from first on. */
static int count_within(struct shape *shape, const float eye[3], uint32_t first, uint32_t count) {
    bool within[MOST];
    struct solid_mesh mesh = {shape->position, shape->indices, shape->triangles, 1e-5F};
    int found = 0;
    solid_find(within, &mesh, eye);
    for (uint32_t i = first; i < first + count; i++)
        found += within[i];
    return found;
}

/* A box is solid from without; from within it is a room. */
TEST(box) {
    struct shape box = {0};
    add_box(&box, origin, unit, 0);
    assert_int_equal(count_within(&box, away, 0, 12), 12);
    assert_int_equal(count_within(&box, origin, 0, 12), 0);
}

/* One that stands open on a floor, whose front closes it; not where it hangs above the floor. */
TEST(open_below) {
    const float above[3] = {0, 2.2F, 0};
    struct shape standing = {0}, hanging = {0};
    add_box(&standing, unit, unit, TOP);
    add_floor(&standing, 20);
    add_box(&hanging, above, unit, TOP);
    add_floor(&hanging, 20);
    assert_int_equal(count_within(&standing, away, 0, 10), 10);
    assert_int_equal(count_within(&standing, away, 10, 2), 0); /* the floor's back sees nothing */
    assert_int_equal(count_within(&hanging, away, 0, 10), 0);
}

/* Beside a room of fronts a sheet hides nothing. */
TEST(sheet) {
    const float wide[3] = {8, 8, 8};
    struct shape room = {0};
    add_box(&room, origin, wide, 0);
    for (uint32_t i = 0; i < 3 * room.triangles; i += 3) { /* seen from within */
        room.indices[i] = i + 1;
        room.indices[i + 1] = i;
    }
    add_floor(&room, 2);
    assert_int_equal(count_within(&room, away, 0, 14), 0);
    add_box(&room, (const float[3]){0, 3, 0}, unit, 0);
    assert_int_equal(count_within(&room, (const float[3]){5, 5, 5}, 0, 26), 12);
}

/* --- scenes ----------------------------------------------------------------------------------- */

static double solid_share(const struct stage *stage) {
    struct caster caster;
    struct caster_desc desc = {.error = .00055F, .long_count = 500, .eye = stage->camera.eye};
    uint32_t all = 0, solid = 0;
    caster_init(&caster, &stage->geometry, &desc);
    for (int l = 0; l < CASTER_KIND_COUNT; l++) {
        all += caster.list[l].index_count;
        if (l >= CASTER_SHORT_SOLID)
            solid += caster.list[l].index_count;
    }
    caster_free(&caster);
    return (double)solid / all;
}

/* All surfaces the other way round, which look as before from both sides. */
static void turn_over(struct stage *stage) {
    struct geometry *geometry = &stage->geometry;
    for (uint32_t i = 0; i < geometry->index_count; i += 3) {
        uint32_t second = geometry->indices[i + 1];
        geometry->indices[i + 1] = geometry->indices[i + 2];
        geometry->indices[i + 2] = second;
    }
    for (uint32_t i = 0; i < geometry->vertex_count; i++)
        for (int c = 0; c < 3; c++)
            geometry->normal[i][c] = -geometry->normal[i][c];
}

/* Turned over nothing is solid, and maps show all faces. */
static void check_frame(const char *path, double least_share) {
    static const char settings[] = "vpls=256 vals=16 interleave=4 caster.error=1e-7";
    OWNED(stage) stage = open_stage(path);
    for (int i = 0; i < stage.scene.material_count; i++)
        stage.scene.materials[i].double_sided = true;
    double share = solid_share(&stage);
    OWNED(image) as_is = render_stage(&stage, "clustered", settings, 96);
    turn_over(&stage);
    double turned_share = solid_share(&stage);
    OWNED(image) turned = render_stage(&stage, "clustered", settings, 96);
    double error = relative_rmse(&as_is, &turned, "indirect");
    printf("  %s: %.2f of the casters are of solids, turned over %.2f; the frame differs by %.4f\n",
           path, share, turned_share, error);
    assert_true(share > least_share && turned_share < .02);
    check_at_most("difference", error, 5e-4);
}

TEST(frame) {
    check_frame("scenes/cornell-animal.glb", .9);
    check_frame("scenes/cornell-box.glb", .3);
}

RUN_TESTS(open_group_context, close_group_context)
