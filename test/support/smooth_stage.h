/* Stages of a floor and a smooth object, lit by a spot, and what is seen there. */
#ifndef TEST_SMOOTH_STAGE_H
#define TEST_SMOOTH_STAGE_H

#include "render_support.h"

#include "gltf_parts.h"

#include <cglm/cglm.h>

#define CHEAP "vpls=64 rsm-size=64 "
#define PATCHES CHEAP "caustics.surface=patches caustics.size=64 "

enum { SIZE = 64, FLOOR = 0, SMOOTH = 1 }; /* pixels; materials */

/* Nodes of quads from 0 to 1 in x and y, which face +z; their material is the mesh's. The floor, 40
 * m wide, is z = 0. */
#define FLOOR_NODE "{mesh: 0, translation: [-20, -20, 0], scale: [40, 40, 1]}"

/* Squares at that z, as wide, which face up and down. */
#define UP_NODE "{mesh: 1, translation: [%g, %g, %g], scale: [%g, %g, 1]}"
#define DOWN_NODE "{mesh: 1, translation: [%g, %g, %g], rotation: [1, 0, 0, 0], scale: [%g, %g, 1]}"

static inline const char *square_node(const char *node, double z, double width) {
    bool is_down = strcmp(node, DOWN_NODE) == 0;
    return form(node, -width / 2, is_down ? width / 2 : -width / 2, z, width, width);
}

/* A light of 1 W/sr in z = 2 that shines down, and a camera that looks down from such a height. */
static inline void open_nodes(struct stage *stage, const char *nodes, float eye) {
    *stage = open_stage(write_parts(
        "caustics.glb",
        &PARTS(.nodes = form("[%s]", nodes),
               .materials = "[{pbrMetallicRoughness: {metallicFactor: 0}}, {pbrMetallicRoughness: "
                            "{metallicFactor: 0}}]",
               .meshes = "[{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 0}]}, "
                         "{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 1}]}]")));
    stage->camera = FILLED(camera, .eye = {0, 0, eye}, .right = {1, 0, 0}, .up = {0, 1, 0},
                           .forward = {0, 0, -1}, .fov_y = .05F);
    emitters_free(&stage->emitters);
    stage->emitters = (struct emitters){.items = mem_alloc(1, sizeof(struct emitter)), .count = 1};
    stage->emitters.items[0] = emitter_new(EMITTER_SPOT);
    stage->emitters.items[0].position[2] = 2;
    stage->emitters.items[0].cos_outer = cosf(1.2F);
    stage->emitters.items[0].cos_inner = cosf(1.1F);
    emitter_aim(&stage->emitters.items[0], (float[]){0, 0, -1});
}

static inline void make_mirror(struct stage *stage) {
    struct material *material = &stage->scene.materials[SMOOTH];
    material->metalness = 1;
    material->roughness = 0;
    for (int c = 0; c < 3; c++)
        material->base_color[c] = 1 - .2F * (float)c;
}

/* Panes lie behind all else. */
static inline void lay_out(struct stage *stage) {
    geometry_free(&stage->geometry);
    check_ok("geometry", geometry_init(&stage->geometry, &stage->scene, 0));
}

static inline void make_glass(struct stage *stage, float index) {
    struct material *material = &stage->scene.materials[SMOOTH];
    material->transmission = 1;
    material->index_of_refraction = index;
    material->roughness = 0;
    lay_out(stage);
}

struct square {
    const char *node; /* UP_NODE or DOWN_NODE */
    double z, width;
};

/* The floor and such squares. */
static inline void open_squares(struct stage *stage, const struct square *squares, int count,
                                float eye) {
    const char *nodes = FLOOR_NODE;
    for (int i = 0; i < count; i++)
        nodes = form("%s, %s", nodes, square_node(squares[i].node, squares[i].z, squares[i].width));
    open_nodes(stage, nodes, eye);
}

/* A mirror above the light, which shines up, and the eye. */
static inline void open_mirror(struct stage *stage, double width, float eye) {
    open_squares(stage, &(struct square){DOWN_NODE, 3, width}, 1, eye);
    make_mirror(stage);
    emitter_aim(&stage->emitters.items[0], (float[]){0, 0, 1});
}

/* A slab from z = .8 to 1 between light and eye. */
static inline void open_slab(struct stage *stage, float index, double width, float eye) {
    const struct square squares[] = {{UP_NODE, 1, width}, {DOWN_NODE, .8, width}};
    open_squares(stage, squares, 2, eye);
    make_glass(stage, index);
}

static inline double channel_mean(const struct image *image, const char *channel) {
    int c = image_find_channel(image, channel);
    double sum = 0;
    assert_true(c >= 0);
    for (int i = 0; i < image->width * image->height; i++)
        sum += (double)image_at(image, i % image->width, i / image->width)[c];
    return sum / image->width / image->height;
}

static inline double mean_of(const struct image *image, const char *layer) {
    char name[32];
    double sum = 0;
    for (int c = 0; c < 3; c++) {
        snprintf(name, sizeof name, "%s.%c", layer, "RGB"[c]);
        sum += channel_mean(image, name) / 3;
    }
    return sum;
}

static inline struct image draw(const struct stage *stage, const char *settings) {
    return render_stage(stage, "unshadowed", settings, SIZE);
}

#endif
