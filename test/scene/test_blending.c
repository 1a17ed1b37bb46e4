/* Materials that blend: opaque, masked or panes by their alphas, and what parts of panes
 * let pass. */
#define _XOPEN_SOURCE 700
#include "gltf_parts.h"
#include "tiny_png.h"

#include "scene/material.h"
#include "scene/mesh/geometry.h"
#include "scene/mesh/pane_triangles.h"

/* Sums area times what passes over parts left and right of x = .5, where alpha is .2 and .8. */
static void check_halves(const struct scene *scene) {
    OWNED(geometry) geometry;
    double area[2] = {0}, passes[2] = {0};
    check_ok("geometry", geometry_init(&geometry, scene, 0));
    struct triangle_parts parts = pane_triangles_of(scene, &geometry);
    for (uint32_t i = 0; i < parts.count; i++) {
        const struct bvh_triangle *part = &parts.items[i];
        vec3s middle = glms_vec3_muladds(part->edges[0], 1.F / 3, part->corner);
        middle = glms_vec3_muladds(part->edges[1], 1.F / 3, middle);
        double own = (double)glms_vec3_norm(glms_vec3_cross(part->edges[0], part->edges[1])) / 2;
        area[middle.x > .5F] += own;
        passes[middle.x > .5F] += own * (part->opaque[0] & 0xffff) / 65535;
    }
    printf("    %u parts\n", parts.count);
    check_near("area", area[0] + area[1], 1, 1e-5);
    check_near("left passes", passes[0], .5 * .8, .02);
    check_near("right passes", passes[1], .5 * .2, .02);
    free(parts.items);
}

/* Each part's share is much that at its corner, where alpha rises with x. */
static void check_ramp(const struct scene *scene) {
    OWNED(geometry) geometry;
    float worst = 0;
    check_ok("geometry", geometry_init(&geometry, scene, 0));
    struct triangle_parts parts = pane_triangles_of(scene, &geometry);
    for (uint32_t i = 0; i < parts.count; i++) {
        const struct bvh_triangle *part = &parts.items[i];
        float alpha = fminf(fmaxf((16 * part->corner.x - .5F) / 15, 0), 1);
        float passes = (float)(part->opaque[0] & 0xffff) / 65535;
        worst = fmaxf(worst, fabsf(passes - (1 - alpha)));
    }
    printf("    %u parts\n", parts.count);
    check_at_most("a part's share, off its corner's", (double)worst, .1);
    free(parts.items);
}

/* What blends is opaque where its alpha is 1, and what shines is a hole below half. Half and half
 * of .2 and .8 is a pane of two shares, of 0 and 1 a mask. */
TEST(blending) {
    static const float uvs[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    static const unsigned char alphas[2][2] = {{51, 204}, {0, 255}};
    unsigned char ramp[16 * 4];
    for (int i = 0; i < 64; i++)
        ramp[i] = (unsigned char)(i % 4 < 3 ? 255 : i / 4 * 17);
    write_tiny_png(scratch("ramp.png"), ramp, 16, 1);
    for (int t = 0; t < 2; t++) {
        unsigned char rgba[16 * 16 * 4];
        memset(rgba, 255, sizeof rgba);
        for (int i = 0; i < 256; i++)
            rgba[4 * i + 3] = alphas[t][i % 16 / 8];
        write_tiny_png(scratch(t ? "leaf.png" : "curtain.png"), rgba, 16, 16);
    }
    OWNED(scene) scene;
    const struct gltf_parts parts = {
        .accessors = PARTS_TEXTURED,
        .more = "images: [{uri: 'curtain.png'}, {uri: 'leaf.png'}, {uri: 'ramp.png'}], textures: "
                "[{source: 0}, {source: 1}, {source: 2, sampler: 0}], samplers: [{wrapS: 33071}],",
        .materials = "[{alphaMode: BLEND}, {alphaMode: BLEND, emissiveFactor: [1, 0, 0]}, "
                     "{alphaMode: BLEND, pbrMetallicRoughness: {baseColorTexture: {index: 0}}}, "
                     "{alphaMode: BLEND, pbrMetallicRoughness: {baseColorTexture: {index: 1}}}, "
                     "{pbrMetallicRoughness: {baseColorTexture: {index: 2}}}]",
        .meshes =
            "[{primitives: [{attributes: {POSITION: 0, TEXCOORD_0: 2}, indices: 1, material: 2}]}]",
        EXTRA(uvs)};
    check_ok("blend", load_parts(&scene, "blend.glb", &parts));
    const struct material *of = scene.materials;
    assert_false(of[0].blends || of[0].alpha_mask);
    assert_true(of[1].alpha_mask && !of[1].blends);
    assert_true(of[2].blends && !of[2].alpha_mask && material_is_pane(&of[2]));
    assert_true(of[3].blends && of[3].alpha_mask && !material_is_pane(&of[3]));
    check_halves(&scene);
    scene.materials[2].base_color_texture = 2;
    check_ramp(&scene);
}

RUN_TESTS(NULL, NULL)
