/* What materials say, each where a mistake is seen: panels in rows, after the intent of the Khronos
 * Group's sample models NormalTangentTest, TextureSettingsTest, AlphaBlendModeTest and
 * EmissiveStrengthTest.
 *
 * From the top: one normal map of a dome, of which each panel shows the same dome; a picture of
 * four colours with each way of wrapping, and from behind; alpha that falls from left to right;
 * strengths of emission, each twice the one before. */
#include "scenes.h"
#include "shapes/shapes.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { COLUMNS = 5, SIDE = 32 };

/* Panels are 1 m apart and .9 m wide; row 0 is the top one. One that faces away is mirrored with
 * its picture. */
static void place_panel(struct glb *glb, const char *name, int row, int column,
                        const float uv[4][2], int material, bool faces_away) {
    float x = (float)column - .5F * (COLUMNS - 1) - .45F, y = 3 - (float)row + .05F;
    float left = faces_away ? x + .9F : x, right = faces_away ? x : x + .9F;
    struct surface panel = {0};
    add_quad(&panel, (const float[]){left, y, 0}, (const float[]){right, y, 0},
             (const float[]){right, y + .9F, 0}, (const float[]){left, y + .9F, 0});
    glb_add_textured_mesh(glb, name, &panel, uv, material);
    surface_free(&panel);
}

static int add_json(struct glb *glb, const char *format, int texture) {
    char json[512];
    snprintf(json, sizeof json, format, texture);
    return glb_add_material_json(glb, json);
}

/* --- normal maps ------------------------------------------------------------------------------ */

/* A dome in the middle: seen from the front it is brightest where the light is. */
static int add_dome(struct glb *glb) {
    static const float radius = .8F;
    unsigned char texels[SIDE][SIDE][4];
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            float right = ((float)x + .5F) * 2 / SIDE - 1, up = 1 - ((float)y + .5F) * 2 / SIDE;
            vec3 normal = {right / radius, up / radius, 0};
            float across = glm_vec3_norm2(normal);
            if (across < 1)
                normal[2] = sqrtf(1 - across);
            else
                glm_vec3_copy((vec3){0, 0, 1}, normal);
            for (int c = 0; c < 3; c++)
                texels[y][x][c] = (unsigned char)lrintf((normal[c] * .5F + .5F) * 255);
            texels[y][x][3] = 255;
        }
    return glb_add_texture(glb, SIDE, SIDE, **texels, "\"wrapS\":33071,\"wrapT\":33071");
}

/* Upright; turned by a quarter and by half; mirrored either way. */
static void place_domes(struct glb *glb) {
    static const float uv[COLUMNS][4][2] = {
        {{0, 1}, {1, 1}, {1, 0}, {0, 0}}, {{0, 0}, {0, 1}, {1, 1}, {1, 0}},
        {{1, 0}, {0, 0}, {0, 1}, {1, 1}}, {{1, 1}, {0, 1}, {0, 0}, {1, 0}},
        {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
    };
    int dome = add_json(
        glb,
        "\"name\":\"dome\",\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"roughnessFactor\":0.4},"
        "\"normalTexture\":{\"index\":%d}",
        add_dome(glb));
    for (int i = 0; i < COLUMNS; i++)
        place_panel(glb, "dome", 0, i, uv[i], dome, false);
}

/* --- textures --------------------------------------------------------------------------------- */

/* From 1 before the picture to 1 behind it: repeated, clamped, mirrored, repeated one way and
 * mirrored the other; and one that is seen from behind. */
static void place_wraps(struct glb *glb) {
    static const unsigned char colors[2][2][4] = {{{230, 30, 30, 255}, {30, 200, 30, 255}},
                                                  {{40, 60, 230, 255}, {240, 240, 240, 255}}};
    static const char *const samplers[COLUMNS] = {"", "\"wrapS\":33071,\"wrapT\":33071",
                                                  "\"wrapS\":33648,\"wrapT\":33648",
                                                  "\"wrapT\":33648", ""};
    static const float uv[4][2] = {{-1, 2}, {2, 2}, {2, -1}, {-1, -1}};
    for (int i = 0; i < COLUMNS; i++) {
        char sampler[128];
        snprintf(sampler, sizeof sampler, "\"magFilter\":9728,\"minFilter\":9728%s%s",
                 *samplers[i] ? "," : "", samplers[i]);
        int texture = glb_add_texture(glb, 2, 2, **colors, sampler);
        int material = add_json(
            glb,
            i == COLUMNS - 1 ? "\"name\":\"behind\",\"doubleSided\":true,\"pbrMetallicRoughness\":{"
                               "\"metallicFactor\":0,\"baseColorTexture\":{\"index\":%d}}"
                             : "\"name\":\"wrap\",\"pbrMetallicRoughness\":{\"metallicFactor\":0,"
                               "\"baseColorTexture\":{\"index\":%d}}",
            texture);
        place_panel(glb, "wrap", 1, i, uv, material, i == COLUMNS - 1);
    }
}

/* --- alpha ------------------------------------------------------------------------------------ */

/* Opaque whatever alpha says; cut off at a quarter, at half, at three quarters; blended. */
static void place_alphas(struct glb *glb) {
    static const char *const modes[COLUMNS] = {
        "\"alphaMode\":\"OPAQUE\"", "\"alphaMode\":\"MASK\",\"alphaCutoff\":0.25",
        "\"alphaMode\":\"MASK\"", "\"alphaMode\":\"MASK\",\"alphaCutoff\":0.75",
        "\"alphaMode\":\"BLEND\""};
    static const float uv[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    unsigned char texels[SIDE][4];
    for (int x = 0; x < SIDE; x++)
        memcpy(texels[x],
               (unsigned char[]){60, 200, 120, (unsigned char)(255 - x * 255 / (SIDE - 1))}, 4);
    int texture = glb_add_texture(glb, SIDE, 1, *texels, "\"wrapS\":33071,\"wrapT\":33071");
    for (int i = 0; i < COLUMNS; i++) {
        char json[256];
        snprintf(json, sizeof json,
                 "\"name\":\"alpha\",%s,\"pbrMetallicRoughness\":{\"metallicFactor\":0,"
                 "\"baseColorTexture\":{\"index\":%d}}",
                 modes[i], texture);
        place_panel(glb, "alpha", 2, i, uv, glb_add_material_json(glb, json), false);
    }
}

/* --- emission --------------------------------------------------------------------------------- */

static void place_lamps(struct glb *glb) {
    static const float uv[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    for (int i = 0; i < COLUMNS; i++) {
        float strength = .125F * (float)(1 << i);
        place_panel(
            glb, "lamp", 3, i, uv,
            glb_add_lamp(glb, "lamp", (const float[]){strength, .75F * strength, .5F * strength}),
            false);
    }
}

void make_materials(struct glb *glb) {
    struct surface wall = {0};
    int grey = glb_add_material(glb, "grey", (const float[]){.18F, .18F, .18F}, GLB_SINGLE_SIDED);
    add_quad(&wall, (const float[]){-3, -.3F, -.3F}, (const float[]){3, -.3F, -.3F},
             (const float[]){3, 4.3F, -.3F}, (const float[]){-3, 4.3F, -.3F});
    glb_add_mesh(glb, "wall", &wall, grey, NULL);
    surface_free(&wall);
    place_domes(glb);
    place_wraps(glb);
    place_alphas(glb);
    place_lamps(glb);
    glb_add_camera(glb, (const float[]){0, 2, 8}, (const float[]){0, 0, -1}, 32, .1, 50);
    glb_add_light(glb, &(struct glb_light){.name = "point",
                                           .eye = {-3, 6, 5},
                                           .direction = {0, 0, -1},
                                           .color = {1, 1, 1},
                                           .intensity = 120});
}
