/* Clusters of VPLs as area lights [Prutkin 2012]: some tens of lights that each pixel takes all of,
 * so that nothing is interleaved or blurred. As rectangles they are lit from by Lambert's formula,
 * as disks by the paper's. The paper has no visibility; here VALs may give it, as it proposes. */
#include "base/memory.h"
#include "passes/lights/cluster_light.h"
#include "passes/lights/seed_importance.h"
#include "shared/cluster.h"
#include "shared/gather.h"
#include "techniques/vals.h"

enum light_seeds { LIGHT_SEEDS_EVEN, LIGHT_SEEDS_IMPORTANCE };

enum light_visibility { LIGHT_VISIBILITY_VALS, LIGHT_VISIBILITY_NONE };

struct cluster_lights_settings {
    int lights; /* J */
    int form;   /* LIGHT_FORM_... */
    int visibility;
    int seeds;
    int near;
};

#define ROW(name) offsetof(struct cluster_lights_settings, name)

static const char *const form_names[] = {"rectangle", "disk", NULL};
static const char *const visibility_names[] = {"vals", "none", NULL};
static const char *const seed_names[] = {"even", "importance", NULL};

static const struct option table[] = {
    {"area-lights", 0, OPTION_INT, ROW(lights), 128, 1, LIGHT_RECTANGLES_MAX,
     .label = "area lights", .help = "number of area lights (clusters of VPLs), J"},
    {"form", 0, OPTION_CHOICE, ROW(form), LIGHT_FORM_RECTANGLE, .label = "shape",
     .choices = form_names,
     .help = "shape of an area light: a rectangle of the cluster's second moments; or,\n"
             "as published, a disk (its clusters weigh normals by\n"
             "10 instead of .1)"},
    {"shadows", 0, OPTION_CHOICE, ROW(visibility), LIGHT_VISIBILITY_VALS, .label = "shadows",
     .choices = visibility_names,
     .help = "visibility of the area lights: from virtual area\n"
             "lights (clustered.vals), or none as published"},
    {"seeds", 0, OPTION_CHOICE, ROW(seeds), LIGHT_SEEDS_EVEN, .label = "first groups",
     .choices = seed_names,
     .help = "VPLs where clusters begin: the first J, or\n"
             "chosen by their unoccluded light in the picture"},
    {"near", 0, OPTION_INT, ROW(near), 256, 0, NEAR_SAMPLES_MAX, .label = "near samples",
     .help = "near-field samples per pixel, which replace the near part of\n"
             "the rectangles; 0: off",
     .needs = "cluster-lights.form=rectangle"},
    {NULL},
};

static const struct settings_part own_part = {"cluster-lights", "area lights of clusters", table,
                                              sizeof(struct cluster_lights_settings)};

/* Clustering weights of squared distance and of normals, w_d and w_n, by the form of the lights;
 * hues have none. */
static const float weight_position = 1;
static const float weight_normal[] = {[LIGHT_FORM_RECTANGLE] = .1F, [LIGHT_FORM_DISK] = 10};

/* The area lights of some VPLs. */
struct light_set {
    struct cluster_pass cluster;
    struct cluster_light_pass shape;
    struct vpl_buffer lights; /* with their VALs' numbers */
};

struct cluster_lights {
    struct many_lights lights;
    struct vals vals;
    struct light_set first, later;
    struct seed_importance_pass importance; /* of the first bounce's */
    bool has_vals, by_importance;
};

static void free_set(struct light_set *set) {
    cluster_pass_free(&set->cluster);
    cluster_light_pass_free(&set->shape);
    vpl_buffer_free(&set->lights);
}

static void free_state(void *state) {
    struct cluster_lights *technique = state;
    if (technique) {
        many_lights_free(&technique->lights);
        vals_free(&technique->vals);
        free_set(&technique->first);
        free_set(&technique->later);
        seed_importance_pass_free(&technique->importance);
    }
    free(technique);
}

static bool init_set(struct light_set *set, const struct settings *settings, int vpl_count,
                     const struct texture *seeds) {
    const struct cluster_lights_settings *own =
        settings_of(struct cluster_lights_settings, settings, &own_part);
    const struct vals_settings *clustering =
        settings_of(struct vals_settings, settings, &vals_part);
    return cluster_pass_init(&set->cluster,
                             &(struct cluster_desc){
                                 .vpl_count = vpl_count,
                                 .val_count = own->lights,
                                 .start = (enum cluster_start)clustering->start,
                                 .seeds = seeds,
                                 .iterations = clustering->iterations,
                                 .metric = CLUSTER_METRIC_SQUARES,
                                 .weight_position = weight_position,
                                 .weight_normal = weight_normal[own->form],
                                 .means_of_map = true,
                             }) &&
           cluster_light_pass_init(&set->shape,
                                   &(struct cluster_light_desc){own->lights, own->form}) &&
           vpl_buffer_init(&set->lights, "lights of clusters", own->lights);
}

static int clamp_of(const struct cluster_lights_settings *own) {
    if (own->form == LIGHT_FORM_DISK)
        return GATHER_CLAMP_DISK;
    return own->near > 0 ? GATHER_CLAMP_RECTANGLE_NEAR : GATHER_CLAMP_RECTANGLE;
}

/* The gather of many lights, but each pixel takes all of them; adaptive pixels look
 * themselves up. */
static struct settings gather_settings(const struct settings *settings) {
    const struct cluster_lights_settings *own =
        settings_of(struct cluster_lights_settings, settings, &own_part);
    struct settings changed = *settings;
    struct gather_settings gather = *settings_of(struct gather_settings, settings, &gather_part);
    gather.interleave = 1;
    gather.adaptive = gather.adaptive > 0 ? 1 : 0;
    gather.clamp = clamp_of(own);
    gather.near_samples = own->near;
    settings_set(&changed, &gather_part, &gather);
    struct blur_settings blur = *settings_of(struct blur_settings, settings, &blur_part);
    blur.radius = 0;
    settings_set(&changed, &blur_part, &blur);
    return changed;
}

static bool init_first(struct cluster_lights *technique, const struct technique_desc *desc) {
    const struct cluster_lights_settings *own =
        settings_of(struct cluster_lights_settings, desc->settings, &own_part);
    const struct lights_settings *lights =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    technique->by_importance = own->seeds == LIGHT_SEEDS_IMPORTANCE;
    struct seed_importance_desc importance = {.count = own->lights,
                                              .clamp_value = many_lights_clamp_value};
    return (!technique->by_importance ||
            seed_importance_pass_init(&technique->importance, &importance)) &&
           init_set(&technique->first, desc->settings, lights->vpls,
                    technique->by_importance ? &technique->importance.seeds : NULL);
}

static bool init(void **state, const struct technique_desc *desc) {
    const struct cluster_lights_settings *own =
        settings_of(struct cluster_lights_settings, desc->settings, &own_part);
    const struct lights_settings *lights =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    struct cluster_lights *technique = *state = mem_alloc(1, sizeof *technique);
    struct settings settings = gather_settings(desc->settings);
    struct technique_desc with_settings = *desc;
    with_settings.settings = &settings;
    struct many_lights_visibility visibility = {VISIBILITY_LOOKUP_NONE, .map_count = 1};
    technique->has_vals = own->visibility == LIGHT_VISIBILITY_VALS;
    if (technique->has_vals) {
        if (!vals_init(&technique->vals, desc, false))
            return false;
        visibility.lookup = vals_lookup(desc->settings);
        visibility.map_count = technique->vals.first.visibility.map_count;
        visibility.block = technique->vals.first.blocks.desc.block;
    }
    return init_first(technique, desc) &&
           (lights->bounces == 1 ||
            init_set(&technique->later, desc->settings, lights->paths, NULL)) &&
           many_lights_init(&technique->lights, &with_settings, &visibility);
}

static bool resize(void *state, int width, int height) {
    struct cluster_lights *technique = state;
    return vals_resize(&technique->vals, &technique->lights, width, height);
}

/* VALs are of the VPLs: a light has the one that it is nearest to. */
static void render_set(struct light_set *set, const struct frame *frame,
                       const struct vpl_buffer *vpls, const struct val_set *vals) {
    cluster_pass_render(&set->cluster, frame, vpls);
    cluster_light_pass_render(&set->shape, frame, &set->cluster.vpls,
                              cluster_pass_centers(&set->cluster));
    if (vals)
        cluster_pass_map(&vals->cluster, &set->shape.lights, &set->lights);
}

static void render_first(struct cluster_lights *technique, const struct frame *frame) {
    const struct val_set *vals = technique->has_vals ? &technique->vals.first : NULL;
    render_set(&technique->first, frame, &technique->lights.vpls, vals);
}

static void render_lights(void *state, const struct frame *frame) {
    struct cluster_lights *technique = state;
    struct many_lights *lights = &technique->lights;
    many_lights_render_vpls(lights, frame);
    if (technique->has_vals)
        vals_render(&technique->vals, lights, frame, NULL);
    if (!technique->by_importance)
        render_first(technique, frame);
    if (lights->bounces > 1)
        render_set(&technique->later, frame, &lights->bounce.vpls,
                   technique->has_vals ? &technique->vals.later : NULL);
}

static void gather(struct cluster_lights *technique, bool later, const struct frame *frame,
                   const struct gbuffer *gbuffer) {
    const struct light_set *set = later ? &technique->later : &technique->first;
    const struct val_set *vals = later ? &technique->vals.later : &technique->vals.first;
    struct gather_inputs inputs = {0};
    if (technique->has_vals)
        inputs = vals_render_blocks(vals, frame, gbuffer);
    inputs.vpls = technique->has_vals ? &set->lights : &set->shape.lights;
    inputs.rectangles = &set->shape.rectangles;
    inputs.later = later;
    many_lights_gather(&technique->lights, frame, gbuffer, &inputs);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct cluster_lights *technique = state;
    if (technique->by_importance) {
        seed_importance_pass_render(&technique->importance, frame, gbuffer, &technique->lights.vpls,
                                    technique->lights.vpl.vertices);
        render_first(technique, frame);
    }
    many_lights_begin(&technique->lights, frame, gbuffer);
    gather(technique, false, frame, gbuffer);
    if (technique->lights.bounces > 1)
        gather(technique, true, frame, gbuffer);
    many_lights_finish(&technique->lights, frame, gbuffer);
}

static void outputs(const void *state, struct output_list *outputs) {
    const struct cluster_lights *technique = state;
    const struct vpl_buffer *vpls =
        technique->has_vals ? &technique->vals.first.cluster.vpls : &technique->lights.vpls;
    many_lights_outputs(&technique->lights, vpls, outputs);
    output_add(outputs, &(struct output){"light", "area lights of clusters, at their middles",
                                         OUTPUT_VPLS, &technique->first.shape.lights});
    if (technique->has_vals)
        vals_outputs(&technique->vals, outputs);
}

static const struct settings_part *const parts[] = {&lights_part, &own_part,    &vals_part,
                                                    &map_part,    &lookup_part, &caster_part,
                                                    &gather_part, &blur_part,   NULL};

static const struct preset presets[] = {
    MANY_LIGHTS_FAST,
    {"paper", "as published: disks, one iteration per frame, importance seeds, no visibility",
     "cluster-lights.form=disk cluster-lights.area-lights=256 clustered.iterations=1 "
     "clustered.start=reseed cluster-lights.seeds=importance cluster-lights.shadows=none "
     "cluster-lights.near=0 lights.vpls=16384",
     NULL},
    {NULL}};

extern const struct technique cluster_lights_technique;
const struct technique cluster_lights_technique = {
    .name = "cluster-lights",
    .help = "clusters of VPLs as area lights, all at each pixel",
    MANY_LIGHTS_TECHNIQUE,
    .refinement = &many_lights_refinement,
    .resize = resize,
};
