/* Lightcuts for blocks of pixels [Walter et al. 2005, 2006; Lin and Yuksel 2020], with the
 * visibility of VALs: each pixel takes a few dozen nodes of a tree over all VPLs, chosen for its
 * block by a bound of what they may be off. */
#include "base/memory.h"
#include "passes/gather/vpl_cut.h"
#include "passes/lights/vpl_tree.h"
#include "shared/gather.h"
#include "techniques/vals.h"

struct lightcuts_settings {
    int nodes;
    float tolerance;
};

enum { BLOCK = 8 }; /* pixels a side that share a cut */

#define ROW(name) offsetof(struct lightcuts_settings, name)

static const struct option table[] = {
    {"nodes", 0, OPTION_INT, ROW(nodes), 32, 1, CUT_NODES_MAX, .label = "nodes of a cut",
     .help = "largest number of tree nodes in a block's cut;\n"
             "raise against faint patches near bright lights"},
    {"tolerance", 0, OPTION_FLOAT, ROW(tolerance), .02, 0, 1, .label = "tolerance",
     .help = "error bound of a node, as a fraction of the unshadowed\n"
             "sum; smaller: more nodes, up to lightcuts.nodes"},
    {NULL},
};

static const struct settings_part own_part = {"lightcuts", "cuts through a tree of VPLs", table,
                                              sizeof(struct lightcuts_settings)};

struct lightcuts {
    struct many_lights lights;
    struct vals vals;
    struct vpl_tree_pass first, later; /* of the first bounce's VPLs; of later ones' */
    struct vpl_cut_pass cut;
};

static void free_state(void *state) {
    struct lightcuts *technique = state;
    if (technique) {
        many_lights_free(&technique->lights);
        vals_free(&technique->vals);
        vpl_tree_pass_free(&technique->first);
        vpl_tree_pass_free(&technique->later);
        vpl_cut_pass_free(&technique->cut);
    }
    free(technique);
}

static bool init_trees(struct lightcuts *technique, const struct technique_desc *desc) {
    const struct lights_settings *lights =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    const struct gather_settings *gather =
        settings_of(struct gather_settings, desc->settings, &gather_part);
    int sets = gather->interleave * gather->interleave;
    return vpl_tree_pass_init(&technique->first, &(struct vpl_tree_desc){lights->vpls, sets}) &&
           (lights->bounces == 1 ||
            vpl_tree_pass_init(&technique->later, &(struct vpl_tree_desc){lights->paths, sets}));
}

static bool init_cut(struct lightcuts *technique, const struct technique_desc *desc) {
    const struct lightcuts_settings *own =
        settings_of(struct lightcuts_settings, desc->settings, &own_part);
    const struct lights_settings *lights =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    const struct gather_settings *gather =
        settings_of(struct gather_settings, desc->settings, &gather_part);
    return vpl_cut_pass_init(&technique->cut, &(struct vpl_cut_desc){
                                                  .width = desc->width,
                                                  .height = desc->height,
                                                  .block = BLOCK,
                                                  .nodes = own->nodes,
                                                  .tolerance = own->tolerance,
                                                  .clamp = gather->clamp,
                                                  .clamp_value = many_lights_clamp_value,
                                                  .later = lights->bounces > 1,
                                                  .later_clamp = GATHER_CLAMP_PATCH,
                                              });
}

static bool init(void **state, const struct technique_desc *desc) {
    struct lightcuts *technique = *state = mem_alloc(1, sizeof *technique);
    const struct val_set *first = &technique->vals.first;
    return vals_init(&technique->vals, desc, false) && init_trees(technique, desc) &&
           init_cut(technique, desc) &&
           many_lights_init(&technique->lights, desc,
                            &(struct many_lights_visibility){
                                .lookup = vals_lookup(desc->settings),
                                .map_count = first->visibility.map_count,
                                .block = first->blocks.desc.block,
                                .cuts = true,
                            });
}

static bool resize(void *state, int width, int height) {
    struct lightcuts *technique = state;
    struct vpl_cut_desc desc = technique->cut.desc;
    struct vpl_cut_pass fresh;
    desc.width = width;
    desc.height = height;
    bool ok = vpl_cut_pass_init(&fresh, &desc) &&
              vals_resize(&technique->vals, &technique->lights, width, height);
    vpl_cut_pass_free(ok ? &technique->cut : &fresh);
    if (ok)
        technique->cut = fresh;
    return ok;
}

static void render_lights(void *state, const struct frame *frame) {
    struct lightcuts *technique = state;
    many_lights_render_vpls(&technique->lights, frame);
    vals_render(&technique->vals, &technique->lights, frame, NULL);
    vpl_tree_pass_render(&technique->first, frame, &technique->vals.first.cluster.vpls);
    if (technique->lights.bounces > 1)
        vpl_tree_pass_render(&technique->later, frame, &technique->vals.later.cluster.vpls);
}

static void gather(struct lightcuts *technique, bool later, const struct frame *frame,
                   const struct gbuffer *gbuffer) {
    const struct vpl_tree_pass *tree = later ? &technique->later : &technique->first;
    const struct val_set *vals = later ? &technique->vals.later : &technique->vals.first;
    struct gather_inputs inputs = vals_render_blocks(vals, frame, gbuffer);
    vpl_cut_pass_render(&technique->cut, frame, gbuffer, &tree->tree, later);
    inputs.cuts = &technique->cut.cuts;
    inputs.later = later;
    many_lights_gather(&technique->lights, frame, gbuffer, &inputs);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct lightcuts *technique = state;
    many_lights_begin(&technique->lights, frame, gbuffer);
    gather(technique, false, frame, gbuffer);
    if (technique->lights.bounces > 1)
        gather(technique, true, frame, gbuffer);
    many_lights_finish(&technique->lights, frame, gbuffer);
}

static void outputs(const void *state, struct output_list *outputs) {
    const struct lightcuts *technique = state;
    many_lights_outputs(&technique->lights, &technique->vals.first.cluster.vpls, outputs);
    vals_outputs(&technique->vals, outputs);
}

static const struct settings_part *const parts[] = {&lights_part, &own_part,    &vals_part,
                                                    &map_part,    &lookup_part, &caster_part,
                                                    &gather_part, &blur_part,   NULL};

static const struct preset presets[] = {MANY_LIGHTS_FAST, {NULL}};

extern const struct technique lightcuts_technique;
const struct technique lightcuts_technique = {
    .name = "lightcuts",
    .help = "a cut through a tree of VPLs for each block of pixels",
    MANY_LIGHTS_TECHNIQUE,
    .refinement = &many_lights_refinement,
    .check = many_lights_check,
    .resize = resize,
};
