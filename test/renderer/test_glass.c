/* What glass and mirrors show: exact answers outside and inside the picture, and the path tracer's
 * pictures. */
#include "smooth_stage.h"

#include "scene/material.h"

/* The smooth surfaces throw no light here: what they show has answers of its own. */
#define SHOWN CHEAP "caustics.surface=patches caustics.size=8 "

/* The light at that height, downwards. */
static void place_light(struct stage *stage, float z) {
    stage->emitters.items[0].position[2] = z;
    emitter_aim(&stage->emitters.items[0], (float[]){0, 0, -1});
}

static void look_up(struct stage *stage) {
    stage->camera.up[1] = -1;
    stage->camera.forward[2] = 1;
}

/* The picture's mean of a channel, over the radiance of the floor below a light that far
 * above it. */
static double over_floor(const struct image *image, const char *channel, double height) {
    return channel_mean(image, channel) * GLM_PI * height * height;
}

/* --- exact answers ---------------------------------------------------------------------------- */

/* The floor below the light, in a mirror above both. The picture does not show the floor. */
TEST(mirror) {
    OWNED(stage) stage;
    open_mirror(&stage, 4, 1);
    place_light(&stage, 2);
    look_up(&stage);
    OWNED(image) drawn = draw(&stage, SHOWN);
    check_near("red over expected", over_floor(&drawn, "R", 2), 1, .01);
    check_near("blue over expected", over_floor(&drawn, "B", 2) / .6, 1, .01);
    check_near("specular", over_floor(&drawn, "direct.specular.R", 2), 1, .01);
    check_near("indirect specular", mean_of(&drawn, "indirect.specular"), 0, 1e-4);
    check_near("direct", mean_of(&drawn, "direct"), 0, 0);
    check_near("indirect", mean_of(&drawn, "indirect"), 0, 0);
    image_free(&drawn);
    emitter_aim(&stage.emitters.items[0], (float[]){0, 0, 1});
    drawn = draw(&stage, SHOWN);
    check_near("a dark floor", mean_of(&drawn, "direct.specular"), 0, 0);
}

/* Light that comes back from a mirror is indirect light of the floor that the mirror shows: none
 * but of rays that see the floor by another surface. A ceiling beside the mirror reflects light to
 * the floor. */
TEST(indirect) {
    OWNED(stage) stage;
    open_nodes(&stage,
               form(FLOOR_NODE ", %s, {mesh: 0, translation: [-20, 20, 3.01], "
                               "rotation: [1, 0, 0, 0], scale: [40, 40, 1]}",
                    square_node(DOWN_NODE, 3, .2)),
               1);
    make_mirror(&stage);
    look_up(&stage);
    stage.emitters.items[0].cos_outer = cosf(.35F);
    stage.emitters.items[0].cos_inner = cosf(.3F);
    stage.emitters.items[0].position[2] = .5F; /* lights the ceiling, and not the floor */
    emitter_aim(&stage.emitters.items[0], (float[]){0, 0, 1});
    stage.emitters.items[0].position[0] = 1;
    OWNED(image) drawn = draw(&stage, SHOWN);
    OWNED(image) traced =
        TRACE(&stage, .width = 8, .height = 8, .bounces = 1, .samples = 1024, .smooth = true);
    double expected = channel_mean(&traced, "indirect.specular.R");
    printf("    traced %g\n", expected);
    check_near("over traced", channel_mean(&drawn, "indirect.specular.R") / expected, 1, .05);
}

/* The floor through a slab, straight on: (1 - F)^2 of it, and F^2 of that once more by reflection
 * within. */
TEST(slab) {
    struct stage stage;
    static const struct {
        const char *what;
        float index, absorption, eye;
        double expected;
    } rows[] = {
        {"index 1", 1, 0, 2, 1},
        {"index 1.5", 1.5F, 0, 2, .9216 * 1.0016},
        {"absorbing", 1.5F, 3, 2, .9216 * .54881164},
        {"camera inside, index 1", 1, 0, .9F, 1},
        {"camera inside, index 1.5", 1.5F, 0, .9F, .96 * 1.0016},
        {"camera inside, absorbing", 1.5F, 3, .9F, .96 * .74081822},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        open_slab(&stage, rows[i].index, 4, rows[i].eye);
        place_light(&stage, .5F);
        stage.camera.fov_y = .02F;
        for (int c = 0; c < 3; c++)
            stage.scene.materials[SMOOTH].absorption[c] = rows[i].absorption;
        OWNED(image) drawn = draw(&stage, SHOWN);
        check_near(rows[i].what, over_floor(&drawn, "R", .5) / rows[i].expected, 1, .003);
        check_near("direct", mean_of(&drawn, "direct"), 0, 0);
        image_free(&drawn);
        drawn = draw(&stage, SHOWN "samples=8");
        check_near("of 8 samples", over_floor(&drawn, "R", .5) / rows[i].expected, 1, .003);
        stage_free(&stage);
    }
}

/* The floor below a pane, by the light above it, from below and from above: without caustics light
 * goes straight on. From below, fog has as much of it. */
TEST(panes) {
    double fog = 0;
    static const struct {
        const char *what;
        float alpha, index;
        double passes;
    } rows[] = {{"glass of index 1", 1, 1, 1}, {"glass", 1, 1.52F, .9183},
                {"blended .2", .2F, 0, .8},    {"blended .5", .5F, 0, .5},
                {"blended .75", .75F, 0, .25}, {"opaque", 1, 0, 0}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int above = 0; above < 2; above++) {
            OWNED(stage) stage;
            open_squares(&stage, &(struct square){UP_NODE, 1, 4}, 1, above ? 1.5F : .5F);
            struct material *pane = &stage.scene.materials[SMOOTH];
            pane->blends = rows[i].index == 0 && rows[i].passes > 0;
            pane->base_color[3] = rows[i].alpha;
            pane->thin_walled = true;
            for (int c = 0; c < 3; c++)
                pane->base_color[c] = rows[i].index > 0;
            if (rows[i].index > 0)
                make_glass(&stage, rows[i].index);
            lay_out(&stage);
            place_light(&stage, 2);
            stage.camera.fov_y = .02F;
            stage.camera.eye[0] = i % 2 ? .05F : 0; /* off and on the diagonal of two triangles */
            OWNED(image) drawn = draw(&stage, CHEAP);
            check_near(rows[i].what, over_floor(&drawn, "R", 2), pow(rows[i].passes, 1 + above),
                       .003);
            image_free(&drawn);
            drawn = draw(&stage, CHEAP "medium.scatter=.001");
            fog = i == 0 && !above ? mean_of(&drawn, "airlight") : fog;
            if (!above)
                check_near("fog", mean_of(&drawn, "airlight") / fog, rows[i].passes, .01);
        }
}

/* The floor by what a blended surface above the light reflects: as much of what it reflects if
 * opaque as it covers. */
TEST(panes_reflect) {
    static const struct {
        const char *node;
        float alpha, expected;
    } rows[] = {{DOWN_NODE, 1, 1},
                {DOWN_NODE, .25F, .25F},
                {DOWN_NODE, .5F, .5F},
                {DOWN_NODE, .75F, .75F},
                {UP_NODE, .5F, 0}};
    double of_opaque = 0;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(stage) stage;
        open_squares(&stage, &(struct square){rows[i].node, 1, 2}, 1, .3F);
        stage.scene.materials[SMOOTH].blends = i > 0;
        stage.scene.materials[SMOOTH].base_color[3] = rows[i].alpha;
        lay_out(&stage);
        place_light(&stage, .5F);
        emitter_aim(&stage.emitters.items[0], (float[]){0, 0, 1});
        OWNED(image) drawn = draw(&stage, "vpls=8192 rsm-size=64");
        of_opaque = i == 0 ? mean_of(&drawn, "indirect") : of_opaque;
        check_near("over opaque", mean_of(&drawn, "indirect") / of_opaque, rows[i].expected, .015);
    }
}

static void make_black_pane(struct stage *stage, float alpha) {
    struct material *pane = &stage->scene.materials[SMOOTH];
    pane->blends = pane->double_sided = true;
    memset(pane->base_color, 0, sizeof pane->base_color);
    pane->base_color[3] = alpha;
    lay_out(stage);
}

/* A small floor and a square above, which faces down, of that material. */
static const char *storeys(int material, double z) {
    return form("{mesh: 0, translation: [-2, -2, 0], scale: [4, 4, 1]}, {mesh: %d, "
                "translation: [-2, 2, %g], rotation: [1, 0, 0, 0], scale: [4, 4, 1]}",
                material, z);
}

/* A floor and a ceiling, and between them perhaps a black pane of alpha .6. */
static void open_storeys(struct stage *stage, bool pane, float light) {
    const char *nodes = storeys(FLOOR, 2);
    if (pane)
        nodes = form("%s, %s", nodes, square_node(UP_NODE, 1, 4));
    open_nodes(stage, nodes, 1.5F);
    make_black_pane(stage, .6F);
    place_light(stage, light);
    look_up(stage);
    stage->camera.fov_y = .5F;
}

/* The ceiling by the floor's light through a black pane of alpha .6, for all techniques; the light
 * is below the pane, and above. */
TEST(techniques) {
    for (int above = 0; above < 2; above++)
        for (const struct technique *const *t = techniques; *t; t++) {
            double indirect[2];
            for (int pane = 0; pane < 2; pane++) {
                OWNED(stage) stage;
                open_storeys(&stage, pane, above ? 1.6F : .4F);
                OWNED(image) drawn = render_stage(&stage, (*t)->name, "", SIZE);
                indirect[pane] = mean_of(&drawn, "indirect");
            }
            check_near((*t)->name, indirect[1] / indirect[0], above ? .16 : .4, .01);
        }
}

/* Links of elements have the colours of panes. */
TEST(red_light) {
    OWNED(stage) stage;
    open_storeys(&stage, true, .4F);
    make_glass(&stage, 1);
    struct material *pane = &stage.scene.materials[SMOOTH];
    pane->blends = false;
    pane->thin_walled = true;
    memcpy(pane->base_color, (float[]){1, .25F, 0, 1}, sizeof pane->base_color);
    lay_out(&stage);
    OWNED(image) drawn = render_stage(&stage, "implicit-visibility", "", SIZE);
    double red = channel_mean(&drawn, "indirect.R");
    check_near("green over red", channel_mean(&drawn, "indirect.G") / red, .25, .002);
    check_near("blue over red", channel_mean(&drawn, "indirect.B") / red, 0, .002);
}

/* A pane before nothing: its own side's light, direct or of the floor, is alpha of what it has if
 * opaque. Voxels that an opaque surface crosses have no light of their own: there its light is of
 * others, a voxel away. */
TEST(panes_before_sky) {
    static const char *const names[] = {"clustered", "imperfect-volume", "implicit-visibility"};
    static const double tolerances[] = {.01, .04, .01};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        for (int up = 0; up < 2; up++) {
            double of_opaque = 0, covered = 0;
            for (int blends = 0; blends < 2; blends++) {
                OWNED(stage) stage;
                open_nodes(&stage, storeys(SMOOTH, 1), .2F);
                stage.scene.materials[SMOOTH].blends = blends;
                stage.scene.materials[SMOOTH].base_color[3] = .6F;
                lay_out(&stage);
                place_light(&stage, .5F);
                emitter_aim(&stage.emitters.items[0], (float[]){0, 0, up ? 1 : -1});
                look_up(&stage);
                stage.camera.fov_y = 1;
                OWNED(image) drawn = render_stage(&stage, names[i], "", SIZE);
                double seen = channel_mean(&drawn, "R");
                of_opaque = blends ? of_opaque : seen;
                covered = blends ? covered : channel_mean(&drawn, "A");
                if (blends) {
                    check_near(up ? "direct over opaque" : "indirect over opaque", seen / of_opaque,
                               .6, tolerances[i]);
                    check_near("A over opaque", channel_mean(&drawn, "A") / covered, .6, .002);
                }
            }
        }
}

/* Of a square lamp, three fifths lie behind a pane of alpha .5 with an edge. */
TEST(half_a_lamp) {
    double direct[2];
    for (int pane = 0; pane < 2; pane++) {
        OWNED(stage) stage;
        open_nodes(&stage,
                   pane ? FLOOR_NODE ", {mesh: 1, translation: [0, -4, 1], scale: [8, 8, 1]}"
                        : FLOOR_NODE,
                   .5F);
        make_black_pane(&stage, .5F);
        stage.emitters.items[0].type = EMITTER_AREA;
        stage.emitters.items[0].size[0] = stage.emitters.items[0].size[1] = 1;
        stage.camera.eye[0] = .1F;
        OWNED(image) drawn = draw(&stage, CHEAP);
        direct[pane] = mean_of(&drawn, "direct");
    }
    check_near("direct light over that without a pane", direct[1] / direct[0], .7, .005);
}

/* Fog that a coloured pane hides from the camera, lit below it: in the frame and in the path
 * tracer. */
TEST(fog_behind_colours) {
    static const char *const channels[] = {"airlight.R", "airlight.G", "airlight.B"};
    OWNED(stage) stage;
    open_squares(&stage, &(struct square){UP_NODE, 1, 30}, 1, 1.5F);
    make_glass(&stage, 1);
    stage.scene.materials[SMOOTH].thin_walled = true;
    for (int c = 0; c < 3; c++) {
        stage.scene.materials[SMOOTH].base_color[c] = 1 / (float)(1 << c);
        stage.scene.medium.scattering[c] = .01F;
    }
    lay_out(&stage);
    place_light(&stage, .8F);
    OWNED(image) drawn = draw(&stage, CHEAP), traced;
    traced = TRACE(&stage, .width = 8, .height = 8, .samples = 64, .medium = stage.scene.medium);
    for (int c = 1; c < 3; c++) {
        check_near("drawn", channel_mean(&drawn, channels[c]) / channel_mean(&drawn, channels[0]),
                   1. / (1 << c), .002);
        check_near("traced",
                   channel_mean(&traced, channels[c]) / channel_mean(&traced, channels[0]),
                   1. / (1 << c), .002);
    }
}

/* Of two renderers of one geometry, glass is a pane to one and an occluder, which throws caustics,
 * to the other. */
TEST(two_renderers) {
    static const char *const settings[] = {CHEAP, SHOWN};
    OWNED(stage) stage;
    struct renderer renderers[2];
    open_slab(&stage, 1.5F, 4, 1);
    place_light(&stage, 2);
    for (int i = 0; i < 2; i++) {
        open_renderer(&renderers[i], desc_of(&stage, "unshadowed", settings[i], SIZE, SIZE));
    }
    for (int i = 0; i < 2; i++) {
        OWNED(image) alone = draw(&stage, settings[i]), beside;
        check_ok("update", renderer_update(&renderers[i]));
        renderer_render(&renderers[i]);
        check_ok("layers", renderer_read_layers(&renderers[i], &beside));
        assert_true(same_pixels(&beside, &alone));
    }
    for (int i = 0; i < 2; i++)
        renderer_free(&renderers[i]);
}

/* A wall of one side, seen from behind through glass, is black, as in the reference; one of two
 * sides has the light below it. */
TEST(wall_from_behind) {
    OWNED(stage) stage;
    open_nodes(&stage,
               form(FLOOR_NODE ", {mesh: 0, translation: [-2, -2, 2.5], scale: [4, 4, 1]}, %s, %s",
                    square_node(UP_NODE, 1, 1), square_node(DOWN_NODE, .8, 1)),
               .5F);
    make_glass(&stage, 1);
    look_up(&stage);
    stage.emitters.items[0].position[2] = 1.5F;
    emitter_aim(&stage.emitters.items[0], (float[]){0, 0, 1});
    for (int two_sided = 0; two_sided < 2; two_sided++) {
        stage.scene.materials[FLOOR].double_sided = two_sided;
        OWNED(image) drawn = draw(&stage, SHOWN);
        OWNED(image) traced = TRACE(&stage, .width = 16, .height = 16, .samples = 16,
                                    .smooth = true, .materials = MATERIALS_FULL);
        check_near(two_sided ? "two sides" : "one side", over_floor(&drawn, "R", 1), two_sided,
                   .03);
        check_near("traced", over_floor(&traced, "R", 1), two_sided, .03);
    }
}

/* One interface, and a slab in a slab, each of whose interfaces has air on its other side: as the
 * reference has it. */
TEST(open_and_nested) {
    for (int nested = 0; nested < 2; nested++) {
        OWNED(stage) stage;
        static const struct square squares[] = {
            {UP_NODE, 1, 4}, {UP_NODE, .95, 4}, {DOWN_NODE, .85, 4}, {DOWN_NODE, .8, 4}};
        open_squares(&stage, squares, nested ? 4 : 1, 2);
        make_glass(&stage, 1.5F);
        place_light(&stage, .5F);
        OWNED(image) drawn = draw(&stage, SHOWN "caustics.chains=8");
        OWNED(image) traced =
            TRACE(&stage, .width = 16, .height = 16, .bounces = 1, .samples = 512, .smooth = true);
        printf("    %s\n", nested ? "nested" : "open");
        check_near("over traced", channel_mean(&drawn, "R") / channel_mean(&traced, "R"), 1, .02);
        check_finite("drawn", &drawn);
    }
}

/* --- beside the path tracer ------------------------------------------------------------------- */

/* Without caustics on surfaces, which the path tracer does not show in glass. */
TEST(traced) {
    enum { WIDE = 96 };
    static const char *const scenes[] = {"scenes/ring.glb", "scenes/pawns.glb", "scenes/gem.glb"};
    static const char shown[] =
        CHEAP "caustics.surface=off caustics.medium=lines caustics.size=8 medium.scatter=.0001";
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        OWNED(stage) stage = open_stage(scenes[i]);
        memset(&stage.scene.medium, 0, sizeof stage.scene.medium);
        OWNED(image) drawn = render_stage(&stage, "unshadowed", shown, WIDE);
        OWNED(image) traced = TRACE(&stage, .width = WIDE, .height = WIDE, .bounces = 1,
                                    .samples = 16, .centers = true, .smooth = true);
        double off = mean_of(&drawn, "specular") / mean_of(&traced, "specular");
        printf("    %s\n", scenes[i]);
        check_near("specular over traced", off, 1, .06);
        check_near("direct over traced", mean_of(&drawn, "direct") / mean_of(&traced, "direct"), 1,
                   .02);
    }
}

/* A medium between glass and the place that it shows: a window of index 1, or thin, shows the same
 * fog. */
static void check_medium(bool thin) {
    OWNED(stage) with, without;
    open_slab(&with, 1, 4, 2);
    with.scene.materials[SMOOTH].thin_walled = thin;
    open_nodes(&without, FLOOR_NODE, 2);
    place_light(&with, .5F);
    place_light(&without, .5F);
    with.camera.fov_y = without.camera.fov_y = 1;
    for (int c = 0; c < 3; c++) {
        with.scene.medium.scattering[c] = without.scene.medium.scattering[c] = .4F;
        with.scene.materials[SMOOTH].absorption[c] = thin ? 0 : .4F;
    }
    OWNED(image) a = draw(&with, SHOWN "medium.steps=128");
    OWNED(image) b = draw(&without, CHEAP "medium.steps=128");
    check_near(thin ? "thin over none" : "index 1 over none",
               channel_mean(&a, "R") / channel_mean(&b, "R"), 1, .03);
}

TEST(medium) {
    check_medium(false);
    check_medium(true);
}

/* --- settings that follow each other ---------------------------------------------------------- */

/* With a sky, a medium and all caustics the composite has more samplers than GL promises, if edge
 * samples have theirs. They come back once there is room. */
TEST(all_kinds) {
    static const char *const settings[] = {
        CHEAP "samples=8 caustics.size=16 caustics.surface=patches caustics.medium=lines",
        CHEAP "samples=8 caustics.size=16 caustics.surface=patches",
        CHEAP "samples=8 caustics.size=16 caustics.medium=lines", CHEAP "samples=8"};
    OWNED(stage) stage;
    OWNED(renderer) renderer = {0};
    check_ok("window",
             stage_init(&stage, &(struct stage_desc){.path = "scenes/window.glb",
                                                     .environment = {"scenes/day.hdr", 0, 1}}));
    for (size_t i = 0; i < sizeof settings / sizeof *settings; i++) {
        struct renderer_desc desc = desc_of(&stage, "clustered", settings[i], SIZE, SIZE);
        OWNED(image) followed = follow_layers(&renderer, &desc), fresh = render_layers(&desc);
        check_finite(settings[i], &followed);
        assert_true(same_pixels(&followed, &fresh));
    }
}

/* Glass is diffuse if all materials are, as it is to the path tracer. */
TEST(diffuse) {
    static const char *const settings[] = {PATCHES, PATCHES "surface.materials=diffuse",
                                           CHEAP "surface.materials=diffuse"};
    OWNED(stage) stage;
    OWNED(renderer) renderer = {0};
    OWNED(image) followed = {0}, opaque = {0};
    open_slab(&stage, 1.5F, 1, 2);
    for (int i = 0; i < 3; i++) {
        struct renderer_desc desc = desc_of(&stage, "unshadowed", settings[i], SIZE, SIZE);
        if (i < 2) {
            image_free(&followed);
            followed = follow_layers(&renderer, &desc);
        } else
            opaque = render_layers(&desc);
    }
    assert_true(same_pixels(&followed, &opaque));
    OWNED(image) traced = TRACE(&stage, .width = 16, .height = 16, .samples = 64,
                                .materials = MATERIALS_DIFFUSE, .smooth = true);
    check_near("over traced", mean_of(&followed, "direct") / mean_of(&traced, "direct"), 1, .02);
}

RUN_TESTS(open_group_context, close_group_context)
