/* VPLs placed by importance: their light is right on the mean, and differs less from set to set. */
#include "render_support.h"

#include "shared/importance_map.h"
#include "techniques/many_lights.h"

enum { CELLS = VPL_DENSITY_SIDE * VPL_DENSITY_SIDE, SETS = 5, SIZE = 32 };

/* --- the map ---------------------------------------------------------------------------------- */

static float *read_texels(const struct texture *texture, GLenum format, int channels) {
    size_t count = (size_t)(texture->desc.width * texture->desc.height * channels);
    float *texels = mem_alloc(count, sizeof *texels);
    gl.GetTextureImage(texture->id, 0, format, GL_FLOAT, (GLsizei)(count * sizeof *texels), texels);
    return texels;
}

/* Of a light's cells: the mean, and the least. */
static double mean_density(const float *densities, int width, int light, double *least) {
    double sum = 0;
    for (int i = 0; i < CELLS; i++) {
        int x = light % VPL_DENSITY_ROW * VPL_DENSITY_SIDE + i % VPL_DENSITY_SIDE;
        int y = light / VPL_DENSITY_ROW * VPL_DENSITY_SIDE + i / VPL_DENSITY_SIDE;
        double density = (double)densities[y * width + x];
        sum += density;
        *least = fmin(*least, density);
    }
    return sum / CELLS;
}

/* All fractions add up to one, and no place is left out: a quarter of the lights, a quarter of the
 * cells. */
TEST(densities) {
    OWNED(stage) stage = open_stage("scenes/courtyard.glb");
    OWNED(renderer) renderer;
    open_renderer(&renderer, desc_of(&stage, "clustered", "lights.importance=on", SIZE, SIZE));
    const struct many_lights *technique = renderer.technique_state;
    const struct importance_map *map = &technique->importance.map;
    float *densities = read_texels(&map->densities, GL_RED, 1),
          *lights = read_texels(&map->lights, GL_RG, 2);
    double worst = 0, least = INFINITY, last = 0;
    for (int i = 0; i < map->lights.desc.width; i++) {
        double of_light = (double)lights[2 * i];
        double mean = mean_density(densities, map->densities.desc.width, i, &least);
        worst = fmax(worst, fabs(mean / of_light - 1));
        assert_true((double)lights[2 * i + 1] >= last);
        last = (double)lights[2 * i + 1];
    }
    check_at_most("mean density of a light's cells, over the light's", worst, 1e-4);
    check_at_most("fractions of all lights, from 1", fabs(last - 1), 1e-5);
    check_at_most("density by flux alone over the least", 1 / least, 16.1);
    mem_free(densities, lights);
}

/* --- sets of VPLs ----------------------------------------------------------------------------- */

struct sets {
    double mean, error; /* of the picture's indirect light, and its standard error */
    double spread; /* standard deviation over sets of a value over its mean: the mean over pixels */
};

static double add_pixels(const struct image *image, double *sums, double *squares) {
    int channel = image_find_channel(image, "indirect.R");
    double sum = 0;
    for (int i = 0; i < SIZE * SIZE; i++)
        for (int c = 0; c < 3; c++) {
            double value = (double)image_at(image, i % SIZE, i / SIZE)[channel + c];
            sums[3 * i + c] += value / SETS;
            squares[3 * i + c] += value * value / SETS;
            sum += value;
        }
    return sum / (3 * SIZE * SIZE);
}

static struct sets measure_sets(const struct stage *stage, const char *importance) {
    static double sums[3 * SIZE * SIZE], squares[3 * SIZE * SIZE];
    OWNED(renderer) renderer = {0};
    struct sets sets = {0};
    double square = 0;
    memset(sums, 0, sizeof sums);
    memset(squares, 0, sizeof squares);
    for (int seed = 1; seed <= SETS; seed++) {
        char *settings =
            mem_printf("lights.importance=%s lights.seed=%d lights.vpls=512", importance, seed);
        struct renderer_desc desc = desc_of(stage, "clustered", settings, SIZE, SIZE);
        OWNED(image) image = follow_layers(&renderer, &desc);
        double mean = add_pixels(&image, sums, squares);
        sets.mean += mean / SETS;
        square += mean * mean / SETS;
        free(settings);
    }
    sets.error = sqrt(fmax(square - sets.mean * sets.mean, 0) / (SETS - 1));
    for (int i = 0; i < 3 * SIZE * SIZE; i++)
        sets.spread += sqrt(fmax(squares[i] - sums[i] * sums[i], 0)) / (sums[i] + .01 * sets.mean);
    sets.spread /= 3 * SIZE * SIZE;
    printf("    importance=%-4s mean %.4f +- %.4f, spread over sets %.3f\n", importance, sets.mean,
           sets.error, sets.spread);
    return sets;
}

/* Under a sky most VPLs by flux lie on roofs and outer walls. */
TEST(sky) {
    OWNED(stage) stage;
    check_ok("stage", stage_init(&stage, &(struct stage_desc){.path = "scenes/atrium.glb",
                                                              .light = "sky",
                                                              .environment = {"scenes/day.hdr"}}));
    struct sets off = measure_sets(&stage, "off"), on = measure_sets(&stage, "on");
    double error = hypot(off.error, on.error);
    check_at_most("means apart, standard errors", fabs(on.mean - off.mean) / error, 3);
    check_at_most("spread, over that by flux alone", on.spread / off.spread, .9);
}

/* --- when ------------------------------------------------------------------------------------- */

static bool same(const struct stage *stage, const char *technique, const char *a, const char *b) {
    OWNED(image) of_a = render_stage(stage, technique, a, SIZE),
                 of_b = render_stage(stage, technique, b, SIZE);
    bool equal = same_pixels(&of_a, &of_b);
    return equal;
}

/* By itself where light starts from several samples, and something tests visibility. */
TEST(auto) {
    OWNED(stage) box, courtyard;
    box = open_stage("scenes/cornell-box.glb");
    courtyard = open_stage("scenes/courtyard.glb");
    assert_true(same(&box, "clustered", "", "lights.importance=off"));
    assert_false(same(&box, "clustered", "", "lights.importance=on"));
    assert_true(same(&courtyard, "clustered", "", "lights.importance=on"));
    assert_false(same(&courtyard, "clustered", "", "lights.importance=off"));
    assert_true(same(&courtyard, "unshadowed", "", "lights.importance=off"));
}

/* What follows shows no other bit than what begins there. */
static void check_followed(const char *what, struct renderer *renderer,
                           const struct renderer_desc *desc) {
    struct image moved;
    check_ok(what, renderer_follow(renderer, desc));
    renderer_render(renderer);
    check_ok("layers", renderer_read_layers(renderer, &moved));
    struct image fresh = render_layers(desc);
    assert_true(same_pixels(&moved, &fresh));
    images_free(&moved, &fresh);
}

/* The hall's lamp stands outdoors: an eleventh of its light falls where the camera sees any of it.
 * Indoors all of it does, and a renderer whose lamp moves there chooses anew. */
TEST(next_door) {
    const float down[] = {0, -1, 0};
    OWNED(stage) hall = open_stage("scenes/hall.glb");
    OWNED(renderer) renderer;
    assert_true(same(&hall, "clustered", "", "lights.importance=on"));
    assert_false(same(&hall, "clustered", "", "lights.importance=off"));
    assert_true(same(&hall, "unshadowed", "", "lights.importance=off"));
    struct renderer_desc desc = desc_of(&hall, "clustered", "", SIZE, SIZE);
    open_renderer(&renderer, desc);
    memcpy(hall.emitters.items[0].position, (float[]){0, 4, 0}, sizeof(float[3]));
    emitter_aim(&hall.emitters.items[0], down);
    assert_true(same(&hall, "clustered", "", "lights.importance=off"));
    assert_false(same(&hall, "clustered", "", "lights.importance=on"));
    desc.emitters = hall.emitters;
    check_followed("lamp indoors", &renderer, &desc);
}

/* More than a row of a texture holds. */
TEST(many) {
    OWNED(stage) hall = open_stage("scenes/hall.glb");
    OWNED(renderer) renderer;
    open_renderer(&renderer,
                  desc_of(&hall, "lightcuts",
                          "lights.importance=on,lights.bounces=2,lights.vpls=20000", 8, 8));
}

/* Lights that are kept while the camera moves are no others than those of a frame that begins
 * there. */
TEST(kept) {
    OWNED(stage) stage = open_stage("scenes/courtyard.glb");
    OWNED(renderer) renderer;
    struct renderer_desc desc = desc_of(&stage, "clustered", "", SIZE, SIZE);
    desc.keep_lights = true;
    open_renderer(&renderer, desc);
    desc.camera.eye[0] += .1F;
    check_followed("a step", &renderer, &desc);
}

RUN_TESTS(open_group_context, close_group_context)
