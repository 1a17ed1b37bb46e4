/* What cameras, lights and VPLs see, and the light that is gathered, against rays and sums on the
 * CPU. */
#include "base/unit.h"
#include "render_support.h"

#include "base/spiral.h"
#include "reference/scene/emission.h"
#include "shared/vpl.h"
#include "techniques/many_lights.h"

static const char *const cornell_box = "scenes/cornell-box.glb";
static const char *const cornell_animal = "scenes/cornell-animal.glb";

/* A stage, its rays, one frame and its layers. */
struct bench {
    struct stage stage;
    struct rays rays;
    struct renderer renderer;
    struct image layers;
};

static void run_frame(struct bench *bench, const char *technique, const char *settings, int size) {
    open_renderer(&bench->renderer, desc_of(&bench->stage, technique, settings, size, size));
    check_ok("layers", renderer_read_layers(&bench->renderer, &bench->layers));
}

static void end_frame(struct bench *bench) {
    renderer_free(&bench->renderer);
    image_free(&bench->layers);
}

static void open_bench(struct bench *bench, const char *scene) {
    bench->stage = open_stage(scene);
    open_rays(&bench->rays, &bench->stage);
}

static void close_bench(struct bench *bench) {
    close_rays(&bench->rays);
    stage_free(&bench->stage);
}

static vec3s layer_at(const struct image *layers, const char *first, int x, int y) {
    return to_vec3s(image_at(layers, x, y) + image_find_channel(layers, first));
}

/* What a ray through the pixel's centre meets; false where either sees nothing. */
static bool pixel_hit(const struct bench *bench, int x, int y, struct hit *hit) {
    float size = (float)bench->layers.width;
    vec3 origin, direction;
    camera_ray(&bench->stage.camera, ((float)x + .5f) / size, ((float)y + .5f) / size, 1, origin,
               direction);
    int alpha = image_find_channel(&bench->layers, "A");
    return ray_scene_camera_hit(&bench->rays.scene, to_vec3s(origin), to_vec3s(direction),
                                (float[]){0, INFINITY}, 0, hit) &&
           image_at(&bench->layers, x, y)[alpha] > 0;
}

static bool nearly(vec3s a, vec3s b, float tolerance) {
    return glms_vec3_distance(a, b) <= tolerance;
}

/* --- what the camera sees --------------------------------------------------------------------- */

static void check_surfaces(const char *scene) {
    struct bench bench;
    open_bench(&bench, scene);
    run_frame(&bench, "unshadowed", "vpls=1 interleave=1", 96);
    int wrong_positions = 0, wrong_normals = 0, wrong_albedos = 0, count = 0;
    for (int y = 0; y < 96; y++)
        for (int x = 0; x < 96; x++) {
            struct hit hit;
            vec3 position;
            if (!pixel_hit(&bench, x, y, &hit))
                continue;
            count++;
            pixel_position(&bench.renderer, &bench.layers, x, y, position);
            wrong_positions +=
                !nearly(to_vec3s(position), hit.position, 1e-4f * bench.stage.geometry.radius);
            wrong_normals += !nearly(layer_at(&bench.layers, "normal.X", x, y), hit.normal, 1e-3f);
            /* Ten bits of the root: a step near white is 0.002. */
            wrong_albedos +=
                !nearly(layer_at(&bench.layers, "albedo.R", x, y), hit.brdf.albedo, 4e-3f);
        }
    /* At edges rasteriser and ray may differ about the triangle. */
    printf("  %s: %d pixels\n", scene, count);
    assert_true(count > 96 * 96 / 4);
    check_at_most("pixels of another position", wrong_positions / (double)count, .003);
    check_at_most("of another normal", wrong_normals / (double)count, .003);
    check_at_most("of another albedo", wrong_albedos / (double)count, .003);
    end_frame(&bench);
    close_bench(&bench);
}

TEST(surfaces) {
    check_surfaces(cornell_box);
    check_surfaces(cornell_animal);
    check_surfaces("scenes/metaballs.glb");
}

/* --- lights ----------------------------------------------------------------------------------- */

/* The stage's light as a point light, or a directional one through the open front, slanting. */
static void make_point(struct stage *stage) {
    stage->emitters.items[0].type = EMITTER_POINT;
}

static void make_directional(struct stage *stage) {
    struct emitter *light = stage->emitters.items;
    vec3 direction = {.3f, -.4f, -1}, up = {0, 1, 0}, back;
    light->type = EMITTER_DIRECTIONAL;
    vec3_unit_to(direction, light->direction);
    glm_vec3_negate_to(light->direction, back);
    vec3_unit_cross(up, back, light->right);
    glm_vec3_cross(back, light->right, light->up);
}

static void make_nothing(struct stage *stage) {
    (void)stage;
}

static const struct light_case {
    const char *name;
    void (*make)(struct stage *stage);
} light_cases[] = {
    {"spot", make_nothing}, {"point", make_point}, {"directional", make_directional}};

/* Direct light at pixel centres; the shadow's outline is a texel of the map wide. */
static void check_direct(struct bench *bench) {
    struct emission emission;
    emission_init(&emission, &bench->stage.emitters, &bench->stage.geometry, NULL, 0);
    int wrong = 0, count = 0, lit = 0;
    run_frame(bench, "unshadowed", "vpls=1 interleave=1", 96);
    for (int y = 0; y < 96; y++)
        for (int x = 0; x < 96; x++) {
            struct hit hit;
            if (!pixel_hit(bench, x, y, &hit))
                continue;
            vec3s expected = emission_direct(&emission, &bench->rays.scene, &hit, NULL, 0).diffuse;
            count++;
            lit += expected.x > 0;
            wrong += !nearly(layer_at(&bench->layers, "direct.R", x, y), expected,
                             .01f * glms_vec3_norm(expected) + 1e-6f);
        }
    assert_true(lit > count / 20 && lit < count);
    check_at_most("pixels of another direct light", wrong / (double)count, .01);
    emission_free(&emission);
    end_frame(bench);
}

TEST(direct) {
    for (int i = 0; i < 3; i++) {
        struct bench bench;
        open_bench(&bench, cornell_animal);
        light_cases[i].make(&bench.stage);
        printf("  %s\n", light_cases[i].name);
        check_direct(&bench);
        close_bench(&bench);
    }
}

/* --- VPLs ------------------------------------------------------------------------------------- */

/* The ray of the light that ends at the VPL meets the same surface, and flux is rho I dw; of a
 * facet as much more as what it receives by the shading normal is more than by its own. */
static bool is_true_vpl(const struct bench *bench, const struct vpl *vpl) {
    const struct emitter *light = bench->stage.emitters.items;
    float radius = bench->stage.geometry.radius;
    bool directional = light->type == EMITTER_DIRECTIONAL;
    vec3s position = to_vec3s(vpl->position);
    vec3s origin = directional
                       ? glms_vec3_muladds(to_vec3s(light->direction), -4 * radius, position)
                       : to_vec3s(light->position);
    vec3s direction = vec3s_unit(glms_vec3_sub(position, origin));
    struct hit hit;
    if (!ray_scene_hit(&bench->rays.scene, origin, direction, &hit))
        return false;
    float share = bench->renderer.light_block->sources[0].measure /
                  (float)settings_number(&bench->renderer.desc.settings, "vpls");
    float cone = emitter_cone(light, glms_vec3_dot(direction, to_vec3s(light->direction)));
    vec3s flux =
        glms_vec3_scale(glms_vec3_mul(hit.brdf.albedo, to_vec3s(light->intensity)), share * cone);
    bool facets = settings_number(&bench->renderer.desc.settings, "facets") > 0;
    vec3s normal = facets ? hit.geometric_normal : hit.normal;
    float more = glms_vec3_dot(hit.normal, direction) / glms_vec3_dot(normal, direction);
    flux = glms_vec3_scale(flux, fminf(fmaxf(more, 0), 8));
    return nearly(hit.position, position, 1e-3f * radius) &&
           nearly(normal, to_vec3s(vpl->normal), 2e-3f) &&
           nearly(flux, to_vec3s(vpl->flux), .01f * glms_vec3_norm(flux));
}

static void check_vpls(const char *settings) {
    for (int i = 0; i < 3; i++) {
        struct bench bench;
        open_bench(&bench, cornell_animal);
        light_cases[i].make(&bench.stage);
        run_frame(&bench, "unshadowed", settings, 8);
        struct vpl *vpls = read_vpls(&bench.renderer);
        int emitting = 0, wrong = 0;
        for (int k = 0; k < 1024; k++) {
            emitting += vpls[k].reach > 0;
            wrong += vpls[k].reach > 0 && !is_true_vpl(&bench, &vpls[k]);
        }
        printf("  %s: %d of 1024 emit\n", light_cases[i].name, emitting);
        assert_true(emitting > 300);
        /* Texels of silhouettes. */
        check_at_most("VPLs that no ray confirms", wrong / (double)emitting, .01);
        free(vpls);
        end_frame(&bench);
        close_bench(&bench);
    }
}

TEST(vpls) {
    check_vpls("vpls=1024 interleave=1");
}

TEST(vpls_of_facets) {
    check_vpls("vpls=1024 interleave=1 facets=on");
}

/* --- gathering -------------------------------------------------------------------------------- */

/* How a clamp bounds cosines / distance^4. */
typedef double (*clamp_function)(const struct bench *bench, const struct vpl *vpl, double cosines,
                                 double distance2);

static double clamp_none(const struct bench *bench, const struct vpl *vpl, double cosines,
                         double distance2) {
    (void)bench, (void)vpl;
    return cosines / (distance2 * distance2);
}

static double clamp_value(const struct bench *bench, const struct vpl *vpl, double cosines,
                          double distance2) {
    double radius = (double)bench->stage.geometry.radius;
    return fmin(clamp_none(bench, vpl, cosines, distance2),
                (double)many_lights_clamp_value / (radius * radius));
}

static double clamp_disk(const struct bench *bench, const struct vpl *vpl, double cosines,
                         double distance2) {
    (void)bench;
    return cosines / (distance2 * (distance2 + (double)vpl->area / GLM_PI));
}

/* Irradiance over pi from VPLs first .. last, red. */
static double sum_vpls(const struct bench *bench, const struct vpl *vpls, int first, int last,
                       const struct hit *receiver, clamp_function clamp) {
    double sum = 0;
    for (int i = first; i < last; i++) {
        vec3s to_vpl = glms_vec3_sub(to_vec3s(vpls[i].position), receiver->position);
        double distance2 = (double)glms_vec3_norm2(to_vpl);
        double cosines = fmax(0, (double)glms_vec3_dot(receiver->normal, to_vpl)) *
                         fmax(0, -(double)glms_vec3_dot(to_vec3s(vpls[i].normal), to_vpl));
        if (cosines > 0)
            sum += (double)vpls[i].flux[0] * clamp(bench, &vpls[i], cosines, distance2);
    }
    return sum / (GLM_PI * GLM_PI);
}

/* The receiver as the G-buffer has it, so that a sum differs by rounding alone. */
static struct hit receiver_at(const struct bench *bench, int x, int y) {
    struct hit receiver = {.normal = layer_at(&bench->layers, "normal.X", x, y)};
    pixel_position(&bench->renderer, &bench->layers, x, y, receiver.position.raw);
    return receiver;
}

static void check_sums(const char *settings, int count, clamp_function clamp) {
    enum { SIZE = 24 };
    struct bench bench;
    open_bench(&bench, cornell_box);
    run_frame(&bench, "unshadowed", settings, SIZE);
    struct vpl *vpls = read_vpls(&bench.renderer);
    double worst = 0, mean = layer_mean(&bench.layers, "indirect");
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            struct hit receiver = receiver_at(&bench, x, y);
            if (image_at(&bench.layers, x, y)[image_find_channel(&bench.layers, "A")] <= 0)
                continue;
            double expected = sum_vpls(&bench, vpls, 0, count, &receiver, clamp);
            double value = (double)layer_at(&bench.layers, "indirect.R", x, y).x;
            worst = fmax(worst, fabs(value - expected) / (expected + .01 * mean));
        }
    printf("  %s\n", settings);
    /* Half floats: 11 bits, in the sum and after the blur that here only copies; and the position
     * that is rebuilt from depth, next to a VPL. */
    check_at_most("worst pixel's distance from the CPU's sum, relative", worst, .005);
    free(vpls);
    end_frame(&bench);
    close_bench(&bench);
}

TEST(sums) {
    check_sums("vpls=64 interleave=1 clamp=none", 64, clamp_none);
    check_sums("vpls=64 interleave=1 clamp=value", 64, clamp_value);
    check_sums("vpls=64 interleave=1 clamp=disk", 64, clamp_disk);
    /* More than one uniform block. */
    check_sums("vpls=2500 interleave=1 clamp=disk", 2500, clamp_disk);
}

/* Each pixel takes the VPLs of its slot, of N / n^2 or one more, for all. */
TEST(slots) {
    enum { SIZE = 20, N = 100, SIDE = 3, SLOTS = SIDE * SIDE };
    struct bench bench;
    open_bench(&bench, cornell_box);
    run_frame(&bench, "unshadowed", "vpls=100 interleave=3 blur-radius=0 clamp=disk", SIZE);
    struct vpl *vpls = read_vpls(&bench.renderer);
    double worst = 0, mean = layer_mean(&bench.layers, "indirect");
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            if (image_at(&bench.layers, x, y)[image_find_channel(&bench.layers, "A")] <= 0)
                continue;
            struct hit receiver = receiver_at(&bench, x, y);
            int slot = (SIZE - 1 - y) % SIDE * SIDE + x % SIDE;
            int first = slot * N / SLOTS, last = (slot + 1) * N / SLOTS;
            double expected = sum_vpls(&bench, vpls, first, last, &receiver, clamp_disk) *
                              ((double)N / (last - first));
            double value = (double)layer_at(&bench.layers, "indirect.R", x, y).x;
            worst = fmax(worst, fabs(value - expected) / (expected + .01 * mean));
        }
    check_at_most("worst pixel's distance from its slot's sum, relative", worst, .005);
    free(vpls);
    end_frame(&bench);
    close_bench(&bench);
}

/* The near field's samples are a pattern's: pixels without interleaving take them all. */
TEST(near_samples) {
    OWNED(stage) stage = open_stage(cornell_box);
    OWNED(image) by_default = render_stage(&stage, "unshadowed", "vpls=64 interleave=1", 24);
    struct image all =
        render_stage(&stage, "unshadowed", "vpls=64 interleave=1 near-samples=1024", 24);
    struct image few =
        render_stage(&stage, "unshadowed", "vpls=64 interleave=1 near-samples=16", 24);
    size_t size = (size_t)24 * 24 * (size_t)all.channel_count * sizeof *all.pixels;
    assert_memory_equal(by_default.pixels, all.pixels, size);
    assert_memory_not_equal(few.pixels, all.pixels, size);
    images_free(&all, &few);
}

/* Beside an edge between two lit planes, `away` texels from it in the light's view: what a sample
 * of the near field finds there, by the logarithm of its radius, from half a texel to 142, and its
 * turn. VPLs leave the nearest 71. */
static double edge_light(double away, double log_radius, double turn) {
    double radius = .5 * exp(log(142 / .5) * log_radius);
    double beside = radius * sin(2 * GLM_PI * turn), up = radius * cos(2 * GLM_PI * turn) - away;
    double distance2 = away * away + up * up + beside * beside;
    double share = fmax(1 - distance2 / (71. * 71.), 0);
    return up <= 0 ? 0 : up * away / (distance2 * distance2) * radius * radius * share * share;
}

static double edge_light_of_place(double away, double edge, int x, int y) {
    enum { samples = 16 };
    struct spiral_shift shift = spiral_shift(x, y, 0);
    double sum = 0;
    for (int i = 0; i < samples; i++)
        sum += edge_light(away, ((double)i + (double)shift.along) / samples,
                          SPIRAL_TURN * i + (double)shift.turn + edge);
    return sum / samples;
}

static double all_edge_light(double away) {
    enum { n = 200 };
    double sum = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            sum += edge_light(away, (i + .5) / n, (j + .5) / n);
    return sum / (n * n);
}

/* Of a pattern's places, by the part that they are of: what each part finds over what there is,
 * root mean square of what that errs by, for edges of all directions, near and far. */
static double error_of_parts(int (*part_of)(int x, int y), int parts) {
    double sum2 = 0;
    int count = 0;
    for (double away = 2; away < 40; away *= 2)
        for (int edge = 0; edge < 16; edge++) {
            double found[8] = {0}, all = all_edge_light(away);
            for (int place = 0; place < 64; place++)
                found[part_of(place % 8, place / 8)] +=
                    edge_light_of_place(away, edge / 16., place % 8, place / 8) * parts / 64;
            for (int part = 0; part < parts; part++, count++)
                sum2 += pow(found[part] / all - 1, 2);
        }
    return sqrt(sum2 / count);
}

static int row_of(int x, int y) {
    (void)x;
    return y;
}

static int column_of(int x, int y) {
    (void)y;
    return x;
}

static int slant_of(int x, int y) {
    return (x + y) % 8;
}

static int quarter_of(int x, int y) {
    return x / 4 + y / 4 * 2;
}

static int all_of(int x, int y) {
    (void)x, (void)y;
    return 0;
}

/* What the blur finds beside an edge, where it does not find all of a pattern, tells the light as
 * all would. */
TEST(near_places) {
    check_at_most("a row's error, relative (Halton's points: .18)", error_of_parts(row_of, 8), .06);
    check_at_most("a column's (.18)", error_of_parts(column_of, 8), .06);
    check_at_most("a slanted line's (.33)", error_of_parts(slant_of, 8), .06);
    check_at_most("a quarter's (.14)", error_of_parts(quarter_of, 4), .015);
    check_at_most("all places' (.025)", error_of_parts(all_of, 1), .01);
}

/* A lamp above a table looks into five faces of a cube: what lies beyond an edge of the face that a
 * receiver is in, another face has, and its texels' solid angles. */
TEST(near_faces) {
    OWNED(stage) stage = open_stage("scenes/table.glb");
    OWNED(image) drawn = render_stage(&stage, "clustered", "samples=1", 64);
    OWNED(image) reference = trace_stage(&stage, 64, 64);
    check_at_most("relative RMSE", relative_rmse(&drawn, &reference, "indirect"), .16);
}

/* Of the light that would be there the part that is: behind a sheet that divides the room, in whose
 * shadow all is dark, and in a corner, where nothing is between. */
static double share_of_unshadowed(const struct stage_desc *desc, const char *technique,
                                  const char *settings) {
    struct stage stage;
    check_ok(desc->path, stage_init(&stage, desc));
    struct image frame = render_stage(&stage, technique, settings, 64);
    struct image all = render_stage(&stage, "unshadowed", "vpls=64", 64);
    double share = layer_mean(&frame, "indirect") / layer_mean(&all, "indirect");
    images_free(&frame, &all);
    stage_free(&stage);
    return share;
}

/* Brightest pixel over the mean, of near light from a shadow map of so many texels a side. */
static double brightest_from(const struct stage *stage, int texels) {
    const char *settings =
        form("vpls=64 interleave=1 samples=1 near-samples=256 facets=on rsm-size=%d", texels);
    OWNED(image) frame = render_stage(stage, "unshadowed", settings, 128);
    int channel = image_find_channel(&frame, "indirect.G");
    double sum = 0, most = 0;
    for (int i = 0; i < 128 * 128; i++) {
        double light = frame.pixels[i * frame.channel_count + channel];
        sum += light;
        most = fmax(most, light);
    }
    return most * 128 * 128 / sum;
}

/* Where a receiver lies in the middle of a texel, the texel is no nearer than a quarter of its
 * width: without a bound one pixel is 86 times the mean. */
TEST(near_facets) {
    const struct stage_desc desc = {
        .path = "scenes/cornell-animal.glb",
        .camera = "0 eye=.31,1.2,.9 forward=-.3,-1,-.9 fov=1.1",
        .light = "0 position=.3,1.2,.9 direction=-.3,-1,-.9 cone=.85,.8",
    };
    OWNED(stage) stage;
    check_ok(desc.path, stage_init(&stage, &desc));
    check_at_most("brightest pixel, 32 texels a side over 1024",
                  brightest_from(&stage, 32) / brightest_from(&stage, 1024), 4);
}

TEST(near_occlusion) {
    const struct stage_desc behind_sheet = {
        .path = "scenes/failures/thin-wall.glb",
        .camera = "0 eye=1.4,1.2,1.8 forward=-.15,-.25,-1 fov=1.1",
        .light = "0 position=-.4,1,-.5 direction=.6,-.6,-.9 cone=.85,.8",
    };
    const struct stage_desc corner = {.path = "scenes/failures/corner.glb"};
    static const char *const views = "vpls=64 vals=64",
                             *const rays = "vpls=64 interleave=1 instant-radiosity.traced=on";
    check_at_most("of unshadowed light, behind a sheet",
                  share_of_unshadowed(&behind_sheet, "clustered", views), .018);
    check_near("in a corner", share_of_unshadowed(&corner, "clustered", views), 1, .03);
    check_at_most("the same by rays", share_of_unshadowed(&behind_sheet, "instant-radiosity", rays),
                  1e-4);
    check_near("in a corner", share_of_unshadowed(&corner, "instant-radiosity", rays), 1, .03);
}

/* --- visibility ------------------------------------------------------------------------------- */

/* One VPL with one map: each pixel has all of its light or none, as a ray to it says. */
static void check_map_of_vpl(const char *scene, int seed) {
    enum { SIZE = 64 };
    struct bench bench;
    open_bench(&bench, scene);
    const char *settings = form("vpls=1 interleave=1 clamp=disk seed=%d", seed);
    run_frame(&bench, "instant-radiosity", settings, SIZE);
    struct vpl *vpl = read_vpls(&bench.renderer);
    int wrong = 0, count = 0, blocked = 0;
    vec3s light = glms_vec3_muladds(to_vec3s(vpl->normal), 1e-3f * bench.stage.geometry.radius,
                                    to_vec3s(vpl->position));
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            struct hit hit;
            if (!pixel_hit(&bench, x, y, &hit))
                continue;
            struct hit receiver = receiver_at(&bench, x, y);
            double expected = sum_vpls(&bench, vpl, 0, 1, &receiver, clamp_disk);
            if (expected <= 0)
                continue;
            bool visible = ray_scene_visible(&bench.rays.scene,
                                             ray_scene_departure(&bench.rays.scene, &hit), light);
            double value = (double)layer_at(&bench.layers, "indirect.R", x, y).x;
            count++;
            blocked += !visible;
            wrong += (value > expected / 2) != visible;
        }
    printf("  %s seed %d: %d pixels, %d blocked\n", scene, seed, count, blocked);
    if (vpl->reach > 0)
        assert_true(count > SIZE * SIZE / 10);
    check_at_most("pixels whose visibility a ray denies", wrong / fmax(count, 1), .02);
    free(vpl);
    end_frame(&bench);
    close_bench(&bench);
}

TEST(map_of_vpl) {
    for (int seed = 1; seed <= 4; seed++) {
        check_map_of_vpl(cornell_box, seed);
        check_map_of_vpl(cornell_animal, seed);
    }
}

RUN_TESTS(open_group_context, close_group_context)
