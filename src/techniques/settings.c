#include "techniques/settings.h"

#include "base/error.h"
#include "passes/gather.h"
#include "shared/vpl.h"

#include <string.h>

#define FIELD(name) offsetof(struct settings, name)

static const char *const start_names[] = {"seeds", "warm", "reseed", NULL};
static const char *const visibility_names[] = {"cssm", "hard", "pcss", NULL};
static const char *const clamp_names[] = {"none", "value", "disk", "near", NULL};
static const char *const tone_map_names[] = {"clamp", "filmic", NULL};

static const char *const path_names[] = {"fast", "paper", NULL};

/* Columns: name, letter, type, field, default, minimum, maximum. */
const struct option settings_table[] = {
    {"path", 0, OPTION_CHOICE, FIELD(path), PATH_FAST, .choices = path_names,
     .help = "paper: as published, with CSSM at each pixel and VPL; sets visibility, "
             "visibility-block, clamp, caster-error, bias, blur-separable, "
             "blur-cosine, samples",
     .reinit = true},
    {"vpls", 0, OPTION_INT, FIELD(vpl_count), 1024, 1, VPLS_MAX, .help = "virtual point lights, N",
     .reinit = true, .group = "virtual lights"},
    {"vals", 0, OPTION_INT, FIELD(val_count), 30, 1, 1024,
     .help = "virtual area lights (clusters), M", .reinit = true},
    {"seed", 0, OPTION_INT, FIELD(seed), 0, 0, 1e9,
     .help = "another set of VPLs; 0 = Halton's points as they are", .reinit = true},
    {"rsm-size", 0, OPTION_INT, FIELD(rsm_size), 512, 16, 8192,
     .help = "reflective shadow map, texels a side", .reinit = true},
    {"shadow-size", 0, OPTION_INT, FIELD(shadow_size), 2048, 16, 16384,
     .help = "shadow map of the direct light, texels a side", .reinit = true,
     .group = "direct light"},
    {"shadow-bias", 0, OPTION_FLOAT, FIELD(shadow_bias), 1.5, 0, 100,
     .help = "receiver offset along its normal, in shadow texels", .reinit = true},
    {"iterations", 0, OPTION_INT, FIELD(iterations), 5, 1, 64, .help = "k-means iterations",
     .reinit = true, .group = "clusters"},
    {"start", 0, OPTION_CHOICE, FIELD(start), 0, .choices = start_names,
     .help = "where k-means begins: the same seeds each frame, the last frame's centres, or those "
             "with empty\nclusters seeded again; frames then depend on the ones before",
     .reinit = true},
    {"weight-position", 0, OPTION_FLOAT, FIELD(weight_position), .7, 0, 1000,
     .help = "clustering weight of distance, w_x", .reinit = true},
    {"weight-normal", 0, OPTION_FLOAT, FIELD(weight_normal), .3, 0, 1000,
     .help = "clustering weight of the angle between normals, w_alpha", .reinit = true},
    {"visibility", 0, OPTION_CHOICE, FIELD(visibility), VISIBILITY_PCSS,
     .choices = visibility_names,
     .help = "lookup in a VAL's map: soft by convolution, hard, or percentage-closer soft",
     .reinit = true, .group = "visibility"},
    {"map-size", 0, OPTION_INT, FIELD(map_size), 256, 16, 4096,
     .help = "paraboloid map, texels a side", .reinit = true},
    {"terms", 0, OPTION_INT, FIELD(basis_terms), 4, 1, 16, .help = "terms of the Fourier series, K",
     .reinit = true},
    {"bias", 0, OPTION_FLOAT, FIELD(bias), .25, 0, 100,
     .help = "receiver offset along its normal, in texels of the map at its distance",
     .reinit = true},
    {"map-bias", 0, OPTION_FLOAT, FIELD(map_bias), .005, 0, 1,
     .help = "depth bias of hard lookups, of the distance", .reinit = true},
    {"near-clip", 0, OPTION_FLOAT, FIELD(near_clip), .01, 0, 1,
     .help = "casters nearer to a VAL's centre are ignored, over the scene's radius; at most\n"
             "the VAL's extent",
     .reinit = true},
    {"shift", 0, OPTION_FLOAT, FIELD(shift), .25, 0, 2,
     .help = "ringing suppression: shift of the receiver depth, over 1/(2K)", .reinit = true},
    {"gain", 0, OPTION_FLOAT, FIELD(gain), 2, .1, 16,
     .help = "ringing suppression: scale about one half", .reinit = true},
    {"sharpen-a", 0, OPTION_FLOAT, FIELD(sharpen_a), 0, 0, 1000,
     .help = "contact sharpening A (thesis eq. 5.9); 0 = off", .reinit = true},
    {"sharpen-b", 0, OPTION_FLOAT, FIELD(sharpen_b), 10, 0, 1000, .help = "contact sharpening B",
     .reinit = true},
    {"taps", 0, OPTION_INT, FIELD(taps), 16, 1, 256, .help = "visibility=pcss: texels of a filter",
     .reinit = true},
    {"filter-jacobian", 0, OPTION_FLAG, FIELD(filter_jacobian), 0,
     .help = "filter width by the paraboloid's Jacobian, not alpha/pi", .reinit = true},
    {"visibility-block", 0, OPTION_INT, FIELD(visibility_block), 7, 0, 64,
     .help = "pixels a side of a block that shares its visibility; 0 = each looks itself up;\n"
             "blocks that are no multiple of interleave blur better",
     .reinit = true},
    {"map-batch", 0, OPTION_INT, FIELD(map_batch), 64, 1, 1024,
     .help = "instant-radiosity: maps in memory at once", .reinit = true},
    {"clamp", 0, OPTION_CHOICE, FIELD(clamp), 3, .choices = clamp_names,
     .help = "bound of the geometry term near a VPL", .reinit = true, .group = "near the lights"},
    {"clamp-value", 0, OPTION_FLOAT, FIELD(clamp_value), 25, 0, 1e9,
     .help = "the bound for clamp=value, times the squared scene radius", .reinit = true},
    {"near-reach", 0, OPTION_FLOAT, FIELD(near_reach), 5, .1, 100,
     .help = "clamp=near: reach of the near field, in spacings of VPLs", .reinit = true},
    {"near-samples", 0, OPTION_INT, FIELD(near_samples), 16, 1, 1024,
     .help = "clamp=near: samples of the near field at each pixel", .reinit = true},
    {"interleave", 0, OPTION_INT, FIELD(interleave), 8, 1, 16,
     .help = "n: each pixel of n x n takes its share of the VPLs; 1 = all", .reinit = true,
     .group = "gather and blur"},
    {"blur-radius", 0, OPTION_INT, FIELD(blur_radius), -1, -1, 64,
     .help = "taps to each side; -1 = half the interleave", .reinit = true},
    {"blur-separable", 0, OPTION_FLAG, FIELD(blur_separable), 1,
     .help = "blur along x, then y, not over the whole square at once", .reinit = true},
    {"blur-distance", 0, OPTION_FLOAT, FIELD(blur_distance), .1, 0, 10,
     .help = "blur within this distance, over the scene's extent, alpha", .reinit = true},
    {"blur-cosine", 0, OPTION_FLOAT, FIELD(blur_cosine), .98, -1, 1,
     .help = "blur within this cosine of the normals, beta", .reinit = true},
    {"caster-edge", 0, OPTION_FLOAT, FIELD(caster_edge), .3, .005, 10,
     .help = "longest edge of a caster in paraboloid maps, over the scene's radius", .reinit = true,
     .group = "casters of VAL maps"},
    {"caster-error", 0, OPTION_FLOAT, FIELD(caster_error), .0015, 0, 1,
     .help = "casters in VALs' maps may stray so far, over the scene's radius; 0 = not at all",
     .reinit = true},
    {"exposure", 0, OPTION_FLOAT, FIELD(exposure), 0, -32, 32, .help = "of the picture, EV",
     .group = "picture"},
    {"samples", 0, OPTION_INT, FIELD(samples), 8, 1, 16,
     .help = "places of a pixel at which edges are told: antialiasing; 1 = its centre alone,\n"
             "more count in fours",
     .reinit = true},
    {"tone-map", 0, OPTION_CHOICE, FIELD(tone_map), 0, .choices = tone_map_names,
     .help = "of the picture"},
    {NULL},
};

void settings_apply_path(struct settings *settings) {
    bool paper = settings->path == PATH_PAPER;
    struct settings fast;
    options_set_defaults(settings_table, &fast);
    settings->visibility = paper ? VISIBILITY_CSSM : fast.visibility;
    settings->visibility_block = paper ? 0 : fast.visibility_block;
    settings->clamp = paper ? GATHER_CLAMP_DISK : fast.clamp;
    settings->caster_error = paper ? 0 : fast.caster_error;
    settings->blur_separable = paper ? false : fast.blur_separable;
    settings->bias = paper ? 2 : fast.bias;
    settings->blur_cosine = paper ? .8F : fast.blur_cosine;
    settings->samples = paper ? 1 : fast.samples;
}

void settings_of_path(struct settings *settings, int path) {
    options_set_defaults(settings_table, settings);
    settings->path = path;
    settings_apply_path(settings);
}

bool settings_assign(struct settings *settings, const char *assignment) {
    if (!option_assign(settings_table, settings, assignment))
        return false;
    if (strncmp(assignment, "path=", 5) == 0)
        settings_apply_path(settings);
    return true;
}

bool settings_check(const struct settings *settings) {
    int slots = settings->interleave * settings->interleave;
    if (settings->vpl_count < slots)
        return error_set("interleave=%d needs at least %d VPLs, and vpls=%d", settings->interleave,
                         slots, settings->vpl_count);
    return true;
}
