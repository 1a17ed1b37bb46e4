/* Clustered visibility [Dong 2009]: N VPLs light, and M virtual area lights with convolution soft
 * shadow maps say whether their light arrives. With visibility=hard the VAL's depth map is looked
 * up as it is: what the paper's soft shadows are compared with (§3). */
#include "base/memory.h"
#include "passes/visibility/basis.h"
#include "passes/visibility/block_visibility.h"
#include "passes/lights/cluster.h"
#include "passes/visibility/paraboloid.h"
#include "techniques/many_lights.h"

#include <stdlib.h>

enum visibility_kind { VISIBILITY_CSSM, VISIBILITY_HARD, VISIBILITY_PCSS, VISIBILITY_RAY };

struct clustered_settings {
    int vals; /* M */
    int iterations;
    int start;                            /* enum cluster_start */
    float weight_position, weight_normal; /* w_x, w_alpha */
    int visibility;                       /* enum visibility_kind */
    int visibility_block;                 /* pixels a side; 0 = each pixel looks itself up */
};

#define ROW(name) offsetof(struct clustered_settings, name)

static const char *const start_names[] = {"seeds", "warm", "reseed", NULL};
static const char *const visibility_names[] = {"cssm", "hard", "pcss", "ray", NULL};

static const struct option table[] = {
    {"vals", 0, OPTION_INT, ROW(vals), 30, 1, 1024, .help = "virtual area lights (clusters), M"},
    {"iterations", 0, OPTION_INT, ROW(iterations), 5, 1, 64, .help = "k-means iterations"},
    {"start", 0, OPTION_CHOICE, ROW(start), 0, .choices = start_names,
     .help = "where k-means begins: the same seeds each frame, the last frame's centres, or those "
             "with empty\nclusters seeded again; frames then depend on the ones before"},
    {"weight-position", 0, OPTION_FLOAT, ROW(weight_position), .25, 0, 1000,
     .help = "clustering weight of distance, w_x"},
    {"weight-normal", 0, OPTION_FLOAT, ROW(weight_normal), .3, 0, 1000,
     .help = "clustering weight of the angle between normals, w_alpha"},
    {"visibility", 0, OPTION_CHOICE, ROW(visibility), VISIBILITY_RAY, .choices = visibility_names,
     .help = "lookup in a VAL's map: soft by convolution, hard, percentage-closer soft, or along "
             "the ray\n"
             "to each VPL, where blocks of pixels take percentage-closer soft"},
    {"visibility-block", 0, OPTION_INT, ROW(visibility_block), 7, 0, 64,
     .help = "pixels a side of a block that shares its visibility; 0 = each looks itself up;\n"
             "blocks that are no multiple of interleave blur better"},
    {NULL},
};

static const struct settings_part own_part = {"clustered", "virtual area lights", table,
                                              sizeof(struct clustered_settings)};

struct clustered {
    struct many_lights lights;
    struct cluster_pass cluster;
    struct paraboloid_pass paraboloid;
    struct basis_pass basis;
    struct block_visibility_pass blocks;
    bool convolve, share;
    struct visibility_desc val_visibility; /* of a VAL as a whole */
    struct val_output vals;
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
    const struct clustered_settings *own = settings_of(settings, &own_part);
    const struct lights_settings *lights = settings_of(settings, &lights_part);
    const struct map_settings *map = settings_of(settings, &map_part);
    return cluster_pass_init(&technique->cluster, &(struct cluster_desc){
                                                      .vpl_count = lights->vpls,
                                                      .val_count = own->vals,
                                                      .start = (enum cluster_start)own->start,
                                                      .iterations = own->iterations,
                                                      .weight_position = own->weight_position,
                                                      .weight_normal = own->weight_normal,
                                                      .near_clip = map->near_clip,
                                                  });
}

static bool init_maps(struct clustered *technique, const struct technique_desc *desc) {
    const struct settings *settings = desc->settings;
    const struct clustered_settings *own = settings_of(settings, &own_part);
    const struct lookup_settings *lookup = settings_of(settings, &lookup_part);
    const struct map_settings *map = settings_of(settings, &map_part);
    return paraboloid_pass_init(&technique->paraboloid,
                                &(struct paraboloid_desc){
                                    .casters = desc->casters,
                                    .caster = many_lights_caster(settings),
                                    .bend = many_lights_caster_bend(desc->settings),
                                    .size = map->size,
                                    .count = own->vals,
                                }) &&
           (!technique->convolve || basis_pass_init(&technique->basis, &(struct basis_desc){
                                                                           .size = map->size,
                                                                           .count = own->vals,
                                                                           .terms = lookup->terms,
                                                                       }));
}

static bool init_blocks(struct clustered *technique, const struct technique_desc *desc) {
    const struct clustered_settings *own = settings_of(desc->settings, &own_part);
    return !technique->share || block_visibility_pass_init(
                                    &technique->blocks, &(struct block_visibility_desc){
                                                            .width = desc->width,
                                                            .height = desc->height,
                                                            .block = own->visibility_block,
                                                            .visibility = technique->val_visibility,
                                                        });
}

/* Where the last means are changes from frame to frame. */
static void find_centers(struct clustered *technique) {
    const struct val_targets *centers = cluster_pass_centers(&technique->cluster);
    technique->vals.positions = &centers->position;
    technique->vals.normals = &centers->normal;
    technique->vals.fluxes = &centers->flux;
}

static void describe_vals(struct clustered *technique) {
    technique->vals = (struct val_output){
        .extremes = &technique->cluster.extremes,
        .visibility = &technique->val_visibility,
        .maps = {.views = &technique->cluster.views,
                 .depth = &technique->paraboloid.maps,
                 .bases = technique->convolve ? &technique->basis.maps : NULL},
    };
    find_centers(technique);
}

static bool init(void **state, const struct technique_desc *desc) {
    const struct clustered_settings *own = settings_of(desc->settings, &own_part);
    struct clustered *technique = *state = mem_alloc(1, sizeof *technique);
    technique->convolve = own->visibility == VISIBILITY_CSSM;
    technique->share = own->visibility_block > 0;
    static const enum visibility_lookup lookups[] = {
        [VISIBILITY_CSSM] = VISIBILITY_LOOKUP_CSSM,
        [VISIBILITY_HARD] = VISIBILITY_LOOKUP_HARD,
        [VISIBILITY_PCSS] = VISIBILITY_LOOKUP_PCSS,
        [VISIBILITY_RAY] = VISIBILITY_LOOKUP_RAY,
    };
    /* A ray ends at a VPL: a VAL as a whole has none. */
    enum visibility_lookup lookup = lookups[own->visibility],
                           val_lookup =
                               lookup == VISIBILITY_LOOKUP_RAY ? VISIBILITY_LOOKUP_PCSS : lookup;
    technique->val_visibility = many_lights_lookup(desc->settings, val_lookup, own->vals);
    describe_vals(technique);
    return many_lights_init(&technique->lights, desc,
                            &(struct many_lights_visibility){.lookup = lookup,
                                                             .map_count = own->vals,
                                                             .share = technique->share}) &&
           init_cluster(technique, desc->settings) && init_maps(technique, desc) &&
           init_blocks(technique, desc);
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
    timer_begin(frame->timers, "maps");
    paraboloid_pass_render(&technique->paraboloid, frame, &technique->cluster.views);
    if (technique->convolve)
        basis_pass_render(&technique->basis, frame, &technique->paraboloid.maps.depth);
    timer_end(frame->timers);
}

static void render_lights(void *state, const struct frame *frame) {
    struct clustered *technique = state;
    many_lights_render_vpls(&technique->lights, frame);
    cluster_pass_render(&technique->cluster, frame, &technique->lights.vpls);
    render_maps(technique, frame);
    find_centers(technique);
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
    many_lights_begin(lights, frame, gbuffer);
    many_lights_gather(lights, frame, gbuffer,
                       &(struct gather_inputs){.vpls = &cluster->vpls,
                                               .visibility = visibility,
                                               .blocks = &technique->blocks.blocks});
    many_lights_finish(lights, frame, gbuffer);
}

static struct contribution contribution(const void *state) {
    const struct clustered *technique = state;
    return many_lights_contribution(&technique->lights);
}

static void add_bases(const struct basis_maps *maps, struct output_list *outputs) {
    const struct output rows[] = {
        {"basis-cos", "Fourier bases cos c_k z of the depth maps; three terms as RGB", OUTPUT_BASIS,
         &maps->cos},
        {"basis-sin", "Fourier bases sin c_k z; three terms as RGB", OUTPUT_BASIS, &maps->sin},
        {"basis-z-cos", "z cos c_k z, for the mean depth of blockers", OUTPUT_SIGNED_BASIS,
         &maps->z_cos},
        {"basis-z-sin", "z sin c_k z, for the mean depth of blockers", OUTPUT_SIGNED_BASIS,
         &maps->z_sin},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        output_add(outputs, &rows[i]);
}

static void outputs(const void *state, struct output_list *outputs) {
    const struct clustered *technique = state;
    const struct output rows[] = {
        {"val", "clusters: VPLs in the colour of their VAL, with its rectangle and normal",
         OUTPUT_VALS, &technique->vals},
        {"val-depth", "paraboloid depth maps from the VALs", OUTPUT_MAP_DEPTH,
         &technique->paraboloid.maps},
        {"visibility", "the soft shadow of each VAL alone [Dong 2009 Fig. 9]", OUTPUT_VISIBILITY,
         &technique->vals},
    };
    many_lights_outputs(&technique->lights, &technique->cluster.vpls, outputs);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        output_add(outputs, &rows[i]);
    if (technique->convolve)
        add_bases(&technique->basis.maps, outputs);
}

static const struct settings_part *const parts[] = {
    &lights_part, &own_part, &map_part, &lookup_part, &caster_part, &gather_part, &blur_part, NULL};

static const struct preset presets[] = {
    MANY_LIGHTS_FAST,
    {"paper", "as published: convolution soft shadow maps at each pixel and VPL",
     "clustered.visibility=cssm clustered.visibility-block=0 " MANY_LIGHTS_AS_PUBLISHED},
    {"fine", "for scenes of many small things: more maps, and lights where detail is",
     "clustered.vals=60 gather.detail=2 gather.detail-times=1"},
    {NULL}};

extern const struct technique clustered_technique;
const struct technique clustered_technique = {
    .name = "clustered",
    .help = "soft shadow maps of clusters of VPLs",
    .parts = parts,
    .presets = presets,
    .refinement = &many_lights_refinement,
    .check = many_lights_check,
    .init = init,
    .free = free_state,
    .resize = resize,
    .render_lights = render_lights,
    .render_view = render_view,
    .contribution = contribution,
    .outputs = outputs,
};
