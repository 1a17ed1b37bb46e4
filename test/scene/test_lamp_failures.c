/* Lights that are hard to get right, in a small room: larger than it, touching what they light or
 * what hides them, without a size, with next to none, on top of each other, of a thousand
 * triangles. All methods of direct light stay finite and silent, and the default one is within
 * bounds of rays. */
#include "render_support.h"

#include "scene/lights/environment.h"

#include <cglm/cglm.h>

enum { WIDTH = 48, HEIGHT = 36 };

/* A light in the room, or, where watts is 0, the scene's own. */
struct row {
    const char *what;
    float position[3], towards[3];
    float size[2];
    float watts;  /* W/sr on the axis */
    float beside; /* a second one, so far along x */
    double rmse;  /* at most, of direct light by the default method, over the mean */
};

/* Edges have most of the error: the reference has pixels' centres alone. */
static const struct row rows[] = {
    {"usual", {0, 2.5F, .5F}, {0, -1, 0}, {.6F, .6F}, 5, 0, .055},
    {"two in one plane, overlapping", {-.2F, 2.5F, .5F}, {0, -1, 0}, {.6F, .6F}, 5, .3F, .06},
    {"larger than the room", {0, 2.9F, 0}, {0, -1, 0}, {12, 12}, 300, 0, .14},
    {"on the ceiling", {0, 3, 0}, {0, -1, 0}, {1, 1}, 5, 0, .09},
    {"touching a wall", {-2, 1.5F, 0}, {1, 0, 0}, {1, 1}, 5, 0, .125},
    {"half in a wall", {-2, 2, 0}, {0, -1, 0}, {1, 1}, 5, 0, 1},
    {"size 0", {0, 2.5F, .5F}, {0, -1, 0}, {0, 0}, 5, 0, .09},
    {"size 1e-6", {0, 2.5F, .5F}, {0, -1, 0}, {1e-6F, 1e-6F}, 5, 0, .07},
    {"size 1e-6 by 2", {0, 2.5F, .5F}, {0, -1, 0}, {2, 1e-6F}, 5, 0, .19},
    {"touched by a block", {.2F, 1.0001F, -.4F}, {0, -1, 0}, {2, 2}, 5, 0, .45},
    {"around a block", {.2F, .5F, -.4F}, {0, 1, 0}, {2, 2}, 5, 0, .45},
    {"a sun of .0093 rad", {0, 0, 0}, {-.4F, -.6F, -1}, {.0093F, 0}, 3, 0, .4},
    {"of 1104 triangles", {0, 0, 0}, {0, 0, 0}, {0, 0}, 0, 0, .155},
};

/* Owns its lights. */
static void open_row(struct stage *stage, const struct row *row) {
    bool is_sun = row->position[1] == 0;
    *stage =
        open_stage(row->watts > 0 ? "scenes/failures/room.glb" : "scenes/failures/ball-lamp.glb");
    if (row->watts == 0)
        return;
    struct emitter lights[2] = {{.type = is_sun ? EMITTER_DIRECTIONAL : EMITTER_AREA}};
    glm_vec3_copy((float *)row->position, lights[0].position);
    glm_vec2_copy((float *)row->size, lights[0].size);
    glm_vec3_broadcast(row->watts, lights[0].intensity);
    emitter_aim(&lights[0], row->towards);
    lights[1] = lights[0];
    lights[1].position[0] += row->beside;
    emitters_free(&stage->emitters);
    stage->emitters =
        emitters_copy(&(struct emitters){.items = lights, .count = row->beside > 0 ? 2 : 1});
}

static struct image trace(const struct stage *stage) {
    struct image image = TRACE(stage, .width = WIDTH, .height = HEIGHT, .samples = 64, .bounces = 1,
                               .centers = true);
    check_finite("traced", &image);
    return image;
}

static struct image draw(const struct stage *stage, const struct direct_method *method) {
    struct renderer_desc desc =
        desc_of(stage, "clustered", "vpls=64 vals=4 shadow-size=512", WIDTH, HEIGHT);
    desc.direct = method;
    struct image image = render_layers(&desc);
    check_finite("drawn", &image);
    return image;
}

TEST(rows) {
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const struct row *row = &rows[i];
        struct stage stage;
        open_row(&stage, row);
        struct image reference = trace(&stage);
        for (const struct direct_method *const *m = direct_methods; *m; m++) {
            if (!is_long_run() && *m != direct_for(&stage.emitters))
                continue;
            OWNED(image) drawn = draw(&stage, *m);
            double error = relative_rmse(&drawn, &reference, "direct");
            printf("    %-30s %-8s RMSE %6.2f %%, mean %+6.2f %%\n", row->what, (*m)->name,
                   100 * error,
                   100 * (layer_mean(&drawn, "direct") / layer_mean(&reference, "direct") - 1));
            if (*m == direct_for(&stage.emitters))
                check_at_most(row->what, error, row->rmse);
        }
        image_free(&reference);
        stage_free(&stage);
    }
}

/* A sky that is black, alone and beside a lamp, lights nothing and breaks nothing. */
TEST(black_sky) {
    static float black[2][3];
    struct environment sky = {.width = 2, .height = 1, .texels = black, .strength = 1};
    OWNED(stage) stage;
    open_row(&stage, &rows[0]);
    OWNED(image) without = trace(&stage);
    stage.emitters.sky = &sky;
    OWNED(image) beside = trace(&stage);
    check_near("direct beside a lamp", layer_mean(&beside, "direct"),
               layer_mean(&without, "direct"), 1e-6);
    stage.emitters.count = 0;
    OWNED(image) alone = trace(&stage);
    check_near("alone", layer_mean(&alone, ""), 0, 0);
}

RUN_TESTS(open_group_context, close_group_context)
