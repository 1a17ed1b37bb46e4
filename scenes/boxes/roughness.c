/* Balls of metal and of plastic by rows, from smooth on the left to rough on the right, after the
 * intent of the Khronos Group's sample model MetalRoughSpheres. From the top: metal by factors, the
 * same by a texture, plastic by factors, the same by a texture: two rows show the same each. */
#include "base/memory.h"
#include "scenes.h"
#include "shapes/placing.h"
#include "shapes/shapes.h"

#include <stdio.h>
#include <stdlib.h>

enum { COLUMNS = 6, ROWS = 4, RINGS = 20 };

static const float radius = .34F;

/* Those of texels: 0, 51 ... 255. */
static float roughness_of(int column) {
    return (float)column / (COLUMNS - 1);
}

/* A row of texels for each row of balls that has them: roughness in G, metalness in B. */
static int add_texture(struct glb *glb) {
    unsigned char texels[2][COLUMNS][4];
    for (int row = 0; row < 2; row++)
        for (int x = 0; x < COLUMNS; x++) {
            unsigned char *texel = texels[row][x];
            texel[0] = 0;
            texel[1] = (unsigned char)(255 * x / (COLUMNS - 1));
            texel[2] = row == 0 ? 255 : 0;
            texel[3] = 255;
        }
    return glb_add_texture(glb, COLUMNS, 2, **texels, "\"magFilter\":9728,\"minFilter\":9728");
}

static int add_textured(struct glb *glb, const float color[3], int texture) {
    char json[256];
    snprintf(json, sizeof json,
             "\"name\":\"by texture\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[%g,%g,%g,1],"
             "\"metallicRoughnessTexture\":{\"index\":%d}}",
             (double)color[0], (double)color[1], (double)color[2], texture);
    return glb_add_material_json(glb, json);
}

/* All of the ball has one texel. */
static void place_textured(struct glb *glb, int material, struct surface *ball, int column,
                           bool metal) {
    float(*uv)[2] = mem_alloc(ball->vertex_count, sizeof *uv);
    for (uint32_t i = 0; i < ball->vertex_count; i++) {
        uv[i][0] = ((float)column + .5F) / COLUMNS;
        uv[i][1] = metal ? .25F : .75F;
    }
    glb_add_textured_mesh(glb, "ball", ball, uv, material);
    free(uv);
    surface_free(ball);
}

static void place_balls(struct glb *glb) {
    static const float colors[2][3] = {{1, .77F, .34F}, {.1F, .35F, .16F}}; /* gold, green */
    int texture = add_texture(glb);
    for (int row = 0; row < ROWS; row++) {
        bool metal = row < 2, textured = row % 2;
        const float *color = colors[metal ? 0 : 1];
        for (int column = 0; column < COLUMNS; column++) {
            const float center[3] = {.86F * ((float)column - .5F * (COLUMNS - 1)),
                                     .86F * (float)(ROWS - row) - .4F, 0};
            struct surface ball = {0};
            add_ball(&ball, center, radius, RINGS);
            if (textured)
                place_textured(glb, add_textured(glb, color, texture), &ball, column, metal);
            else
                place_surface(
                    glb, "ball",
                    glb_add_specular(glb, "by factors", color, metal, roughness_of(column)), &ball);
        }
    }
}

static void place_room(struct glb *glb) {
    int white = glb_add_material(glb, "white", (const float[]){.7F, .7F, .7F}, GLB_SINGLE_SIDED);
    int red = glb_add_material(glb, "red", (const float[]){.6F, .1F, .08F}, GLB_SINGLE_SIDED);
    int blue = glb_add_material(glb, "blue", (const float[]){.12F, .2F, .5F}, GLB_SINGLE_SIDED);
    const struct {
        const char *name;
        int material;
        float corners[4][3];
    } walls[] = {
        {"floor", white, {{-3, -.3F, 3}, {3, -.3F, 3}, {3, -.3F, -1}, {-3, -.3F, -1}}},
        {"back wall", white, {{-3, -.3F, -1}, {3, -.3F, -1}, {3, 4, -1}, {-3, 4, -1}}},
        {"left wall", red, {{-3, -.3F, 3}, {-3, -.3F, -1}, {-3, 4, -1}, {-3, 4, 3}}},
        {"right wall", blue, {{3, -.3F, -1}, {3, -.3F, 3}, {3, 4, 3}, {3, 4, -1}}},
    };
    for (size_t i = 0; i < sizeof walls / sizeof walls[0]; i++)
        place_quad(glb, walls[i].name, walls[i].material, walls[i].corners);
}

void make_roughness(struct glb *glb) {
    place_room(glb);
    place_balls(glb);
    place_quad(glb, "lamp", glb_add_lamp(glb, "lamp", (const float[]){16, 16, 16}),
               (const float[4][3]){{-1, 5, 5}, {1, 5, 5}, {1, 4, 6.5F}, {-1, 4, 6.5F}});
    glb_add_camera(glb, (const float[]){0, 1.75F, 9}, (const float[]){0, 0, -1}, 26, .1, 50);
}
