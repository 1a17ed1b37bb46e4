/* What the camera sees through glass and in mirrors, where a chain of them ends or passes in a
 * special way. */
#include "light_scenes.h"

#include "scene/lights/environment.h"

static float white[2][3] = {{1, 1, 1}, {1, 1, 1}};
static const struct environment sky = {.width = 2, .height = 1, .texels = white, .strength = 1};

/* Looks down on a rectangle of glass or a mirror that fills the view. */
static void make_sheet(struct world *world) {
    add_rectangle(world, MATERIAL_SMOOTH, at(-1, 0, 1), at(2, 0, 0), at(0, 0, -2));
    world_finish(world);
    look_down(world, -.5F, -.5F, 1, 1);
}

static double beauty_of(struct world *world, const struct path_tracer_desc *look) {
    struct path_tracer_desc desc = describe(world, 4, 1024);
    OWNED(image) image;
    desc.smooth = true;
    desc.emitters = look->emitters;
    desc.hides_sky = look->hides_sky;
    render(&desc, &image);
    check_finite(&image);
    double beauty = mean_of_layer(&image, "");
    check_near("specular light over beauty", mean_of_layer(&image, "specular"), beauty, 1e-4);
    return beauty;
}

/* Behind glass that has no back is glass without end. */
TEST(open) {
    static const float expected[] = {1, .04F};
    for (int absorbs = 0; absorbs < 2; absorbs++) {
        OWNED(world) world;
        world_init(&world);
        make_glass(&world.materials[MATERIAL_SMOOTH], 1.5F);
        for (int c = 0; c < 3; c++)
            world.materials[MATERIAL_SMOOTH].absorption[c] = (float)absorbs;
        make_sheet(&world);
        struct path_tracer_desc look = {.emitters = {.sky = &sky}};
        check_near(absorbs ? "black glass" : "clear glass", beauty_of(&world, &look),
                   (double)expected[absorbs], .002);
    }
}

/* A sky that is hidden behind surfaces still lights them. */
TEST(hidden_sky) {
    OWNED(world) world;
    world_init(&world);
    make_mirror(&world.materials[MATERIAL_SMOOTH], .7F);
    make_sheet(&world);
    for (int hides = 0; hides < 2; hides++) {
        struct path_tracer_desc look = {.emitters = {.sky = &sky}, .hides_sky = hides};
        check_near("a mirror under a sky", beauty_of(&world, &look), .7, 1e-4);
    }
}

/* Glass that shines is seen in a mirror, before a sky. */
TEST(glow) {
    enum { LAMP = 1 };
    OWNED(world) world;
    struct emissive_surface surface = {.end = 6, .lamp = LAMP};
    struct geometry_part part = {.first_index = 6, .index_count = 6};
    world_init(&world);
    make_mirror(&world.materials[MATERIAL_SMOOTH], .7F);
    make_glass(&world.materials[MATERIAL_INNER], 1);
    world.materials[MATERIAL_INNER].thin_walled = true;
    for (int c = 0; c < 3; c++)
        world.materials[MATERIAL_INNER].emission[c] = 2;
    add_rectangle(&world, MATERIAL_SMOOTH, at(-1, 0, 1), at(2, 0, 0), at(0, 0, -2));
    add_rectangle(&world, MATERIAL_INNER, at(-1, 2, -1), at(2, 0, 0), at(0, 0, 2));
    world_finish(&world);
    look_down(&world, -.5F, -.5F, 1, 1);
    world.scene.surfaces = &surface;
    world.scene.surface_count = world.geometry.part_count = 1;
    world.geometry.parts = &part;
    place_light(&world, EMITTER_POINT, at(0, 2, 0), at(0, -1, 0), 1);
    world.light.lamp = LAMP;
    world.light.stands_in = 1;
    struct path_tracer_desc look = {.emitters = {.items = &world.light, .count = 1, .sky = &sky}};
    check_near("glass of 2 before a sky of 1, in a mirror", beauty_of(&world, &look), .7 * (2 + 1),
               1e-4);
}

/* Panes that let light pass straight on keep the light of a white sky: what glass reflects is what
 * Fresnel's equations leave, at each angle, and the rest of the surface has what enters. */
TEST(pane_furnace) {
    for (int i = 0; i < 8; i++) {
        OWNED(world) world;
        OWNED(image) image;
        struct material *pane = &world.materials[MATERIAL_SMOOTH];
        world_init(&world);
        make_glass(pane, 1.5F);
        glm_vec3_broadcast(.04F, pane->specular_f0);
        pane->specular_f90 = 1;
        pane->transmission = i & 1 ? .4F : 1;
        pane->thin_walled = i & 2;
        make_sheet(&world);
        float angle = glm_rad(i & 4 ? 75 : 50), s = sinf(angle), c = cosf(angle);
        world.camera.forward[0] = s, world.camera.forward[1] = -c;
        world.camera.right[0] = c, world.camera.right[1] = s;
        world.camera.eye[0] = -s, world.camera.eye[1] = c;
        world.camera.y_extent = .05F;
        struct path_tracer_desc desc = describe(&world, 4, 4096);
        desc.emitters = (struct emitters){.sky = &sky};
        render(&desc, &image);
        check_near("glass in a white furnace", mean_of_layer(&image, ""), 1, .002);
    }
}

RUN_TESTS(NULL, NULL)
