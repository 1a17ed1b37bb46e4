#include "reference/brdf.h"

#include "reference/warp.h"
#include "scene/lobe_albedo.h"
#include "shared/brdf.h"

#include <math.h>

static const float least_roughness = (float)BRDF_LEAST_ROUGHNESS;
static const float least_cosine = (float)BRDF_LEAST_COSINE;

/* Of samples of a surface that has both parts, each takes so many at least. */
static const float least_share = .1F;

struct brdf brdf_lambertian(vec3s albedo) {
    return (struct brdf){.albedo = albedo, .diffuse = true};
}

struct brdf brdf_of(const struct material *material, vec3s base_color,
                    const struct reflectance *reflectance) {
    if (material_is_diffuse(material))
        return brdf_lambertian(base_color);
    vec3s f90 = glms_vec3_fill(reflectance->f90);
    float metalness = reflectance->metalness;
    float clamped = fmaxf(reflectance->roughness, least_roughness);
    struct brdf brdf = {
        .alpha = clamped * clamped,
        .f0 = glms_vec3_lerp(reflectance->f0, base_color, metalness),
        .f90 = glms_vec3_lerp(f90, glms_vec3_one(), metalness),
        .outer_f0 = glms_vec3_max(reflectance->f0),
        .outer_f90 = reflectance->f90,
    };
    brdf.transmitted = fmaxf(reflectance_transmits(reflectance), (float)BRDF_LEAST_THROUGH);
    brdf.below = glms_vec3_scale(base_color, 1 - metalness);
    brdf.albedo = glms_vec3_scale(brdf.below, brdf.transmitted);
    return brdf;
}

/* The fraction of light from or to that angle that the interface lets through. */
static float let_through(const struct brdf *brdf, float cosine) {
    return fmaxf(1 - lobe_albedo(brdf->outer_f0, brdf->outer_f90, brdf->alpha, cosine), 0);
}

void brdf_turn(struct brdf *brdf, vec3s n, vec3s v) {
    if (!brdf->diffuse)
        brdf->albedo = glms_vec3_scale(brdf->below, let_through(brdf, glms_vec3_dot(n, v)));
}

/* --- value ------------------------------------------------------------------------------------ */

/* v as it is taken: above the horizon. */
static vec3s facing(vec3s n, vec3s v) {
    float cosine = glms_vec3_dot(n, v);
    return cosine >= least_cosine ? v : vec3s_unit(glms_vec3_muladds(n, least_cosine - cosine, v));
}

/* D, where 1 - (n.h)^2 would lose its digits on smooth surfaces. */
static float distribution(float alpha, vec3s n, vec3s h) {
    float cosine = glms_vec3_dot(n, h), sine2 = glms_vec3_norm2(glms_vec3_cross(n, h));
    float across = sine2 / alpha + cosine * cosine * alpha;
    return GLM_1_PIf / (across * across);
}

/* sqrt(a^2 + (1 - a^2) cos^2) */
static float smith_root(float alpha, float cosine) {
    return sqrtf(alpha * alpha + (1 - alpha * alpha) * cosine * cosine);
}

static float schlick(float cosine) {
    float rest = fmaxf(1 - cosine, 0);
    return rest * rest * rest * rest * rest;
}

struct brdf_value brdf_eval(const struct brdf *brdf, vec3s n, vec3s v, vec3s l) {
    float n_l = glms_vec3_dot(n, l);
    if (n_l <= 0)
        return (struct brdf_value){0};
    if (brdf->diffuse)
        return (struct brdf_value){.diffuse = 1};
    v = facing(n, v);
    vec3s h = vec3s_unit(glms_vec3_add(v, l));
    float n_v = glms_vec3_dot(n, v), w = schlick(glms_vec3_dot(v, h));
    float visibility =
        .5F / (n_v * smith_root(brdf->alpha, n_l) + n_l * smith_root(brdf->alpha, n_v));
    float lobe = visibility * distribution(brdf->alpha, n, h);
    return (struct brdf_value){
        .diffuse = let_through(brdf, n_l) / brdf->transmitted,
        .specular = glms_vec3_scale(glms_vec3_lerp(brdf->f0, brdf->f90, w), lobe),
    };
}

/* --- sampling --------------------------------------------------------------------------------- */

/* About the share of light that the specular part reflects: an analytic fit [Karis 2014], too low
 * by a quarter where rough metals are seen grazing. */
static vec3s specular_albedo(const struct brdf *brdf, float n_v) {
    float roughness = sqrtf(brdf->alpha), x = 1 - roughness;
    float fall = fminf(x * x, exp2f(-9.28F * n_v)) * x + .0425F - .0275F * roughness;
    float scale = 1.04F - .572F * roughness - 1.04F * fall;
    float bias = .022F * roughness - .04F + 1.04F * fall;
    return glms_vec3_add(glms_vec3_scale(brdf->f0, scale), glms_vec3_scale(brdf->f90, bias));
}

/* Of samples, by the cosine. */
static float diffuse_share(const struct brdf *brdf, float n_v) {
    float diffuse = glms_vec3_max(brdf->albedo);
    if (diffuse == 0)
        return 0;
    float specular = glms_vec3_max(specular_albedo(brdf, n_v));
    return glm_clamp(diffuse / (diffuse + specular), least_share, 1 - least_share);
}

/* The direction with its part across n squeezed. */
static vec3s squeeze(vec3s n, vec3s direction, float alpha) {
    float along = fmaxf(0, glms_vec3_dot(n, direction));
    return vec3s_unit(glms_vec3_muladds(n, (1 - alpha) * along, glms_vec3_scale(direction, alpha)));
}

/* Of the microfacets' normals that v sees, one: of a hemisphere's, which v, squeezed as they are,
 * sees as half a disc and half an ellipse below. */
static vec3s visible_normal(vec3s n, vec3s v, float alpha, vec2s sample) {
    vec3s seen_from = squeeze(n, v, alpha), right = glms_vec3_cross(n, seen_from);
    right = glms_vec3_norm2(right) > 0 ? vec3s_unit(right) : warp_to_disc((vec2s){{1, 0}}, n);
    vec3s up = glms_vec3_cross(seen_from, right);
    float radius = sqrtf(sample.x), turn = 2 * GLM_PIf * sample.y, x = radius * cosf(turn);
    float upper = (1 + glms_vec3_dot(n, seen_from)) / 2;
    float y = glm_lerp(sqrtf(fmaxf(0, 1 - x * x)), radius * sinf(turn), upper);
    vec3s normal = glms_vec3_scale(seen_from, sqrtf(fmaxf(0, 1 - x * x - y * y)));
    normal = glms_vec3_muladds(right, x, glms_vec3_muladds(up, y, normal));
    return squeeze(n, normal, alpha);
}

vec3s brdf_sample(const struct brdf *brdf, vec3s n, vec3s v, vec2s sample) {
    if (brdf->diffuse)
        return warp_to_cosine(sample, n);
    v = facing(n, v);
    float share = diffuse_share(brdf, glms_vec3_dot(n, v));
    if (sample.x < share)
        return warp_to_cosine((vec2s){{sample.x / share, sample.y}}, n);
    sample.x = fminf((sample.x - share) / (1 - share), 0x1.fffffep-1F);
    vec3s h = visible_normal(n, v, brdf->alpha, sample);
    return vec3s_unit(glms_vec3_sub(glms_vec3_scale(h, 2 * glms_vec3_dot(v, h)), v));
}

float brdf_density(const struct brdf *brdf, vec3s n, vec3s v, vec3s l) {
    float cosine = fmaxf(glms_vec3_dot(n, l), 0) * GLM_1_PIf;
    if (brdf->diffuse)
        return cosine;
    v = facing(n, v);
    float n_v = glms_vec3_dot(n, v), share = diffuse_share(brdf, n_v);
    /* G1(v) D / (4 n.v), also of directions that come out below the horizon. */
    vec3s h = vec3s_unit(glms_vec3_add(v, l));
    float visible = distribution(brdf->alpha, n, h) / (2 * (n_v + smith_root(brdf->alpha, n_v)));
    return share * cosine + (1 - share) * visible;
}
