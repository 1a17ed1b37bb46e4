/* Clustered visibility [Dong 2009]: N VPLs light, and M virtual area lights with convolution soft
 * shadow maps say whether their light arrives. With visibility=hard the VAL's depth map is looked
 * up as it is: what the paper's soft shadows are compared with (§3). */
#include "base/memory.h"
#include "passes/basis.h"
#include "passes/cluster.h"
#include "passes/paraboloid.h"
#include "techniques/many_lights.h"

#include <stdlib.h>

struct clustered {
    struct many_lights lights;
    struct cluster_pass cluster;
    struct paraboloid_pass paraboloid;
    struct basis_pass basis;
    bool soft;
};

static void free_state(void *state) {
    struct clustered *technique = state;
    if (technique) {
        many_lights_free(&technique->lights);
        cluster_pass_free(&technique->cluster);
        paraboloid_pass_free(&technique->paraboloid);
        basis_pass_free(&technique->basis);
    }
    free(technique);
}

static bool init(void **state, const struct technique_desc *desc) {
    const struct settings *settings = desc->settings;
    struct clustered *technique = *state = mem_alloc(1, sizeof *technique);
    technique->soft = settings->visibility == VISIBILITY_CSSM;
    int vals = settings->val_count;
    float range = many_lights_depth_range(settings);
    return many_lights_init(&technique->lights, desc,
                            &(struct many_lights_visibility){
                                technique->soft ? GATHER_VISIBILITY_CSSM : GATHER_VISIBILITY_HARD,
                                .map_count = vals}) &&
           cluster_pass_init(&technique->cluster,
                             &(struct cluster_desc){
                                 .vpl_count = settings->vpl_count,
                                 .val_count = vals,
                                 .iterations = settings->iterations,
                                 .weight_position = settings->weight_position,
                                 .weight_normal = settings->weight_normal,
                                 .near_clip = settings->near_clip,
                                 .depth_range = range,
                             }) &&
           paraboloid_pass_init(&technique->paraboloid,
                                &(struct paraboloid_desc){.size = settings->map_size,
                                                          .count = vals,
                                                          .depth_range = range}) &&
           (!technique->soft ||
            basis_pass_init(&technique->basis,
                            &(struct basis_desc){.size = settings->map_size,
                                                 .count = vals,
                                                 .terms = settings->basis_terms}));
}

static void render(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct clustered *technique = state;
    struct many_lights *lights = &technique->lights;
    struct cluster_pass *cluster = &technique->cluster;
    many_lights_render_vpls(lights, frame);
    cluster_pass_render(cluster, frame, &lights->vpls);

    timer_begin(frame->timers, "cssm");
    paraboloid_pass_render(&technique->paraboloid, frame, &cluster->views);
    if (technique->soft)
        basis_pass_render(&technique->basis, frame, &technique->paraboloid.maps);
    timer_end(frame->timers);

    gather_pass_clear(&lights->gather);
    gather_pass_render(&lights->gather, frame, gbuffer,
                       &(struct gather_inputs){.vpls = &cluster->vpls,
                                               .views = &cluster->views,
                                               .depth = &technique->paraboloid.maps,
                                               .bases = &technique->basis.maps});
    many_lights_finish(lights, frame, gbuffer);
}

static void outputs(const void *state, struct technique_outputs *outputs) {
    const struct clustered *technique = state;
    const struct val_targets *centers = cluster_pass_centers(&technique->cluster);
    many_lights_outputs(&technique->lights, outputs);
    outputs->vpls = &technique->cluster.vpls;
    outputs->val_views = &technique->cluster.views;
    outputs->val_positions = &centers->position;
    outputs->val_normals = &centers->normal;
    outputs->val_fluxes = &centers->flux;
    outputs->depth_maps = &technique->paraboloid.maps;
    outputs->basis_maps = technique->soft ? &technique->basis.maps : NULL;
}

extern const struct technique clustered_technique;
const struct technique clustered_technique = {
    .name = "clustered",
    .help = "soft shadow maps of clusters of VPLs",
    .init = init,
    .free = free_state,
    .render = render,
    .outputs = outputs,
};
