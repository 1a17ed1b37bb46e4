/* Each texture of a material lies by its own TEXCOORD and KHR_texture_transform, for the renderer
 * and for the path tracer; textures that are left out scale their factors by their mean. */
#include "gltf_parts.h"
#include "render_support.h"
#include "tiny_png.h"

#include "scene/hash.h"
#include "scene/material.h"
#include "scene/texture.h"

#include <cglm/cglm.h>

enum { SIZE = 40, QUARTERS = 4 };

/* A square before the camera, lit so that white reflects 1. Of a texture of 2 x 2 texels the first
 * one covers another quarter by each set: the upper left, the upper right, the lower left, the
 * lower right. */
static const float sets[4][4][2] = {{{0, 1}, {1, 1}, {1, 0}, {0, 0}},
                                    {{1, 1}, {0, 1}, {0, 0}, {1, 0}},
                                    {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                                    {{1, 0}, {0, 0}, {0, 1}, {1, 1}}};

#define ACCESSOR(at, count, kind, type)                                                            \
    "{bufferView: 0, byteOffset: " #at ", componentType: " #kind ", count: " #count                \
    ", type: '" type "'}"

#define UVS(at) ACCESSOR(at, 4, 5126, "VEC2")

static const char accessors[] = "[" ACCESSOR(0, 4, 5126, "VEC3") "," ACCESSOR(
    48, 6, 5123, "SCALAR") "," UVS(64) "," UVS(96) "," UVS(128) "," UVS(160) "]";

/* The textures, by their numbers: all white; the first texel white, the others black; the first
 * rough metal, the others rough; a hole in the first; normals that lean along X, and along Y; the
 * first without reflectance, the others with one of a half, all rough. Then two as the second,
 * clamped and mirrored, and two of codes of sRGB. */
static const unsigned char texels[][2][4] = {
    {{255, 255, 255, 255}, {255, 255, 255, 255}}, {{255, 255, 255, 255}, {0, 0, 0, 0}},
    {{0, 255, 255, 255}, {0, 255, 0, 255}},       {{255, 255, 255, 0}, {255, 255, 255, 255}},
    {{218, 128, 218, 255}, {218, 128, 218, 255}}, {{128, 218, 218, 255}, {128, 218, 218, 255}},
    {{0, 0, 0, 0}, {188, 188, 188, 0}},           {{5, 15, 24, 255}, {64, 96, 188, 255}},
    {{1, 10, 32, 255}, {40, 128, 250, 255}}};

static const char textures[] =
    "images: [{uri: '0.png'}, {uri: '1.png'}, {uri: '2.png'}, {uri: '3.png'}, {uri: '4.png'}, "
    "{uri: '5.png'}, {uri: '6.png'}, {uri: '7.png'}, {uri: '8.png'}], samplers: [{magFilter: "
    "9728}, {magFilter: 9728, wrapS: 33071}, {magFilter: 9728, wrapS: 33648}], textures: [{source: "
    "0, sampler: 0}, {source: 1, sampler: 0}, {source: 2, sampler: 0}, {source: 3, sampler: 0}, "
    "{source: 4, sampler: 0}, {source: 5, sampler: 0}, {source: 6, sampler: 0}, {source: 1, "
    "sampler: 1}, {source: 1, sampler: 2}, {source: 7, sampler: 0}, {source: 8, sampler: 0}],";

static const char *write_square(const char *material) {
    static char more[4096], name[32];
    static int count;
    for (size_t i = 0; i < sizeof texels / sizeof *texels; i++) {
        unsigned char rgba[QUARTERS][4];
        for (int k = 0; k < QUARTERS; k++)
            memcpy(rgba[k], texels[i][k > 0], sizeof rgba[k]);
        snprintf(name, sizeof name, "%zu.png", i);
        write_tiny_png(scratch(name), rgba[0], 2, 2);
    }
    snprintf(more, sizeof more,
             "%s cameras: [{type: orthographic, orthographic: {xmag: 0.5, ymag: 0.5, znear: 0.1, "
             "zfar: 10}}], extensions: {KHR_lights_punctual: {lights: [{type: directional, "
             "intensity: 3.14159265}]}},",
             textures);
    const char *materials = form("[%s]", material);
    snprintf(name, sizeof name, "square%d.glb", count++);
    return write_parts(
        name,
        &PARTS(.more = more, .accessors = accessors, .materials = materials,
               .meshes = "[{primitives: [{attributes: {POSITION: 0, TEXCOORD_0: 2, TEXCOORD_1: 3, "
                         "TEXCOORD_2: 4, TEXCOORD_3: 5}, indices: 1, material: 0}]}]",
               .nodes = "[{mesh: 0}, {camera: 0, translation: [0.5, 0.5, 3]}, {extensions: "
                        "{KHR_lights_punctual: {light: 0}}}]",
               EXTRA(sets)));
}

struct pictures {
    struct image drawn, traced;
};

static void make_pictures(const char *path, struct pictures *pictures) {
    OWNED(stage) stage = open_stage(path);
    pictures->drawn = render_stage(&stage, "clustered", "", SIZE);
    pictures->traced =
        TRACE(&stage, .width = SIZE, .height = SIZE, .samples = 4, .bounces = 1, .centers = true);
}

static void free_pictures(struct pictures *pictures) {
    images_free(&pictures->drawn, &pictures->traced);
}

static double value_at(const struct image *image, const char *channel, int quarter) {
    int number = image_find_channel(image, channel);
    assert_true(number >= 0);
    return (double)image_at(image, SIZE / 4 + quarter % 2 * SIZE / 2,
                            SIZE / 4 + quarter / 2 * SIZE / 2)[number];
}

static void check_quarters(const char *what, const struct pictures *pictures, const char *channel,
                           const double expected[QUARTERS]) {
    double drawn = 0, traced = 0;
    for (int q = 0; q < QUARTERS; q++) {
        drawn = fmax(drawn, fabs(value_at(&pictures->drawn, channel, q) - expected[q]));
        traced = fmax(traced, fabs(value_at(&pictures->traced, channel, q) - expected[q]));
    }
    printf("    %s: %s apart, drawn %.4f, traced %.4f\n", what, channel, drawn, traced);
    check_at_most(what, fmax(drawn, traced), .02);
}

struct row {
    const char *what, *material, *channel;
    double expected[QUARTERS];
};

static void check_rows(const struct row *rows, size_t count) {
    for (size_t i = 0; i < count; i++) {
        struct pictures pictures;
        make_pictures(write_square(rows[i].material), &pictures);
        check_quarters(rows[i].what, &pictures, rows[i].channel, rows[i].expected);
        free_pictures(&pictures);
    }
}

#define BASE                                                                                       \
    "pbrMetallicRoughness: {metallicFactor: 0, baseColorFactor: [0.5, 0.5, 0.5, 1], "              \
    "baseColorTexture: {index: 0}}"
#define GLOW "{" BASE ", emissiveFactor: [1, 1, 1], emissiveTexture: {"
#define TRANSFORM "extensions: {KHR_texture_transform: {"

/* Half of the light, and where the glow lies its own. */
TEST(emission) {
    static const struct row rows[] = {
        {"set 1", GLOW "index: 1, texCoord: 1}}", "R", {.5, 1.5, .5, .5}},
        {"set 2", GLOW "index: 1, texCoord: 2}}", "R", {.5, .5, 1.5, .5}},
        {"set of the transform",
         GLOW "index: 1, " TRANSFORM "texCoord: 3}}}}",
         "R",
         {.5, .5, .5, 1.5}},
        {"offset", GLOW "index: 1, " TRANSFORM "offset: [0.5, 0]}}}}", "R", {.5, 1.5, .5, .5}},
        {"rotation", GLOW "index: 1, " TRANSFORM "rotation: 1.5707963}}}}", "R", {.5, 1.5, .5, .5}},
        {"repeated",
         GLOW "index: 1, " TRANSFORM "scale: [2, 1], offset: [-0.75, 0]}}}}",
         "R",
         {.5, .5, .5, .5}},
        {"clamped",
         GLOW "index: 7, " TRANSFORM "scale: [2, 1], offset: [-0.75, 0]}}}}",
         "R",
         {1.5, .5, .5, .5}},
        {"mirrored",
         GLOW "index: 8, " TRANSFORM "scale: [2, 1], offset: [-1.25, 0]}}}}",
         "R",
         {.5, 1.5, .5, .5}},
    };
    check_rows(rows, sizeof rows / sizeof *rows);
}

/* .955 is what a surface of the standard's reflectance lets through. */
#define METAL(base, more)                                                                          \
    "{pbrMetallicRoughness: {baseColorFactor: [0.5, 0.5, 0.5, 1], " base                           \
    " metallicRoughnessTexture: {index: 2, " more "}}}"

TEST(metal) {
    static const struct row rows[] = {
        {"set 2",
         METAL("baseColorTexture: {index: 0},", "texCoord: 2"),
         "albedo.R",
         {.4775, .4775, 0, .4775}},
        {"alone, set 3", METAL("", "texCoord: 3"), "albedo.R", {.4775, .4775, .4775, 0}},
        {"offset",
         METAL("baseColorTexture: {index: 0},", TRANSFORM "offset: [0.5, 0.5]}}"),
         "albedo.R",
         {.4775, .4775, .4775, 0}},
        {"under a mask by set 1",
         "{alphaMode: MASK, pbrMetallicRoughness: {baseColorFactor: [0.5, 0.5, 0.5, 1], "
         "baseColorTexture: {index: 3, texCoord: 1}, metallicRoughnessTexture: {index: 2}}}",
         "albedo.R",
         {0, 0, .4775, .4775}},
    };
    check_rows(rows, sizeof rows / sizeof *rows);
}

/* Along X of its own mapping. */
TEST(normals) {
    static const struct row rows[] = {
        {"set 1",
         "{" BASE ", normalTexture: {index: 4, texCoord: 1}}",
         "normal.X",
         {-.707, -.707, -.707, -.707}},
        {"set 0", "{" BASE ", normalTexture: {index: 4}}", "normal.X", {.707, .707, .707, .707}},
        {"rotated",
         "{" BASE ", normalTexture: {index: 4, " TRANSFORM "rotation: 1.5707963}}}}",
         "normal.Y",
         {-.707, -.707, -.707, -.707}},
        {"rotated, along Y",
         "{" BASE ", normalTexture: {index: 5, " TRANSFORM "rotation: 1.5707963}}}}",
         "normal.X",
         {.707, .707, .707, .707}},
        {"upside down, along Y",
         "{" BASE ", normalTexture: {index: 5, texCoord: 2}}",
         "normal.Y",
         {-.707, -.707, -.707, -.707}},
    };
    check_rows(rows, sizeof rows / sizeof *rows);
}

/* Samples of a pixel lie on its triangle, however far a map bends its normal: none is an edge. */
TEST(samples_of_bent_normals) {
    static GLuint assigned[SIZE][SIZE][2];
    OWNED(stage) stage = open_stage(write_square("{" BASE ", normalTexture: {index: 4}}"));
    OWNED(renderer) renderer;
    open_renderer(&renderer, desc_of(&stage, "clustered", "samples=8", SIZE, SIZE));
    gl.GetTextureImage(renderer.antialias.assignment.id, 0, GL_RG_INTEGER, GL_UNSIGNED_INT,
                       sizeof assigned, assigned);
    int edges = 0;
    for (int i = 0; i < (SIZE - 2) * (SIZE - 2); i++)
        edges += assigned[1 + i / (SIZE - 2)][1 + i % (SIZE - 2)][0] != 0;
    assert_int_equal(edges, 0);
}

static void paint_even(const float direction[3], float radiance[3]) {
    (void)direction;
    glm_vec3_broadcast(1, radiance);
}

/* A square does not light itself: a bent normal faces places in the square's plane, and so does
 * that of its other side, which the sky lights, too. */
TEST(other_side_of_bent_normals) {
    OWNED(stage) stage =
        open_stage(write_square("{" BASE ", doubleSided: true, normalTexture: {index: 4}}"));
    set_sky(&stage, 16, 8, paint_even);
    OWNED(image) drawn = render_stage(&stage, "clustered", "", SIZE);
    check_at_most("indirect over direct light",
                  layer_mean(&drawn, "indirect") / layer_mean(&drawn, "direct"), .01);
}

/* Four textures, four mappings. Two quarters differ by the glow alone. */
TEST(all) {
    struct pictures pictures;
    make_pictures(write_square("{pbrMetallicRoughness: {baseColorFactor: [0.5, 0.5, 0.5, 1], "
                               "baseColorTexture: {index: 0}, metallicRoughnessTexture: {index: 2, "
                               "texCoord: 1}}, emissiveFactor: [1, 1, 1], emissiveTexture: {index: "
                               "1, texCoord: 2}, normalTexture: {index: 4, texCoord: 3}}"),
                  &pictures);
    check_quarters("metal", &pictures, "albedo.R", (double[]){.4775, 0, .4775, .4775});
    check_quarters("normal", &pictures, "normal.X", (double[]){-.707, -.707, -.707, -.707});
    check_near("drawn glow", value_at(&pictures.drawn, "R", 2) - value_at(&pictures.drawn, "R", 0),
               1, .01);
    check_near("traced glow",
               value_at(&pictures.traced, "R", 2) - value_at(&pictures.traced, "R", 0), 1, .01);
    free_pictures(&pictures);
}

#define GLOSSINESS "{extensions: {KHR_materials_pbrSpecularGlossiness: {"
#define HALF "diffuseFactor: [0.5, 0.5, 0.5, 1]"

/* The diffuse part has the light that the lobe leaves. A lobe of roughness 1 and a reflectance of a
 * half reflects half of 1 - ln 2, .1534, straight up. .125 is what it reflects where it
 * is rough. */
TEST(glossiness) {
    static const struct row rows[] = {
        {"texture by set 1",
         GLOSSINESS HALF ", specularGlossinessTexture: {index: 6, texCoord: 1}}}}",
         "albedo.R",
         {.4233, .5, .4233, .4233}},
        {"both textures",
         GLOSSINESS HALF
         ", diffuseTexture: {index: 1}, specularGlossinessTexture: {index: 6, " TRANSFORM
         "offset: [0, 0.5]}}}}}}",
         "albedo.R",
         {.4233, 0, 0, 0}},
        {"texture times factors",
         GLOSSINESS HALF ", specularFactor: [0.5, 0.25, 0.25], glossinessFactor: 0.5, "
                         "specularGlossinessTexture: {index: 6}}}}",
         "albedo.R",
         {.5, .4616, .4616, .4616}},
        {"rough by its alpha",
         GLOSSINESS
         "diffuseFactor: [0, 0, 0, 1], specularGlossinessTexture: {index: 6, texCoord: 2}}}}",
         "R",
         {.125, .125, 0, .125}},
        {"no reflectance, smooth",
         GLOSSINESS HALF ", specularFactor: [0, 0, 0]}}}",
         "R",
         {.5, .5, .5, .5}},
        {"no reflectance by the texture, smooth",
         GLOSSINESS HALF ", specularFactor: [0, 0, 0], specularGlossinessTexture: {index: 0}}}}",
         "R",
         {.5, .5, .5, .5}},
        {"a reflectance of a half",
         GLOSSINESS HALF ", specularFactor: [0.5, 0.5, 0.5]}}}",
         "albedo.R",
         {.25, .25, .25, .25}},
    };
    check_rows(rows, sizeof rows / sizeof *rows);
}

/* --- what is left out ------------------------------------------------------------------------- */

#define SPECULAR(of) "{" BASE ", extensions: {KHR_materials_specular: {" of "}}}"

/* Of a texture of which a quarter is white, f0 and f90 are a quarter, or f0 alone is. Scenes do not
 * keep it. */
TEST(means) {
    static const struct {
        const char *material;
        double f0, f90;
    } rows[] = {
        {SPECULAR("specularTexture: {index: 1}"), .01, .25},
        {SPECULAR("specularColorTexture: {index: 1, texCoord: 1}"), .01, 1},
        {SPECULAR(
             "specularFactor: 0.5, specularTexture: {index: 1}, specularColorTexture: {index: 1}"),
         .00125, .125},
        {SPECULAR("specularColorFactor: [0.5, 0.5, 0.5], specularTexture: {index: 0}"), .02, 1},
        {SPECULAR(""), .04, 1}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(scene) scene;
        hear_notes();
        check_ok("load", scene_load(&scene, write_square(rows[i].material)));
        end_notes();
        check_near("from straight on", (double)scene.materials[0].specular_f0[1], rows[i].f0, 1e-6);
        check_near("grazing", (double)scene.materials[0].specular_f90, rows[i].f90, 1e-6);
        assert_int_equal(scene.texture_count, 1);
        assert_true((strstr(notes, "mean everywhere") != NULL) == (i < 4));
    }
}

/* Coordinates that the mesh lacks are zeros, and a note tells. */
TEST(no_such_set) {
    struct pictures pictures;
    hear_notes();
    make_pictures(write_square(GLOW "index: 1, texCoord: 5}}"), &pictures);
    end_notes();
    check_quarters("set 5", &pictures, "R", (double[]){1.5, 1.5, 1.5, 1.5});
    assert_non_null(strstr(notes, "texture coordinates"));
    free_pictures(&pictures);
}

/* Optimisers leave the number of a set that is gone in KHR_texture_transform: the texture's own one
 * counts. */
TEST(set_left_over) {
    static const struct row rows[] = {
        {"own set 1",
         GLOW "index: 1, texCoord: 1, " TRANSFORM "texCoord: 7}}}}",
         "R",
         {.5, 1.5, .5, .5}},
        {"own set 0, moved",
         GLOW "index: 1, " TRANSFORM "texCoord: 4, offset: [0.5, 0]}}}}",
         "R",
         {.5, 1.5, .5, .5}},
        {"of a base colour",
         "{pbrMetallicRoughness: {metallicFactor: 0, baseColorTexture: {index: 1, texCoord: "
         "2, " TRANSFORM "texCoord: 4}}}}}",
         "R",
         {0, 0, 1, 0}},
    };
    hear_notes();
    check_rows(rows, sizeof rows / sizeof *rows);
    end_notes();
    assert_non_null(strstr(notes, "mesh 0: primitive 0: TEXCOORD_7"));
    assert_null(strstr(notes, "(zeros)"));
}

/* --- what is unlit ---------------------------------------------------------------------------- */

#define UNLIT ", extensions: {KHR_materials_unlit: {}"

/* The base colour alone, and no lamp is made of it. */
TEST(unlit) {
    static const struct row rows[] = {
        {"emission", "{" BASE UNLIT "}, emissiveFactor: [1, 1, 1]}", "R", {.5, .5, .5, .5}},
        {"emissive texture",
         GLOW "index: 1}" UNLIT ", KHR_materials_emissive_strength: {emissiveStrength: 9}}}",
         "R",
         {.5, .5, .5, .5}},
        {"metal, normals, transmission",
         "{pbrMetallicRoughness: {baseColorTexture: {index: 1}, metallicRoughnessTexture: {index: "
         "2}}, normalTexture: {index: 4}" UNLIT
         ", KHR_materials_transmission: {transmissionFactor: 1}}}",
         "R",
         {1, 0, 0, 0}},
        {"specular glossiness",
         "{emissiveFactor: [1, 1, 1]" UNLIT
         ", KHR_materials_pbrSpecularGlossiness: {diffuseFactor: [0.25, 0.5, 0.5, 1], "
         "specularGlossinessTexture: {index: 6}}}}",
         "R",
         {.25, .25, .25, .25}},
    };
    check_rows(rows, sizeof rows / sizeof *rows);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(stage) stage = open_stage(write_square(rows[i].material));
        assert_int_equal(stage.emitters.count, 1);
    }
}

/* --- small lights of large triangles ---------------------------------------------------------- */

/* One texel of 64 x 64 glows: it is found, and shows. */
TEST(small_light) {
    static unsigned char rgba[64 * 64][4];
    struct pictures pictures;
    const char *path = write_square(GLOW "index: 1}}");
    memset(rgba, 0, sizeof rgba);
    memset(rgba[64 * 16 + 16], 255, 4);
    write_tiny_png(scratch("1.png"), rgba[0], 64, 64);
    make_pictures(path, &pictures);
    check_quarters("light", &pictures, "R", (double[]){1.5, .5, .5, .5});
    free_pictures(&pictures);
}

/* --- large pictures --------------------------------------------------------------------------- */

/* Higher than OpenGL has them: half white, half black, for the renderer and the path tracer. */
TEST(high_picture) {
    enum { HEIGHT = 20000 };
    static unsigned char rgba[HEIGHT][4];
    struct pictures pictures;
    const char *path = write_square(GLOW "index: 1}}");
    memset(rgba, 255, sizeof rgba / 2);
    write_tiny_png(scratch("1.png"), rgba[0], 1, HEIGHT);
    hear_notes();
    make_pictures(path, &pictures);
    end_notes();
    check_quarters("half", &pictures, "R", (double[]){1.5, 1.5, .5, .5});
    assert_non_null(strstr(notes, "image 1: its 1x20000 pixels are scaled down to 1x16384"));
    free_pictures(&pictures);
}

/* A GPU without room for a texture has a smaller one. */
TEST(short_gpu) {
    enum { SIDE = 2048 };
    static unsigned char rgba[SIDE * SIDE][4];
    struct pictures pictures;
    const char *path = write_square(GLOW "\"index\": 1}}");
    memset(rgba, 255, sizeof rgba / 2);
    write_tiny_png(scratch("1.png"), rgba[0], SIDE, SIDE);
    size_t memory = gl.memory;
    gl.memory = 17 << 20;
    hear_notes();
    make_pictures(path, &pictures);
    end_notes();
    gl.memory = memory;
    check_quarters("half", &pictures, "R", (double[]){1.5, 1.5, .5, .5});
    assert_non_null(strstr(notes, "textures are scaled down, some to 1024 texels a side"));
    free_pictures(&pictures);
}

/* A texel is the mean of those that it covers, of light and not of numbers. */
TEST(shrink) {
    static const unsigned char from[2][4] = {{0, 0, 0, 0}, {255, 255, 255, 255}};
    static const unsigned char to[2][4] = {{188, 188, 188, 128}, {128, 128, 128, 128}};
    for (int linear = 0; linear < 2; linear++) {
        struct scene_texture texture = {.bitmap = {2, 1, mem_copy(from, 2, 4)},
                                        .linear = linear > 0};
        texture_shrink(&texture, 1);
        assert_int_equal(texture.bitmap.width, 1);
        assert_memory_equal(texture.bitmap.rgba, to[linear], 4);
        bitmap_free(&texture.bitmap);
    }
}

/* --- memory ----------------------------------------------------------------------------------- */

/* Vertices have as many coordinates as the material that has most; another mapping is another
 * scene. */
TEST(counts) {
    static const struct {
        const char *material;
        int mappings;
    } rows[] = {{"{" BASE "}", 1},
                {GLOW "index: 1}}", 1},
                {GLOW "index: 1, texCoord: 1}}", 2},
                {GLOW "index: 1, texCoord: 2}, normalTexture: {index: 4, " TRANSFORM
                      "scale: [2, 2]}}}}",
                 3}};
    uint64_t sums[sizeof rows / sizeof *rows];
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(stage) stage = open_stage(write_square(rows[i].material));
        const struct geometry *geometry = &stage.geometry;
        assert_int_equal(geometry->mapping_count, rows[i].mappings);
        for (int m = 0; m < MAPPINGS_MAX; m++)
            assert_true((geometry->uv[m] != NULL) == (m < rows[i].mappings));
        assert_true(materials_have_mappings(&stage.scene) == (rows[i].mappings > 1));
        sums[i] = scene_hash(&stage.scene, geometry, &stage.camera, &stage.emitters);
        for (size_t k = 0; k < i; k++)
            assert_true(sums[k] != sums[i]);
    }
}

/* --- files that were reported ----------------------------------------------------------------- */

TEST(cases) {
    static const struct {
        const char *file, *channel;
        double value;
    } cases[] = {{"second-uv/emission-uv1.gltf", "R", .503},
                 {"second-uv/emission-transform.gltf", "R", .503},
                 {"second-uv/metal-uv1.gltf", "R", .49},
                 {"second-uv/metal-transform.gltf", "R", .49},
                 {"gloss-texture/diffuse.gltf", "R", .5}};
    for (size_t i = 0; shared_path() && i < sizeof cases / sizeof *cases; i++) {
        struct pictures pictures;
        const char *path = form("%s/cases/%s", shared_path(), cases[i].file);
        FILE *file = fopen(path, "rb");
        if (!file)
            continue;
        fclose(file);
        double value = cases[i].value;
        make_pictures(path, &pictures);
        check_quarters(cases[i].file, &pictures, cases[i].channel,
                       (double[]){value, value, value, value});
        free_pictures(&pictures);
    }
}

static double decoded(int code) {
    double value = code / 255.;
    return value <= .04045 ? value / 12.92 : pow((value + .055) / 1.055, 2.4);
}

/* A pixel of the drawn albedo, whatever decodes textures and holds albedo. */
static void check_albedo(const char *material, int quarter, const double expected[3]) {
    static const char *const channels[] = {"albedo.R", "albedo.G", "albedo.B"};
    OWNED(stage) stage = open_stage(write_square(material));
    OWNED(image) drawn = render_stage(&stage, "clustered", "materials=diffuse", SIZE);
    for (int c = 0; c < 3; c++)
        check_near(channels[c], value_at(&drawn, channels[c], quarter), expected[c],
                   .003 * expected[c]);
}

TEST(dark_albedo) {
    for (int texture = 7; texture <= 8; texture++)
        for (int quarter = 0; quarter <= 1; quarter++) {
            const unsigned char *code = texels[texture][quarter];
            const char *material =
                form("{pbrMetallicRoughness: {baseColorTexture: {index: %d}}}", texture + 2);
            check_albedo(material, quarter,
                         (double[]){decoded(code[0]), decoded(code[1]), decoded(code[2])});
        }
    check_albedo("{pbrMetallicRoughness: {baseColorFactor: [0.002, 0.01, 0.5, 1]}}", 0,
                 (double[]){.002, .01, .5});
}

RUN_TESTS(open_group_context, close_group_context)
