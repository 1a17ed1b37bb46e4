#include "reference/vpl_sum.h"

#include "reference/channels.h"
#include "reference/light_cut.h"
#include "reference/primary.h"
#include "reference/residual.h"
#include "reference/rows.h"
#include "reference/scene/emission.h"
#include "reference/vector.h"

#include <assert.h>
#include <math.h>
#include <string.h>

struct summation {
    struct vpl_sum_desc desc; /* resolved */
    struct ray_scene rays;
    struct primary_rays primary;
    struct emission emission;
    struct light_tree tree; /* where there are cuts */
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

struct view {
    const struct summation *summation;
    const struct hit *x;
};

static float evaluate(const void *context, int vpl) {
    const struct view *view = context;
    return seen_term(view->summation, view->x, &view->summation->desc.vpls[vpl]);
}

/* The same of a cut, and how far it may be off at most. */
static vec3s gather_cut(const struct summation *summation, const struct hit *x,
                        struct light_cut *cut, vec3s *bound) {
    const struct light_node *nodes = summation->tree.nodes;
    vec3s sum = glms_vec3_zero(), most = glms_vec3_zero();
    light_cut_find(cut, &(struct light_cut_desc){
                            .tree = &summation->tree,
                            .receiver = {x->position, x->position, x->normal, .cosine = 1},
                            .term = summation->desc.term,
                            .tolerance = summation->desc.cuts->tolerance,
                            .evaluate = evaluate,
                            .context = &(struct view){summation, x},
                        });
    for (int i = 0; i < cut->count; i++) {
        const struct light_node *node = &nodes[cut->nodes[i].node];
        if (cut->nodes[i].term > 0)
            sum = glms_vec3_muladds(node->flux, cut->nodes[i].term, sum);
        most = glms_vec3_muladds(node->flux, cut->nodes[i].bound / node->power, most);
    }
    *bound = glms_vec3_scale(most, unit);
    return glms_vec3_scale(sum, unit);
}

static void write(float *layer, vec3s value) {
    memcpy(layer, value.raw, sizeof value.raw);
}

/* The indirect layer, and what cuts have besides. */
static vec3s indirect_light(const struct summation *summation, const struct hit *x,
                            struct light_cut *cut, float *channels) {
    vec3s bound;
    if (!summation->desc.cuts)
        return gather(summation, x);
    vec3s indirect = gather_cut(summation, x, cut, &bound);
    write(&channels[CHANNEL_BOUND], bound);
    write(&channels[CHANNEL_NODES], glms_vec3_fill((float)cut->count));
    return indirect;
}

static vec3s taken_light(const struct summation *summation, const struct hit *x, uint32_t pixel) {
    const struct vpl_sum_compensation *compensation = summation->desc.compensation;
    const struct residual residual = {&summation->rays, &summation->emission,
                                      summation->desc.term.clamp_value, compensation->rays};
    return residual_light(&residual, x, sampler_hash(compensation->seed, pixel));
}

/* Places on lights with a size, the same for all pixels: without noise, with steps in penumbrae. */
static struct reflected direct_light(const struct summation *summation, const struct hit *x) {
    enum { PLACES = 64 };
    struct sampler samplers[PLACES];
    for (uint32_t i = 0; i < PLACES; i++)
        samplers[i] = (struct sampler){.index = i};
    return emission_direct(&summation->emission, &summation->rays, x, samplers, PLACES);
}

static void render_pixel(const struct summation *summation, int px, int py, struct light_cut *cut) {
    struct hit hit;
    if (!primary_hit(&summation->primary, (float)px + 0.5f, (float)py + 0.5f, 0, &hit))
        return;
    float *channels = image_at(summation->image, px, py);
    vec3s indirect = indirect_light(summation, &hit, cut, channels);
    if (summation->desc.compensation)
        indirect = glms_vec3_add(
            indirect, taken_light(summation, &hit, (uint32_t)(py * summation->desc.width + px)));
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
    struct light_cut cut = {0};
    for (int x = 0; x < summation->desc.width; x++)
        render_pixel(summation, x, row, &cut);
    light_cut_free(&cut);
}

static bool report(void *context, double done) {
    const struct vpl_sum_desc *desc = &((const struct summation *)context)->desc;
    return !desc->progress || desc->progress(desc->user, done);
}

static struct vpl_sum_desc resolve(const struct vpl_sum_desc *desc) {
    struct vpl_sum_desc resolved = *desc;
    assert(desc->scene && desc->geometry && desc->camera && (desc->vpls || desc->vpl_count == 0));
    assert(desc->term.bound != GEOMETRY_CLAMPED || desc->term.clamp_value >= 0);
    assert(!desc->compensation || desc->term.bound == GEOMETRY_CLAMPED);
    if (resolved.width == 0)
        resolved.width = 800;
    if (resolved.height == 0)
        resolved.height = 800;
    if (resolved.vpl_clearance == 0)
        resolved.vpl_clearance = 1e-3f * desc->geometry->radius;
    return resolved;
}

static void init_lights(struct summation *summation, const struct hit_table *table) {
    const struct vpl_sum_desc *desc = &summation->desc;
    emission_init(&summation->emission, &desc->emitters, desc->geometry, table, 0);
    if (desc->cuts)
        light_tree_init(&summation->tree, desc->vpls, desc->vpl_count, desc->cuts->seed);
}

static bool render(struct summation *summation) {
    const struct vpl_sum_desc *desc = &summation->desc;
    int channels = desc->cuts ? CHANNEL_CUTS_END : CHANNEL_COMMON_END;
    if (!image_fits(desc->width, desc->height, channels))
        return false;
    image_init(summation->image, desc->width, desc->height,
               desc->cuts ? CHANNELS_OF_CUTS : CHANNELS_COMMON);
    return rows_render(&(struct rows){desc->height, desc->threads, render_row, report, summation});
}

bool vpl_sum_render(const struct vpl_sum_desc *desc, struct image *image) {
    struct summation summation = {.desc = resolve(desc), .image = image};
    struct hit_table table;
    *image = (struct image){0};
    summation.primary = primary_rays_of(&summation.rays, desc->camera, desc->geometry,
                                        summation.desc.width, summation.desc.height);
    hit_table_init(&table, desc->scene, desc->geometry, (enum materials)desc->materials);
    init_lights(&summation, &table);
    bool ok = ray_scene_init(&summation.rays, &table) && render(&summation);
    if (!ok)
        image_free(image);
    light_tree_free(&summation.tree);
    emission_free(&summation.emission);
    ray_scene_free(&summation.rays);
    hit_table_free(&table);
    return ok;
}
