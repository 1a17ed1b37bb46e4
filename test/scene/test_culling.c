/* What view frustum culling leaves out: nothing that is seen, by all triangles one by one and by
 * pictures, and much of what is not. */
#include "render_support.h"

#include "scene/gpu/culling.h"

#include <cglm/cglm.h>

/* --- triangles -------------------------------------------------------------------------------- */

/* Whether all three corners lie beyond one plane of clip space. */
static bool is_beside(const struct view *view, const struct geometry *geometry, uint32_t triangle) {
    int beyond = 63;
    for (int k = 0; k < 3; k++) {
        vec4 corner = {0, 0, 0, 1}, at;
        glm_vec3_copy(geometry->position[geometry->indices[3 * triangle + (uint32_t)k]], corner);
        glm_mat4_mulv((vec4 *)view->world_to_clip, corner, at);
        beyond &= (at[0] < -at[3]) | (at[0] > at[3]) << 1 | (at[1] < -at[3]) << 2 |
                  (at[1] > at[3]) << 3 | (at[2] < 0) << 4 | (at[2] > at[3]) << 5;
    }
    return beyond != 0;
}

/* The share of the triangles that a draw leaves out, of which no view sees one. */
static double left_out(const struct culling *culling, const struct geometry *geometry,
                       const struct draw_views *views) {
    uint32_t triangles = geometry->index_count / 3, drawn = 0, at = 0, before = 0, first, count;
    bool *is_drawn = mem_alloc(triangles, sizeof *is_drawn);
    while (culling_next(culling, views, &at, geometry->index_count, &first, &count)) {
        assert_true(first >= before && first % 3 == 0 && count % 3 == 0);
        for (uint32_t i = first / 3; i < (first + count) / 3; i++)
            is_drawn[i] = true;
        drawn += count / 3;
        before = first + count;
    }
    assert_true(before <= geometry->index_count);
    for (uint32_t i = 0; i < triangles; i++)
        for (int v = 0; v < views->count && !is_drawn[i]; v++) {
            const char *view = (const char *)views->first + (size_t)v * views->stride;
            assert_true(is_beside((const struct view *)view, geometry, i));
        }
    free(is_drawn);
    return 1 - drawn / (double)triangles;
}

/* A perspective view from near the scene's middle. */
static void look(struct view *view, const struct stage *stage, float angle, float fov) {
    static const float up[3] = {0, 1, 0};
    struct camera camera = {.fov_y = fov};
    vec3 forward = {cosf(angle), -.2F, sinf(angle)}, eye;
    glm_vec3_copy((float *)stage->geometry.center, eye);
    glm_vec3_muladds(forward, -.2F * stage->geometry.radius, eye);
    camera_look(&camera, eye, forward, up);
    view_of_camera(view, &camera, &stage->geometry, 1);
}

/* A directional light's: of the whole scene, or of the middle third of its picture. */
static void look_along(struct view *view, const struct stage *stage, float zoom) {
    struct emitter sun = {.type = EMITTER_DIRECTIONAL,
                          .direction = {.6F, -.8F, 0},
                          .right = {.8F, .6F, 0},
                          .up = {0, 0, 1}};
    view_of_directional(view, &sun, &stage->geometry);
    for (int c = 0; c < 4; c++)
        glm_vec2_scale(view->world_to_clip[c], zoom, view->world_to_clip[c]);
}

static const float margin = 1e-3F; /* as frames have it */

/* A point light at the scene's centre, on the border of faces and runs. */
static struct emitter lamp_inside(const struct stage *stage) {
    struct emitter lamp = {.type = EMITTER_POINT, .intensity = {9, 9, 9}, .lamp = -1};
    memcpy(lamp.position, stage->geometry.center, sizeof lamp.position);
    return lamp;
}

/* Returns the largest share of the triangles that the six faces draw: a run's box in one octant
 * around the lamp meets three faces, and one more for each plane between octants that cuts it. */
static double most_of_faces(const struct stage *stage, const struct culling *culling,
                            const float lamp[3]) {
    enum { RUN = 3 * 128 }; /* as culling.c */
    const float apart = 2 * margin * stage->geometry.radius;
    double sum = 0;
    for (uint32_t i = 0; i < culling->runs; i++) {
        uint32_t left = stage->geometry.index_count - i * RUN;
        int faces = 3;
        for (int c = 0; c < 3; c++)
            faces += culling->boxes[i][0][c] <= lamp[c] + apart &&
                     culling->boxes[i][1][c] >= lamp[c] - apart;
        sum += faces / 6. * (left < RUN ? left : RUN);
    }
    return sum / stage->geometry.index_count;
}

/* Each of a point light's six views draws few triangles; all together leave out none. */
static void check_faces(const struct stage *stage, const struct culling *culling) {
    struct emitters lamp = {.items = (struct emitter[]){lamp_inside(stage)}, .count = 1};
    struct light_block *block = mem_alloc(1, sizeof *block);
    views_of_emitters(block, &lamp, &stage->geometry);
    struct draw_views around = {.count = 6,
                                .first = &block->views[0].view,
                                .stride = sizeof *block->views,
                                .margin = margin};
    double sum = 0;
    for (int i = 0; i < around.count; i++) {
        struct draw_views face = draw_views_only(&around, i);
        sum += (1 - left_out(culling, &stage->geometry, &face)) / around.count;
    }
    check_at_most("share that a face draws", sum,
                  most_of_faces(stage, culling, lamp.items[0].position));
    assert_true(left_out(culling, &stage->geometry, &around) == 0);
    free(block);
}

static void check_views(const struct stage *stage, const struct culling *culling) {
    enum { VIEWS = 6 };
    struct view views[VIEWS], sun, part_of_sun;
    const struct geometry *geometry = &stage->geometry;
    double least = 1, most = 0;
    for (int i = 0; i < VIEWS; i++) {
        look(&views[i], stage, (float)i, .2F + .2F * (float)i);
        struct draw_views one = {.count = 1, .first = &views[i], .margin = margin};
        double share = left_out(culling, geometry, &one);
        least = fmin(least, share);
        most = fmax(most, share);
    }
    look_along(&sun, stage, 1);
    look_along(&part_of_sun, stage, 3);
    struct draw_views layers = {.count = 3, .first = views, .margin = margin};
    struct draw_views three = {
        .count = 3, .first = views, .stride = sizeof *views, .margin = margin};
    struct draw_views along = {.count = 1, .first = &sun, .margin = margin};
    struct draw_views along_part = {.count = 1, .first = &part_of_sun, .margin = margin};
    double of_part = left_out(culling, geometry, &along_part);
    printf("%s: of the triangles %.3f to %.3f left out, of three views %.3f, of part of a sun "
           "%.3f\n",
           stage->name, least, most, left_out(culling, geometry, &three), of_part);
    assert_true(left_out(culling, geometry, &layers) >= left_out(culling, geometry, &three));
    assert_true(left_out(culling, geometry, &along) == 0);
    assert_true(of_part > .3);
    check_faces(stage, culling);
    assert_true(most > .5);
}

static const char small[] = "vpls=64 vals=4 map-size=32 rsm-size=64 shadow-size=64 samples=12";

/* Perspective and orthographic views, one and several; at the beginning of a clip and where its
 * parts have moved, and their arrays have grown. */
TEST(triangles) {
    static const char *const paths[] = {"scenes/atrium.glb", "scenes/creatures.glb",
                                        "scenes/metaballs.glb", "scenes/character.glb"};
    for (size_t p = 0; p < sizeof paths / sizeof *paths; p++) {
        OWNED(stage) stage = open_stage(paths[p]);
        OWNED(renderer) renderer;
        open_renderer(&renderer, desc_of(&stage, "clustered", small, 16, 16));
        check_views(&stage, &renderer.scene.culling);
        check_ok("pose", stage_pose(&stage, 3));
        check_ok("show", stage_show(&stage, &renderer));
        check_views(&stage, &renderer.scene.culling);
    }
}

/* --- pictures --------------------------------------------------------------------------------- */

static void see_all(const struct culling *culling) {
    for (uint32_t run = 0; run < culling->runs; run++) {
        glm_vec3_broadcast(-1e30F, culling->boxes[run][0]);
        glm_vec3_broadcast(1e30F, culling->boxes[run][1]);
    }
}

/* Fails unless the picture is the same bits as where all is drawn. */
static void check_picture(const struct stage *stage, const char *what, int width, int height) {
    OWNED(renderer) renderer;
    OWNED(image) culled, whole;
    open_renderer(&renderer, desc_of(stage, "clustered", small, width, height));
    check_ok("layers", renderer_read_layers(&renderer, &culled));
    see_all(&renderer.scene.culling);
    renderer_render(&renderer);
    check_ok("layers", renderer_read_layers(&renderer, &whole));
    printf("%s, %s, %d x %d: difference %g\n", stage->name, what, width, height,
           relative_rmse(&culled, &whole, "indirect"));
    assert_true(same_pixels(&culled, &whole));
}

/* Also tiny ones, of which samples leave a good part. */
TEST(pictures) {
    static const char *const paths[] = {"scenes/atrium.glb", "scenes/three-lights.glb",
                                        "scenes/plant.glb"};
    static const int sizes[][2] = {{64, 40}, {3, 2}, {1, 1}};
    for (size_t p = 0; p < sizeof paths / sizeof *paths; p++) {
        OWNED(stage) stage = open_stage(paths[p]);
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
            check_picture(&stage, "as it is", sizes[i][0], sizes[i][1]);
    }
}

/* Cameras and lights that triangles surround, in scenes whose parts move, bend and change. */
TEST(pictures_inside) {
    static const char *const paths[] = {"scenes/atrium.glb", "scenes/creatures.glb",
                                        "scenes/character.glb"};
    static const float up[3] = {0, 1, 0}, forward[3] = {.8F, -.2F, .6F};
    for (size_t p = 0; p < sizeof paths / sizeof *paths; p++) {
        OWNED(stage) stage = open_stage(paths[p]);
        check_ok("pose", stage_pose(&stage, 1.5));
        stage.emitters.items[0] = lamp_inside(&stage);
        stage.emitters.count = 1;
        camera_look(&stage.camera, stage.geometry.center, forward, up);
        check_picture(&stage, "inside", 64, 40);
        stage.camera.shift[0] = .4F;
        check_picture(&stage, "shifted", 64, 40);
        stage.camera.orthographic = true;
        stage.camera.y_extent = .3F * stage.geometry.radius;
        check_picture(&stage, "orthographic", 64, 40);
    }
}

/* Backs of single-sided surfaces are culled by the winding of a mirrored node: the picture of a
 * closed mesh is that with two sides. */
TEST(mirrored_backs) {
    struct image drawn[2];
    for (int two = 0; two < 2; two++) {
        OWNED(stage) stage = open_stage("scenes/cornell-animal.glb");
        for (int i = 0; i < stage.scene.node_count; i++)
            stage.scene.nodes[i].scale[0] *= stage.scene.nodes[i].parent < 0 ? -1 : 1;
        for (int m = 0; m < stage.scene.material_count; m++)
            stage.scene.materials[m].double_sided = two;
        pose_stage(&stage);
        drawn[two] = render_stage(&stage, "clustered", small, 48);
    }
    check_at_most("difference", relative_rmse(&drawn[0], &drawn[1], "direct"), 1e-3);
    image_free(&drawn[0]);
    image_free(&drawn[1]);
}

RUN_TESTS(open_group_context, close_group_context)
