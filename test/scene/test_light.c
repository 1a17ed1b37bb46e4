/* Exact answers: inside a diffuse sphere direct light and one bounce are known at every point; and
 * what the VPLs reflect is what meets the surfaces, times albedo. */
#include "render_support.h"

#include "base/deal.h"
#include "shared/vpl.h"

#include <cglm/cglm.h>

/* --- inside a diffuse sphere ------------------------------------------------------------------ */

/* scenes/sphere.glb: radius 1, albedo 1/2, a point light of pi W/sr in the centre. Direct radiance
 * rho I / (pi R^2) everywhere, and one bounce exactly rho times that: cos cos / d^2 = 1 / (4 R^2)
 * for any two points, so that any VPLs, slots and clusters give the same. The layers
 * are without the receiver's albedo. */
static const double exact_direct = 1, exact_indirect = .5;

/* The triangles lie up to this far below the sphere. Where receiver and VPL lie in facets of
 * depths that differ by h, the product of the cosines is off by (2 h / d^2)^2. */
static const double facet_depth = 4e-4;

/* What to allow beyond the tolerance for the VPLs next to a receiver. */
static double facet_error(const struct vpl *vpls, int count, const vec3 receiver) {
    double error = 0;
    for (int i = 0; i < count; i++) {
        double d2 = (double)glm_vec3_distance2((float *)vpls[i].position, (float *)receiver);
        error += fmin(1, pow(2 * facet_depth / fmax(d2, 1e-9), 2)) / count;
    }
    return error;
}

struct sphere_case {
    const char *technique;
    int vpls, vals, interleave;
    double mean, worst; /* bounds of the relative error */
    const char *more;   /* settings */
};

static void check_direct(const struct image *image) {
    int channel = image_find_channel(image, "direct.R");
    double worst = 0;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            worst = fmax(worst, fabs((double)image_at(image, x, y)[channel] / exact_direct - 1));
    check_at_most("direct light at the worst pixel", worst, .005);
}

/* The part of the worst pixel's error that facets do not explain. */
static double worst_indirect(const struct renderer *renderer, const struct image *image) {
    int count = (int)settings_number(&renderer->desc.settings, "vpls");
    struct vpl *vpls = read_vpls(renderer);
    int channel = image_find_channel(image, "indirect.R");
    double worst = 0;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++) {
            vec3 position;
            pixel_position(renderer, image, x, y, position);
            double error = fabs((double)image_at(image, x, y)[channel] / exact_indirect - 1);
            worst = fmax(worst, error - facet_error(vpls, count, position));
        }
    free(vpls);
    return worst;
}

static void check_sphere(const struct stage *stage, const struct sphere_case *row) {
    OWNED(renderer) renderer;
    OWNED(image) image;
    /* Any bound of the geometry term, also the disk's, takes light away that is exact here. */
    const char *settings = form("vpls=%d vals=%d interleave=%d clamp=none %s", row->vpls, row->vals,
                                row->interleave, row->more);
    printf("  %s %s\n", row->technique, settings);
    open_renderer(&renderer, desc_of(stage, row->technique, settings, 64, 64));
    check_ok("layers", renderer_read_layers(&renderer, &image));
    check_direct(&image);
    check_near("one bounce, mean", layer_mean(&image, "indirect") / exact_indirect, 1, row->mean);
    check_at_most("one bounce at the worst pixel", worst_indirect(&renderer, &image), row->worst);
}

/* Every N that the interleave allows; and every M up to N. */
static void check_technique(const char *technique, const char *more, bool clusters, double mean,
                            double worst) {
    static const int vpls[] = {16, 64, 1024}, vals[] = {1, 8, 30}, interleaves[] = {1, 8};
    struct stage stage = open_stage("scenes/sphere.glb");
    for (int n = 0; n < 3; n++)
        for (int i = 0; i < 2; i++)
            for (int m = 0; m < (clusters ? 3 : 1); m++)
                if (is_tried_here((size_t)(n + i + m + 1), 2) &&
                    interleaves[i] * interleaves[i] <= vpls[n] && vals[m] <= vpls[n])
                    check_sphere(&stage, &(struct sphere_case){technique, vpls[n], vals[m],
                                                               interleaves[i], mean, worst, more});
    stage_free(&stage);
}

TEST(sphere_unshadowed) {
    check_technique("unshadowed", "", false, .01, .01);
}

TEST(sphere_instant_radiosity) {
    check_technique("instant-radiosity", "", false, .01, .01);
}

TEST(sphere_clustered) {
    check_technique("clustered", "visibility=cssm visibility-block=0 caster-error=0", true, .01,
                    .03);
}

/* The plane that PCSS compares with leaves the sphere where a filter is as wide as the sphere: with
 * 16 or 64 VPLs a VAL spans a good part of it. */
TEST(sphere_pcss) {
    check_technique("clustered", "visibility=pcss caster-error=0", true, .02, .04);
    /* Simplified casters are chords of the sphere; they must not come before it. */
    check_technique("clustered", "visibility=pcss", true, .02, .04);
}

static double mean_with(const struct stage *stage, const char *clamp, int vpls) {
    const char *settings = form("vpls=%d interleave=1 clamp=%s", vpls, clamp);
    OWNED(image) image = render_stage(stage, "unshadowed", settings, 64);
    double mean = layer_mean(&image, "indirect") / exact_indirect;
    return mean;
}

/* The bound of the geometry term by the VPL's own area takes light away: a disk of area A seen at
 * distance d has d^2 + A / pi in place of d^2. Here A = 4 pi / N; over the sphere the mean of
 * d^2 / (d^2 + 4 / N), with d^2 uniform over [0, 4], is 1 - ln(1 + N) / N. The near field gives
 * back what it takes, but for its noise. */
TEST(sphere_clamps) {
    OWNED(stage) stage = open_stage("scenes/sphere.glb");
    for (int n = 64; n <= 1024; n *= 4) {
        double lost = log(1 + n) / n;
        printf("  N = %d\n", n);
        /* The picture is a part of the sphere, VPLs are no continuum, and it comes in half
         * floats. */
        check_near("one bounce with the disk's form factor, mean", mean_with(&stage, "disk", n),
                   1 - lost, .3 * lost + .0005);
        check_near("one bounce with the near field, mean", mean_with(&stage, "near", n), 1, .01);
    }
}

/* --- energy ----------------------------------------------------------------------------------- */

enum { ENERGY_VPLS = 4096, LIGHTS = 3 };

/* Sums of the fluxes of each light's VPLs, the mean of RGB, W. */
static void vpl_fluxes(const struct stage *stage, double sums[LIGHTS]) {
    OWNED(renderer) renderer;
    struct renderer_desc desc =
        desc_of(stage, "unshadowed", "vpls=4096 interleave=1 rsm-size=1024", 8, 8);
    struct dealt dealt[ENERGY_VPLS];
    double weights[LIGHTS] = {0};
    for (int i = 0; i < stage->emitters.count; i++)
        weights[i] = emitter_flux(&stage->emitters.items[i], stage->geometry.radius);
    deal(weights, stage->emitters.count, dealt, ENERGY_VPLS, NULL);
    open_renderer(&renderer, desc);
    struct vpl *vpls = read_vpls(&renderer);
    memset(sums, 0, LIGHTS * sizeof *sums);
    for (int i = 0; i < ENERGY_VPLS; i++)
        for (int c = 0; c < 3; c++)
            sums[dealt[i].taker] += (double)vpls[i].flux[c] / 3;
    free(vpls);
}

/* What a ray of the light's colour reflects where it lands, the mean of RGB. */
static double reflected(const struct emitter *light, const struct rays *rays, vec3s origin,
                        vec3s direction) {
    struct hit hit;
    if (!ray_scene_hit(&rays->scene, origin, direction, &hit))
        return 0;
    double sum = 0;
    for (int c = 0; c < 3; c++)
        sum += (double)(hit.brdf.albedo.raw[c] * light->intensity[c]) / 3;
    return sum;
}

/* The same flux by rays in evenly spread directions of the whole sphere (Fibonacci's spiral). */
static double reflected_by_rays(const struct emitter *light, const struct rays *rays) {
    enum { DIRECTIONS = 200000 };
    vec3s origin = to_vec3s(light->position);
    double sum = 0;
    for (int i = 0; i < DIRECTIONS; i++) {
        double z = 1 - (2 * i + 1) / (double)DIRECTIONS, r = sqrt(1 - z * z);
        double azimuth = i * GLM_PI * (3 - sqrt(5));
        vec3s direction = {{(float)(r * cos(azimuth)), (float)(r * sin(azimuth)), (float)z}};
        double cone =
            (double)emitter_cone(light, glms_vec3_dot(direction, to_vec3s(light->direction)));
        if (cone > 0)
            sum += cone * reflected(light, rays, origin, direction);
    }
    return sum * 4 * GLM_PI / DIRECTIONS;
}

/* The same by parallel rays from a square that covers the scene's bounding sphere. */
static double reflected_by_parallel_rays(const struct stage *stage, const struct emitter *light,
                                         const struct rays *rays) {
    enum { SIDE = 400 };
    vec3s direction = to_vec3s(light->direction);
    vec3s right = to_vec3s(light->right);
    vec3s up = to_vec3s(light->up);
    float radius = stage->geometry.radius, cell = 2 * radius / SIDE;
    vec3s middle = glms_vec3_muladds(direction, -2 * radius, to_vec3s(stage->geometry.center));
    double sum = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        float s = ((float)(i % SIDE) + .5f) * cell - radius;
        float t = ((float)(i / SIDE) + .5f) * cell - radius;
        vec3s origin = glms_vec3_muladds(right, s, glms_vec3_muladds(up, t, middle));
        sum += reflected(light, rays, origin, direction);
    }
    return sum * (double)(cell * cell);
}

/* Of each light by itself. */
static void check_energy(const char *what, const struct stage *stage) {
    struct rays rays;
    double sums[LIGHTS];
    open_rays(&rays, stage);
    vpl_fluxes(stage, sums);
    for (int i = 0; i < stage->emitters.count; i++) {
        const struct emitter *light = &stage->emitters.items[i];
        double expected = light->type == EMITTER_DIRECTIONAL
                              ? reflected_by_parallel_rays(stage, light, &rays)
                              : reflected_by_rays(light, &rays);
        check_near(what, sums[i] / expected, 1, .01);
    }
    close_rays(&rays);
}

/* In through the open front, slanting. */
static void make_sun(struct emitter *light) {
    light->type = EMITTER_DIRECTIONAL;
    emitter_aim(light, (const float[]){.3f, -.4f, -1});
}

TEST(energy) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    struct emitter *light = stage.emitters.items;
    assert_int_equal(light->type, EMITTER_SPOT);
    check_energy("reflected flux of the scene's spot", &stage);
    light->cos_outer = cosf(.3f);
    light->cos_inner = cosf(.1f);
    check_energy("of a narrow spot", &stage);
    light->cos_outer = cosf(1.5f);
    light->cos_inner = cosf(.2f);
    check_energy("of a spot wider than one map", &stage);
    light->type = EMITTER_POINT;
    check_energy("of a point light", &stage);
    make_sun(light);
    check_energy("of a directional light", &stage);
}

/* Of three lights of all types: each VPL stands for more where there are fewer. */
TEST(energy_of_several) {
    OWNED(stage) stage = open_stage("scenes/three-lights.glb");
    check_energy("reflected flux of two spots and a point", &stage);
    make_sun(&stage.emitters.items[1]);
    for (int c = 0; c < 3; c++)
        stage.emitters.items[1].intensity[c] /= 100;
    check_energy("of a spot, a sun and a point", &stage);
}

RUN_TESTS(open_group_context, close_group_context)
