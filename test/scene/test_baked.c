/* Models as artists bake them, drawn beside path-traced: two scenes of the Khronos Group's
 * properties. MultiUVTest: a cube with its colour on one TEXCOORD and its emission on another.
 * DamagedHelmet: maps of everything, and a few small lamps as the only lights. */
#include "base/unit.h"
#include "gltf_parts.h"
#include "render_support.h"
#include "tiny_png.h"

#include "quality/picture.h"

enum { SIZE = 96, VERTICES_MAX = 1024, INDICES_MAX = 4096, TEXELS = 32 };

/* --- a mesh of several primitives in one buffer ----------------------------------------------- */

struct vertex {
    float position[3], normal[3], uv[2][2], color[4];
};

struct mesh_data {
    struct vertex vertices[VERTICES_MAX];
    uint16_t indices[INDICES_MAX];
    int vertex_count, index_count;
};

static void add_grid(struct mesh_data *mesh, int columns, int rows,
                     struct vertex (*at)(const void *of, float x, float y), const void *of) {
    int first = mesh->vertex_count;
    for (int j = 0; j <= rows; j++)
        for (int i = 0; i <= columns; i++)
            mesh->vertices[mesh->vertex_count++] =
                at(of, (float)i / (float)columns, (float)j / (float)rows);
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++) {
            int a = first + j * (columns + 1) + i, b = a + columns + 1;
            const int corners[6] = {a, a + 1, b + 1, a, b + 1, b};
            for (int k = 0; k < 6; k++)
                mesh->indices[mesh->index_count++] = (uint16_t)corners[k];
        }
    assert_true(mesh->vertex_count <= VERTICES_MAX && mesh->index_count <= INDICES_MAX);
}

/* A square of a cube of 1 m, its second mapping a third of an atlas of 3 x 2; its vertices are
 * tinted. */
static struct vertex cube_at(const void *of, float x, float y) {
    int face = *(const int *)of, axis = face % 3;
    float side = face < 3 ? 1 : -1;
    struct vertex vertex = {.uv = {{x, 1 - y}, {((float)axis + x) / 3, (face < 3 ? y : 1 + y) / 2}},
                            .color = {1, .7F + .3F * x, .7F + .3F * y, 1}};
    vertex.normal[axis] = side;
    vertex.position[axis] = .5F * side;
    vertex.position[(axis + 1) % 3] = side * (x - .5F);
    vertex.position[(axis + 2) % 3] = y - .5F;
    vertex.position[1] += .5F;
    return vertex;
}

/* A ball of 1 m, from pole to pole. */
static struct vertex ball_at(const void *of, float x, float y) {
    (void)of;
    float around = 2 * GLM_PIf * x, polar = GLM_PIf * y;
    struct vertex vertex = {
        .normal = {-sinf(polar) * cosf(around), -cosf(polar), sinf(polar) * sinf(around)},
        .uv = {{x, 1 - y}, {2 * x, 1 - y}},
        .color = {1, 1, 1, 1}};
    for (int c = 0; c < 3; c++)
        vertex.position[c] = .5F * vertex.normal[c] + (c == 1 ? .55F : 0);
    return vertex;
}

static struct vertex floor_at(const void *of, float x, float y) {
    (void)of;
    return FILLED(vertex, .position = {4 * x - 2, 0, 2 - 4 * y}, .normal = {0, 1, 0},
                  .uv = {{x, y}, {x, y}}, .color = {1, 1, 1, 1});
}

/* --- textures --------------------------------------------------------------------------------- */

static void write_texture(const char *name, void (*texel)(int x, int y, unsigned char rgb[3])) {
    static unsigned char rgba[TEXELS * TEXELS][4];
    for (int i = 0; i < TEXELS * TEXELS; i++) {
        texel(i % TEXELS, i / TEXELS, rgba[i]);
        rgba[i][3] = 255;
    }
    write_tiny_png(scratch(name), rgba[0], TEXELS, TEXELS);
}

static void set(unsigned char rgb[3], int r, int g, int b) {
    rgb[0] = (unsigned char)r, rgb[1] = (unsigned char)g, rgb[2] = (unsigned char)b;
}

static void checks(int x, int y, unsigned char rgb[3]) {
    bool dark = (x / 4 + y / 4) % 2;
    set(rgb, dark ? 90 : 220, dark ? 110 : 210, dark ? 160 : 190);
}

/* A bar on each square of the atlas. */
static void bars(int x, int y, unsigned char rgb[3]) {
    int across = x * 3 % TEXELS, along = y * 2 % TEXELS;
    bool glows = across > 10 && across < 20 && along > 4 && along < 28;
    set(rgb, glows ? 255 : 0, glows ? 40 + 6 * x : 0, glows ? 60 : 0);
}

static void panels(int x, int y, unsigned char rgb[3]) {
    bool seam = x % 8 == 0 || y % 8 == 0;
    set(rgb, seam ? 60 : 190, seam ? 55 : 170 - 2 * y, seam ? 50 : 120);
}

/* Roughness in G, metal in B. */
static void metal(int x, int y, unsigned char rgb[3]) {
    set(rgb, 0, 120 + (x * 14 + y * 6) % 100, (x / 8 + y / 8) % 2 ? 255 : 0);
}

static void lamps(int x, int y, unsigned char rgb[3]) {
    bool glows = x % 8 >= 3 && x % 8 < 5 && y >= 14 && y < 16;
    set(rgb, glows ? 60 : 0, glows ? 220 : 0, glows ? 255 : 0);
}

static void dents(int x, int y, unsigned char rgb[3]) {
    float dx = ((float)(x % 8) - 3.5F) / 4, dy = ((float)(y % 8) - 3.5F) / 4;
    float depth = fmaxf(0, 1 - dx * dx - dy * dy);
    vec3 normal = {.6F * dx * depth, -.6F * dy * depth, 1};
    vec3_unit(normal);
    set(rgb, (int)(127.5F + 127.5F * normal[0]), (int)(127.5F + 127.5F * normal[1]),
        (int)(127.5F + 127.5F * normal[2]));
}

static void shade(int x, int y, unsigned char rgb[3]) {
    set(rgb, x * 8, y * 8, 0);
}

/* --- files ------------------------------------------------------------------------------------ */

/* The primitives' triangles: of the model up to there, of the floor behind. */
static const char *write_model(const char *name, const struct mesh_data *mesh, int model_indices,
                               const char *materials, const char *more) {
    static char json[8192];
    char file[64];
    int size = (int)sizeof(struct vertex), vertices = mesh->vertex_count * size;
    FILE *bin;
    snprintf(file, sizeof file, "%s.bin", name);
    bin = fopen(scratch(file), "wb");
    assert_non_null(bin);
    fwrite(mesh->vertices, sizeof(struct vertex), (size_t)mesh->vertex_count, bin);
    fwrite(mesh->indices, sizeof *mesh->indices, (size_t)mesh->index_count, bin);
    assert_true(fclose(bin) == 0);
    int length = snprintf(
        json, sizeof json,
        "{asset: {version: '2.0'}, %s buffers: [{uri: '%s', byteLength: %d}], bufferViews: "
        "[{buffer: 0, byteLength: %d, byteStride: %d}, {buffer: 0, byteOffset: %d, byteLength: "
        "%d}], accessors: [{bufferView: 0, componentType: 5126, count: %d, type: VEC3}, "
        "{bufferView: 0, byteOffset: 12, componentType: 5126, count: %d, type: VEC3}, {bufferView: "
        "0, byteOffset: 24, componentType: 5126, count: %d, type: VEC2}, {bufferView: 0, "
        "byteOffset: 32, componentType: 5126, count: %d, type: VEC2}, {bufferView: 0, byteOffset: "
        "40, componentType: 5126, count: %d, type: VEC4}, {bufferView: 1, componentType: 5123, "
        "count: %d, type: SCALAR}, {bufferView: 1, byteOffset: %d, componentType: 5123, count: %d, "
        "type: SCALAR}], meshes: [{primitives: [{attributes: {POSITION: 0, NORMAL: 1, TEXCOORD_0: "
        "2, TEXCOORD_1: 3, COLOR_0: 4}, indices: 5, material: 0}, {attributes: {POSITION: 0, "
        "NORMAL: 1}, indices: 6, material: 1}]}], materials: [%s, {pbrMetallicRoughness: "
        "{metallicFactor: 0, baseColorFactor: [0.6, 0.6, 0.6, 1]}}], cameras: [{type: perspective, "
        "perspective: {yfov: 0.6, znear: 0.1}}], nodes: [{mesh: 0, rotation: [0, 0.3, 0, 0.954]}, "
        "{camera: 0, translation: [0, 1.8, 3], rotation: [-0.2164, 0, 0, 0.9763]}, {translation: "
        "[1.5, 3, 2], extensions: {KHR_lights_punctual: {light: 0}}}], extensions: "
        "{KHR_lights_punctual: {lights: [{type: point, intensity: 20}]}}}",
        more, file, vertices + 2 * mesh->index_count, vertices, size, vertices,
        2 * mesh->index_count, mesh->vertex_count, mesh->vertex_count, mesh->vertex_count,
        mesh->vertex_count, mesh->vertex_count, model_indices, 2 * model_indices,
        mesh->index_count - model_indices, materials);
    assert_true(length > 0 && (size_t)length < sizeof json);
    snprintf(file, sizeof file, "%s.gltf", name);
    write_json(scratch(file), json);
    return scratch(file);
}

static const char *write_cube(void) {
    static struct mesh_data mesh;
    memset(&mesh, 0, sizeof mesh);
    for (int face = 0; face < 6; face++)
        add_grid(&mesh, 4, 4, cube_at, &face);
    int model = mesh.index_count;
    add_grid(&mesh, 1, 1, floor_at, NULL);
    write_texture("checks.png", checks);
    write_texture("bars.png", bars);
    return write_model("cube", &mesh, model,
                       "{pbrMetallicRoughness: {metallicFactor: 0, baseColorTexture: {index: 0}}, "
                       "emissiveFactor: [1, 1, 1], emissiveTexture: {index: 1, texCoord: 1}}",
                       "images: [{uri: 'checks.png'}, {uri: 'bars.png'}], samplers: [{magFilter: "
                       "9728}], textures: [{source: 0, sampler: 0}, {source: 1, sampler: 0}],");
}

static const char *write_helmet(void) {
    static struct mesh_data mesh;
    memset(&mesh, 0, sizeof mesh);
    add_grid(&mesh, 32, 16, ball_at, NULL);
    int model = mesh.index_count;
    add_grid(&mesh, 1, 1, floor_at, NULL);
    write_texture("panels.png", panels);
    write_texture("metal.png", metal);
    write_texture("lamps.png", lamps);
    write_texture("dents.png", dents);
    write_texture("shade.png", shade);
    return write_model(
        "helmet", &mesh, model,
        "{pbrMetallicRoughness: {baseColorTexture: {index: 0}, metallicRoughnessTexture: {index: "
        "1}}, emissiveFactor: [1, 1, 1], emissiveTexture: {index: 2}, normalTexture: {index: 3, "
        "texCoord: 1}, occlusionTexture: {index: 4}}",
        "images: [{uri: 'panels.png'}, {uri: 'metal.png'}, {uri: 'lamps.png'}, {uri: 'dents.png'}, "
        "{uri: 'shade.png'}], textures: [{source: 0}, {source: 1}, {source: 2}, {source: 3}, "
        "{source: 4}],");
}

/* The noise is that of light of lamps and of specular reflection. Edges of textures and of shadows
 * take the rest: two in a hundred, and of indirect light, of which there is little, as much as the
 * technique errs elsewhere. */
static void compare(const char *path) {
    OWNED(stage) stage = open_stage(path);
    OWNED(image) drawn = render_stage(&stage, "clustered", "", SIZE), traced, common;
    struct path_tracer_progress reached = {0};
    const struct path_tracer_desc tracer = {.width = SIZE,
                                            .height = SIZE,
                                            .samples = is_long_run() ? 144 : 100,
                                            .bounces = 1,
                                            .centers = true};
    check_ok("trace", picture_trace_paths(&stage, &tracer, &traced, &reached));
    common = common_layers(&traced);
    double noise = (double)reached.noise;
    check_at_most("noise", noise, .12);
    check_at_most("albedo", relative_rmse(&drawn, &common, "albedo"), .02);
    check_at_most("direct", relative_rmse(&drawn, &common, "direct"), .02 + noise);
    check_at_most("indirect", relative_rmse(&drawn, &common, "indirect"), .15 + noise);
    check_at_most("picture", relative_rmse(&drawn, &common, ""), .02 + noise);
}

TEST(cube) {
    compare(write_cube());
}

TEST(helmet) {
    compare(write_helmet());
}

RUN_TESTS(open_group_context, close_group_context)
