#include "shared/gather.h"
#include "techniques/many_lights.h"

#define ROW(type, name) offsetof(struct type##_settings, name)

/* What only techniques with VPLs read. */
#define VIRTUAL_LIGHTS "technique!=imperfect-volume|implicit-visibility"

static const char *const importance_names[] = {"off", "auto", "on", NULL};

/* Columns: name, letter, type, field, default, minimum, maximum. */
static const struct option lights_table[] = {
    {"vpls", 0, OPTION_INT, ROW(lights, vpls), 0, 0, 65536, .label = "virtual lights",
     .help = "number of virtual point lights (VPLs), N; more: smoother and slower;\n"
             "0: 512 if clustered traces shadow rays, else 1024",
     .needs = VIRTUAL_LIGHTS},
    {"seed", 0, OPTION_INT, ROW(lights, seed), 0, 0, 1e9, .label = "random seed",
     .help = "seed of VPLs, light paths and random choices; 0: unshifted Halton sequence",
     .needs = VIRTUAL_LIGHTS},
    {"rsm-size", 0, OPTION_INT, ROW(lights, rsm_size), 512, RSM_SIZE_MIN, 8192,
     .label = "light map texels",
     .help = "texels along each side of a reflective shadow map;\n"
             "reduced for more than 4 light views or 21 point lights",
     .needs = VIRTUAL_LIGHTS},
    {"bounces", 0, OPTION_INT, ROW(lights, bounces), 1, 1, 1000, .label = "light bounces",
     .help = "number of indirect bounces; in a room the first has half to three\n"
             "quarters of the indirect light; light paths from VPLs add the others;\n"
             "past the eighth, chance ends paths as often as surfaces absorb light",
     .needs = "volume.volume!=ao"},
    {"paths", 0, OPTION_INT, ROW(lights, paths), 4096, VPL_PARTNERS_MAX, 16384,
     .label = "paths of bounces",
     .help = "number of VPLs of later bounces, P; 4 P light paths are traced,\n"
             "and the VPLs share the light of all paths",
     .needs = "lights.bounces>1, " VIRTUAL_LIGHTS},
    {"facets", 0, OPTION_FLAG, ROW(lights, facets), 0, .label = "flat triangles",
     .help = "emits from flat triangles instead of smooth normals, for VPLs and near\n"
             "field; unbiased but noisier; only in scenes without specular surfaces",
     .needs = VIRTUAL_LIGHTS},
    {"importance", 0, OPTION_CHOICE, ROW(lights, importance), IMPORTANCE_AUTO,
     .label = "VPL placement", .choices = importance_names,
     .help = "places VPLs, and with lights.bounces>1 VALs, where their light reaches the picture;\n"
             "auto: VPLs of environments, wide lamps, lamps next door and many lights,\n"
             "which are then made for each view; on: those of all lights",
     .needs = VIRTUAL_LIGHTS},
    {NULL},
};

static const struct option map_table[] = {
    {"size", 0, OPTION_INT, ROW(map, size), 256, 16, 4096, .label = "map texels",
     .help = "texels along each side of a paraboloid\n"
             "map; raise for finer contact shadows",
     .needs = "technique!=imperfect-shadow-maps, instant-radiosity.traced!=on, " SHADOWS},
    {NULL},
};

static const struct option lookup_table[] = {
    {"terms", 0, OPTION_INT, ROW(lookup, terms), 4, 1, 16, .label = "Fourier terms",
     .help = "terms of the Fourier series, K", .needs = SHADOWS ", clustered.visibility=cssm"},
    {NULL},
};

static const char *const clamp_names[] = {"none", "value", "disk", "near", "sphere", NULL};

static const char *const specular_names[] = {"point", "sphere", "rays", NULL};

static const struct option gather_table[] = {
    {"interleave", 0, OPTION_INT, ROW(gather, interleave), 8, 1, 16, .label = "pixel pattern",
     .help = "interleave n: each pixel of an n x n pattern takes 1/n^2 of the VPLs,\n"
             "and a blur removes the pattern; 1: all VPLs at each pixel, slowest",
     .needs = "technique!=cluster-lights"},
    {"clamp", 0, OPTION_CHOICE, ROW(gather, clamp), GATHER_CLAMP_NEAR, .label = "near lights",
     .choices = clamp_names,
     .help = "bound of the geometry term near a VPL: none, 25 over the squared scene radius\n"
             "(value), a disk's form factor, the near field from the reflective shadow map,\n"
             "or a virtual spherical light",
     .needs = "technique!=cluster-lights"},
    {"near-samples", 0, OPTION_INT, ROW(gather, near_samples), 1024, 1, 1024,
     .label = "near samples",
     .help = "near-field samples per n x n pixels of the interleave pattern; adaptive\n"
             "pixels take fewer above 400x400, down to half",
     .needs = "technique!=cluster-lights, gather.clamp=near"},
    {"specular", 0, OPTION_CHOICE, ROW(gather, specular), SPECULAR_RAYS - 1,
     .label = "specular light", .choices = specular_names,
     .help = "specular reflection of indirect light: VPLs as points\n"
             "(visible as spots), VPLs as balls, or points and rays through\n"
             "the BVH (least error); without a BVH rays are balls"},
    {"adaptive", 0, OPTION_INT, ROW(gather, adaptive), -1, -1, 8, .label = "adaptive pattern",
     .help = "interleave for adaptive pixels, which have too few similar neighbours\n"
             "to blur; smaller than gather.interleave: more VPLs each, own lookups,\n"
             "less blur; 0: off; if gather.interleave=1, use 1 (own lookups) or 0;\n"
             "-1: 3 if clustered traces shadow rays, else 4"},
    {"adaptive-factor", 0, OPTION_INT, ROW(gather, adaptive_factor), 0, 0, 64,
     .label = "adaptive factor",
     .help = "factor of VPLs for adaptive pixels of fine detail, with fewer\n"
             "than 2 of 4 neighbours on their surface within 8 degrees; above 400x400\n"
             "divided by pixels / 160000; 0: 1 if clustered traces shadow rays, else 4",
     .needs = "technique!=cluster-lights, gather.adaptive!=0, blur.radius!=0"},
    {"edge-samples", 0, OPTION_FLAG, ROW(gather, edge_samples), 1, .label = "edge samples",
     .help = "edge samples: points of a pixel on a surface that no neighbouring\n"
             "pixel centre sees gather separately",
     .needs = "gather.adaptive!=0"},
    {NULL},
};

static const struct option blur_table[] = {
    {"radius", 0, OPTION_INT, ROW(blur, radius), -1, -1, 64, .label = "blur radius",
     .help = "radius of the blur, in pixels; -1: half\n"
             "of gather.interleave; 0: no blur",
     .needs = "technique!=cluster-lights"},
    {"separable", 0, OPTION_FLAG, ROW(blur, separable), 1, .label = "in two steps",
     .help = "blurs along x, then along y; off: over the whole square at once, slower",
     .needs = "technique!=cluster-lights, blur.radius!=0"},
    {"distance", 0, OPTION_FLOAT, ROW(blur, distance), .1, 0, 10, .label = "distance limit",
     .help = "largest distance of neighbours in the blur, over\n"
             "the picture's height at the pixel's depth, alpha"},
    {"cosine", 0, OPTION_FLOAT, ROW(blur, cosine), .995, -1, 1, .label = "normal limit",
     .help = "smallest cosine between normals of neighbours\n"
             "in the blur, beta; .995: 6 degrees"},
    {NULL},
};

static const struct option caster_table[] = {
    {"error", 0, OPTION_FLOAT, ROW(caster, error), CASTER_ERROR, 0, 1, .label = "simplification",
     .help = "largest deviation of simplified casters in the maps, over the\n"
             "square root of the scene's surface area; 0: no simplification",
     .needs = "technique!=instant-radiosity|row-column, " SHADOWS},
    {"long", 0, OPTION_INT, ROW(caster, long_count), CASTER_LONG_COUNT, 0, 10000000,
     .label = "bent triangles",
     .help = "number of triangles, those with the longest edges, whose edges a map\n"
             "bends exactly; raise against bent shadow edges of large triangles",
     .needs = "instant-radiosity.traced!=on, " SHADOWS},
    {NULL},
};

#define PART(name, heading)                                                                        \
    const struct settings_part name##_part = {#name, heading, name##_table,                        \
                                              sizeof(struct name##_settings)}

PART(lights, "virtual point lights");
PART(map, "maps of virtual lights");
PART(lookup, "visibility lookups in the maps");
PART(gather, "gather of the light");
PART(blur, "geometry-aware blur");
PART(caster, "casters in the maps");

/* Fewer VPLs by rays err as much as many by maps, and adaptive pixels then take more of these:
 * docs/notes/rays.md. */
struct settings many_lights_chosen(const struct settings *settings, bool by_rays) {
    struct settings chosen = *settings;
    struct lights_settings lights = *settings_of(struct lights_settings, settings, &lights_part);
    struct gather_settings gather = *settings_of(struct gather_settings, settings, &gather_part);
    if (lights.vpls == 0)
        lights.vpls = by_rays ? 512 : 1024;
    if (gather.adaptive < 0)
        gather.adaptive = by_rays ? 3 : 4;
    if (gather.adaptive_factor == 0)
        gather.adaptive_factor = by_rays ? 1 : 4;
    settings_set(&chosen, &lights_part, &lights);
    settings_set(&chosen, &gather_part, &gather);
    return chosen;
}

const float many_lights_near_clip = .025F;
const float many_lights_clamp_value = 25;

const struct refinement many_lights_refinement = {
    .technique = "instant-radiosity",
    .settings = MANY_LIGHTS_REFINED " instant-radiosity.traced=on",
    .first_weight = 2,
};
