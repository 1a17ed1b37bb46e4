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
    int bounce_vals;
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
    {"bounce-vals", 0, OPTION_INT, ROW(bounce_vals), 60, 1, 1024,
     .help = "and of those of further bounces (lights.bounces)"},
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

/* The VALs of some VPLs, and what they see. */
struct vals {
    struct cluster_pass cluster;
    struct paraboloid_pass paraboloid;
    struct basis_pass basis;
    struct block_visibility_pass blocks;
    bool convolve, share;
    struct visibility_desc visibility; /* of a VAL as a whole */
};

struct clustered {
    struct many_lights lights;
    struct vals first, further; /* of the first bounce; of further ones, where there are any */
    struct val_output output;   /* of the first */
};

static void free_vals(struct vals *vals) {
    cluster_pass_free(&vals->cluster);
    paraboloid_pass_free(&vals->paraboloid);
    basis_pass_free(&vals->basis);
    block_visibility_pass_free(&vals->blocks);
}

static void free_state(void *state) {
    struct clustered *technique = state;
    if (technique) {
        many_lights_free(&technique->lights);
        free_vals(&technique->first);
        free_vals(&technique->further);
    }
    free(technique);
}

static bool init_cluster(struct vals *vals, const struct settings *settings, int vpl_count) {
    const struct clustered_settings *own = settings_of(settings, &own_part);
    const struct map_settings *map = settings_of(settings, &map_part);
    return cluster_pass_init(&vals->cluster, &(struct cluster_desc){
                                                 .vpl_count = vpl_count,
                                                 .val_count = vals->visibility.map_count,
                                                 .start = (enum cluster_start)own->start,
                                                 .iterations = own->iterations,
                                                 .weight_position = own->weight_position,
                                                 .weight_normal = own->weight_normal,
                                                 .near_clip = map->near_clip,
                                             });
}

static bool init_maps(struct vals *vals, const struct technique_desc *desc) {
    const struct settings *settings = desc->settings;
    const struct lookup_settings *lookup = settings_of(settings, &lookup_part);
    const struct map_settings *map = settings_of(settings, &map_part);
    return paraboloid_pass_init(&vals->paraboloid,
                                &(struct paraboloid_desc){
                                    .casters = desc->casters,
                                    .caster = many_lights_caster(settings),
                                    .bend = many_lights_caster_bend(desc->settings),
                                    .size = map->size,
                                    .count = vals->visibility.map_count,
                                }) &&
           (!vals->convolve ||
            basis_pass_init(&vals->basis, &(struct basis_desc){
                                              .size = map->size,
                                              .count = vals->visibility.map_count,
                                              .terms = lookup->terms,
                                          }));
}

static bool init_blocks(struct vals *vals, const struct technique_desc *desc) {
    const struct clustered_settings *own = settings_of(desc->settings, &own_part);
    return !vals->share ||
           block_visibility_pass_init(&vals->blocks, &(struct block_visibility_desc){
                                                         .width = desc->width,
                                                         .height = desc->height,
                                                         .block = own->visibility_block,
                                                         .visibility = vals->visibility,
                                                     });
}

/* A ray ends at a VPL: a VAL as a whole has none. */
static enum visibility_lookup lookup_of_val(enum visibility_lookup lookup) {
    return lookup == VISIBILITY_LOOKUP_RAY ? VISIBILITY_LOOKUP_PCSS : lookup;
}

static bool init_vals(struct vals *vals, const struct technique_desc *desc,
                      enum visibility_lookup lookup, int vpl_count, int val_count) {
    const struct clustered_settings *own = settings_of(desc->settings, &own_part);
    vals->convolve = lookup == VISIBILITY_LOOKUP_CSSM;
    vals->share = own->visibility_block > 0;
    vals->visibility = many_lights_lookup(desc->settings, lookup_of_val(lookup), val_count);
    return init_cluster(vals, desc->settings, vpl_count) && init_maps(vals, desc) &&
           init_blocks(vals, desc);
}

/* Where the last means are changes from frame to frame. */
static void find_centers(struct clustered *technique) {
    const struct val_targets *centers = cluster_pass_centers(&technique->first.cluster);
    technique->output.positions = &centers->position;
    technique->output.normals = &centers->normal;
    technique->output.fluxes = &centers->flux;
}

static struct visibility_inputs maps_of(const struct vals *vals) {
    return (struct visibility_inputs){
        .views = &vals->cluster.views,
        .depth = &vals->paraboloid.maps,
        .bases = vals->convolve ? &vals->basis.maps : NULL,
    };
}

static void describe_vals(struct clustered *technique) {
    technique->output = (struct val_output){
        .extremes = &technique->first.cluster.extremes,
        .visibility = &technique->first.visibility,
        .maps = maps_of(&technique->first),
    };
    find_centers(technique);
}

static bool init(void **state, const struct technique_desc *desc) {
    const struct clustered_settings *own = settings_of(desc->settings, &own_part);
    const struct lights_settings *lights = settings_of(desc->settings, &lights_part);
    struct clustered *technique = *state = mem_alloc(1, sizeof *technique);
    static const enum visibility_lookup lookups[] = {
        [VISIBILITY_CSSM] = VISIBILITY_LOOKUP_CSSM,
        [VISIBILITY_HARD] = VISIBILITY_LOOKUP_HARD,
        [VISIBILITY_PCSS] = VISIBILITY_LOOKUP_PCSS,
        [VISIBILITY_RAY] = VISIBILITY_LOOKUP_RAY,
    };
    enum visibility_lookup lookup = lookups[own->visibility];
    if (!init_vals(&technique->first, desc, lookup, lights->vpls, own->vals) ||
        (lights->bounces > 1 &&
         !init_vals(&technique->further, desc, lookup, lights->points, own->bounce_vals)))
        return false;
    describe_vals(technique);
    return many_lights_init(&technique->lights, desc,
                            &(struct many_lights_visibility){.lookup = lookup,
                                                             .map_count = own->vals,
                                                             .share = technique->first.share});
}

/* Those of another size, beside the ones that are there. */
static bool init_blocks_anew(struct block_visibility_pass *fresh,
                             const struct block_visibility_pass *old, int width, int height) {
    struct block_visibility_desc desc = old->desc;
    desc.width = width;
    desc.height = height;
    return !old->program || block_visibility_pass_init(fresh, &desc);
}

static void replace_blocks(struct vals *vals, const struct block_visibility_pass *fresh) {
    block_visibility_pass_free(&vals->blocks);
    vals->blocks = *fresh;
}

static bool resize(void *state, int width, int height) {
    struct clustered *technique = state;
    struct block_visibility_pass first = {0}, further = {0};
    if (!init_blocks_anew(&first, &technique->first.blocks, width, height) ||
        !init_blocks_anew(&further, &technique->further.blocks, width, height) ||
        !many_lights_resize(&technique->lights, width, height)) {
        block_visibility_pass_free(&first);
        block_visibility_pass_free(&further);
        return false;
    }
    replace_blocks(&technique->first, &first);
    replace_blocks(&technique->further, &further);
    return true;
}

static void render_vals(struct vals *vals, const struct frame *frame,
                        const struct vpl_buffer *vpls) {
    cluster_pass_render(&vals->cluster, frame, vpls);
    timer_begin(frame->timers, "maps");
    paraboloid_pass_render(&vals->paraboloid, frame, &vals->cluster.views);
    if (vals->convolve)
        basis_pass_render(&vals->basis, frame, &vals->paraboloid.maps.depth);
    timer_end(frame->timers);
}

/* The points' VALs are those of the second bounce: later ones light the same surfaces. */
static void render_bounce(struct clustered *technique, const struct frame *frame, int bounce) {
    struct many_lights *lights = &technique->lights;
    struct vals *further = &technique->further, *from = bounce == 2 ? &technique->first : further;
    struct bounce_inputs inputs = {.vpls = &from->cluster.vpls, .visibility = maps_of(from)};
    if (bounce == 2)
        bounce_pass_pick(&lights->bounce, frame, &inputs);
    bounce_pass_begin(&lights->bounce);
    bounce_pass_gather(&lights->bounce, frame, &inputs);
    many_lights_end_bounce(lights, frame, bounce);
    if (bounce == 2)
        render_vals(further, frame, &lights->bounce.vpls);
    else
        cluster_pass_map(&further->cluster, &lights->bounce.vpls);
}

static void render_lights(void *state, const struct frame *frame) {
    struct clustered *technique = state;
    many_lights_render_vpls(&technique->lights, frame);
    render_vals(&technique->first, frame, &technique->lights.vpls);
    for (int bounce = 2; bounce <= technique->lights.bounces; bounce++)
        render_bounce(technique, frame, bounce);
    find_centers(technique);
}

static void gather(const struct clustered *technique, const struct vals *vals, bool further,
                   const struct frame *frame, const struct gbuffer *gbuffer) {
    struct visibility_inputs maps = maps_of(vals);
    if (vals->share)
        block_visibility_pass_render(&vals->blocks, frame, gbuffer, &maps);
    many_lights_gather(&technique->lights, frame, gbuffer,
                       &(struct gather_inputs){.vpls = &vals->cluster.vpls,
                                               .further = further,
                                               .visibility = maps,
                                               .blocks = &vals->blocks.blocks});
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct clustered *technique = state;
    many_lights_begin(&technique->lights, frame, gbuffer);
    gather(technique, &technique->first, false, frame, gbuffer);
    if (technique->lights.bounces > 1)
        gather(technique, &technique->further, true, frame, gbuffer);
    many_lights_finish(&technique->lights, frame, gbuffer);
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
         OUTPUT_VALS, &technique->output},
        {"val-depth", "paraboloid depth maps from the VALs", OUTPUT_MAP_DEPTH,
         &technique->first.paraboloid.maps},
        {"visibility", "the soft shadow of each VAL alone [Dong 2009 Fig. 9]", OUTPUT_VISIBILITY,
         &technique->output},
    };
    many_lights_outputs(&technique->lights, &technique->first.cluster.vpls, outputs);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        output_add(outputs, &rows[i]);
    if (technique->first.convolve)
        add_bases(&technique->first.basis.maps, outputs);
}

static const struct settings_part *const parts[] = {
    &lights_part, &own_part, &map_part, &lookup_part, &caster_part, &gather_part, &blur_part, NULL};

static const struct preset presets[] = {
    {"draft", "for slow machines: fewer lights and maps, no care for detail",
     "lights.vpls=512 clustered.vals=12 map.size=128 gather.detail=0 gather.near-samples=256"},
    MANY_LIGHTS_FAST,
    {"fine", "for scenes of many small things: more maps, and lights where detail is",
     "clustered.vals=60 gather.detail=2 gather.detail-times=1"},
    {"paper", "as published: convolution soft shadow maps at each pixel and VPL",
     "clustered.visibility=cssm clustered.visibility-block=0 " MANY_LIGHTS_AS_PUBLISHED},
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
