/* Clustered visibility [Dong 2009]: N VPLs light, and M virtual area lights with convolution soft
 * shadow maps say whether their light arrives. With visibility=hard the VAL's depth map is looked
 * up as it is: what the paper's soft shadows are compared with (§3). */
#include "base/memory.h"
#include "passes/basis.h"
#include "passes/block_visibility.h"
#include "passes/cluster.h"
#include "passes/paraboloid.h"
#include "techniques/many_lights.h"

#include <stdlib.h>

struct clustered {
    struct many_lights lights;
    struct cluster_pass cluster;
    struct paraboloid_pass paraboloid;
    struct basis_pass basis;
    struct block_visibility_pass blocks;
    bool convolve, share;
};

static void free_state(void *state) {
    struct clustered *technique = state;
    if (technique) {
        many_lights_free(&technique->lights);
        cluster_pass_free(&technique->cluster);
        paraboloid_pass_free(&technique->paraboloid);
        basis_pass_free(&technique->basis);
        block_visibility_pass_free(&technique->blocks);
    }
    free(technique);
}

static bool init_cluster(struct clustered *technique, const struct settings *settings) {
    return cluster_pass_init(&technique->cluster,
                             &(struct cluster_desc){
                                 .vpl_count = settings->vpl_count,
                                 .val_count = settings->val_count,
                                 .start = (enum cluster_start)settings->start,
                                 .iterations = settings->iterations,
                                 .weight_position = settings->weight_position,
                                 .weight_normal = settings->weight_normal,
                                 .near_clip = settings->near_clip,
                                 .depth_range = many_lights_depth_range(settings),
                             });
}

static bool init_maps(struct clustered *technique, const struct settings *settings) {
    return paraboloid_pass_init(&technique->paraboloid,
                                &(struct paraboloid_desc){
                                    .size = settings->map_size,
                                    .count = settings->val_count,
                                    .depth_range = many_lights_depth_range(settings),
                                }) &&
           (!technique->convolve ||
            basis_pass_init(&technique->basis, &(struct basis_desc){
                                                   .size = settings->map_size,
                                                   .count = settings->val_count,
                                                   .terms = settings->basis_terms,
                                               }));
}

static bool init_blocks(struct clustered *technique, const struct technique_desc *desc,
                        enum visibility_lookup lookup) {
    const struct settings *settings = desc->settings;
    return !technique->share ||
           block_visibility_pass_init(
               &technique->blocks,
               &(struct block_visibility_desc){
                   .width = desc->width,
                   .height = desc->height,
                   .block = settings->visibility_block,
                   .visibility = many_lights_lookup(settings, lookup, settings->val_count),
               });
}

static bool init(void **state, const struct technique_desc *desc) {
    const struct settings *settings = desc->settings;
    struct clustered *technique = *state = mem_alloc(1, sizeof *technique);
    technique->convolve = settings->visibility == VISIBILITY_CSSM;
    technique->share = settings->visibility_block > 0;
    static const enum visibility_lookup lookups[] = {
        [VISIBILITY_CSSM] = VISIBILITY_LOOKUP_CSSM,
        [VISIBILITY_HARD] = VISIBILITY_LOOKUP_HARD,
        [VISIBILITY_PCSS] = VISIBILITY_LOOKUP_PCSS,
    };
    enum visibility_lookup lookup = lookups[settings->visibility];
    /* A pixel on its own, at a silhouette, needs no soft shadow: its VPLs' maps all differ. */
    bool own_hard = technique->share && lookup == VISIBILITY_LOOKUP_PCSS;
    return many_lights_init(&technique->lights, desc,
                            &(struct many_lights_visibility){
                                .lookup = own_hard ? VISIBILITY_LOOKUP_HARD : lookup,
                                .map_count = settings->val_count,
                                .share = technique->share}) &&
           init_cluster(technique, settings) && init_maps(technique, settings) &&
           init_blocks(technique, desc, lookup);
}

static bool resize(void *state, int width, int height) {
    struct clustered *technique = state;
    struct block_visibility_desc desc = technique->blocks.desc;
    struct block_visibility_pass blocks = {0};
    desc.width = width;
    desc.height = height;
    if ((technique->share && !block_visibility_pass_init(&blocks, &desc)) ||
        !many_lights_resize(&technique->lights, width, height)) {
        block_visibility_pass_free(&blocks);
        return false;
    }
    block_visibility_pass_free(&technique->blocks);
    technique->blocks = blocks;
    return true;
}

static void render_maps(struct clustered *technique, const struct frame *frame) {
    timer_begin(frame->timers, "cssm");
    paraboloid_pass_render(&technique->paraboloid, frame, &technique->cluster.views);
    if (technique->convolve)
        basis_pass_render(&technique->basis, frame, &technique->paraboloid.maps);
    timer_end(frame->timers);
}

static void render_lights(void *state, const struct frame *frame) {
    struct clustered *technique = state;
    many_lights_render_vpls(&technique->lights, frame);
    cluster_pass_render(&technique->cluster, frame, &technique->lights.vpls);
    render_maps(technique, frame);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct clustered *technique = state;
    struct many_lights *lights = &technique->lights;
    struct cluster_pass *cluster = &technique->cluster;
    struct visibility_inputs visibility = {
        .views = &cluster->views,
        .depth = &technique->paraboloid.maps,
        .bases = &technique->basis.maps,
    };
    if (technique->share)
        block_visibility_pass_render(&technique->blocks, frame, gbuffer, &visibility);
    gather_pass_clear(&lights->gather);
    gather_pass_render(&lights->gather, frame, gbuffer,
                       &(struct gather_inputs){.vpls = &cluster->vpls,
                                               .visibility = visibility,
                                               .blocks = &technique->blocks.blocks});
    many_lights_finish(lights, frame, gbuffer);
}

static void outputs(const void *state, struct technique_outputs *outputs) {
    const struct clustered *technique = state;
    const struct val_targets *centers = cluster_pass_centers(&technique->cluster);
    many_lights_outputs(&technique->lights, outputs);
    outputs->vpls = &technique->cluster.vpls;
    if (technique->share)
        outputs->visibility = &technique->blocks.desc.visibility;
    outputs->val_views = &technique->cluster.views;
    outputs->val_positions = &centers->position;
    outputs->val_normals = &centers->normal;
    outputs->val_fluxes = &centers->flux;
    outputs->val_extremes = &technique->cluster.extremes;
    outputs->depth_maps = &technique->paraboloid.maps;
    outputs->basis_maps = technique->convolve ? &technique->basis.maps : NULL;
}

extern const struct technique clustered_technique;
const struct technique clustered_technique = {
    .name = "clustered",
    .help = "soft shadow maps of clusters of VPLs",
    .init = init,
    .free = free_state,
    .resize = resize,
    .render_lights = render_lights,
    .render_view = render_view,
    .outputs = outputs,
};
