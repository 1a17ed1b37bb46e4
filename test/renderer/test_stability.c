/* Where such methods break: far from the origin, at other scales, behind a closed door. */
#include "base/unit.h"
#include "render_support.h"

#include "scene/node.h"
#include "scene/recentre.h"

/* All columns: which of them stand for others turns on rounding, as other random numbers would. */
static const char small[] = "vpls=256 vals=16 columns=256 map-size=64 rsm-size=128 shadow-size=256";
/* Without detail, where rounding lets another light answer for others: another noise, of the same
 * mean. */
static const char plain_settings[] = "vpls=1024 map-size=128 rsm-size=256 adaptive=0";
static const char *const shadowing[] = {"clustered", "instant-radiosity"};

/* --- far from the origin ---------------------------------------------------------------------- */

/* Hangs all roots on a new one that stands elsewhere. */
static void move_away(struct scene *scene, const float translation[3]) {
    scene->nodes = mem_resize(scene->nodes, (size_t)scene->node_count + 1, sizeof *scene->nodes);
    memmove(scene->nodes + 1, scene->nodes, (size_t)scene->node_count++ * sizeof *scene->nodes);
    for (int i = 1; i < scene->node_count; i++)
        scene->nodes[i].parent++;
    scene->nodes[0] = node_new();
    memcpy(scene->nodes[0].translation, translation, sizeof scene->nodes[0].translation);
}

static void check_far(const char *path) {
    static const float away[3] = {10000, -10000, 10000};
    for (int i = 0; i < 2; i++) {
        OWNED(stage) stage = open_stage(path);
        assert_true(stage.scene.origin[0] == 0);
        OWNED(image) near = render_stage(&stage, shadowing[i], small, 48);
        move_away(&stage.scene, away);
        pose_stage(&stage);
        assert_true(scene_recentre(&stage.scene, &stage.geometry));
        check_near("origin", stage.scene.origin[0], 10000, 8);
        pose_stage(&stage);
        OWNED(image) far = render_stage(&stage, shadowing[i], small, 48);
        check_at_most("17 km away", relative_rmse(&far, &near, "indirect"), .005);
    }
}

TEST(far) {
    check_far("scenes/cornell-box.glb");
    check_far("scenes/sphere.glb");
}

/* --- scale ------------------------------------------------------------------------------------ */

/* A power of two scales without rounding: only a length that is absolute changes the picture. Cross
 * products of the edges of these triangles are shorter than 1e-7. */
TEST(millimetre) {
    static const char *const paths[] = {"scenes/cornell-animal.glb", "scenes/gloss.glb"};
    for (int i = 0; i < 2; i++) {
        struct image traced[2], drawn[2];
        OWNED(stage) stage = open_stage(paths[i]);
        for (int k = 0; k < 2; k++) {
            traced[k] = trace_stage(&stage, 32, 4);
            drawn[k] = render_stage(&stage, "clustered", "path=traced vpls=256 columns=256", 32);
            scale_scene(&stage.scene, 0x1p-11F);
            pose_stage(&stage);
        }
        printf("  %s\n", paths[i]);
        check_at_most("traced", relative_rmse(&traced[1], &traced[0], ""), .001);
        check_at_most("drawn", relative_rmse(&drawn[1], &drawn[0], ""), .001);
        for (int k = 0; k < 2; k++) {
            images_free(&traced[k], &drawn[k]);
        }
    }
}

/* --- the closed door -------------------------------------------------------------------------- */

/* The mean of the indirect light that a camera sees. */
static double mean_from(struct stage *stage, const char *technique, const char *settings,
                        const float eye[3], const float direction[3]) {
    struct camera *camera = &stage->camera;
    glm_vec3_copy((float *)eye, camera->eye);
    vec3_unit_to((float *)direction, camera->forward);
    vec3_unit_cross(camera->forward, (vec3){0, 1, 0}, camera->right);
    glm_vec3_cross(camera->right, camera->forward, camera->up);
    struct image image = render_stage(stage, technique, settings, 64);
    double mean = layer_mean(&image, "indirect");
    image_free(&image);
    return mean;
}

static double leak(const char *technique, const char *settings) {
    struct stage stage = open_stage("scenes/door.glb");
    double lit = mean_from(&stage, technique, settings, (const float[]){-.4F, 1.6F, 1.6F},
                           (const float[]){-1, -.1F, -.6F});
    double dark = mean_from(&stage, technique, settings, (const float[]){3.9F, 1.6F, 1.2F},
                            (const float[]){-1, -.1F, -.3F});
    assert_true(lit > 0);
    stage_free(&stage);
    printf("    %-20s lit %.4g, behind the door %.4g\n", technique, lit, dark);
    return dark / lit;
}

TEST(closed_door) {
    for (int i = 0; i < 2; i++)
        check_at_most("light behind a closed door", leak(shadowing[i], "vpls=512"), .01);
}

/* --- a plain around a room -------------------------------------------------------------------- */

static struct node *find_node(struct scene *scene, const char *name) {
    for (int i = 0; i < scene->node_count; i++)
        if (strcmp(scene->nodes[i].name, name) == 0)
            return &scene->nodes[i];
    fail_msg("no node is called %s", name);
    return NULL;
}

/* What no light reaches changes nothing, however large it is: neither what lies near a light's
 * centre, nor clusters, casters, blocks and the blur's reach. */
TEST(plain) {
    for (int i = 0; i < 2; i++) {
        OWNED(stage) stage = open_stage("scenes/failures/plain.glb");
        double large = (double)stage.geometry.radius;
        OWNED(image) with = render_stage(&stage, shadowing[i], plain_settings, 96);
        find_node(&stage.scene, "plain")->mesh = -1;
        pose_stage(&stage);
        OWNED(image) without = render_stage(&stage, shadowing[i], plain_settings, 96);
        printf("    %s: radius %.4g m, without the plain %.4g m\n", shadowing[i], large,
               (double)stage.geometry.radius);
        assert_true(large > 30 * (double)stage.geometry.radius);
        check_at_most("a plain around a room, relative RMSE",
                      relative_rmse(&with, &without, "indirect"), .01);
    }
}

RUN_TESTS(open_group_context, close_group_context)
