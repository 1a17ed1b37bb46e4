/* The highlight of a smooth ball has all of its energy in pictures of every size. */
#include "render_support.h"

#include "gltf_parts.h"

#include "scene/lights/environment.h"

#include <cglm/cglm.h>

enum { RINGS = 48, SECTORS = 96, VERTICES = (RINGS + 1) * (SECTORS + 1) };
enum { INDICES = 6 * RINGS * SECTORS, SKY_WIDTH = 256, SKY_HEIGHT = 128 };

static const float radius = .4F;

/* The unit sphere, whose places are its normals. */
static void write_ball(const char *name) {
    static struct {
        float place[VERTICES][3];
        uint16_t indices[INDICES];
    } ball;
    uint16_t *index = ball.indices;
    for (int i = 0; i < VERTICES; i++) {
        float down = GLM_PIf * (float)(i / (SECTORS + 1)) / RINGS;
        float turn = 2 * GLM_PIf * (float)(i % (SECTORS + 1)) / SECTORS;
        glm_vec3_copy((vec3){sinf(down) * cosf(turn), cosf(down), -sinf(down) * sinf(turn)},
                      ball.place[i]);
    }
    for (int i = 0; i < RINGS * SECTORS; i++) {
        int a = i / SECTORS * (SECTORS + 1) + i % SECTORS, b = a + SECTORS + 1;
        const int corners[6] = {a, b, b + 1, a, b + 1, a + 1};
        for (int k = 0; k < 6; k++)
            *index++ = (uint16_t)corners[k];
    }
    FILE *file = fopen(scratch(name), "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(&ball, sizeof ball, 1, file), 1);
    assert_int_equal(fclose(file), 0);
}

/* A white metal, seen from +z by an orthographic camera of 1 x 1 m. */
static void open_ellipsoid(struct stage *stage, const char *radii) {
    write_ball("ball.bin");
    const char *buffers =
        form("[{byteLength: 320}, {uri: 'ball.bin', byteLength: %d}]", 12 * VERTICES + 2 * INDICES);
    const char *views =
        form("[{buffer: 1, byteLength: %d}, {buffer: 1, byteOffset: %d, byteLength: %d}]",
             12 * VERTICES, 12 * VERTICES, 2 * INDICES);
    const char *accessors = form("[{bufferView: 0, componentType: 5126, count: %d, type: VEC3}, "
                                 "{bufferView: 1, componentType: 5123, count: %d, type: SCALAR}]",
                                 VERTICES, INDICES);
    const char *nodes = form("[{mesh: 0, scale: [%s]}]", radii);
    *stage = open_stage(
        write_parts("ball.glb", &PARTS(.buffers = buffers, .views = views, .accessors = accessors,
                                       .materials = "[{doubleSided: false}]",
                                       .meshes = "[{primitives: [{attributes: {POSITION: 0, "
                                                 "NORMAL: 0}, indices: 1, material: 0}]}]",
                                       .nodes = nodes)));
    stage->camera = FILLED(camera, .eye = {0, 0, 3}, .right = {1, 0, 0}, .up = {0, 1, 0},
                           .forward = {0, 0, -1}, .orthographic = true, .y_extent = .5F);
}

static void open_ball(struct stage *stage) {
    open_ellipsoid(stage, "0.4, 0.4, 0.4");
}

/* Checks the picture's mean, W/sr. */
static void check_mean(const struct renderer_desc *desc, double wanted, double share,
                       const char *what) {
    double sum = 0;
    struct image drawn = render_layers(desc);
    int green = image_find_channel(&drawn, "direct.specular.G");
    for (int i = 0; i < desc->width * desc->height; i++)
        sum += (double)image_at(&drawn, i % desc->width, i / desc->width)[green];
    check_near(what, sum / desc->width / desc->height, wanted, share * wanted);
    image_free(&drawn);
}

/* A mirror ball reflects E pi r^2 evenly to all sides, so that each side sees E r^2 / 4 W/sr. */
static void check_ball(const struct renderer_desc *desc, const char *what) {
    check_mean(desc, GLM_PI * (double)(radius * radius) / 4, .06, what);
}

static const int sizes[] = {64, 65, 33, 128};

/* Suns of pi W/m2 at angles from the eye. */
TEST(suns) {
    static const float roughnesses[] = {0, .1F, .2F}, angles[] = {30, 60, 10};
    OWNED(stage) stage;
    open_ball(&stage);
    for (int i = 0; i < 36; i++) {
        struct emitter sun = {.type = EMITTER_DIRECTIONAL, .number = -1};
        float angle = angles[i / 12];
        if (!is_tried_here((size_t)i, 13))
            continue;
        emitter_aim(&sun, (float[]){-.6F * sinf(glm_rad(angle)), -.8F * sinf(glm_rad(angle)),
                                    -cosf(glm_rad(angle))});
        glm_vec3_broadcast(GLM_PIf, sun.intensity);
        stage.scene.materials[0].roughness = roughnesses[i / 4 % 3];
        struct renderer_desc desc = desc_of(&stage, "unshadowed", "", sizes[i % 4], sizes[i % 4]);
        desc.emitters = (struct emitters){.items = &sun, .count = 1};
        const char *what = form("roughness %.1f, %d pixels, %.0f degrees",
                                (double)roughnesses[i / 4 % 3], sizes[i % 4], (double)angle);
        check_ball(&desc, what);
    }
}

/* A needle of 3 pixels across bends much across alone. A mirror shows E / (4 K) W/sr, with K the
 * Gaussian curvature where it mirrors the sun: 1 / K = (a b c)^2 / sum((a n_x)^2 ...)^2. */
TEST(needle) {
    static const float angles[] = {0, 10, 20};
    const double across = .05 * .05, along = .4 * .4;
    OWNED(stage) stage;
    open_ellipsoid(&stage, "0.05, 0.4, 0.05");
    stage.scene.materials[0].roughness = 0;
    for (int i = 0; i < 3; i++) {
        struct emitter sun = {.type = EMITTER_DIRECTIONAL, .number = -1};
        double up = sin((double)glm_rad(angles[i]) / 2), y2 = up * up;
        double inverse = across * along * across / pow(across * (1 - y2) + along * y2, 2);
        emitter_aim(&sun, (float[]){0, -sinf(glm_rad(angles[i])), -cosf(glm_rad(angles[i]))});
        glm_vec3_broadcast(GLM_PIf, sun.intensity);
        struct renderer_desc desc = desc_of(&stage, "unshadowed", "", 64, 64);
        desc.emitters = (struct emitters){.items = &sun, .count = 1};
        const char *what = form("needle, %.0f degrees", (double)angles[i]);
        check_mean(&desc, GLM_PI * inverse / 4, .3, what);
    }
}

/* The same sun as the one bright texel of a sky. */
static void paint_sun(const float direction[3], float radiance[3]) {
    const struct environment sky = {.width = SKY_WIDTH, .height = SKY_HEIGHT};
    int column, row;
    environment_texel(&sky, direction, &column, &row);
    bool is_sun = column == 180 && row == 30;
    glm_vec3_broadcast(is_sun ? GLM_PIf / (float)environment_solid_angle(&sky, row) : 0, radiance);
}

TEST(sun_of_sky) {
    OWNED(stage) stage;
    open_ball(&stage);
    stage.scene.materials[0].roughness = 0;
    set_sky(&stage, SKY_WIDTH, SKY_HEIGHT, paint_sun);
    for (int i = 0; i < 4; i++) {
        if (!is_tried_here((size_t)i, 4))
            continue;
        struct renderer_desc desc = desc_of(&stage, "unshadowed", "", sizes[i], sizes[i]);
        check_ball(&desc, "sun of a sky");
    }
}

RUN_TESTS(open_group_context, close_group_context)
