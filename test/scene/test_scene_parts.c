/* The scene floor: textures, the number that tells scenes apart, flat nodes, how lights are laid
 * out. */
#include "gltf_parts.h"

#include "lights/view.h"
#include "scene/camera.h"
#include "scene/hash.h"
#include "scene/lights/emitter.h"
#include "scene/lights/environment.h"
#include "scene/material.h"
#include "scene/node.h"
#include "scene/open.h"
#include "scene/stand_in.h"
#include "scene/texture.h"

#include <cglm/cglm.h>

static float red_at(const struct scene_texture *texture, float u, float v) {
    static float table[256];
    texture_decode_table(table);
    return texture_lookup(texture, table, (vec2s){{u, v}}).raw[0] * 255;
}

/* Four texels of a row; beyond its ends each way of wrapping, by the nearest one and by two. */
TEST(texture) {
    unsigned char rgba[16] = {[0] = 10, [4] = 20, [8] = 40, [12] = 80};
    struct scene_texture texture = {.bitmap = {4, 1, rgba}, .linear = true, .nearest = true};
    static const struct {
        enum texture_wrap wrap;
        double left, right, far; /* of the row, and one and a half rows away */
    } rows[] = {
        {TEXTURE_WRAP_REPEAT, 80, 10, 40},
        {TEXTURE_WRAP_CLAMP, 10, 80, 80},
        {TEXTURE_WRAP_MIRROR, 10, 80, 20},
    };
    for (int i = 0; i < 3; i++) {
        texture.wrap_u = texture.wrap_v = rows[i].wrap;
        check_near("in it", (double)red_at(&texture, .3F, .5F), 20, 1e-4);
        check_near("left of it", (double)red_at(&texture, -.1F, .5F), rows[i].left, 1e-4);
        check_near("right of it", (double)red_at(&texture, 1.1F, -3.5F), rows[i].right, 1e-4);
        check_near("far from it", (double)red_at(&texture, 1.6F, 2.5F), rows[i].far, 1e-4);
    }
    texture.nearest = false;
    check_near("between two", (double)red_at(&texture, .5F, .5F), 30, 1e-4);
    check_near("between the last and the first, mirrored", (double)red_at(&texture, 1, .5F), 80,
               1e-4);
    check_near("nowhere", (double)red_at(&texture, INFINITY, NAN), 10, 1e-4);
    texture.linear = false;
    check_near("as a monitor has it", (double)red_at(&texture, .875F, .5F), 20.4, .2);
    check_near("dark", (double)red_at(&texture, .125F, .5F), .774, .01);
}

/* Any part of a scene that is drawn has a share in the number that tells scenes apart. */
TEST(hash) {
    OWNED(scene) scene;
    OWNED(geometry) geometry;
    struct camera camera;
    vec3 sky_texels[2] = {{1, 1, 1}, {2, 2, 2}};
    struct environment sky = {.width = 2, .height = 1, .texels = sky_texels, .strength = 1};
    unsigned char rgba[2 * 3 * 4] = {0};
    struct scene_texture texture = {.bitmap = {2, 3, rgba}};
    struct emitters emitters = {0};
    check_ok("open", scene_open(&scene, &geometry, write_parts("plain.glb", &PARTS(0)), NULL));
    camera_place(&camera, &scene, 0, 0);
    uint64_t sums[5] = {scene_hash(&scene, &geometry, &camera, &emitters)};
    emitters.sky = &sky;
    sums[1] = scene_hash(&scene, &geometry, &camera, &emitters);
    sky.turn = 1;
    sums[2] = scene_hash(&scene, &geometry, &camera, &emitters);
    free(scene.textures);
    scene.textures = &texture;
    scene.texture_count = 1;
    sums[3] = scene_hash(&scene, &geometry, &camera, &emitters);
    texture.wrap_v = TEXTURE_WRAP_CLAMP;
    sums[4] = scene_hash(&scene, &geometry, &camera, &emitters);
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < i; k++)
            assert_true(sums[i] != sums[k]);
    struct stand_in stand_in;
    stand_in_init(&stand_in, &scene, &geometry);
    const struct bitmap *few = &stand_in.scene.textures[0].bitmap;
    printf("    a texture of 2x3 is stood in for by one of %dx%d\n", few->width, few->height);
    assert_true(few->width == 2 && few->height == 3);
    stand_in_free(&stand_in);
    scene.textures = NULL;
    scene.texture_count = 0;
}

/* Nodes that are flat in one way or another still look somewhere, across what they have left. */
TEST(flat_nodes) {
    static const float worlds[][16] = {
        {0},
        {[8] = 0, [9] = 0, [10] = 2},
        {[8] = 0, [9] = 3, [10] = 0, [5] = 1},
        {[4] = 1, [8] = 1},
        {[4] = 1e30F, [8] = 1e-38F},
    };
    for (size_t i = 0; i < sizeof worlds / sizeof *worlds; i++) {
        vec3 right, up, forward;
        node_frame(worlds[i], right, up, forward);
        check_vector("right, up, forward: lengths",
                     (float[]){glm_vec3_norm(right), glm_vec3_norm(up), glm_vec3_norm(forward)}, 1,
                     1, 1, 1e-6);
        check_vector("and products",
                     (float[]){glm_vec3_dot(right, up), glm_vec3_dot(up, forward),
                               glm_vec3_dot(forward, right)},
                     0, 0, 0, 1e-6);
    }
}

/* Lights are told apart by any part, and no more than there is room for shine at once. */
TEST(layouts) {
    enum { MANY = 200 };
    static struct emitter lights[MANY];
    struct emitters one = {.items = lights, .count = 1}, two = {.items = lights, .count = 2},
                    all = {.items = lights, .count = MANY};
    struct light_layout a, b;
    for (int i = 0; i < MANY; i++)
        lights[i] = emitter_new(EMITTER_POINT);
    check_ok("one", light_layout_of(&a, &one));
    check_ok("two", light_layout_of(&b, &two));
    assert_true(light_layouts_same(&a, &a) && !light_layouts_same(&a, &b));
    assert_true(emitters_same(&one, &one) && !emitters_same(&one, &two));
    check_refused(light_layout_of(&a, &all), "");
    light_layout_of(&a, &one);
    lights[0] = emitter_new(EMITTER_SPOT);
    light_layout_of(&b, &one);
    assert_false(light_layouts_same(&a, &b));
    lights[0].size[0] = 1;
    light_layout_of(&a, &one);
    assert_false(light_layouts_same(&a, &b));
    OWNED(emitters) copy = emitters_copy(&one);
    assert_true(emitters_same(&one, &copy));
    copy.items[0].position[0] = 1;
    assert_false(emitters_same(&one, &copy));
}

/* What is diffuse: no metal, rough all over, and reflecting as usual or not at all. */
TEST(matt) {
    const struct material usual = {.roughness = 1,
                                   .specular_f0 = {DIELECTRIC_F0, DIELECTRIC_F0, DIELECTRIC_F0},
                                   .specular_f90 = 1,
                                   .metal_roughness_texture = -1};
    struct material other = usual;
    assert_true(material_is_diffuse(&usual));
    other.metalness = .5F;
    assert_false(material_is_diffuse(&other));
    other = usual;
    other.roughness = .5F;
    assert_false(material_is_diffuse(&other));
    other = usual;
    other.metal_roughness_texture = 0;
    assert_false(material_is_diffuse(&other));
    other = usual;
    other.specular_f0[2] = .5F;
    assert_false(material_is_diffuse(&other));
    other = usual;
    other.specular_f90 = .5F;
    assert_false(material_is_diffuse(&other));
    other = (struct material){.roughness = .25F, .metal_roughness_texture = -1};
    assert_true(material_is_diffuse(&other)); /* it has no specular part, however smooth it is */
}

RUN_TESTS(be_quiet, NULL)
