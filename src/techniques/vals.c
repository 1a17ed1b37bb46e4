#include "techniques/vals.h"

#include "passes/frame.h"

enum visibility_kind {
    VISIBILITY_CSSM,
    VISIBILITY_HARD,
    VISIBILITY_PCSS,
    VISIBILITY_RAY,
};

/* Condition under which clusters are used. */
#define VAL_MAPS "clustered.trace!=on"

#define ROW(name) offsetof(struct vals_settings, name)

static const char *const start_names[] = {"seeds", "warm", "reseed", NULL};
static const char *const visibility_names[] = {"cssm", "hard", "pcss", "ray", NULL};
static const char *const trace_names[] = {"off", "auto", "on", NULL};

static const struct option table[] = {
    {"trace", 0, OPTION_CHOICE, ROW(trace), TRACE_AUTO, .label = "shadow rays",
     .choices = trace_names,
     .help = "tests visibility by rays through the scene's triangles instead of VALs and maps;\n"
             "auto: up to 1048576 triangles, 20000 in an animated scene, unless a setting\n"
             "of VALs, maps, lookups or casters differs from its default",
     .needs = "technique=clustered"},
    {"vals", 0, OPTION_INT, ROW(vals), 30, 1, 1024, .label = "shadow groups",
     .help = "number of virtual area lights (VALs), M: clusters of VPLs with\n"
             "one shadow map each; more: finer indirect shadows, slower",
     .needs = SHADOWS},
    {"bounce-vals", 0, OPTION_INT, ROW(bounce_vals), 60, 1, 1024, .label = "groups of bounces",
     .help = "number of VALs for the VPLs of later bounces", .needs = SHADOWS ", lights.bounces>1"},
    {"iterations", 0, OPTION_INT, ROW(iterations), 5, 1, 64, .label = "grouping steps",
     .help = "k-means iterations of the clustering", .needs = VAL_MAPS},
    {"start", 0, OPTION_CHOICE, ROW(start), 0, .label = "grouping begins", .choices = start_names,
     .help = "initial centres of k-means: fixed seeds, the last frame's centres (warm),\n"
             "or the last frame's with new seeds for empty clusters (reseed); with warm\n"
             "and reseed a frame depends on the frames before",
     .needs = VAL_MAPS},
    {"weight-position", 0, OPTION_FLOAT, ROW(weight_position), .25, 0, 1000,
     .label = "weight of place",
     .help = "clustering weight of distance over the spread of the VPLs, w_x", .needs = SHADOWS},
    {"weight-normal", 0, OPTION_FLOAT, ROW(weight_normal), .3, 0, 1000, .label = "weight of normal",
     .help = "clustering weight of the angle between normals over pi, w_alpha", .needs = SHADOWS},
    {"visibility", 0, OPTION_CHOICE, ROW(visibility), VISIBILITY_RAY, .label = "shadow lookup",
     .choices = visibility_names,
     .help = "visibility of a VPL by its VAL's map: convolution (cssm), hard, percentage-closer\n"
             "(pcss), or a ray through the map; blocks use pcss",
     .needs = SHADOWS},
    {"visibility-block", 0, OPTION_INT, ROW(visibility_block), 7, 0, 64, .label = "shadow block",
     .help = "pixels along each side of a block that shares its visibility; 0: a lookup per\n"
             "pixel; blocks that are no multiple of gather.interleave blur better",
     .needs = SHADOWS},
    {NULL},
};

const struct settings_part vals_part = {"clustered", "virtual area lights", table,
                                        sizeof(struct vals_settings)};

static void free_set(struct val_set *set) {
    cluster_pass_free(&set->cluster);
    vpl_weight_pass_free(&set->weight);
    paraboloid_pass_free(&set->paraboloid);
    basis_pass_free(&set->basis);
    block_visibility_pass_free(&set->blocks);
}

/* Differences between the VALs of the first bounce and of later bounces. */
struct set_desc {
    int vpl_count, val_count;
    bool by_importance;
};

static bool init_cluster(struct val_set *set, const struct settings *settings,
                         const struct set_desc *of) {
    const struct vals_settings *own = settings_of(struct vals_settings, settings, &vals_part);
    if (of->by_importance && !vpl_weight_pass_init(&set->weight, of->vpl_count))
        return false;
    return cluster_pass_init(&set->cluster,
                             &(struct cluster_desc){
                                 .vpl_count = of->vpl_count,
                                 .val_count = set->visibility.map_count,
                                 .start = (enum cluster_start)own->start,
                                 .weights = of->by_importance ? &set->weight.weights : NULL,
                                 .iterations = own->iterations,
                                 .weight_position = own->weight_position,
                                 .weight_normal = own->weight_normal,
                                 .has_views = true,
                                 .near_clip = many_lights_near_clip,
                             });
}

static bool init_maps(struct val_set *set, const struct technique_desc *desc) {
    const struct settings *settings = desc->settings;
    const struct lookup_settings *lookup =
        settings_of(struct lookup_settings, settings, &lookup_part);
    const struct map_settings *map = settings_of(struct map_settings, settings, &map_part);
    return paraboloid_pass_init(&set->paraboloid,
                                &(struct paraboloid_desc){
                                    .casters = desc->casters,
                                    .caster = many_lights_caster(settings),
                                    .size = map->size,
                                    .count = set->visibility.map_count,
                                }) &&
           (!set->convolve || basis_pass_init(&set->basis, &(struct basis_desc){
                                                               .size = map->size,
                                                               .count = set->visibility.map_count,
                                                               .terms = lookup->terms,
                                                           }));
}

static bool init_blocks(struct block_visibility_pass *blocks, const struct val_set *set, int width,
                        int height) {
    return set->block == 0 || block_visibility_pass_init(blocks, &(struct block_visibility_desc){
                                                                     .width = width,
                                                                     .height = height,
                                                                     .block = set->block,
                                                                     .visibility = set->visibility,
                                                                 });
}

enum visibility_lookup vals_lookup(const struct settings *settings) {
    static const enum visibility_lookup lookups[] = {
        [VISIBILITY_CSSM] = VISIBILITY_LOOKUP_CSSM,
        [VISIBILITY_HARD] = VISIBILITY_LOOKUP_HARD,
        [VISIBILITY_PCSS] = VISIBILITY_LOOKUP_PCSS,
        [VISIBILITY_RAY] = VISIBILITY_LOOKUP_RAY,
    };
    const struct vals_settings *own = settings_of(struct vals_settings, settings, &vals_part);
    return lookups[own->visibility];
}

/* True if a setting that only maps read differs from its default. */
static bool asks_for_maps(const struct settings *settings) {
    static const struct settings_part *const parts[] = {&vals_part, &map_part, &lookup_part,
                                                        &caster_part, NULL};
    struct settings usual = {0};
    bool same = true;
    for (const struct settings_part *const *part = parts; *part && same; part++) {
        settings_add(&usual, *part);
        same = settings_same(settings, &usual, *part);
    }
    return !same;
}

bool vals_by_rays(const struct settings *settings, const struct scene *scene,
                  const struct geometry *geometry) {
    const struct vals_settings *own = settings_of(struct vals_settings, settings, &vals_part);
    return own->trace == TRACE_ON || (own->trace == TRACE_AUTO && !asks_for_maps(settings) &&
                                      many_lights_may_trace(scene, geometry));
}

static bool init_set(struct val_set *set, const struct technique_desc *desc,
                     const struct set_desc *of) {
    const struct vals_settings *own = settings_of(struct vals_settings, desc->settings, &vals_part);
    enum visibility_lookup lookup = vals_lookup(desc->settings);
    if (lookup == VISIBILITY_LOOKUP_RAY) /* a ray ends at a VPL; a block has one lookup per VAL */
        lookup = VISIBILITY_LOOKUP_PCSS;
    set->convolve = lookup == VISIBILITY_LOOKUP_CSSM;
    set->block = own->visibility_block;
    set->visibility = many_lights_lookup(desc->settings, lookup, of->val_count);
    return init_cluster(set, desc->settings, of) && init_maps(set, desc) &&
           init_blocks(&set->blocks, set, desc->width, desc->height);
}

static struct visibility_inputs maps_of(const struct val_set *set) {
    return (struct visibility_inputs){
        .views = &set->cluster.views,
        .depth = &set->paraboloid.maps,
        .bases = set->convolve ? &set->basis.maps : NULL,
    };
}

bool vals_init(struct vals *vals, const struct technique_desc *desc, bool follow) {
    const struct vals_settings *own = settings_of(struct vals_settings, desc->settings, &vals_part);
    const struct lights_settings *lights =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    vals->by_importance = follow && lights->importance != IMPORTANCE_OFF && lights->bounces > 1;
    const struct set_desc first = {lights->vpls, own->vals, vals->by_importance};
    const struct set_desc later = {lights->paths, own->bounce_vals, vals->by_importance};
    if (!init_set(&vals->first, desc, &first) ||
        (lights->bounces > 1 && !init_set(&vals->later, desc, &later)))
        return false;
    const struct val_targets *centers = cluster_pass_centers(&vals->first.cluster);
    vals->output = (struct val_output){
        .positions = &centers->position,
        .normals = &centers->normal,
        .fluxes = &centers->flux,
        .extremes = &vals->first.cluster.extremes,
        .visibility = &vals->first.visibility,
        .maps = maps_of(&vals->first),
    };
    return true;
}

void vals_free(struct vals *vals) {
    free_set(&vals->first);
    free_set(&vals->later);
}

bool vals_resize(struct vals *vals, struct many_lights *lights, int width, int height) {
    struct block_visibility_pass first = {0}, later = {0};
    bool ok = init_blocks(&first, &vals->first, width, height) &&
              init_blocks(&later, &vals->later, width, height) &&
              many_lights_resize(lights, width, height);
    block_visibility_pass_free(ok ? &vals->first.blocks : &first);
    block_visibility_pass_free(ok ? &vals->later.blocks : &later);
    if (ok) {
        vals->first.blocks = first;
        vals->later.blocks = later;
    }
    return ok;
}

static void render_set(struct val_set *set, const struct frame *frame,
                       const struct gbuffer *gbuffer, const struct vpl_buffer *vpls) {
    if (gbuffer)
        vpl_weight_pass_render(&set->weight, frame, gbuffer, vpls);
    cluster_pass_render(&set->cluster, frame, vpls);
    timer_begin(frame->timers, "maps");
    paraboloid_pass_render(&set->paraboloid, frame, &set->cluster.views);
    if (set->convolve)
        basis_pass_render(&set->basis, frame, &set->paraboloid.maps.depth);
    timer_end(frame->timers);
}

void vals_render(struct vals *vals, struct many_lights *lights, const struct frame *frame,
                 const struct gbuffer *gbuffer) {
    render_set(&vals->first, frame, gbuffer, &lights->vpls);
    if (lights->bounces > 1)
        render_set(&vals->later, frame, gbuffer, &lights->bounce.vpls);
}

struct gather_inputs vals_render_blocks(const struct val_set *set, const struct frame *frame,
                                        const struct gbuffer *gbuffer) {
    struct gather_inputs inputs = {
        .vpls = &set->cluster.vpls, .visibility = maps_of(set), .blocks = &set->blocks.blocks};
    if (set->block > 0)
        block_visibility_pass_render(&set->blocks, frame, gbuffer, &inputs.visibility);
    return inputs;
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

void vals_outputs(const struct vals *vals, struct output_list *outputs) {
    const struct output rows[] = {
        {"val", "clusters: VPLs in the colour of their VAL, with its rectangle and normal",
         OUTPUT_VALS, &vals->output},
        {"val-depth", "paraboloid depth maps from the VALs", OUTPUT_MAP_DEPTH,
         &vals->first.paraboloid.maps},
        {"visibility", "the soft shadow of each VAL alone [Dong 2009 Fig. 9]", OUTPUT_VISIBILITY,
         &vals->output},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        output_add(outputs, &rows[i]);
    if (vals->first.convolve)
        add_bases(&vals->first.basis.maps, outputs);
}
