/* Lights without maps: more lights than have maps give the light that maps and paths find. */
#include "gltf_parts.h"
#include "render_support.h"

#include "base/halton.h"
#include "scene/placing.h"

enum { SIZE = 64, LIGHTS = 60 };

static const char *const settings = "vpls=512 shadow-size=256 rsm-size=64";

/* Stages of one room; its first light is a spot. */
static void open_room(struct stage *stage) {
    *stage = open_stage("scenes/cornell-box.glb");
}

static struct image render_with(const struct stage *stage, struct emitter *lights, int count,
                                const char *technique) {
    struct renderer_desc desc = desc_of(stage, technique, settings, SIZE, SIZE);
    desc.emitters = (struct emitters){.items = lights, .count = count};
    return render_layers(&desc);
}

/* Spreads lights over the upper half of the room, by powers of one to three. */
static void spread_lights(const struct stage *stage, struct emitter *lights, int count,
                          enum emitter_type type, const float size[2]) {
    const struct geometry *room = &stage->geometry;
    for (int i = 0; i < count; i++) {
        lights[i] = emitter_new(type);
        for (int c = 0; c < 3; c++) {
            static const uint32_t bases[] = {2, 3, 5};
            float low = room->bounds_min[c], high = room->bounds_max[c];
            float place = .1F + .8F * (float)radical_inverse(bases[c], (uint32_t)i + 1);
            lights[i].position[c] = low + (high - low) * (c == 1 ? .5F + .5F * place : place);
            lights[i].intensity[c] =
                (1 + (float)((i + c) % 3)) * room->radius * room->radius / (float)count;
        }
        memcpy(lights[i].size, size, sizeof lights[i].size);
    }
}

/* --- a second implementation: maps ------------------------------------------------------------ */

/* imperfect-volume gives each light a map. */
TEST(maps) {
    static const struct {
        const char *what;
        enum emitter_type type;
        float size[2]; /* over the room's radius */
        double rmse;
    } rows[] = {{"points", EMITTER_POINT, {0, 0}, .08},
                {"spots", EMITTER_SPOT, {0, 0}, .25},
                {"rectangles", EMITTER_AREA, {.1F, .05F}, .15},
                {"disks", EMITTER_AREA, {.1F, 0}, .15},
                {"spheres", EMITTER_POINT, {.02F, 0}, .15}};
    OWNED(stage) stage;
    open_room(&stage);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct emitter lights[LIGHTS];
        const float size[2] = {rows[i].size[0] * stage.geometry.radius,
                               rows[i].size[1] * stage.geometry.radius};
        spread_lights(&stage, lights, LIGHTS, rows[i].type, size);
        OWNED(image) maps = render_with(&stage, lights, LIGHTS, "imperfect-volume");
        OWNED(image) sampled = render_with(&stage, lights, LIGHTS, "unshadowed");
        printf("%s\n", rows[i].what);
        check_near("direct light, mean",
                   layer_mean(&sampled, "direct") / layer_mean(&maps, "direct"), 1, .01);
        check_at_most("direct light, relative RMSE", relative_rmse(&sampled, &maps, "direct"),
                      rows[i].rmse);
    }
}

/* --- paths ------------------------------------------------------------------------------------ */

TEST(reference) {
    OWNED(stage) stage;
    struct emitter lights[LIGHTS];
    open_room(&stage);
    spread_lights(&stage, lights, LIGHTS, EMITTER_POINT, (float[]){0, 0});
    emitters_free(&stage.emitters);
    struct emitters own = {.items = lights, .count = LIGHTS};
    stage.emitters = emitters_copy(&own);
    OWNED(image) traced = trace_stage(&stage, SIZE, 64), reference = common_layers(&traced);
    OWNED(image) frame = render_with(&stage, lights, LIGHTS, "clustered");
    check_near("direct light, mean",
               layer_mean(&frame, "direct") / layer_mean(&reference, "direct"), 1, .01);
    check_near("indirect light, mean",
               layer_mean(&frame, "indirect") / layer_mean(&reference, "indirect"), 1, .03);
    check_at_most("indirect light, relative RMSE", relative_rmse(&frame, &reference, "indirect"),
                  .15);
}

/* The mean of passes; one pass is the frame. */
static struct image render_passes(const struct stage *stage, struct emitter *lights,
                                  const char *technique, int passes) {
    struct renderer_desc desc = desc_of(stage, technique, settings, SIZE, SIZE);
    desc.emitters = (struct emitters){.items = lights, .count = LIGHTS};
    return render_mean(&desc, 0, passes);
}

/* Forty panels over a floor: 24 have lights of their own, and the triangles of the others are
 * lights. */
TEST(panels) {
    enum { PANELS = 40, NODE = 160 };
    char nodes[(PANELS + 2) * NODE] = "[{mesh: 1, scale: [9, 9, 1], translation: [-4.5, -4.5, 0]}, "
                                      "{camera: 0, translation: [0, 0, 6]}";
    const char *path;
    for (int i = 0; i < PANELS; i++)
        sprintf(
            nodes + strlen(nodes),
            ", {mesh: 0, rotation: [1, 0, 0, 0], scale: [%f, 0.2, 1], translation: [%d, %d, 2]}",
            .2 + .01 * (double)i, i % 8 - 4, i / 8 - 2);
    strcat(nodes, "]");
    path = write_parts(
        "panels.glb",
        &PARTS(.more = "cameras: [{type: orthographic, orthographic: {xmag: 4, ymag: 4, znear: 5, "
                       "zfar: 7}}],",
               .materials = "[{emissiveFactor: [1, 1, 1]}, {}]",
               .meshes = "[{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 0}]}, "
                         "{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 1}]}]",
               .nodes = nodes));
    OWNED(stage) stage = open_stage(path);
    OWNED(image) traced = trace_stage(&stage, SIZE, 64), reference = common_layers(&traced),
                 frame = render_stage(&stage, "clustered", settings, SIZE);
    check_near("direct light, mean",
               layer_mean(&frame, "direct") / layer_mean(&reference, "direct"), 1, .01);
}

/* Passes have other samples, and their mean errs less. */
TEST(passes) {
    OWNED(stage) stage;
    struct emitter lights[LIGHTS];
    double errors[2];
    open_room(&stage);
    spread_lights(&stage, lights, LIGHTS, EMITTER_POINT, (float[]){0, 0});
    for (int i = 0; i < 2; i++) {
        int passes = i == 0 ? 1 : 8;
        OWNED(image) maps = render_passes(&stage, lights, "imperfect-volume", passes),
                     sampled = render_passes(&stage, lights, "unshadowed", passes);
        errors[i] = relative_rmse(&sampled, &maps, "direct");
    }
    check_at_most("error of eight passes over that of one", errors[1] / errors[0], .7);
}

/* --- relations -------------------------------------------------------------------------------- */

TEST(order) {
    OWNED(stage) stage;
    struct emitter lights[LIGHTS], reversed[LIGHTS];
    open_room(&stage);
    spread_lights(&stage, lights, LIGHTS, EMITTER_POINT, (float[]){0, 0});
    for (int i = 0; i < LIGHTS; i++)
        reversed[i] = lights[LIGHTS - 1 - i];
    OWNED(image) a = render_with(&stage, lights, LIGHTS, "unshadowed"),
                 b = render_with(&stage, reversed, LIGHTS, "unshadowed");
    check_near("direct light, mean", layer_mean(&a, "direct") / layer_mean(&b, "direct"), 1, .002);
}

/* One light among dark ones, and one that outshines all others, have maps. */
TEST(one_strong) {
    OWNED(stage) stage;
    struct emitter lights[LIGHTS];
    open_room(&stage);
    for (int faint = 0; faint < 2; faint++) {
        spread_lights(&stage, lights, LIGHTS, EMITTER_POINT, (float[]){0, 0});
        lights[0] = stage.emitters.items[0];
        for (int i = 1; i < LIGHTS; i++)
            for (int c = 0; c < 3; c++)
                lights[i].intensity[c] *= faint ? 1e-6F : 0;
        OWNED(image) alone = render_with(&stage, lights, 1, "clustered"),
                     among = render_with(&stage, lights, LIGHTS, "clustered");
        check_at_most("direct light, relative RMSE", relative_rmse(&among, &alone, "direct"), 1e-5);
        check_at_most("indirect light, relative RMSE", relative_rmse(&among, &alone, "indirect"),
                      faint ? .1 : 1e-5);
    }
}

/* Lights within a solid cost samples, and give no light. */
TEST(inside_solid) {
    struct stage stage;
    struct emitter lights[2 * LIGHTS];
    open_room(&stage);
    const struct geometry_part *block = stage.geometry.parts;
    while (block->index_count < 36) /* walls have fewer */
        block++;
    spread_lights(&stage, lights, 2 * LIGHTS, EMITTER_POINT, (float[]){0, 0});
    for (int i = LIGHTS; i < 2 * LIGHTS; i++)
        glm_vec3_center((float *)block->bounds_min, (float *)block->bounds_max, lights[i].position);
    struct image alone = render_with(&stage, lights, LIGHTS, "clustered"),
                 among = render_with(&stage, lights, 2 * LIGHTS, "clustered");
    check_near("direct light, mean", layer_mean(&among, "direct") / layer_mean(&alone, "direct"), 1,
               .01);
    check_near("indirect light, mean",
               layer_mean(&among, "indirect") / layer_mean(&alone, "indirect"), 1, .03);
    images_free(&alone, &among);
    stage_free(&stage);
}

/* A ball that emits is its triangles; a change of what stands in for it is refused. */
TEST(ball) {
    struct emitters changed = {0};
    OWNED(stage) stage = open_stage("scenes/failures/ball-lamp.glb");
    struct image traced = trace_stage(&stage, SIZE, 64), reference = common_layers(&traced);
    struct image image = render_stage(&stage, "clustered", "", SIZE);
    check_near("direct light over the reference's",
               layer_mean(&image, "direct") / layer_mean(&reference, "direct"), 1, .02);
    check_at_most("its error", relative_rmse(&image, &reference, "direct"), .1);
    check_near("indirect light over the reference's",
               layer_mean(&image, "indirect") / layer_mean(&reference, "indirect"), 1, .05);
    assert_false(emitters_from_text(&changed, &stage.scene, "0 size=2,2", 0));
    assert_non_null(strstr(error_get(), "light: 0 stands in"));
    images_free(&traced, &reference, &image);
}

/* Lights outside a closed room light nothing in it. */
TEST(behind_walls) {
    OWNED(stage) stage;
    struct emitter lights[LIGHTS];
    open_room(&stage);
    spread_lights(&stage, lights, LIGHTS, EMITTER_POINT, (float[]){0, 0});
    for (int i = 0; i < LIGHTS; i++) /* the room is open in front */
        lights[i].position[2] = stage.geometry.bounds_min[2] - .1F * stage.geometry.radius;
    OWNED(image) image = render_with(&stage, lights, LIGHTS, "clustered");
    check_at_most("direct light, mean", layer_mean(&image, "direct"), 0);
    check_at_most("indirect light, mean", layer_mean(&image, "indirect"), 0);
}

/* Glossy surfaces: what is mirrored is not reflected diffusely, and highlights keep their light. */
TEST(gloss) {
    struct emitter lights[LIGHTS];
    OWNED(stage) stage = open_stage("scenes/gloss.glb");
    spread_lights(&stage, lights, LIGHTS, EMITTER_POINT, (float[]){0, 0});
    OWNED(image) maps = render_with(&stage, lights, LIGHTS, "imperfect-volume"),
                 sampled = render_with(&stage, lights, LIGHTS, "unshadowed");
    check_near("direct light, mean", layer_mean(&sampled, "direct") / layer_mean(&maps, "direct"),
               1, .01);
    check_near("highlights, mean",
               layer_mean(&sampled, "direct.specular") / layer_mean(&maps, "direct.specular"), 1,
               .05);
}

/* Lights come and go: sampled lights, and parts that only frames with them have. A size tells the
 * direct method. */
TEST(follow) {
    OWNED(stage) stage;
    OWNED(renderer) renderer = {0};
    struct emitter lights[LIGHTS];
    open_room(&stage);
    spread_lights(&stage, lights, LIGHTS, EMITTER_AREA, (float[]){.1F * stage.geometry.radius, 0});
    struct renderer_desc desc = desc_of(&stage, "clustered", settings, SIZE, SIZE);
    for (int i = 0; i < 4; i++) {
        if (i == 3) /* as the viewer does */
            desc = renderer.desc;
        else
            desc.emitters = (struct emitters){.items = lights, .count = i == 1 ? 2 : LIGHTS};
        desc.width = i == 2 ? SIZE / 2 : SIZE;
        OWNED(image) followed = follow_layers(&renderer, &desc), fresh = render_layers(&desc);
        assert_true(same_pixels(&followed, &fresh));
        lights[i].position[0] *= .5F;
    }
}

RUN_TESTS(open_group_context, close_group_context)
