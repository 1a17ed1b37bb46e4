/* glTF files: each form of meshes, materials and nodes that the standard has. */
#define _XOPEN_SOURCE 700
#include "gltf_parts.h"

#include "scene/material.h"
#include "scene/mesh/geometry.h"

static struct scene load(const char *name, struct gltf_parts parts) {
    struct scene scene;
    check_ok(name, load_parts(&scene, name, &parts));
    return scene;
}

static const struct primitive *first_primitive(const struct scene *scene) {
    assert_true(scene->mesh_count > 0 && scene->meshes[0].primitive_count > 0);
    return &scene->meshes[0].primitives[0];
}

static void check_values(const char *what, const float *value, int n, const double *expected,
                         double tolerance) {
    for (int c = 0; c < n; c++)
        check_near(what, value[c], expected[c], tolerance);
}

TEST(quad) {
    OWNED(scene) scene = load("quad.glb", PARTS(0));
    const struct primitive *quad = first_primitive(&scene);
    assert_int_equal(quad->index_count, 6);
    assert_string_equal(scene.meshes[0].name, "quad");
    assert_string_equal(scene.nodes[0].name, "one");
    /* No normals in the file: flat ones, on vertices of each triangle's own. */
    assert_int_equal(quad->vertex_count, 6);
    for (int i = 0; i < 6; i++)
        check_values("normal", quad->normal[i], 3, (double[]){0, 0, 1}, 1e-7);
    assert_null(quad->uv[0]);
    assert_null(quad->color);
}

/* Colours of every component type; the first has all components 1/2 or as near as the type goes. */
TEST(component_types) {
    static const struct {
        int type;
        bool normalized;
        unsigned char bytes[4];
        double expected;
    } rows[] = {
        {5120, true, {64}, 64 / 127.},      {5120, true, {0x80}, -1},
        {5120, false, {0xFE}, -2},          {5121, true, {51}, .2},
        {5121, false, {200}, 200},          {5122, true, {0, 0x40}, 16384 / 32767.},
        {5122, true, {0, 0x80}, -1},        {5122, false, {0xFF, 0xFF}, -1},
        {5123, true, {0x33, 0x33}, .2},     {5123, false, {1, 1}, 257},
        {5125, false, {0, 0, 1, 0}, 65536}, {5126, false, {0, 0, 0xC0, 0x3E}, .375},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        size_t size = rows[i].type < 5122 ? 1 : rows[i].type < 5125 ? 2 : 4;
        unsigned char extra[64] = {0};
        for (int k = 0; k < 16; k++)
            memcpy(extra + (size_t)k * size, rows[i].bytes, size);
        const char *accessors =
            form("[{bufferView: 0, componentType: 5126, count: 4, type: VEC3}, {bufferView: 0, "
                 "byteOffset: 64, componentType: %d, count: 4, normalized: %s, type: VEC4}]",
                 rows[i].type, rows[i].normalized ? "true" : "false");
        OWNED(scene) scene = load(
            "component.glb",
            PARTS(.accessors = accessors,
                  .meshes = "[{primitives: [{attributes: {POSITION: 0, COLOR_0: 1}, mode: 5}]}]",
                  EXTRA(extra)));
        const char *what = form("component type %d", rows[i].type);
        check_near(what, first_primitive(&scene)->color[0][3], rows[i].expected, 1e-7);
    }
}

TEST(index_types) {
    static const unsigned char bytes[] = {0, 1, 2, 0, 0, 0, 0, 0};
    static const uint16_t shorts[] = {0, 1, 2};
    static const uint32_t words[] = {0, 1, 2};
    const void *const extras[] = {bytes, shorts, words};
    static const int types[] = {5121, 5123, 5125};
    for (int i = 0; i < 3; i++) {
        const char *accessors =
            form("[{bufferView: 0, componentType: 5126, count: 4, type: VEC3}, {bufferView: 0, "
                 "byteOffset: 64, componentType: %d, count: 3, type: SCALAR}]",
                 types[i]);
        OWNED(scene) scene = load(
            "index.glb", PARTS(.accessors = accessors, .extra = extras[i], .extra_size = 3u << i));
        const struct primitive *triangle = first_primitive(&scene);
        assert_int_equal(triangle->index_count, 3);
        check_values("corner", triangle->position[triangle->indices[2]], 3, (double[]){1, 1, 0}, 0);
    }
}

/* Positions of a triangle's corners, "x y" each, in the order of its winding from corner 0. */
static void check_triangle(const struct primitive *primitive, int triangle, const int corners[3]) {
    static const double quad[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (int i = 0; i < 3; i++)
        check_values("corner", primitive->position[primitive->indices[triangle * 3 + i]], 3,
                     quad[corners[i]], 0);
}

TEST(strip_and_fan) {
    struct scene scene = load(
        "strip.glb", PARTS(.meshes = "[{primitives: [{attributes: {POSITION: 0}, mode: 5}]}]"));
    assert_int_equal(first_primitive(&scene)->index_count, 6);
    check_triangle(first_primitive(&scene), 0, (int[]){0, 1, 2});
    check_triangle(first_primitive(&scene), 1, (int[]){1, 3, 2});
    scene_free(&scene);
    scene =
        load("fan.glb", PARTS(.meshes = "[{primitives: [{attributes: {POSITION: 0}, mode: 6}]}]"));
    assert_int_equal(first_primitive(&scene)->index_count, 6);
    check_triangle(first_primitive(&scene), 0, (int[]){1, 2, 0});
    check_triangle(first_primitive(&scene), 1, (int[]){2, 3, 0});
    scene_free(&scene);
}

/* Lines beside triangles are left out; a mesh of lines alone is empty. */
TEST(lines_are_ignored) {
    struct scene scene =
        load("lines.glb", PARTS(.meshes = "[{primitives: [{attributes: {POSITION: 0}, mode: 1}, "
                                          "{attributes: {POSITION: 0}, indices: 1}]}]"));
    assert_int_equal(scene.meshes[0].primitive_count, 1);
    assert_int_equal(first_primitive(&scene)->index_count, 6);
    scene_free(&scene);
}

TEST(stride_and_sparse) {
    /* Normals with a stride of 16, of which the sparse part replaces the third. */
    struct {
        float normal[4][4];
        uint16_t index, padding;
        float value[3];
    } extra = {
        .normal = {{0, 0, 2}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, .index = 2, .value = {3, 0, 4}};
    OWNED(scene) scene =
        load("sparse.glb",
             PARTS(.views = "[{buffer: 0, byteLength: 320}, {buffer: 0, byteOffset: 64, "
                            "byteLength: 64, byteStride: 16}]",
                   .accessors = "[" PARTS_QUAD
                                ", {bufferView: 1, componentType: 5126, count: 4, type: VEC3, "
                                "sparse: {count: 1, indices: {bufferView: 0, byteOffset: 128, "
                                "componentType: 5123}, values: {bufferView: 0, byteOffset: 132}}}]",
                   .meshes = "[{primitives: [{attributes: {POSITION: 0, NORMAL: 2}, indices: 1}]}]",
                   EXTRA(extra)));
    const struct primitive *quad = first_primitive(&scene);
    assert_int_equal(quad->vertex_count, 4);
    check_values("normal", quad->normal[0], 3, (double[]){0, 0, 1}, 1e-7);
    check_values("normal", quad->normal[2], 3, (double[]){.6, 0, .8}, 1e-7);
}

/* Zero and NaN normals, and triangles without area: all end in finite unit normals. */
TEST(hopeless_normals) {
    static const float normals[4][3] = {{0, 0, 0}, {NAN, 0, 0}, {0, INFINITY, 0}, {0, 1e-20F, 0}};
    static const struct gltf_parts parts[] = {
        {.accessors = PARTS_OWN_NORMALS,
         .meshes = "[{primitives: [{attributes: {POSITION: 0, NORMAL: 2}, indices: 1}]}]",
         EXTRA(normals)},
        {.accessors =
             "[{bufferView: 0, byteOffset: 96, componentType: 5126, count: 4, type: VEC3}, "
             "{bufferView: 0, byteOffset: 48, componentType: 5123, count: 6, type: SCALAR}]"},
    };
    for (int i = 0; i < 2; i++) {
        OWNED(scene) scene = load("normals.glb", parts[i]);
        const struct primitive *primitive = first_primitive(&scene);
        for (int v = 0; v < primitive->vertex_count; v++)
            check_values("normal", primitive->normal[v], 3,
                         i == 0 ? (double[]){0, 0, 1} : (double[]){0, 1, 0}, 1e-7);
    }
}

/* A 2x1 PNG: red and green. */
static size_t make_png(unsigned char *bytes, size_t size) {
    const char *path = scratch("texture.png");
    unsigned char pixels[] = {255, 0, 0, 255, 0, 255, 0, 255};
    check_ok("png", bitmap_write(&(struct bitmap){2, 1, pixels}, path));
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t got = fread(bytes, 1, size, file);
    fclose(file);
    assert_true(got < size);
    return got;
}

TEST(texture) {
    static const float uvs[4][2] = {{0, 0}, {1, 0}, {1, 1}, {.25F, .5F}};
    unsigned char png[4096];
    make_png(png, sizeof png);
    OWNED(scene) scene = load(
        "textured.glb",
        PARTS(.accessors = PARTS_TEXTURED,
              .more = "images: [{uri: 'texture%2Epng'}], samplers: [{wrapS: 33071, wrapT: 33648, "
                      "magFilter: 9728}], textures: [{source: 0, sampler: 0}], extensionsRequired: "
                      "[KHR_texture_transform],",
              .materials =
                  "[{alphaMode: MASK, alphaCutoff: 0.25, doubleSided: true, pbrMetallicRoughness: "
                  "{baseColorFactor: [0.5, 0.25, 1, 0.75], baseColorTexture: {index: 0, texCoord: "
                  "7, extensions: {KHR_texture_transform: {offset: [10, 20], rotation: "
                  "0.5235987756, scale: [2, 4], texCoord: 1}}}}}, {pbrMetallicRoughness: "
                  "{baseColorTexture: {index: 0}}}]",
              .meshes = "[{primitives: [{attributes: {POSITION: 0, TEXCOORD_1: 2}, indices: 1, "
                        "material: 0}]}]",
              EXTRA(uvs)));
    const struct material *material = &scene.materials[0];
    check_values("base colour", material->base_color, 4, (double[]){.5, .25, 1, .75}, 0);
    assert_true(material->alpha_mask && material->double_sided &&
                material->base_color_texture == 0);
    check_near("cutoff", material->alpha_cutoff, .25, 0);
    /* The second material shares the first one's texture. */
    assert_int_equal(scene.texture_count, 1);
    assert_int_equal(scene.materials[1].base_color_texture, 0);
    const struct scene_texture *texture = &scene.textures[0];
    assert_int_equal(texture->bitmap.width, 2);
    assert_int_equal(texture->bitmap.rgba[5], 255);
    assert_int_equal(texture->wrap_u, TEXTURE_WRAP_CLAMP);
    assert_int_equal(texture->wrap_v, TEXTURE_WRAP_MIRROR);
    assert_true(texture->nearest);
    /* Scaled, turned by 30 degrees counter-clockwise with v downward, and moved. */
    const struct primitive *quad = first_primitive(&scene);
    double u = 2 * .25, v = 4 * .5, c = cos(M_PI / 6), s = sin(M_PI / 6);
    check_values("uv", quad->uv[0][5], 2, (double[]){c * u + s * v + 10, c * v - s * u + 20}, 1e-5);
}

/* The same picture in a buffer view, unaligned. */
TEST(embedded_texture) {
    unsigned char extra[256] = {0};
    size_t size = make_png(extra + 33, sizeof extra - 33);
    const char *views =
        form("[{buffer: 0, byteLength: 320}, {buffer: 0, byteOffset: 97, byteLength: %zu}]", size);
    OWNED(scene) scene = load(
        "embedded.glb",
        PARTS(.views = views, .accessors = PARTS_TEXTURED,
              .more = "images: [{bufferView: 1, mimeType: 'image/png'}], textures: [{source: 0}],",
              .materials = "[{pbrMetallicRoughness: {baseColorTexture: {index: 0}}}]",
              .meshes = "[{primitives: [{attributes: {POSITION: 0, TEXCOORD_0: 2}, indices: 1, "
                        "material: 0}]}]",
              EXTRA(extra)));
    assert_int_equal(scene.textures[0].bitmap.width, 2);
    assert_int_equal(scene.textures[0].wrap_u, TEXTURE_WRAP_REPEAT);
    assert_false(scene.textures[0].nearest);
    assert_non_null(first_primitive(&scene)->uv[0]);
}

/* A red WebP of 8 x 8, which an extension names. */
TEST(webp) {
    static const unsigned char webp[] = {
        0x52, 0x49, 0x46, 0x46, 0x44, 0,    0,    0,    0x57, 0x45, 0x42, 0x50, 0x56,
        0x50, 0x38, 0x20, 0x38, 0,    0,    0,    0x50, 2,    0,    0x9d, 1,    0x2a,
        8,    0,    8,    0,    0,    0,    0,    0x25, 0xa0, 2,    0x74, 0xba, 1,
        0xf8, 1,    0xfa, 1,    0xfc, 0,    7,    0x90, 0,    0xfe, 0xff, 0x6f, 0x56,
        0xff, 0xfc, 0xb0, 0xfc, 0x7f, 0x52, 0x79, 0xff, 0xcb, 0x10, 0xff, 0xff, 0x13,
        0xd3, 0x9b, 0xc4, 0x54, 0xf2, 0xbf, 0xfe, 0x26, 0x40, 0,    0};
    OWNED(scene) scene = load(
        "webp.glb",
        PARTS(.views =
                  "[{buffer: 0, byteLength: 320}, {buffer: 0, byteOffset: 64, byteLength: 76}]",
              .more = "extensionsRequired: [EXT_texture_webp], images: [{bufferView: 1, mimeType: "
                      "'image/webp'}], textures: [{extensions: {EXT_texture_webp: {source: 0}}}],",
              .materials = "[{pbrMetallicRoughness: {baseColorTexture: {index: 0}}}]",
              EXTRA(webp)));
    assert_int_equal(scene.textures[0].bitmap.width, 8);
    check_near("red", scene.textures[0].bitmap.rgba[0], 255, 4);
    check_near("green", scene.textures[0].bitmap.rgba[1], 0, 4);
}

/* All that a material says. The first one's roughness lies where its colour does, its glow has a
 * mapping of its own; numbers are not colours, though they are the same picture. */
TEST(materials) {
    unsigned char png[4096];
    make_png(png, sizeof png);
    OWNED(scene) scene = load(
        "materials.glb",
        PARTS(.more = "images: [{uri: 'texture.png'}], textures: [{source: 0}], "
                      "extensionsRequired: [KHR_materials_emissive_strength],",
              .materials =
                  "[{pbrMetallicRoughness: {metallicFactor: 0.25, roughnessFactor: 0.75, "
                  "baseColorTexture: {index: 0}, metallicRoughnessTexture: {index: 0}}, "
                  "emissiveTexture: {index: 0, texCoord: 1}}, {emissiveFactor: [1, 0.5, 0.25], "
                  "emissiveTexture: {index: 0}, normalTexture: {index: 0, scale: 0.5}, extensions: "
                  "{KHR_materials_emissive_strength: {emissiveStrength: 20}, KHR_materials_ior: "
                  "{ior: 2}, KHR_materials_specular: {specularFactor: 0.5, specularColorFactor: "
                  "[0.9, 18, 0]}}}, {pbrMetallicRoughness: {metallicFactor: 0}, extensions: "
                  "{KHR_materials_transmission: {transmissionFactor: 0.75}, KHR_materials_ior: "
                  "{ior: 1.25}, KHR_materials_volume: {thicknessFactor: 0.1, attenuationDistance: "
                  "2, attenuationColor: [1, 0.5, 0.25]}}}, {extensions: "
                  "{KHR_materials_transmission: {transmissionFactor: 0.5}}}, {extensions: "
                  "{KHR_materials_unlit: {}}}]"));
    const struct material *plain = &scene.materials[0], *lamp = &scene.materials[1];
    check_near("metalness", plain->metalness, .25, 0);
    check_near("roughness", plain->roughness, .75, 0);
    check_values("emission of none", plain->emission, 3, (double[]){0, 0, 0}, 0);
    check_values("emission", lamp->emission, 3, (double[]){20, 10, 5}, 0);
    assert_int_equal(plain->base_color_texture, 0);
    assert_int_equal(plain->metal_roughness_texture, 1);
    assert_int_equal(plain->emission_texture, 0);
    assert_true(plain->metal_roughness_mapping == 0 && plain->emission_mapping == 1);
    assert_true(lamp->emission_mapping == 0 && lamp->normal_mapping == 0);
    assert_int_equal(lamp->base_color_texture, -1);
    assert_int_equal(lamp->metal_roughness_texture, -1);
    assert_int_equal(lamp->emission_texture, 0);
    assert_int_equal(lamp->normal_texture, 1);
    check_near("scale of normals", lamp->normal_scale, .5, 0);
    check_values("reflectance", lamp->specular_f0, 3, (double[]){.05, .5, 0}, 1e-7);
    check_near("grazing", lamp->specular_f90, .5, 0);
    assert_true(scene.materials[4].unlit && !lamp->unlit);
    const struct material *glass = &scene.materials[2], *pane = &scene.materials[3];
    check_near("transmission", glass->transmission, .75, 0);
    check_values("absorption", glass->absorption, 3, (double[]){0, log(2) / 2, log(2)}, 1e-6);
    assert_true(!glass->thin_walled && pane->thin_walled && glass->index_of_refraction == 1.25F &&
                material_smooth_kind(glass) == SMOOTH_GLASS &&
                material_smooth_kind(pane) == SMOOTH_NONE);
    assert_int_equal(plain->normal_texture, -1);
    check_near("plain reflectance", plain->specular_f0[0], .04, 1e-8);
    check_near("plain, grazing", plain->specular_f90, 1, 0);
    assert_int_equal(scene.texture_count, 2);
    assert_false(scene.textures[0].linear);
    assert_true(scene.textures[1].linear);
    assert_int_equal(scene.textures[1].bitmap.rgba[5], 255);
    /* One that says nothing, and the one for primitives without. */
    for (int i = 3; i < 5; i++) {
        check_near("metalness by default", scene.materials[i].metalness, 1, 0);
        check_near("roughness by default", scene.materials[i].roughness, 1, 0);
        assert_int_equal(scene.materials[i].emission_texture, -1);
    }
}

/* All that is dropped is said in one note, each thing once; and nothing of what is read. */
TEST(lacks) {
    unsigned char png[4096];
    make_png(png, sizeof png);
    hear_notes();
    OWNED(scene) scene = load(
        "lacks.glb",
        PARTS(.more = "extensionsRequired: [KHR_materials_unlit], extensionsUsed: "
                      "[KHR_lights_punctual, KHR_materials_unlit, KHR_materials_clearcoat, "
                      "EXT_new], images: [{uri: 'texture.png'}], textures: [{source: 0}],",
              .materials = "[{normalTexture: {index: 0}, alphaMode: BLEND, emissiveFactor: [1, 1, "
                           "1], extensions: {KHR_materials_specular: {specularTexture: {index: "
                           "0}}}}, {normalTexture: {index: 0}, occlusionTexture: {index: 0}}]",
              .meshes = "[{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 1, "
                        "targets: [{POSITION: 0, COLOR_0: 0}, {TEXCOORD_0: 0}]}]}]"));
    static const char *const each[] = {"clear coat", "EXT_new",      "blending",
                                       "occlusion",  "morph target", "textures of specular"};
    printf("    %s", notes);
    for (size_t i = 0; i < sizeof each / sizeof *each; i++) {
        const char *found = strstr(notes, each[i]);
        assert_non_null(found);
        assert_null(strstr(found + 1, each[i]));
    }
    assert_null(strstr(notes, "punctual"));
    assert_null(strstr(notes, "unlit"));
    assert_null(strstr(notes, "normal"));
    assert_ptr_equal(strchr(notes, '\n'), notes + strlen(notes) - 1);
    scene_free(&scene);
    *notes = '\0';
    scene = load("plain.glb", PARTS(.materials = "[{pbrMetallicRoughness: {metallicFactor: 0}}]"));
    assert_string_equal(notes, "");
    assert_true(material_is_diffuse(&scene.materials[0]) &&
                !material_is_diffuse(&scene.materials[1]));
    end_notes();
}

/* The older model of materials: diffuse colour, reflectance, and glossiness; its second texture has
 * both. What is left out of it is white and smooth, and hardly any reflectance has none when
 * grazing, too. */
TEST(specular_glossiness) {
    unsigned char png[4096];
    make_png(png, sizeof png);
    OWNED(scene) scene =
        load("glossiness.glb",
             PARTS(.more = "images: [{uri: 'texture.png'}], textures: [{source: 0}], "
                           "extensionsRequired: [KHR_materials_pbrSpecularGlossiness],",
                   .materials = "[{extensions: {KHR_materials_pbrSpecularGlossiness: "
                                "{diffuseFactor: [0.5, 0.25, 1, 0.75], glossinessFactor: 0.25, "
                                "specularFactor: [0, 0.01, 0.005], diffuseTexture: {index: 0}}}}, "
                                "{extensions: {KHR_materials_pbrSpecularGlossiness: "
                                "{specularGlossinessTexture: {index: 0, texCoord: 1}}}}]"));
    const struct material *material = &scene.materials[0], *textured = &scene.materials[1];
    check_values("base colour", material->base_color, 4, (double[]){.5, .25, 1, .75}, 0);
    assert_int_equal(material->base_color_texture, 0);
    check_near("metalness", material->metalness, 0, 0);
    check_near("roughness", material->roughness, .75, 0);
    check_values("reflectance", material->specular_f0, 3, (double[]){0, .01, .005}, 1e-8);
    check_near("grazing", material->specular_f90, .5, 1e-6);
    assert_false(material_is_diffuse(material));
    check_values("reflectance by default", textured->specular_f0, 3, (double[]){1, 1, 1}, 0);
    check_near("roughness by default", textured->roughness, 0, 0);
    assert_true(textured->specular_glossiness);
    assert_false(scene.textures[textured->metal_roughness_texture].linear);
    struct reflectance at = material_reflectance_at(textured, (vec4s){{.5F, .25F, 0, .25F}});
    check_values("reflectance there", at.f0.raw, 3, (double[]){.5, .25, 0}, 0);
    check_near("roughness there", at.roughness, .75, 0);
    check_near("metalness there", at.metalness, 0, 0);
}

/* A matrix and the TRS it is made of place the quad alike; children come after their parents. */
TEST(nodes) {
    /* 90 degrees about z, scaled by 2 along x, then moved. */
    OWNED(scene) scene =
        load("nodes.glb",
             PARTS(.nodes = "[{name: child, mesh: 0, translation: [5, 6, 7]}, {name: trs, "
                            "children: [0], translation: [1, 2, 3], rotation: [0, 0, 0.70710678, "
                            "0.70710678], scale: [2, 1, 1]}, {name: matrix, matrix: [0,2,0,0, "
                            "-1,0,0,0, 0,0,1,0, 1,2,3,1], mesh: 0}, {name: unused}]",
                   .more = "scenes: [{nodes: []}, {nodes: [1, 2]}], scene: 1,"));
    assert_int_equal(scene.node_count, 3);
    assert_string_equal(scene.nodes[0].name, "trs");
    assert_string_equal(scene.nodes[1].name, "child");
    assert_string_equal(scene.nodes[2].name, "matrix");
    assert_int_equal(scene.nodes[1].parent, 0);
    float worlds[3][16];
    scene_node_worlds(&scene, 0, worlds);
    for (int i = 0; i < 16; i++)
        check_near("trs against matrix", worlds[0][i], worlds[2][i], 1e-6);
    /* (5, 6, 7) scaled, turned, moved. */
    check_values("child", &worlds[1][12], 3, (double[]){1 - 6, 2 + 10, 3 + 7}, 1e-5);
}

/* Three quads by instancing, below their node, with its child once: places, turns as
 * shorts, sizes. */
TEST(instances) {
    struct {
        float places[3][3], sizes[3][3];
        int16_t turns[3][4];
    } extra = {
        {{0, 0, 0}, {10, 0, 0}, {0, 20, 0}},
        {{1, 1, 1}, {2, 1, 1}, {1, 1, 1}},
        {{0, 0, 0, 32767}, {0, 0, 0, 32767}, {0, 0, 23170, 23170}},
    };
    OWNED(scene) scene =
        load("instances.glb",
             PARTS(.accessors = "[" PARTS_QUAD
                                ", {bufferView: 0, byteOffset: 64, componentType: 5126, count: 3, "
                                "type: VEC3}, {bufferView: 0, byteOffset: 100, componentType: "
                                "5126, count: 3, type: VEC3}, {bufferView: 0, byteOffset: 136, "
                                "componentType: 5122, count: 3, normalized: true, type: VEC4}]",
                   .more = "extensionsRequired: [EXT_mesh_gpu_instancing],",
                   .nodes = "[{mesh: 0, children: [1], translation: [0, 0, 5], extensions: "
                            "{EXT_mesh_gpu_instancing: {attributes: {TRANSLATION: 2, SCALE: 3, "
                            "ROTATION: 4, _ID: 2}}}}, {mesh: 0}]",
                   EXTRA(extra)));
    OWNED(geometry) geometry;
    check_ok("geometry", geometry_init(&geometry, &scene, 0));
    assert_int_equal(scene.node_count, 5);
    assert_int_equal(geometry.part_count, 4);
    check_values("least", geometry.bounds_min, 3, (double[]){-1, 0, 5}, 1e-4);
    check_values("greatest", geometry.bounds_max, 3, (double[]){12, 21, 5}, 1e-4);
}

/* Deep chains are no recursion. */
TEST(deep_chain) {
    enum { DEPTH = 20000 };
    char *text = mem_alloc(DEPTH * 64, 1), *end = text;
    end +=
        sprintf(end, "{asset: {version: '2.0'}, accessors: [{componentType: 5126, count: 3, type: "
                     "VEC3}], meshes: [{primitives: [{attributes: {POSITION: 0}}]}], nodes: [");
    for (int i = 0; i < DEPTH; i++)
        end += sprintf(end, "{children: [%d], translation: [0, 1, 0]},", i + 1);
    end += sprintf(end, "{mesh: 0}]}");
    const char *path = scratch("chain.gltf");
    write_json(path, text);
    OWNED(scene) scene;
    OWNED(geometry) geometry;
    check_ok("load", scene_load(&scene, path));
    check_ok("geometry", geometry_init(&geometry, &scene, 0));
    check_near("height", geometry.center[1], DEPTH, 0);
    check_at_most("a point's radius is above 0", 1e-9, geometry.radius);
    free(text);
}

RUN_TESTS(be_quiet, NULL)
