/* Volumes of scenes of two sizes: the box that they hold, and points on what of a huge triangle is
 * in it. */
#include "volume_scenes.h"

#include "scene/clips.h"

/* A room of 4 m keeps its light on a plain of 222 m: voxels that held the plain would be as wide as
 * the room. */
TEST(plain) {
    OWNED(stage) stage = open_stage("scenes/failures/plain.glb");
    OWNED(image) volume = render_stage(&stage, "imperfect-volume", "", 48);
    OWNED(image) clustered = render_stage(&stage, "clustered", "", 48);
    check_near("light over that of VPLs",
               layer_mean(&volume, "indirect") / layer_mean(&clustered, "indirect"), 1, .2);
}

/* A room of 1 m around the origin without a floor, on a plain of so many metres that is
 * its floor. */
static void open_on_plain(struct stage *stage, float plain) {
    struct shape *shape = new_shape();
    add_room(shape, at(-.5F, 0, -.5F), at(.5F, 1, .5F));
    shape->index_count = 0; /* the floor goes, and the wall before the camera */
    for (uint32_t wall = 1; wall < 5; wall++) {
        const uint32_t first = 4 * wall;
        add_square(shape, (uint32_t[]){first, first + 1, first + 2, first + 3});
    }
    add_rectangle(shape, at(-plain / 2, 0, plain / 2), at(plain, 0, 0), at(0, 0, -plain));
    open_shape(stage, shape, .7, false, at(0, .5F, 0));
    look(stage, at(0, 0, 0), at(0, -1, 0), at(0, 0, -1), .9F);
    stage->camera.eye[1] = .9F;
}

/* Points lie close on what of a huge triangle is in the room. */
static double light_on_plain(float plain, const char *technique) {
    OWNED(stage) stage;
    open_on_plain(&stage, plain);
    OWNED(image) image = render_stage(&stage, technique, "", 48);
    double mean = layer_mean(&image, "indirect");
    printf("  plain of %g m, %s: %.4f\n", (double)plain, technique, mean);
    return mean;
}

TEST(floor_of_plain) {
    double small = light_on_plain(1, "imperfect-volume");
    double wide = light_on_plain(200, "imperfect-volume");
    check_near("light on a floor of 200 m over that on one of 1 m", wide / small, 1, .1);
    check_near("light over that of VPLs", wide / light_on_plain(200, "clustered"), 1, .1);
}

/* The node of that name goes so far to the right in a second; or all nodes but this one. */
static void slide(struct stage *stage, const char *name, bool others, float far) {
    struct scene *scene = &stage->scene;
    free(scene->clips); /* of none */
    struct clip *clip = scene->clips = mem_alloc(1, sizeof *scene->clips);
    scene->clip_count = 1;
    *clip = (struct clip){.channels = mem_alloc((size_t)scene->node_count, sizeof *clip->channels),
                          .duration = 1};
    for (int n = 0; n < scene->node_count; n++) {
        const float *from = scene->nodes[n].translation;
        if ((strcmp(scene->nodes[n].name, name) == 0) == others)
            continue;
        struct channel *channel = &clip->channels[clip->channel_count++];
        *channel = (struct channel){.target = n, .key_count = 2, .width = 3};
        channel->times = mem_alloc(2, sizeof *channel->times);
        channel->values = mem_alloc(6, sizeof *channel->values);
        channel->times[1] = 1;
        memcpy(channel->values, from, sizeof(float[3]));
        memcpy(channel->values + 3, from, sizeof(float[3]));
        channel->values[3] += far;
    }
    clips_play_default(scene);
    check_ok("pose", stage_pose(stage, 0));
}

/* It keeps its light as it moves; a renderer that begins late has the same box. */
TEST(moving_room) {
    OWNED(stage) stage = open_stage("scenes/failures/plain.glb");
    OWNED(renderer) renderer;
    OWNED(image) after;
    slide(&stage, "plain", true, 10);
    struct renderer_desc desc = desc_of(&stage, "imperfect-volume", "", 48, 48);
    OWNED(image) before = render_layers(&desc);
    open_renderer(&renderer, desc);
    check_ok("pose", stage_pose(&stage, 1));
    check_ok("follow", stage_show(&stage, &renderer));
    renderer_render(&renderer);
    check_ok("layers", renderer_read_layers(&renderer, &after));
    desc = desc_of(&stage, "imperfect-volume", "", 48, 48);
    OWNED(image) fresh = render_layers(&desc);
    check_at_most("difference of a renderer that begins late",
                  relative_rmse(&after, &fresh, "indirect"), .05);
    check_near("light over that of the first pose",
               layer_mean(&after, "indirect") / layer_mean(&before, "indirect"), 1, .2);
}

/* Another part of a huge floor is in the box as the floor moves. */
TEST(moving_floor) {
    OWNED(stage) stage = open_stage("scenes/failures/giant-triangle.glb");
    OWNED(renderer) renderer;
    OWNED(image) before, after;
    slide(&stage, "floor", false, 100);
    open_renderer(&renderer, desc_of(&stage, "imperfect-volume", "", 48, 48));
    renderer_render(&renderer);
    check_ok("layers", renderer_read_layers(&renderer, &before));
    check_ok("pose", stage_pose(&stage, 1));
    check_ok("follow", stage_show(&stage, &renderer));
    renderer_render(&renderer);
    check_ok("layers", renderer_read_layers(&renderer, &after));
    check_at_most("difference of what does not look different",
                  relative_rmse(&after, &before, "indirect"), .1);
}

/* --- a triangle and a box --------------------------------------------------------------------- */

/* Of a triangle far larger than the box: the area is that of the box's section, and places lie
 * evenly in it. */
TEST(boxed_triangle) {
    enum { SIDE = 64 };
    const struct box box = {{-1, -1, 2}, {3, 1, 5}};
    float corners[3][3] = {{-900, .25F, -700}, {800, .25F, -600}, {50, .25F, 900}}; /* metres */
    const uint32_t index[3] = {0, 1, 2};
    struct geometry geometry = {.position = corners};
    double share = boxed_share(&box, &geometry, index), sum[3] = {0};
    check_near("area in the box, m2", share * corners_area(&geometry, index), 12, 1e-3);
    for (int i = 0; i < SIDE * SIDE; i++) {
        struct corners place = {.index = {0, 1, 2}};
        assert_true(boxed_spread(place.weight, &box, &geometry, index, (i % SIDE + .5) / SIDE,
                                 (floor((double)i / SIDE) + .5) / SIDE));
        vec3s at = corners_vector(&place, corners);
        for (int c = 0; c < 3; c++) {
            assert_true(at.raw[c] > box.low[c] - 1e-3F && at.raw[c] < box.high[c] + 1e-3F);
            sum[c] += (double)at.raw[c] / (SIDE * SIDE);
        }
    }
    check_near("mean place, x", sum[0], 1, .01);
    check_near("z", sum[2], 3.5, .01);
}

/* A triangle that the box holds is whole, and one beside it has no part. */
TEST(whole_triangle) {
    const struct box box = {{-1, -1, -1}, {1, 1, 1}};
    float corners[6][3] = {{-.5F, 0, 0}, {.5F, 0, 0}, {0, .5F, 0}, {2, 2, 0}, {0, 4, 0}, {4, 0, 4}};
    const uint32_t inside[3] = {0, 1, 2}, outside[3] = {3, 4, 5};
    struct geometry geometry = {.position = corners};
    float weight[3], spread[3];
    check_near("share of one inside", boxed_share(&box, &geometry, inside), 1, 0);
    check_near("share of one outside", boxed_share(&box, &geometry, outside), 0, 0);
    assert_true(boxed_spread(weight, &box, &geometry, inside, .3, .7));
    corners_spread(spread, .3, .7);
    assert_memory_equal(weight, spread, sizeof weight);
    assert_false(boxed_spread(weight, &box, &geometry, outside, .3, .7));
}

RUN_TESTS(open_group_context, close_group_context)
