/* Panes in the path tracer: what glass and blended surfaces let pass, to the eye and to surfaces;
 * and alphas that equal their cutoff. */
#include "hand_made.h"

#include "reference/scene/ray_scene.h"
#include "scene/mesh/pane_triangles.h"

enum { FLOOR, PANE };

struct pane_scene {
    struct world world;
    struct hit_table table;
    struct ray_scene rays;
    struct bvh panes;
};

static void make_glass(struct material *material, float index) {
    float f0 = (index - 1) / (index + 1) * (index - 1) / (index + 1);
    for (int c = 0; c < 3; c++) {
        material->base_color[c] = 1;
        material->specular_f0[c] = f0;
    }
    material->roughness = 0;
    material->transmission = 1;
    material->thin_walled = true;
    material->index_of_refraction = index;
}

static void blend(struct material *material, float alpha) {
    material->blends = true;
    material->double_sided = true;
    material->base_color[3] = alpha;
}

/* A floor that sees light straight from above through so many panes at heights from 1 on. */
static void start(struct world *world, const struct material *pane, int panes) {
    world_init(world);
    world->materials[PANE] = *pane;
    add_rectangle(world, FLOOR, at(-20, 0, 20), at(40, 0, 0), at(0, 0, -40));
    for (int i = 0; i < panes; i++)
        add_rectangle(world, PANE, at(-20, 1 + .1F * (float)i, 20), at(40, 0, 0), at(0, 0, -40));
    look_down(world, -.5F, -.5F, 1, 3);
    place_light(world, EMITTER_DIRECTIONAL, glms_vec3_zero(), at(0, -1, 0), GLM_PIf);
    world_finish(world);
}

static struct material plain(void) {
    OWNED(world) world;
    world_init(&world);
    struct material material = world.materials[0];
    return material;
}

static void open_rays(struct pane_scene *scene, const struct material *pane, int panes) {
    start(&scene->world, pane, panes);
    hit_table_init(&scene->table, &scene->world.scene, &scene->world.geometry, MATERIALS_FULL);
    check_ok("rays", ray_scene_init(&scene->rays, &scene->table));
    scene->world.geometry.blocking_batch_count = 1;
    struct triangle_parts list = pane_triangles_of(&scene->world.scene, &scene->world.geometry);
    bvh_init(&scene->panes, list.items, list.count);
}

static void close_rays(struct pane_scene *scene) {
    bvh_free(&scene->panes);
    ray_scene_free(&scene->rays);
    world_free(&scene->world);
}

/* The other tree of panes has the colours in ten bits. */
static vec3s passes_between(const struct pane_scene *scene, vec3s from, vec3s to) {
    vec3s passes = ray_scene_passes(&scene->rays, from, to), path = glms_vec3_sub(to, from);
    vec3s other = pane_triangles_pass(&scene->panes, from, vec3s_unit(path), glms_vec3_norm(path));
    for (int c = 0; c < 3; c++)
        assert_float_equal(other.raw[c], passes.raw[c], 2e-3);
    return passes;
}

static vec3s passes_at(const struct pane_scene *scene, float degrees) {
    float turn = glm_rad(degrees);
    vec3s aside = at(sinf(turn), cosf(turn), .003F); /* off the diagonal */
    return passes_between(scene, glms_vec3_scale(aside, .2F), glms_vec3_scale(aside, 12));
}

/* CIE 171:2006, 5.5: clear glass of index 1.52 with inner reflections. */
TEST(glass_by_angle) {
    static const float degrees[] = {0, 15, 30, 45, 60, 75, 80};
    static const double expected[] = {.9183, .9182, .9160, .9025, .8435, .6148, .4560};
    struct material glass = plain();
    struct pane_scene scene;
    make_glass(&glass, 1.52F);
    open_rays(&scene, &glass, 1);
    for (size_t i = 0; i < sizeof degrees / sizeof *degrees; i++)
        check_near("passes", passes_at(&scene, degrees[i]).x, expected[i], 2e-4);
    close_rays(&scene);
    open_rays(&scene, &glass, 3);
    check_near("three panes", passes_at(&scene, 60).y, pow(.8435, 3), 5e-4);
    close_rays(&scene);
    glass.base_color[0] = .5F;
    glass.base_color[2] = 0;
    open_rays(&scene, &glass, 2);
    check_near("red of two coloured panes", passes_at(&scene, 30).x, pow(.5 * .9160, 2), 2e-4);
    check_near("their blue", passes_at(&scene, 30).z, 0, 0);
    close_rays(&scene);
    make_glass(&glass, 1.52F);
    glass.thin_walled = false;
    glass.thickness = .2F;
    glass.absorption[0] = 3;
    open_rays(&scene, &glass, 2);
    check_near("two faces of a solid", passes_at(&scene, 0).y, .9183, 2e-4);
    check_near("which absorbs", passes_at(&scene, 0).x, .9183 * exp(-.6), 2e-4);
    close_rays(&scene);
}

TEST(blended) {
    static const float alphas[] = {0, .2F, .5F, .7F, 1};
    for (size_t i = 0; i < sizeof alphas / sizeof *alphas; i++) {
        struct material pane = plain();
        struct pane_scene scene;
        blend(&pane, alphas[i]);
        open_rays(&scene, &pane, 2);
        check_near("two of one alpha", passes_at(&scene, 70).x, pow(1 - alphas[i], 2), 1e-6);
        for (int n = -4; n <= 4;
             n++) /* along both diagonals, one of which is an edge of triangles */
            for (int side = -1; side <= 1; side += 2)
                check_near("on an edge",
                           passes_between(&scene, at((float)n, .2F, (float)(side * n)),
                                          at((float)n, 12, (float)(side * n)))
                               .x,
                           pow(1 - alphas[i], 2), 1e-6);
        close_rays(&scene);
    }
}

/* The floor through the pane, lit through it, and the pane's own light before it. */
TEST(seen) {
    static const float alphas[] = {.3F, .5F, .8F};
    for (size_t i = 0; i < sizeof alphas / sizeof *alphas; i++) {
        OWNED(world) world;
        OWNED(image) image;
        struct material pane = plain();
        double a = alphas[i], own = .9;
        blend(&pane, alphas[i]);
        pane.base_color[1] = (float)own;
        start(&world, &pane, 1);
        struct path_tracer_desc desc = describe(&world, 8, 256);
        render(&desc, &image);
        check_near("green", mean_of(&image, CHANNEL_BEAUTY + 1), a * own + (1 - a) * (1 - a) / 2,
                   .004);
    }
}

/* Light of one bounce from the floor to the ceiling through a pane is as much less. */
TEST(bounce) {
    double seen[3];
    for (int kind = 0; kind < 3; kind++) {
        OWNED(world) world;
        OWNED(image) image;
        struct material pane = plain();
        if (kind == 1)
            make_glass(&pane, 1);
        blend(&pane, kind == 1 ? 1 : .6F);
        for (int c = 0; kind == 2 && c < 3; c++)
            pane.base_color[c] = 0;
        world_init(&world);
        world.materials[PANE] = pane;
        add_rectangle(&world, FLOOR, at(-5, 0, 5), at(10, 0, 0), at(0, 0, -10));
        add_rectangle(&world, FLOOR, at(-5, 4, -5), at(10, 0, 0), at(0, 0, 10));
        if (kind > 0)
            add_rectangle(&world, PANE, at(-5, 3, 5), at(10, 0, 0), at(0, 0, -10));
        look_down(&world, -1, -1, 2, 3.5F);
        world.camera.forward[1] = 1;
        place_light(&world, EMITTER_AREA, at(0, 2, 0), at(0, -1, 0), 4);
        world_finish(&world);
        struct path_tracer_desc desc = describe(&world, 8, 256);
        desc.bounces = 1;
        render(&desc, &image);
        seen[kind] = mean_of(&image, CHANNEL_INDIRECT);
    }
    check_near("glass of index 1 lets all pass", seen[1] / seen[0], 1, .02);
    check_near("black of alpha .6 lets .4 pass", seen[2] / seen[0], .4, .012);
}

/* Interpolated alphas are a rounding off. */
TEST(cutoff) {
    static const float alphas[] = {.5F, .3F, .9F};
    for (size_t i = 0; i < sizeof alphas / sizeof *alphas; i++) {
        struct material mask = plain();
        struct pane_scene scene;
        mask.alpha_mask = true;
        mask.base_color[3] = mask.alpha_cutoff = alphas[i];
        open_rays(&scene, &mask, 1);
        int holes = 0;
        for (uint32_t n = 0; n < 4096; n++)
            holes += ray_scene_visible(&scene.rays, at(.01F * (float)(n % 64), .1F, 0),
                                       at(.03F * (float)(n / 64), 2, 1));
        check_near("holes", holes, 0, 0);
        close_rays(&scene);
    }
}

RUN_TESTS(NULL, NULL)
