#include "reference/vpl_sum.h"

#include "reference/channels.h"
#include "reference/primary.h"
#include "reference/rows.h"
#include "reference/scene/emission.h"
#include "reference/vector.h"

#include <assert.h>
#include <string.h>

struct summation {
    struct vpl_sum_desc desc; /* resolved */
    struct ray_scene rays;
    struct primary_rays primary;
    struct emission emission;
    struct image *image;
};

static float term_of(const struct vpl_sum_desc *desc, const struct hit *x, const struct vpl *vpl) {
    vec3s path = glms_vec3_sub(vector_of(vpl->position), x->position);
    float distance2 = glms_vec3_norm2(path);
    float cos_x = glms_vec3_dot(x->normal, path);
    float cos_i = -glms_vec3_dot(vector_of(vpl->normal), path);
    if (cos_x <= 0 || cos_i <= 0)
        return 0;
    return geometry_term(&desc->term, cos_x * cos_i / distance2, distance2, vpl->area);
}

/* What passes between them; the mean of colours, which cuts do not tell apart. */
static float visibility(const struct summation *summation, const struct hit *x,
                        const struct vpl *vpl) {
    vec3s above = glms_vec3_muladds(vector_of(vpl->normal), summation->desc.vpl_clearance,
                                    vector_of(vpl->position));
    if (summation->desc.unshadowed)
        return 1;
    vec3s from = ray_scene_departure(&summation->rays, x);
    return glms_vec3_hadd(ray_scene_passes(&summation->rays, from, above)) / 3;
}

/* With visibility. */
static float seen_term(const struct summation *summation, const struct hit *x,
                       const struct vpl *vpl) {
    float term = vpl->reach > 0 ? term_of(&summation->desc, x, vpl) : 0;
    return term > 0 ? term * visibility(summation, x, vpl) : 0;
}

/* Irradiance over pi, over flux and geometry term. */
static const float unit = GLM_1_PIf * GLM_1_PIf;

static vec3s gather(const struct summation *summation, const struct hit *x) {
    const struct vpl_sum_desc *desc = &summation->desc;
    vec3s sum = glms_vec3_zero();
    for (int i = 0; i < desc->vpl_count; i++) {
        const struct vpl *vpl = &desc->vpls[i];
        float term = seen_term(summation, x, vpl);
        if (term > 0)
            sum = glms_vec3_muladds(vector_of(vpl->flux), term, sum);
    }
    return glms_vec3_scale(sum, unit);
}

static void write(float *layer, vec3s value) {
    memcpy(layer, value.raw, sizeof value.raw);
}

/* Places on lights with a size, the same for all pixels: without noise, with steps in penumbrae. */
static struct reflected direct_light(const struct summation *summation, const struct hit *x) {
    enum { PLACES = 64 };
    struct sampler samplers[PLACES];
    for (uint32_t i = 0; i < PLACES; i++)
        samplers[i] = (struct sampler){.index = i};
    return emission_direct(&summation->emission, &summation->rays, x, samplers, PLACES);
}

static void render_pixel(const struct summation *summation, int px, int py) {
    struct hit hit;
    if (!primary_hit(&summation->primary, (float)px + 0.5f, (float)py + 0.5f, 0, &hit))
        return;
    float *channels = image_at(summation->image, px, py);
    vec3s indirect = gather(summation, &hit);
    vec3s direct = direct_light(summation, &hit).diffuse, albedo = hit.brdf.albedo;
    write(&channels[CHANNEL_BEAUTY], glms_vec3_mul(albedo, glms_vec3_add(direct, indirect)));
    channels[CHANNEL_ALPHA] = 1;
    channels[CHANNEL_DEPTH] = primary_depth(&summation->primary, hit.position);
    write(&channels[CHANNEL_DIRECT], direct);
    write(&channels[CHANNEL_INDIRECT], indirect);
    write(&channels[CHANNEL_ALBEDO], albedo);
    write(&channels[CHANNEL_NORMAL], hit.normal);
}

static void render_row(void *context, int row) {
    const struct summation *summation = context;
    for (int x = 0; x < summation->desc.width; x++)
        render_pixel(summation, x, row);
}

static bool report(void *context, double done) {
    const struct vpl_sum_desc *desc = &((const struct summation *)context)->desc;
    return !desc->progress || desc->progress(desc->user, done);
}

static struct vpl_sum_desc resolve(const struct vpl_sum_desc *desc) {
    struct vpl_sum_desc resolved = *desc;
    assert(desc->scene && desc->geometry && desc->camera && (desc->vpls || desc->vpl_count == 0));
    assert(desc->term.bound != GEOMETRY_CLAMPED || desc->term.clamp_value >= 0);
    if (resolved.width == 0)
        resolved.width = 800;
    if (resolved.height == 0)
        resolved.height = 800;
    if (resolved.vpl_clearance == 0)
        resolved.vpl_clearance = 1e-3f * desc->geometry->radius;
    return resolved;
}

static bool render(struct summation *summation) {
    const struct vpl_sum_desc *desc = &summation->desc;
    if (!image_fits(desc->width, desc->height, CHANNEL_COMMON_END))
        return false;
    image_init(summation->image, desc->width, desc->height, CHANNELS_COMMON);
    return rows_render(&(struct rows){desc->height, desc->threads, render_row, report, summation});
}

bool vpl_sum_render(const struct vpl_sum_desc *desc, struct image *image) {
    struct summation summation = {.desc = resolve(desc), .image = image};
    struct hit_table table;
    *image = (struct image){0};
    summation.primary = primary_rays_of(&summation.rays, desc->camera, desc->geometry,
                                        summation.desc.width, summation.desc.height);
    hit_table_init(&table, desc->scene, desc->geometry, (enum materials)desc->materials);
    emission_init(&summation.emission, &summation.desc.emitters, desc->geometry, &table, 0);
    bool ok = ray_scene_init(&summation.rays, &table) && render(&summation);
    if (!ok)
        image_free(image);
    emission_free(&summation.emission);
    ray_scene_free(&summation.rays);
    return ok;
}
