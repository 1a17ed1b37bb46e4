/* The reflection of surfaces: closed forms, and what any reflection must keep to. */
#include "support.h"

#include "reference/brdf.h"
#include "reference/sampler.h"
#include "scene/lobe_albedo.h"

static const vec3s up = {{0, 0, 1}};

/* As if all were reflected at every angle: f0 = f90 = 1. */
static struct brdf white_metal(float roughness) {
    struct material material = {.metalness = 1, .roughness = roughness, .specular_f90 = 1};
    struct reflectance reflectance = material_reflectance(&material);
    return brdf_of(&material, glms_vec3_one(), &reflectance);
}

static struct brdf plastic(float roughness) {
    struct material material = {
        .roughness = roughness, .specular_f0 = {.04F, .04F, .04F}, .specular_f90 = 1};
    struct reflectance reflectance = material_reflectance(&material);
    return brdf_of(&material, (vec3s){{.8F, .5F, .2F}}, &reflectance);
}

static vec3s at_cosine(float cosine, float turn) {
    float sine = sqrtf(1 - cosine * cosine);
    return (vec3s){{sine * cosf(turn), sine * sinf(turn), cosine}};
}

/* The share of even light that the specular part reflects. */
static double albedo_by_samples(const struct brdf *brdf, float cosine, uint32_t count) {
    vec3s v = at_cosine(cosine, .3F);
    double sum = 0;
    for (uint32_t i = 0; i < count; i++) {
        struct sampler sampler = {.seed = 7, .index = i};
        vec3s l = brdf_sample(brdf, up, v, sampler_next(&sampler));
        float density = brdf_density(brdf, up, v, l);
        if (l.z > 0 && density > 0)
            sum += (double)(brdf_eval(brdf, up, v, l).specular.x * l.z / density);
    }
    return sum / count;
}

/* F = 1, roughness 1: 1 - mu ln(1 + 1/mu). The others are of an independent quadrature. */
TEST(albedo) {
    static const struct {
        float roughness, cosine;
        double albedo;
    } rows[] = {
        {1, 1, .306853},    {1, .5F, .450694},    {1, .1F, .760210},
        {.5F, 1, .915812},  {.5F, .5F, .857264},  {.5F, .1F, .891622},
        {.25F, 1, .995690}, {.25F, .5F, .988324}, {.25F, .1F, .896770},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct brdf brdf = white_metal(rows[i].roughness);
        printf("    roughness %.2f, cosine %.1f:", (double)rows[i].roughness,
               (double)rows[i].cosine);
        check_near("albedo", albedo_by_samples(&brdf, rows[i].cosine, 1 << 18), rows[i].albedo,
                   2e-4);
    }
}

static vec3s any_direction(uint32_t i, uint32_t pair) {
    struct sampler sampler = {.seed = 3, .index = i, .pair = pair};
    vec2s sample = sampler_next(&sampler);
    return at_cosine(.01F + .99F * sample.x, 2 * GLM_PIf * sample.y);
}

TEST(reciprocity) {
    double worst = 0;
    for (uint32_t i = 0; i < 10000; i++) {
        struct brdf brdf = plastic(.05F + (float)i / 10000);
        vec3s l = any_direction(i, 0), v = any_direction(i, 1);
        struct brdf seen_from_l = brdf;
        brdf_turn(&brdf, up, v), brdf_turn(&seen_from_l, up, l);
        struct brdf_value there = brdf_eval(&brdf, up, v, l), back = brdf_eval(&brdf, up, l, v);
        worst = fmax(worst, fabs((double)(there.specular.x / back.specular.x - 1)));
        worst = fmax(worst, fabs((double)(there.diffuse * brdf.albedo.x -
                                          back.diffuse * seen_from_l.albedo.x)));
    }
    check_near("the other way round, at worst", worst, 0, 1e-4);
}

enum { ACROSS = 12, AROUND = 24, CELLS = ACROSS * AROUND + 1 };

/* Cells even in the cosine and the turn; the last one is all below the horizon. */
static int cell_of(vec3s l) {
    if (l.z <= 0)
        return CELLS - 1;
    double turn = atan2((double)l.y, (double)l.x) / (2 * GLM_PI);
    int i = (int)fmin((double)l.z * ACROSS, ACROSS - 1), j = (int)((turn - floor(turn)) * AROUND);
    return i * AROUND + (j < AROUND ? j : AROUND - 1);
}

static void integrate_cells(const struct brdf *brdf, vec3s v, double expected[CELLS]) {
    enum { FINE = 40 };
    double sum = 0;
    for (int i = 0; i < ACROSS * FINE; i++)
        for (int j = 0; j < AROUND * FINE; j++) {
            vec3s l = at_cosine(((float)i + .5F) / (ACROSS * FINE),
                                2 * GLM_PIf * ((float)j + .5F) / (AROUND * FINE));
            double share =
                (double)brdf_density(brdf, up, v, l) * 2 * GLM_PI / (ACROSS * FINE * AROUND * FINE);
            expected[i / FINE * AROUND + j / FINE] += share;
            sum += share;
        }
    expected[CELLS - 1] = 1 - sum;
}

/* Chi-square of 10^5 samples over the cells in which enough are expected. */
static void check_sampling(const struct brdf *brdf, float cosine) {
    enum { COUNT = 100000, LEAST = 8 };
    double expected[CELLS] = {0}, square = 0, rest = 0;
    int counts[CELLS] = {0}, freedom = -1, rest_count = 0;
    vec3s v = at_cosine(cosine, 1);
    integrate_cells(brdf, v, expected);
    srand(5);
    for (int i = 0; i < COUNT; i++) {
        vec2s sample = {
            {(float)rand() / ((float)RAND_MAX + 1), (float)rand() / ((float)RAND_MAX + 1)}};
        counts[cell_of(brdf_sample(brdf, up, v, sample))]++;
    }
    for (int i = 0; i < CELLS; i++) {
        double want = expected[i] * COUNT;
        if (want < LEAST) {
            rest += want, rest_count += counts[i];
            continue;
        }
        square += (counts[i] - want) * (counts[i] - want) / want;
        freedom++;
    }
    if (rest >= LEAST)
        square += (rest_count - rest) * (rest_count - rest) / rest, freedom++;
    /* Wilson and Hilferty: nearly normal. */
    double spread = 2 / (9. * freedom), z = (cbrt(square / freedom) - 1 + spread) / sqrt(spread);
    printf("    cosine %.2f, chi-square %.1f of %d:", (double)cosine, square, freedom);
    check_near("standard deviations", z, 0, 3.5);
}

TEST(sampling) {
    static const float cosines[] = {.95F, .5F, .1F};
    for (int i = 0; i < 3; i++) {
        struct brdf metal = white_metal(.5F), rough = white_metal(1), mixed = plastic(.6F);
        check_sampling(&metal, cosines[i]);
        check_sampling(&rough, cosines[i]);
        check_sampling(&mixed, cosines[i]);
    }
}

/* Metals never reflect more than they get. */
TEST(energy) {
    double most = 0;
    for (int r = 0; r <= 10; r++)
        for (int c = 1; c <= 8; c++) {
            struct brdf brdf = white_metal((float)r / 10);
            most = fmax(most, albedo_by_samples(&brdf, (float)c / 8, 1 << 14));
        }
    printf("    of white metals the albedo is %.5f at most\n", most);
    assert_true(most < 1.0005 && most > .99);
}

/* The lobe's albedo where it reflects all (0), or (1 - v.h)^5 (1): an integral over half vectors in
 * doubles, by the turn and by the square of the half vector's tangent over alpha, each by the
 * midpoint rule. */
static double lobe_albedo_by_half_vectors(double alpha, double cosine, int power) {
    enum { ACROSS = 400, AROUND = 100 };
    double sine = sqrt(1 - cosine * cosine), sum = 0;
    for (int i = 0; i < ACROSS; i++)
        for (int j = 0; j < AROUND; j++) {
            double u = (i + .5) / ACROSS, turn = GLM_PI * (j + .5) / AROUND;
            double c = sqrt((1 - u) / (1 - u + alpha * alpha * u)), s = sqrt(1 - c * c);
            double v_h = sine * s * cos(turn) + cosine * c, n_l = 2 * v_h * c - cosine;
            if (v_h <= 0 || n_l <= 0)
                continue;
            double a2 = alpha * alpha, root_v = sqrt(a2 + (1 - a2) * cosine * cosine);
            double root_l = sqrt(a2 + (1 - a2) * n_l * n_l);
            double visibility = .5 / (cosine * root_l + n_l * root_v);
            /* Half vectors come with D n.h; each stands for 4 v.h of light. */
            sum += 4 * v_h / c * n_l * visibility * pow(1 - v_h, 5 * power);
        }
    return sum / (ACROSS * AROUND);
}

TEST(lobe_albedo) {
    double worst[2] = {0};
    for (int r = 0; r < 8; r++)
        for (int c = 0; c < 8; c++) {
            double roughness = .1 + .88 * r / 7, cosine = .1 + .88 * c / 7;
            double alpha = roughness * roughness;
            for (int power = 0; power < 2; power++) {
                double want = lobe_albedo_by_half_vectors(alpha, cosine, power);
                double found = (double)lobe_albedo((float)!power, 1, (float)alpha, (float)cosine);
                worst[power] = fmax(worst[power], fabs(found - want));
            }
        }
    check_at_most("error where all is reflected", worst[0], .006);
    check_at_most("error of the part that rises", worst[1], .003);
}

/* A white dielectric shows all of even light at every angle, whatever its interface, and reflects
 * all that comes at every angle; no surface shows more. The sum over the lobe is by samples, the
 * diffuse part's by the midpoint rule. */
TEST(furnace) {
    static const float cosines[] = {1, .866F, .5F, .1736F, .0872F};
    static const float roughnesses[] = {.1F, .3F, .5F, .75F, .95F};
    static const struct {
        const char *name;
        float metalness, f0, f90;
    } rows[] = {{"dielectric", 0, .04F, 1},
                {"index of refraction 2", 0, .111F, 1},
                {"specular factor .25", 0, .01F, .25F},
                {"specular-glossiness", 0, .3F, 1},
                {"half a metal", .5F, .04F, 1},
                {"metal", 1, .04F, 1}};
    enum { STEPS = 512 };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        double least = 2, most = 0;
        for (int i = 0; i < 25; i++) {
            struct reflectance reflectance = {rows[k].metalness, roughnesses[i / 5],
                                              glms_vec3_fill(rows[k].f0), rows[k].f90};
            struct material material = {.metalness = rows[k].metalness, .specular_f90 = 1};
            struct brdf brdf = brdf_of(&material, glms_vec3_one(), &reflectance);
            vec3s v = at_cosine(cosines[i % 5], .3F);
            brdf_turn(&brdf, up, v);
            double sum = albedo_by_samples(&brdf, cosines[i % 5], 1 << 12), diffuse = 0;
            for (int s = 0; s < STEPS; s++) {
                vec3s l = at_cosine(sqrtf(((float)s + .5F) / STEPS), 0);
                diffuse += (double)brdf_eval(&brdf, up, v, l).diffuse / STEPS;
            }
            sum += (double)brdf.albedo.x * diffuse;
            least = fmin(least, sum), most = fmax(most, sum);
        }
        printf("    %s shows %.4f to %.4f of even light:", rows[k].name, least, most);
        check_at_most("most", most, 1.005);
        if (rows[k].metalness == 0)
            check_near("least", least, 1, .01);
    }
}

/* What is told of all that a surface reflects of even light, against the sum over views. */
TEST(even_light) {
    enum { VIEWS = 32 };
    static const float roughnesses[] = {.2F, .5F, .9F};
    const struct material material = {
        .specular_f0 = {.04F, .04F, .04F}, .specular_f90 = 1, .metal_roughness_texture = -1};
    const vec3s base = {{.8F, .5F, .2F}};
    for (int i = 0; i < 6; i++) {
        float metalness = (float)(i / 3), roughness = roughnesses[i % 3];
        struct reflectance reflectance = material_reflectance(&material);
        reflectance.metalness = metalness, reflectance.roughness = roughness;
        struct brdf brdf = brdf_of(&material, base, &reflectance);
        double sum = (double)brdf.albedo.x;
        for (int v = 0; v < VIEWS; v++)
            sum += albedo_by_samples(&brdf, sqrtf(((float)v + .5F) / VIEWS), 1 << 13) / VIEWS;
        printf("    metalness %.0f, roughness %.1f:", (double)metalness, (double)roughness);
        check_near("reflected of even light",
                   (double)material_reflects(&material, base, &reflectance).x, sum, .006);
    }
}

TEST(matt) {
    struct material material = {.roughness = 1,
                                .specular_f0 = {DIELECTRIC_F0, DIELECTRIC_F0, DIELECTRIC_F0},
                                .specular_f90 = 1,
                                .metal_roughness_texture = -1};
    struct reflectance reflectance = material_reflectance(&material);
    struct brdf brdf = brdf_of(&material, (vec3s){{.8F, .5F, .2F}}, &reflectance);
    struct brdf_value value = brdf_eval(&brdf, up, any_direction(1, 0), any_direction(1, 1));
    assert_true(brdf.diffuse);
    check_near("albedo", brdf.albedo.x, .8, 1e-7);
    check_near("diffuse", value.diffuse, 1, 0);
    check_near("specular", glms_vec3_max(value.specular), 0, 0);
    material.roughness = .9F;
    assert_false(material_is_diffuse(&material));
    material.specular_f90 = 0;
    memset(material.specular_f0, 0, sizeof material.specular_f0);
    assert_true(material_is_diffuse(&material));
    material.specular_f90 = 1;
    reflectance = material_reflectance(&material);
    assert_false(brdf_of(&material, glms_vec3_one(), &reflectance).diffuse);
}

/* All is reflected outside, as older files' white specular colour has it: hardly anything is left
 * to divide by. */
TEST(all_outside) {
    const struct material materials[] = {
        {.roughness = 1, .specular_f0 = {1, 1, 1}, .specular_f90 = 1},
        {.roughness = .1F, .specular_f0 = {1, 0, 0}, .specular_f90 = 1},
    };
    for (size_t i = 0; i < sizeof materials / sizeof *materials; i++) {
        struct reflectance reflectance = material_reflectance(&materials[i]);
        struct brdf brdf = brdf_of(&materials[i], glms_vec3_one(), &reflectance);
        struct brdf_value value = brdf_eval(&brdf, up, at_cosine(.7F, 0), at_cosine(.4F, 2));
        printf("  transmitted %g, diffuse %g, albedo %g\n", (double)brdf.transmitted,
               (double)value.diffuse, (double)brdf.albedo.x);
        assert_true(isfinite(value.diffuse) && value.diffuse >= 0);
        assert_true(brdf.albedo.x >= 0 && brdf.albedo.x < 1);
    }
}

RUN_TESTS(NULL, NULL)
