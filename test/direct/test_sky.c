/* Light of a sky: what a sky of 1 gives, in closed forms; a day with a sun beside the path tracer;
 * and that it adds to whatever else shines. */
#include "base/unit.h"
#include "render_support.h"

#include "gltf_parts.h"

#include "direct/direct.h"
#include "scene/lights/environment.h"
#include "scene/lobe_albedo.h"

enum { SIZE = 80, SKY_WIDTH = 128, SKY_HEIGHT = 64 };

/* The only one that is bright in one of the skies. */
enum { TEXEL_COLUMN = 70, TEXEL_ROW = 14, TEXEL_RADIANCE = 1000 };

static void paint_even(const float direction[3], float radiance[3]) {
    (void)direction;
    glm_vec3_broadcast(1, radiance);
}

/* Bright at the horizon, dark below, and a sun. */
static void paint_day(const float direction[3], float radiance[3]) {
    static const float sun[3] = {.48F, .64F, .6F};
    float up = direction[1], haze = expf(-4 * fabsf(up));
    glm_vec3_copy(up > 0 ? (vec3){.2F + haze, .4F + haze, 1 + haze} : (vec3){.2F, .15F, .1F},
                  radiance);
    if (glm_vec3_dot((float *)direction, (float *)sun) > .9985F)
        glm_vec3_copy((vec3){300, 280, 250}, radiance);
}

static void open_quads(struct stage *stage, const char *camera, const char *nodes) {
    const char *all = form("[{camera: 0, %s}, %s]", camera, nodes);
    const char *path = write_parts(
        "sky.glb",
        &PARTS(.nodes = all,
               .more = "cameras: [{type: perspective, perspective: {yfov: 0.9, znear: 0.01}}],"));
    *stage = open_stage(path);
    set_sky(stage, SKY_WIDTH, SKY_HEIGHT, paint_even);
}

/* What the share of the sky should be at a place; negative where it is not asked for. */
typedef double (*expectation)(const float place[3]);

struct shares {
    double rms, worst;   /* of errors */
    double mean, wanted; /* over all places */
};

static struct shares measure_shares(struct stage *stage, const char *settings,
                                    expectation expected) {
    struct renderer renderer;
    struct renderer_desc desc = desc_of(stage, "unshadowed", settings, SIZE, SIZE);
    struct image layers;
    struct shares shares = {0};
    int count = 0;
    open_renderer(&renderer, desc);
    check_ok("layers", renderer_read_layers(&renderer, &layers));
    int direct = image_find_channel(&layers, "direct.R"), alpha = image_find_channel(&layers, "A");
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            float place[3];
            if (image_at(&layers, x, y)[alpha] < 1)
                continue;
            pixel_position(&renderer, &layers, x, y, place);
            double wanted = expected(place);
            if (wanted < 0)
                continue;
            double got = (double)image_at(&layers, x, y)[direct], error = got - wanted;
            shares.mean += got;
            shares.wanted += wanted;
            shares.rms += error * error;
            shares.worst = fmax(shares.worst, fabs(error));
            count++;
        }
    image_free(&layers);
    renderer_free(&renderer);
    assert_true(count > SIZE * SIZE / 5);
    shares.rms = sqrt(shares.rms / count);
    shares.mean /= count;
    shares.wanted /= count;
    return shares;
}

static double all_of_it(const float place[3]) {
    (void)place;
    return 1;
}

/* --- a sky of 1: irradiance pi, as the direct layer has it 1 ---------------------------------- */

static const char *const settings_tried[] = {"", "sky.lights=6", "fit=rectangles lights=60",
                                             "sky.shadow-rays=2"};

TEST(floor) {
    OWNED(stage) stage;
    open_quads(&stage, "translation: [0, 0, 2]",
               "{mesh: 0, scale: [4, 4, 1], translation: [-2, -2, 0]}");
    for (size_t i = 0; i < sizeof settings_tried / sizeof *settings_tried; i++) {
        if (!is_tried_here(i, 3))
            continue;
        printf("  %s\n", settings_tried[i]);
        check_at_most("worst error on an open floor",
                      measure_shares(&stage, settings_tried[i], all_of_it).worst, 2e-3);
    }
}

/* A cube, of which the camera sees three sides: none hides another's sky. */
TEST(convex_body) {
    OWNED(stage) stage;
    open_quads(
        &stage,
        "matrix: [0.70710678, 0, -0.70710678, 0, -0.40824829, 0.81649658, -0.40824829, 0, "
        "0.57735027, 0.57735027, 0.57735027, 0, 2.2, 2.2, 2.2, 1]",
        "{mesh: 0, translation: [0, 0, 1]},{mesh: 0, rotation: [0, 0.70710678, 0, 0.70710678], "
        "translation: [1, 0, 1]},{mesh: 0, rotation: [-0.70710678, 0, 0, 0.70710678], translation: "
        "[0, 1, 1]},{mesh: 0, rotation: [0, 1, 0, 0], translation: [1, 0, 0]},{mesh: 0, rotation: "
        "[0, -0.70710678, 0, 0.70710678]},{mesh: 0, rotation: [0.70710678, 0, 0, 0.70710678]}");
    for (size_t i = 0; i < sizeof settings_tried / sizeof *settings_tried; i++) {
        if (!is_tried_here(i, 3))
            continue;
        printf("  %s\n", settings_tried[i]);
        struct shares shares = measure_shares(&stage, settings_tried[i], all_of_it);
        printf("    %-48s %g\n", "worst", shares.worst);
        check_at_most("RMS error on a cube", shares.rms, .02);
    }
}

/* At x from the foot of a wall of height 1, but far from its ends. */
static double beside_wall(const float place[3]) {
    double x = (double)place[0];
    return place[2] < 1e-3F && x > .15 && fabsf(place[1]) < 1 ? (1 + x / hypot(x, 1)) / 2 : -1;
}

TEST(wall) {
    OWNED(stage) stage;
    open_quads(&stage, "translation: [1.2, 0, 2]",
               "{mesh: 0, scale: [3, 16, 1], translation: [0, -8, 0]},{mesh: 0, rotation: [0, "
               "0.70710678, 0, 0.70710678], scale: [1, 16, 1], translation: [0, -8, 1]}");
    static const struct {
        const char *settings;
        double bound;
    } rows[] = {{"", .05}, {"lights=100 sky.shadow-rays=8", .04}, {"fit=rectangles", .08}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        printf("  %s\n", rows[i].settings);
        struct shares shares = measure_shares(&stage, rows[i].settings, beside_wall);
        check_at_most("RMS error beside a wall", shares.rms, rows[i].bound);
        printf("    %-48s %g\n", "worst", shares.worst);
    }
}

/* --- a furnace: a sky of 1 by kind of material, roughness and angle --------------------------- */

enum { ANGLES = 5, CELL = 4 }; /* pixels a side */
static const double angles[ANGLES] = {0, 30, 60, 75, 80};
static const float roughnesses[] = {.3F, .5F, .1F, .75F, .95F};

/* A convex roof, so that no part hides another's sky: a column bends down for each angle, a row has
 * a material each. */
static void open_roof(struct stage *stage, int rows, const char *material) {
    char materials[512] = "", meshes[1024] = "", nodes[8192] = "";
    for (int row = 0; row < rows; row++) {
        const char *end = row + 1 < rows ? ", " : "";
        double x = 0, z = 0;
        snprintf(materials + strlen(materials), sizeof materials - strlen(materials), "%s%s",
                 material, end);
        snprintf(meshes + strlen(meshes), sizeof meshes - strlen(meshes),
                 "{primitives: [{attributes: {POSITION: 0}, indices: 1, material: %d}]}%s", row,
                 end);
        for (int i = 0; i < ANGLES; i++) {
            double angle = angles[i] * GLM_PI / 180;
            snprintf(nodes + strlen(nodes), sizeof nodes - strlen(nodes),
                     "{mesh: %d, translation: [%g, %d, %g], scale: [%g, 1, 1], rotation: [0, %g, "
                     "0, %g]}%s",
                     row, x, row, z, 1 / cos(angle), sin(angle / 2), cos(angle / 2),
                     i + 1 < ANGLES ? ", " : end);
            x += 1;
            z -= tan(angle);
        }
    }
    char all[3][sizeof nodes + 2];
    snprintf(all[0], sizeof all[0], "[%s]", materials);
    snprintf(all[1], sizeof all[1], "[%s]", meshes);
    snprintf(all[2], sizeof all[2], "[%s]", nodes);
    *stage = open_stage(
        write_parts("roof.glb", &PARTS(.materials = all[0], .meshes = all[1], .nodes = all[2])));
    stage->camera =
        FILLED(camera, .eye = {ANGLES / 2.F, ANGLES / 2.F, 1}, .right = {1, 0, 0}, .up = {0, 1, 0},
               .forward = {0, 0, -1}, .orthographic = true, .y_extent = ANGLES / 2.F);
    set_sky(stage, SKY_WIDTH, SKY_HEIGHT, paint_even);
}

/* A dielectric shows all light, a metal what its lobe reflects once. */
TEST(furnace) {
    static const struct {
        const char *name;
        float metalness, f0;
    } kinds[] = {{"dielectric", 0, .04F}, {"specular-glossiness", 0, .3F}, {"metal", 1, .04F}};
    int rows = is_long_run() ? 5 : 2;
    OWNED(stage) stage;
    open_roof(&stage, rows, "{doubleSided: false}");
    for (int k = 0; k < 3; k++) {
        double most = 0, farthest = 0;
        for (int row = 0; row < rows; row++) {
            struct material *material = &stage.scene.materials[row];
            material->metalness = kinds[k].metalness;
            material->roughness = roughnesses[row];
            material->specular_glossiness = k == 1;
            glm_vec3_broadcast(kinds[k].f0, material->specular_f0);
        }
        OWNED(image) got = render_stage(&stage, "unshadowed", "", CELL * ANGLES);
        int red = image_find_channel(&got, "R");
        for (int i = 0; i < rows * ANGLES; i++) {
            int row = i / ANGLES, x = CELL * (i % ANGLES) + CELL / 2;
            float cosine = cosf(glm_rad((float)angles[i % ANGLES]));
            double shown = image_at(&got, x, CELL * (ANGLES - row) - CELL / 2)[red];
            double wanted =
                k == 2 ? lobe_albedo(1, 1, roughnesses[row] * roughnesses[row], cosine) : 1;
            most = fmax(most, shown);
            farthest = fmax(farthest, fabs(shown - wanted));
        }
        printf("  %s\n", kinds[k].name);
        check_at_most("most", most, 1.005);
        check_at_most("farthest from what it reflects", farthest, .01);
    }
}

/* A pane that transmits .4 of what enters shows all light: past it, diffuse and mirrored. */
TEST(furnace_of_glass) {
    OWNED(stage) stage;
    open_roof(&stage, 1,
              "{pbrMetallicRoughness: {metallicFactor: 0, roughnessFactor: 0}, extensions: "
              "{KHR_materials_transmission: {transmissionFactor: 0.4}}}");
    OWNED(image) got = render_stage(&stage, "unshadowed", "", CELL * ANGLES);
    for (int i = 0; i < ANGLES; i++)
        check_near("glass at an angle",
                   (double)image_at(&got, CELL * i + CELL / 2,
                                    CELL * ANGLES - CELL / 2)[image_find_channel(&got, "R")],
                   1, .005);
}

/* --- rough metal ------------------------------------------------------------------------------ */

/* A floor 6 m before a wall of 3 m, seen 20 degrees above it: the wall takes the middle of most
 * lobes, and their tails find the sky. */
static void open_metal_floor(struct stage *stage) {
    const float cosine = cosf(.35F), sine = sinf(.35F);
    open_quads(stage, "translation: [0, 0, 2]",
               "{mesh: 0, scale: [60, 80, 1], translation: [-30, -40, 0]},{mesh: 0, rotation: [0, "
               "0.70710678, 0, 0.70710678], scale: [3, 80, 1], translation: [0, -40, 3]}");
    stage->scene.materials[0].metalness = 1;
    stage->camera = FILLED(camera, .eye = {3 + 20 * cosine, 0, 20 * sine}, .right = {0, 1, 0},
                           .up = {-sine, 0, cosine}, .forward = {-cosine, 0, -sine},
                           .orthographic = true, .y_extent = 3 * sine);
}

TEST(metal_before_wall) {
    static const struct {
        float roughness;
        double bound; /* of noise; .2 has no blur */
    } rows[] = {{.4F, .15}, {.6F, .08}, {.2F, 1.4}};
    OWNED(stage) stage;
    open_metal_floor(&stage);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (!is_tried_here(i, 3))
            continue;
        printf("  roughness %g\n", (double)rows[i].roughness);
        stage.scene.materials[0].roughness = rows[i].roughness;
        OWNED(image)
        reference = TRACE(&stage, .width = SIZE, .height = SIZE, .samples = 64, .centers = true);
        OWNED(image) got = render_stage(&stage, "unshadowed", "", SIZE);
        double mean = layer_mean(&reference, "direct.specular");
        check_near("mirrored sky, mean", layer_mean(&got, "direct.specular"), mean, .03 * mean);
        check_at_most("its relative RMSE", relative_rmse(&got, &reference, "direct.specular"),
                      rows[i].bound);
    }
}

/* --- a closed room, 1 m wide and high, its walls two triangles thin --------------------------- */

/* Wall x = .5 has a window there; +Z is up. */
static const float window[4][3] = {
    {.5F, -.25F, .3F}, {.5F, .25F, .3F}, {.5F, .25F, .8F}, {.5F, -.25F, .8F}};

/* Lambert's sum over the window's corners, over pi. */
static double through_window(const float place[3]) {
    vec3 to[4];
    double sum = 0;
    if (place[2] > 1e-3F)
        return -1;
    for (int i = 0; i < 4; i++) {
        glm_vec3_sub((float *)window[i], (float *)place, to[i]);
        vec3_unit(to[i]);
    }
    for (int i = 0; i < 4; i++) {
        vec3 normal;
        glm_vec3_cross(to[i], to[(i + 1) % 4], normal);
        double angle = acos((double)glm_vec3_dot(to[i], to[(i + 1) % 4]));
        sum += angle * (double)(normal[2] / glm_vec3_norm(normal));
    }
    return fabs(sum) / (2 * GLM_PI);
}

#define ACROSS_X "rotation: [0, 0.70710678, 0, 0.70710678]"
#define ACROSS_Y "rotation: [-0.70710678, 0, 0, 0.70710678]"
#define ROOM                                                                                       \
    "{mesh: 0, translation: [-0.5, -0.5, 0]},{mesh: 0, translation: [-0.5, -0.5, 1]},{mesh: "      \
    "0, " ACROSS_X ", translation: [-0.5, -0.5, 1]},{mesh: 0, " ACROSS_Y                           \
    ", translation: [-0.5, -0.5, 1]},{mesh: 0, " ACROSS_Y ", translation: [-0.5, 0.5, 1]},"
#define PIECE(depth, width, y, z)                                                                  \
    "{mesh: 0, " ACROSS_X ", scale: [" depth ", " width ", 1], translation: [0.5, " y ", " z "]}"

/* Its walls are seen edge-on, or from below a roof, by the lights whose ways leave through them. */
TEST(room) {
    struct stage stage;
    open_quads(&stage, "translation: [0, 0, 0.95]",
               ROOM PIECE("0.3", "1", "-0.5", "0.3") "," PIECE("0.2", "1", "-0.5", "1") "," PIECE(
                   "0.5", "0.25", "-0.5", "0.8") "," PIECE("0.5", "0.25", "0.25", "0.8"));
    struct shares shares = measure_shares(&stage, "", through_window);
    stage_free(&stage);
    check_near("light through a window, mean", shares.mean, shares.wanted, .1 * shares.wanted);
    check_at_most("its RMS error over the mean", shares.rms / shares.wanted, .4);
    double lit = shares.wanted;
    open_quads(&stage, "translation: [0, 0, 0.95]", ROOM PIECE("1", "1", "-0.5", "1"));
    shares = measure_shares(&stage, "", through_window);
    stage_free(&stage);
    check_at_most("of that without the window", shares.mean / lit, .006);
}

/* --- a day ------------------------------------------------------------------------------------ */

/* In progressive passes too: other directions in each, the same light on average. */
static void check_passes(const struct stage *stage, const struct image *reference) {
    OWNED(image) got;
    OWNED(renderer) renderer;
    struct renderer_desc desc = desc_of(stage, "clustered", "", SIZE, SIZE);
    int passes = is_long_run() ? 16 : 4;
    desc.progressive = true;
    open_renderer(&renderer, desc);
    for (int pass = 0; pass < passes; pass++)
        renderer_add_pass(&renderer, pass);
    check_ok("layers", renderer_read_layers(&renderer, &got));
    double mean = layer_mean(reference, "indirect");
    check_near("indirect light of passes, mean", layer_mean(&got, "indirect"), mean, .08 * mean);
    check_at_most("its relative RMSE", relative_rmse(&got, reference, "indirect"), .2);
}

/* Below the table it is too dark: what the map shows is taken to be as deep as keeps courtyards
 * dark. */
TEST(day) {
    OWNED(stage) stage = open_stage("scenes/table.glb");
    set_sky(&stage, SKY_WIDTH, SKY_HEIGHT, paint_day);
    OWNED(image) reference = trace_stage(&stage, SIZE, is_long_run() ? 256 : 64);
    OWNED(image) got = render_stage(&stage, "clustered", "", SIZE);
    double mean = layer_mean(&reference, "direct");
    check_near("direct light, mean", layer_mean(&got, "direct"), mean, .06 * mean);
    check_at_most("direct light, relative RMSE", relative_rmse(&got, &reference, "direct"), .12);
    mean = layer_mean(&reference, "indirect");
    check_near("indirect light, mean", layer_mean(&got, "indirect"), mean, .12 * mean);
    check_at_most("indirect light, relative RMSE", relative_rmse(&got, &reference, "indirect"), .3);
    check_passes(&stage, &reference);
}

/* A sky of one bright texel is a sun: the direct light of a directional light of L times its solid
 * angle, of its width. */
static void paint_texel(const float direction[3], float radiance[3]) {
    const struct environment sky = {.width = SKY_WIDTH, .height = SKY_HEIGHT};
    int column, row;
    environment_texel(&sky, direction, &column, &row);
    glm_vec3_broadcast(column == TEXEL_COLUMN && row == TEXEL_ROW ? TEXEL_RADIANCE : 0, radiance);
}

TEST(texel) {
    struct emitter sun = {.type = EMITTER_DIRECTIONAL, .number = -1};
    float towards[3];
    OWNED(stage) stage = open_stage("scenes/table.glb");
    set_sky(&stage, SKY_WIDTH, SKY_HEIGHT, paint_texel);
    const struct environment *sky = stage.scene.environment;
    double solid_angle = environment_solid_angle(sky, TEXEL_ROW);
    environment_direction(sky, TEXEL_COLUMN + .5, TEXEL_ROW + .5, towards);
    OWNED(image) got = render_stage(&stage, "unshadowed", "", SIZE);
    int samples = is_long_run() ? 64 : 16;
    OWNED(image) reference = trace_stage(&stage, SIZE, samples);
    glm_vec3_negate(towards);
    emitter_aim(&sun, towards);
    glm_vec3_broadcast((float)(TEXEL_RADIANCE * solid_angle), sun.intensity);
    sun.size[0] = (float)(2 * sqrt(solid_angle / GLM_PI));
    struct emitters scene_own = stage.emitters;
    stage.emitters = (struct emitters){.items = &sun, .count = 1};
    OWNED(image) traced = trace_stage(&stage, SIZE, samples);
    stage.emitters = scene_own;
    double mean = layer_mean(&traced, "direct");
    printf("    %g sr, %g W/m2\n", solid_angle, (double)sun.intensity[0]);
    check_near("rays, beside those of a sun", layer_mean(&reference, "direct"), mean, .01 * mean);
    check_near("mean, beside a sun", layer_mean(&got, "direct"), mean, .02 * mean);
}

/* Below a roof between walls, by the scene's own sky. */
TEST(courtyard) {
    OWNED(stage) stage = open_stage("scenes/courtyard.glb");
    OWNED(image) reference = trace_stage(&stage, SIZE, 64);
    OWNED(image) got = render_stage(&stage, "clustered", "", SIZE);
    double mean = layer_mean(&reference, "direct");
    check_near("direct light, mean", layer_mean(&got, "direct"), mean, .08 * mean);
    double error = relative_rmse(&got, &reference, "direct");
    check_at_most("direct light, relative RMSE", error, .2);
    mean = layer_mean(&reference, "indirect");
    check_near("indirect light, mean", layer_mean(&got, "indirect"), mean, .1 * mean);
    /* .35 where pixels of detail show the one direction of the sky that they are dealt. */
    check_at_most("indirect light, relative RMSE", relative_rmse(&got, &reference, "indirect"), .2);
    /* Pixels ask for each of many lights, too, though it has little. */
    OWNED(image) many = render_stage(&stage, "clustered", "sky.lights=240", SIZE);
    check_at_most("with 240 lights", relative_rmse(&many, &reference, "direct"), error);
}

/* --- beside other lights ---------------------------------------------------------------------- */

TEST(sum) {
    const char *settings = is_long_run() ? "" : "shadow-size=512 rsm-size=64 vpls=64";
    OWNED(stage) stage = open_stage("scenes/table.glb");
    set_sky(&stage, SKY_WIDTH, SKY_HEIGHT, paint_day);
    for (const struct direct_method *const *method = direct_methods; *method; method++) {
        if (!is_tried_here((size_t)(method - direct_methods), 3))
            continue;
        struct renderer_desc desc = desc_of(&stage, "unshadowed", settings, SIZE, SIZE);
        struct image layers[3];
        double farthest = 0;
        desc.direct = *method;
        for (int i = 0; i < 3; i++) { /* both, the sky, the lamp */
            desc.emitters.count = i != 1;
            desc.emitters.sky = i != 2 ? stage.scene.environment : NULL;
            layers[i] = render_layers(&desc);
        }
        int direct = image_find_channel(&layers[0], "direct.R");
        for (int p = 0; p < SIZE * SIZE; p++) {
            int x = p % SIZE, y = p / SIZE;
            double sum =
                (double)(image_at(&layers[1], x, y)[direct] + image_at(&layers[2], x, y)[direct]);
            double both = (double)image_at(&layers[0], x, y)[direct];
            farthest = fmax(farthest, fabs(both - sum) / fmax(sum, 1e-3));
        }
        printf("  %s\n", (*method)->name);
        check_at_most("both, from the sum of each", farthest, 1e-3);
        for (int i = 0; i < 3; i++)
            image_free(&layers[i]);
    }
}

/* A black sky lights nothing, and all else is as without. */
static void paint_black(const float direction[3], float radiance[3]) {
    (void)direction;
    glm_vec3_zero(radiance);
}

TEST(black) {
    OWNED(stage) stage = open_stage("scenes/table.glb");
    OWNED(image) without = render_stage(&stage, "clustered", "", SIZE);
    set_sky(&stage, SKY_WIDTH, SKY_HEIGHT, paint_black);
    OWNED(image) dark = render_stage(&stage, "clustered", "", SIZE);
    check_finite("black sky alone", &dark);
    check_near("its light", layer_mean(&dark, "direct") + layer_mean(&dark, "indirect"), 0, 0);
    stage.emitters.count = 1;
    OWNED(image) with = render_stage(&stage, "clustered", "", SIZE);
    assert_true(same_pixels(&without, &with));
}

RUN_TESTS(open_group_context, close_group_context)
