#include "passes/gather/gather.h"
#include "shared/gather.h"
#include "techniques/many_lights.h"

#define ROW(type, name) offsetof(struct type##_settings, name)

/* Columns: name, letter, type, field, default, minimum, maximum. */
static const struct option lights_table[] = {
    {"vpls", 0, OPTION_INT, ROW(lights, vpls), 1024, 1, 65536, .help = "virtual point lights, N"},
    {"seed", 0, OPTION_INT, ROW(lights, seed), 0, 0, 1e9,
     .help = "another set of VPLs, and of paths; 0 = Halton's as they are"},
    {"rsm-size", 0, OPTION_INT, ROW(lights, rsm_size), 512, RSM_SIZE_MIN, 8192,
     .help =
         "reflective shadow map, texels a side; more than four of them have the texels of four"},
    {"bounces", 0, OPTION_INT, ROW(lights, bounces), 1, 1, 8,
     .help = "of indirect light; those after the first by paths of light from VPLs"},
    {"paths", 0, OPTION_INT, ROW(lights, paths), 4096, VPL_PARTNERS_MAX, 16384,
     .help = "of light that each leave a VPL of further bounces, P; three more each share\n"
             "their light out to these"},
    {"facets", 0, OPTION_FLAG, ROW(lights, facets), 0,
     .help =
         "where nothing is glossy VPLs and near field send light as triangles do, and not as the\n"
         "smooth surface that their normals tell of; right on the mean, and less even"},
    {NULL},
};

static const struct option map_table[] = {
    {"size", 0, OPTION_INT, ROW(map, size), 256, 16, 4096, .help = "paraboloid map, texels a side"},
    {"near-clip", 0, OPTION_FLOAT, ROW(map, near_clip), .025, 0, 1,
     .help =
         "casters nearer to a light's centre are ignored, over the spread of the VPLs; at most\n"
         "their spacing there"},
    {NULL},
};

static const struct option lookup_table[] = {
    {"terms", 0, OPTION_INT, ROW(lookup, terms), 4, 1, 16,
     .help = "terms of the Fourier series, K"},
    {"bias", 0, OPTION_FLOAT, ROW(lookup, bias), .25, 0, 100,
     .help = "receiver offset along its normal, in texels of the map at its distance; of rays two\n"
             "fifths of it"},
    {"map-bias", 0, OPTION_FLOAT, ROW(lookup, map_bias), .005, 0, 1,
     .help = "depth bias of hard lookups, of the distance"},
    {"shift", 0, OPTION_FLOAT, ROW(lookup, shift), .25, 0, 2,
     .help = "ringing suppression: shift of the receiver depth, over 1/(2K)"},
    {"gain", 0, OPTION_FLOAT, ROW(lookup, gain), 2, .1, 16,
     .help = "ringing suppression: scale about one half"},
    {"sharpen-a", 0, OPTION_FLOAT, ROW(lookup, sharpen_a), 0, 0, 1000,
     .help = "contact sharpening A [Dong 2011, eq. 5.9]; 0 = off"},
    {"sharpen-b", 0, OPTION_FLOAT, ROW(lookup, sharpen_b), 10, 0, 1000,
     .help = "contact sharpening B"},
    {"taps", 0, OPTION_INT, ROW(lookup, taps), 16, 1, 256,
     .help = "percentage-closer: texels of a filter"},
    {"filter-jacobian", 0, OPTION_FLAG, ROW(lookup, filter_jacobian), 0,
     .help = "filter width by the paraboloid's Jacobian, not alpha/pi"},
    {NULL},
};

static const char *const clamp_names[] = {"none", "value", "disk", "near", "sphere", NULL};

static const char *const gloss_names[] = {"point", "sphere", "rays", NULL};

static const struct option gather_table[] = {
    {"interleave", 0, OPTION_INT, ROW(gather, interleave), 8, 1, 16,
     .help = "n: each pixel of n x n takes its share of the VPLs; 1 = all"},
    {"clamp", 0, OPTION_CHOICE, ROW(gather, clamp), GATHER_CLAMP_NEAR, .choices = clamp_names,
     .help = "bound of the geometry term near a VPL"},
    {"clamp-value", 0, OPTION_FLOAT, ROW(gather, clamp_value), 25, 0, 1e9,
     .help = "the bound for clamp=value, times the squared scene radius"},
    {"sphere", 0, OPTION_FLOAT, ROW(gather, sphere), .25, 0, 10,
     .help = "clamp=sphere and gloss=sphere: radius, over the distance within which ten VPLs lie"},
    {"near-reach", 0, OPTION_FLOAT, ROW(gather, near_reach), 5, .1, 100,
     .help = "clamp=near: reach of the near field, in spacings of VPLs"},
    {"near-samples", 0, OPTION_INT, ROW(gather, near_samples), 1024, 1, 1024,
     .help =
         "clamp=near: samples of the near field that n x n pixels share out; in pictures of more\n"
         "than 400x400 those where detail is take fewer, down to half"},
    {"gloss", 0, OPTION_CHOICE, ROW(gather, gloss), SPECULAR_RAYS - 1, .choices = gloss_names,
     .help =
         "as what VPLs are reflected: points, whose images are spots, the balls that hold what\n"
         "they stand for, or points as far as rays through the lights' maps do not find the same\n"
         "light better"},
    {"gloss-rays", 0, OPTION_INT, ROW(gather, gloss_rays), 4, 1, 256,
     .help = "gloss=rays: of each pixel"},
    {"gloss-interleave", 0, OPTION_INT, ROW(gather, gloss_interleave), 2, 1, 16,
     .help = "n of what is reflected as by a mirror; at most that of interleave"},
    {"detail", 0, OPTION_INT, ROW(gather, detail), 4, 0, 8,
     .help =
         "n, less than interleave, of pixels that the blur finds few neighbours for: they take\n"
         "more VPLs each, their own lookups and a smaller blur; with interleave=1 1 = their own\n"
         "lookups alone; 0 = as all others"},
    {"detail-times", 0, OPTION_INT, ROW(gather, detail_times), 4, 1, 64,
     .help =
         "as many times as many VPLs again for those of whose neighbours fewer than two are like,\n"
         "or turned by less than 8 degrees; in pictures of more than 400x400 as many fewer"},
    {"detail-share", 0, OPTION_FLOAT, ROW(gather, detail_share), 1, 0, 1,
     .help =
         "such are pixels of whose four neighbours, half the blur's radius away, fewer than this\n"
         "share lie on the same surface, .75 leaves out corners, .5 straight edges too; and those\n"
         "that no block of shared visibility speaks for"},
    {"further-points", 0, OPTION_FLAG, ROW(gather, further_points), 1,
     .help = "with detail: a pixel that shows what no pixel near sees at its centre gathers there, "
             "too"},
    {NULL},
};

static const struct option blur_table[] = {
    {"radius", 0, OPTION_INT, ROW(blur, radius), -1, -1, 64,
     .help = "taps to each side; -1 = half the interleave"},
    {"separable", 0, OPTION_FLAG, ROW(blur, separable), 1,
     .help = "along x, then y, not over the whole square at once"},
    {"distance", 0, OPTION_FLOAT, ROW(blur, distance), .1, 0, 10,
     .help = "within this distance, over the picture's height at the pixel's depth, alpha"},
    {"cosine", 0, OPTION_FLOAT, ROW(blur, cosine), .995, -1, 1,
     .help = "within this cosine of the normals, beta"},
    {NULL},
};

static const struct option caster_table[] = {
    {"error", 0, OPTION_FLOAT, ROW(caster, error), .00055, 0, 1,
     .help = "casters in VALs' maps may stray so far, over the root of the surfaces' area;\n"
             "0 = not at all"},
    {"long", 0, OPTION_INT, ROW(caster, long_count), 500, 0, 10000000,
     .help = "casters whose edges bend as a map bends them: the triangles with the longest edges"},
    {NULL},
};

#define PART(name, heading)                                                                        \
    const struct settings_part name##_part = {#name, heading, name##_table,                        \
                                              sizeof(struct name##_settings)}

PART(lights, "virtual lights");
PART(map, "maps of the virtual lights");
PART(lookup, "looking a map up");
PART(gather, "gathering light");
PART(blur, "blurring it");
PART(caster, "casters in the maps");

const struct refinement many_lights_refinement = {
    .technique = "instant-radiosity",
    .settings = MANY_LIGHTS_REFINED " instant-radiosity.traced=on",
    .first_weight = 2,
};
