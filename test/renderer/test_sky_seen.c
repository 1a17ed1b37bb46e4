/* Directions of a sky's reflected light: dense where light comes in, and right on average for
 * whatever weights. */
#include "render_support.h"

#include "gltf_parts.h"

#include "lights/sky_seen.h"
#include "scene/lights/environment.h"

#include <cglm/cglm.h>

enum { SIZE = 48, DIRECTIONS = 12, PLACES = 4096, SEEDS = 4 };

/* A closed room, 1 m wide and high, whose wall x = .5 has an upright slit; +Z is up. */
#define ACROSS_X "rotation: [0, 0.70710678, 0, 0.70710678]"
#define ACROSS_Y "rotation: [-0.70710678, 0, 0, 0.70710678]"
#define SLIT_ROOM                                                                                  \
    "{mesh: 0, translation: [-0.5, -0.5, 0]},{mesh: 0, translation: [-0.5, -0.5, 1]},{mesh: "      \
    "0, " ACROSS_X ", translation: [-0.5, -0.5, 1]},{mesh: 0, " ACROSS_Y                           \
    ", translation: [-0.5, -0.5, 1]},{mesh: 0, " ACROSS_Y                                          \
    ", translation: [-0.5, 0.5, 1]},{mesh: 0, " ACROSS_X                                           \
    ", scale: [1, 0.46, 1], translation: [0.5, -0.5, 1]},{mesh: 0, " ACROSS_X                      \
    ", scale: [1, 0.46, 1], translation: [0.5, 0.04, 1]}"

/* One whose roof has a hole along x = .5; and one with a plain around it. */
#define ROOF_ROOM                                                                                  \
    "{mesh: 0, translation: [-0.5, -0.5, 0]},{mesh: 0, scale: [0.8, 1, 1], translation: [-0.5, "   \
    "-0.5, 1]},{mesh: 0, " ACROSS_X ", translation: [-0.5, -0.5, 1]},{mesh: 0, " ACROSS_X          \
    ", translation: [0.5, -0.5, 1]},{mesh: 0, " ACROSS_Y                                           \
    ", translation: [-0.5, -0.5, 1]},{mesh: 0, " ACROSS_Y ", translation: [-0.5, 0.5, 1]}"
#define PLAIN_ROOM "{mesh: 0, scale: [20, 20, 1], translation: [-10, -10, -0.01]}," ROOF_ROOM

static void paint_even(const float direction[3], float radiance[3]) {
    (void)direction;
    glm_vec3_broadcast(1, radiance);
}

/* The camera looks down from the middle of the ceiling. */
static void open_nodes(struct stage *stage, const char *nodes) {
    const char *all = form("[{camera: 0, translation: [0, 0, 0.95]}, %s]", nodes);
    *stage = open_stage(write_parts(
        "room.glb",
        &PARTS(.nodes = all,
               .materials = "[{doubleSided: true, pbrMetallicRoughness: {metallicFactor: 0}}]",
               .more = "cameras: [{type: perspective, perspective: {yfov: 1.2, znear: 0.01}}],")));
    set_sky(stage, 64, 32, paint_even);
}

static void group(struct sky_groups *groups, struct environment_lights *lights,
                  const struct stage *stage) {
    struct surface_rays rays;
    environment_lights_fit(lights, stage->emitters.sky, SKY_FIT_EVEN, 120);
    environment_lights_find_joins(lights);
    surface_rays_init(&rays, &stage->scene, &stage->geometry, NULL);
    sky_groups_by_seen(groups, lights, DIRECTIONS, stage->emitters.sky, &rays, &stage->camera, 1);
    surface_rays_free(&rays);
}

/* Its direction meets the slit from somewhere in the room. */
static bool comes_in(const struct emitter *light) {
    return light->direction[0] < 0 &&
           fabsf(light->direction[1]) < .54F / .001F * -light->direction[0];
}

/* Light from behind the other walls has the least weight; the mean is 1, and so much; most
 * directions come in. */
TEST(slit) {
    OWNED(stage) stage;
    struct sky_groups groups;
    struct environment_lights lights;
    open_nodes(&stage, SLIT_ROOM);
    group(&groups, &lights, &stage);
    double power = 0, weighted = 0, behind = 0;
    int inside = 0;
    for (int i = 0; i < lights.count; i++) {
        double own = (double)environment_light_power(&lights.items[i]);
        bool behind_walls = true;
        for (int c = 0; c < 4; c++)
            behind_walls &= lights.items[i].corners[c][0] <= 1e-6F;
        power += own;
        weighted += own * (double)groups.weights[i];
        if (behind_walls)
            behind = fmax(behind, (double)groups.weights[i]);
    }
    for (int g = 0; g < groups.count; g++) {
        struct emitter middle = sky_group_emitter(&lights, &groups, g, stage.emitters.sky);
        inside += comes_in(&middle);
    }
    check_near("mean weight", weighted / power, 2, 1e-4);
    check_near("largest weight behind walls", behind, 1, 1e-6);
    printf("    %-48s %d of %d\n", "directions that come in", inside, groups.count);
    assert_true(inside > DIRECTIONS / 2);
}

/* The sky's strength changes no bit: the renderer keeps groups while it changes. */
TEST(strength) {
    OWNED(stage) stage;
    struct sky_groups groups, again;
    struct environment_lights lights;
    open_nodes(&stage, SLIT_ROOM);
    stage.scene.environment->turn = 90;
    group(&groups, &lights, &stage);
    stage.scene.environment->strength = 2.3F;
    group(&again, &lights, &stage);
    assert_true(sky_groups_same(&groups, &again));
}

/* No place reflects light into the picture: all lights count by their power. */
TEST(open_floor) {
    OWNED(stage) stage;
    struct sky_groups groups, even;
    struct environment_lights lights;
    open_nodes(&stage, "{mesh: 0, scale: [4, 4, 1], translation: [-2, -2, 0]}");
    group(&groups, &lights, &stage);
    environment_lights_group(&even, &lights, DIRECTIONS);
    assert_true(sky_groups_same(&groups, &even));
}

/* The mean over places is what the lights have together, for even weights and others. */
TEST(pieces) {
    OWNED(stage) stage;
    struct sky_groups groups;
    struct environment_lights lights;
    float weights[ENVIRONMENT_LIGHTS_MAX];
    double all = 0;
    open_nodes(&stage, SLIT_ROOM);
    environment_lights_fit(&lights, stage.emitters.sky, SKY_FIT_EVEN, 60);
    environment_lights_find_joins(&lights);
    for (int i = 0; i < lights.count; i++) {
        weights[i] = i % 3 ? .1F : 3;
        all += (double)environment_light_power(&lights.items[i]);
    }
    for (int even = 0; even < 2; even++) {
        double sum = 0;
        if (even)
            environment_lights_group(&groups, &lights, DIRECTIONS);
        else
            environment_lights_group_by_weights(&groups, &lights, weights, DIRECTIONS);
        for (int g = 0; g < groups.count; g++)
            for (int i = 0; i < PLACES; i++) {
                const float place[2] = {((float)i + .5F) / PLACES, .5F};
                struct emitter piece =
                    sky_group_piece(&lights, &groups, g, stage.emitters.sky, place);
                sum += (double)piece.intensity[0] / PLACES;
            }
        check_near(even ? "even weights" : "other weights", sum / all, 1, 2e-3);
    }
}

/* Frames of a few seeds have the tracer's light. By twelve directions the slit has up to half too
 * much of it, by luck. */
TEST(light) {
    static const char *const rooms[] = {SLIT_ROOM, ROOF_ROOM, PLAIN_ROOM};
    for (size_t r = 0; r < sizeof rooms / sizeof *rooms; r++) {
        struct stage stage;
        double sum = 0;
        if (!is_tried_here(r, 3))
            continue;
        open_nodes(&stage, rooms[r]);
        OWNED(image) reference = trace_stage(&stage, SIZE, is_long_run() ? 4096 : 1024);
        double mean = layer_mean(&reference, "indirect");
        for (int seed = 0; seed < SEEDS; seed++) {
            const char *settings = form("path=traced lights.seed=%d", seed);
            OWNED(image) image = render_stage(&stage, "clustered", settings, SIZE);
            double share = layer_mean(&image, "indirect") / mean;
            check_near(settings, share, 1, .35);
            sum += share / SEEDS;
        }
        check_near("indirect light, mean over seeds", sum, 1, .1);
        stage_free(&stage);
    }
}

/* A renderer whose camera moves has the pictures of new ones. */
TEST(moved_camera) {
    OWNED(stage) stage = open_stage("scenes/courtyard.glb");
    OWNED(renderer) renderer = {0};
    for (int i = 0; i < 3; i++) {
        struct renderer_desc desc = desc_of(&stage, "clustered", "vpls=64", SIZE, SIZE);
        desc.keep_lights = true;
        desc.camera.eye[0] += .7F * (float)(i % 2);
        OWNED(image) followed = follow_layers(&renderer, &desc), fresh = render_layers(&desc);
        assert_true(same_pixels(&followed, &fresh));
    }
}

/* Voxels stay while only the camera moves, so their light comes from the same directions for all
 * views. */
TEST(voxels) {
    OWNED(stage) stage;
    open_nodes(&stage, SLIT_ROOM);
    struct image by_power =
        render_stage(&stage, "imperfect-volume", "path=fast lights.importance=off", SIZE);
    OWNED(image) usual = render_stage(&stage, "imperfect-volume", "path=fast", SIZE);
    assert_true(same_pixels(&by_power, &usual));
    image_free(&by_power);
}

/* Near light of a plain, whose VPLs are far apart, does not reach into a closed room but at its
 * edges. */
TEST(closed_room) {
    OWNED(stage) stage;
    open_nodes(&stage, PLAIN_ROOM ", {mesh: 0, translation: [-0.5, -0.5, 1]}");
    OWNED(image) image = render_stage(&stage, "clustered", "path=traced importance=off", SIZE);
    check_near("indirect light", layer_mean(&image, "indirect"), 0, .002);
}

RUN_TESTS(open_group_context, close_group_context)
