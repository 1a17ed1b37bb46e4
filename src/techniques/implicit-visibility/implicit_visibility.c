/* Radiosity with implicit visibility [Dong 2011 chapter 4]: surface elements know their nearest
 * partner in each of some hundred directions, and so need no shadow map. All but the picture is
 * made on the CPU, on all cores. */
#include "base/error.h"
#include "base/memory.h"
#include "gl/cancel.h"
#include "lights/light_samples.h"
#include "passes/frame.h"
#include "scene/caustics.h"
#include "techniques/implicit-visibility/interpolate.h"
#include "techniques/implicit-visibility/specular.h"
#include "techniques/many_lights.h"

struct radiosity_settings {
    int elements, bins;
    int cover, weight; /* enum links_cover, links_weight */
    int sky, lamps;    /* BY_... */
    int links;         /* LINKS_BY_... */
    int specular;      /* SPECULAR_... */
    bool turned;
};

#define ROW(name) offsetof(struct radiosity_settings, name)

enum { BY_RAYS, BY_BINS };                /* values of radiosity.sky and radiosity.lamps */
enum { LINKS_BY_LEAVES, LINKS_BY_PAIRS }; /* values of radiosity.links */
enum { SPECULAR_OFF, SPECULAR_DIRECT, SPECULAR_INDIRECT }; /* values of radiosity.specular */

static const char *const light_names[] = {"rays", "bins", NULL};
static const char *const links_names[] = {"leaves", "pairs", NULL};
static const char *const specular_names[] = {"off", "direct", "indirect", NULL};
static const char *const cover_names[] = {"disk", "center", NULL};
static const char *const weight_names[] = {"bin", "element", NULL};

static const struct option table[] = {
    {"elements", 0, OPTION_INT, ROW(elements), 4000, 16, 65536, .label = "elements",
     .help = "largest number of surface elements; more: finer light and fewer leaks, time in\n"
             "proportion"},
    {"bins", 0, OPTION_INT, ROW(bins), 12, 2, BINS_SIDE_MAX, .label = "bins a side",
     .help = "bins along each side of a cube of directions, n: 6 n^2 directions; more: sharper\n"
             "shadows, slower; at most the root of a sixth of the elements"},
    {"links", 0, OPTION_CHOICE, ROW(links), LINKS_BY_LEAVES, .label = "links made by",
     .choices = links_names,
     .help = "who makes links: leaves, each element by its own walk of the tree; pairs, nodes in\n"
             "pairs, then refined and pushed to the elements, as published"},
    {"cover", 0, OPTION_CHOICE, ROW(cover), LINKS_COVER_DISK, .label = "bins filled",
     .choices = cover_names,
     .help =
         "bins that an element fills: disk, all that it covers; center, the one of its middle,\n"
         "as published, with leaks",
     .needs = "radiosity.links=leaves"},
    {"weight", 0, OPTION_CHOICE, ROW(weight), LINKS_WEIGHT_BIN, .label = "weight",
     .choices = weight_names,
     .help = "light of an element: bin, as if it filled its bin; element, by its own solid angle,\n"
             "as published, too dark by half"},
    {"sky", 0, OPTION_CHOICE, ROW(sky), BY_RAYS, .label = "environment", .choices = light_names,
     .help = "light of an environment at the elements: rays, from sky.directions directions;\n"
             "bins, through those without a partner, as published"},
    {"lamps", 0, OPTION_CHOICE, ROW(lamps), BY_RAYS, .label = "lamps", .choices = light_names,
     .help = "light of lamps that are surfaces, at the elements: rays, to the lights that stand\n"
             "for them; bins, by links to their elements, as published"},
    {"specular", 0, OPTION_CHOICE, ROW(specular), SPECULAR_OFF, .label = "specular by bins",
     .choices = specular_names,
     .help = "what specular surfaces reflect by bins: direct, light of lamps and environments in\n"
             "place of the direct method's, as published; indirect, all other light;\n"
             "off, nothing"},
    {"turned", 0, OPTION_FLAG, ROW(turned), 1, .label = "turned bins",
     .help = "turns the bins of each element at random: noise in place of bands",
     .needs = "radiosity.links=leaves"},
    {NULL},
};

static const struct settings_part radiosity_part = {"radiosity", "surface elements and their links",
                                                    table, sizeof(struct radiosity_settings)};

struct implicit_visibility {
    const struct scene *scene;
    struct elements_desc elements_desc;
    struct links_desc links_desc;
    int bounces;
    struct elements elements;
    struct tree tree;
    struct links links;
    struct element_light light;
    struct bvh casters, panes;
    struct interpolate_pass interpolate;
    int specular_kind; /* SPECULAR_...; off where all surfaces are diffuse */
    struct specular_pass specular;
    unsigned pose;   /* the geometry's, where the elements are */
    int clip_choice; /* the scene's, in which they were made */
    bool linked;     /* the links are those of this pose, with light of the sky or without */
    bool sky_linked;
    bool sky_by_bins;          /* it shines through bins; else by rays */
    bool lamps_by_bins;        /* likewise lamps, by links */
    struct lamps lamps;        /* where they are by bins */
    float (*sky)[3];           /* of each bin; NULL: none */
    struct environment sky_of; /* what it is of: its texels are the scene's */
};

static void free_elements(struct implicit_visibility *technique) {
    elements_free(&technique->elements);
    tree_free(&technique->tree);
    links_free(&technique->links);
    element_light_free(&technique->light);
    lamps_free(&technique->lamps);
    bvh_free(&technique->casters);
    bvh_free(&technique->panes);
}

static void free_state(void *state) {
    struct implicit_visibility *technique = state;
    if (technique) {
        free_elements(technique);
        interpolate_pass_free(&technique->interpolate);
        specular_pass_free(&technique->specular);
        free(technique->sky);
    }
    free(technique);
}

/* Over the scene's radius: how far apart elements count that are turned by one radian. */
static const float turn_length = .3F;

/* Metaballs have other triangles in each pose. */
static bool is_dynamic(const struct geometry *geometry) {
    for (int i = 0; i < geometry->part_count; i++)
        if (geometry->parts[i].dynamic)
            return true;
    return false;
}

static void lay_elements(struct implicit_visibility *technique, const struct geometry *geometry) {
    technique->elements_desc.geometry = geometry;
    elements_init(&technique->elements, &technique->elements_desc);
    if (technique->elements.count > 0)
        tree_init(&technique->tree, &technique->elements, turn_length * geometry->radius);
}

/* In the pose of time 0, so that a frame depends on its time alone, and not on the pose in which it
 * began. Error: the geometry's. */
static bool lay_elements_at_start(struct implicit_visibility *technique, bool still) {
    struct geometry start;
    if (!(still ? geometry_init_still : geometry_init)(&start, technique->scene, 0))
        return false;
    lay_elements(technique, &start);
    geometry_free(&start);
    return true;
}

/* Moves the elements to the geometry's pose. Error: out of GPU memory. */
static bool place_elements(struct implicit_visibility *technique, const struct geometry *geometry) {
    technique->pose = geometry->pose_count;
    technique->linked = false;
    elements_place(&technique->elements, geometry);
    bvh_free(&technique->casters);
    bvh_free(&technique->panes);
    if (technique->elements.count > 0)
        element_light_casters(&technique->casters, &technique->panes, technique->scene, geometry);
    technique->links.panes = &technique->panes;
    technique->links.clearance = geometry_clearance(geometry);
    return interpolate_pass_fit(&technique->interpolate, &technique->elements, geometry) &&
           (technique->specular_kind == SPECULAR_OFF ||
            specular_pass_fit(&technique->specular, technique->elements.count));
}

/* Error: out of memory. */
static bool make_elements(struct implicit_visibility *technique, const struct geometry *geometry) {
    const struct scene *scene = technique->scene;
    free_elements(technique);
    technique->clip_choice = scene->clip_choice;
    if (scene->clip_count == 0 || is_dynamic(geometry))
        lay_elements(technique, geometry);
    else if (!lay_elements_at_start(technique, geometry->still))
        return false;
    if (!links_init(&technique->links, &technique->links_desc, technique->elements.count))
        return false;
    element_light_init(&technique->light, &technique->tree);
    if (technique->lamps_by_bins)
        lamps_init(&technique->lamps, scene, geometry, &technique->elements);
    return place_elements(technique, geometry);
}

/* The environment may be turned while its picture stays. */
static void follow_sky(struct implicit_visibility *technique) {
    const struct environment *environment = technique->scene->environment;
    struct environment *of = &technique->sky_of;
    bool same = !environment
                    ? !technique->sky
                    : technique->sky && environment->texels == of->texels &&
                          environment->turn == of->turn && environment->strength == of->strength;
    if (!technique->sky_by_bins || same)
        return;
    free(technique->sky);
    technique->sky = NULL;
    technique->linked = false;
    if (environment) {
        technique->sky = element_light_sky(&technique->links.bins, environment);
        *of = *environment;
    }
}

static bool init(void **state, const struct technique_desc *desc) {
    struct implicit_visibility *technique = *state = mem_alloc(1, sizeof *technique);
    const struct radiosity_settings *own =
        settings_of(struct radiosity_settings, desc->settings, &radiosity_part);
    const struct material_settings *materials =
        settings_of(struct material_settings, desc->settings, &material_part);
    technique->scene = desc->scene;
    technique->elements_desc = (struct elements_desc){
        .scene = desc->scene,
        .materials = (enum materials)materials->materials,
        .smooth_black = caustics_shown(desc->scene, desc->settings),
        .most = own->elements,
    };
    /* Pairs, and partners of one bin each, know no elements that only receive. */
    technique->elements_desc.panes =
        own->links != LINKS_BY_PAIRS && own->cover != LINKS_COVER_CENTER;
    technique->links_desc = (struct links_desc){
        .side = own->bins,
        .cover = (enum links_cover)own->cover,
        .weight = (enum links_weight)own->weight,
        .turned = own->turned,
        .leaky = own->cover == LINKS_COVER_CENTER || own->links == LINKS_BY_PAIRS,
        .pairs = own->links == LINKS_BY_PAIRS,
    };
    technique->bounces = settings_of(struct lights_settings, desc->settings, &lights_part)->bounces;
    technique->lamps_by_bins = own->lamps == BY_BINS;
    technique->sky_by_bins = own->sky == BY_BINS;
    technique->specular_kind = desc->specular ? own->specular : SPECULAR_OFF;
    if (!interpolate_pass_init(&technique->interpolate, desc->width, desc->height) ||
        (technique->specular_kind != SPECULAR_OFF &&
         !specular_pass_init(&technique->specular, own->bins, desc->width, desc->height)) ||
        !make_elements(technique, desc->geometry))
        return false;
    follow_sky(technique);
    return true;
}

/* Both targets or none. */
static bool resize(void *state, int width, int height) {
    struct implicit_visibility *technique = state;
    struct irradiance radiance = {0};
    bool specular = technique->specular_kind != SPECULAR_OFF;
    if (specular && !specular_target_init(&radiance, width, height))
        return false;
    if (!irradiance_resize(&technique->interpolate.irradiance, width, height)) {
        irradiance_free(&radiance);
        return false;
    }
    if (specular) {
        irradiance_free(&technique->specular.radiance);
        technique->specular.radiance = radiance;
    }
    return true;
}

/* Also called where lights changed, in the same pose. */
static bool update(void *state, const struct geometry *geometry) {
    struct implicit_visibility *technique = state;
    bool other = technique->clip_choice != technique->scene->clip_choice ||
                 geometry->painted > technique->pose;
    bool moved = technique->pose != geometry->pose_count;
    bool ok = other || (moved && is_dynamic(geometry)) ? make_elements(technique, geometry)
              : moved                                  ? place_elements(technique, geometry)
                                                       : true;
    if (ok)
        follow_sky(technique);
    return ok;
}

/* The samples of the frame's sky, which come last (lights/light_samples.h); 0 where it does not
 * shine. */
static int sky_samples(const struct frame *frame) {
    return frame->emitters->sky ? frame->groups[frame->layout.groups - 1].count : 0;
}

static void link_elements(struct implicit_visibility *technique, const struct frame *frame,
                          bool sky) {
    if (technique->linked && technique->sky_linked == sky)
        return;
    timer_begin(frame->timers, "pull up");
    tree_pull_up(&technique->tree, &technique->elements);
    timer_end(frame->timers);
    timer_begin(frame->timers, "links");
    links_make(&technique->links, &technique->tree, sky ? (const float(*)[3])technique->sky : NULL);
    if (technique->lamps_by_bins) { /* those of lamps that are dark, too */
        element_light_emit(&technique->light, &technique->elements, &technique->tree);
        links_sort_lamps(&technique->links, (const float(*)[4])technique->light.emission);
    }
    timer_end(frame->timers);
    technique->linked = !cancel_came();
    technique->sky_linked = sky;
}

/* Lamps are dark where all lights were replaced by others. */
static bool lamps_shine(const struct frame *frame) {
    for (int i = 0; i < frame->emitters->count; i++)
        if (frame->emitters->items[i].lamp > 0)
            return true;
    return false;
}

static void write_specular(struct implicit_visibility *technique, const struct frame *frame,
                           bool lamps, bool sky) {
    const struct element_light *light = &technique->light;
    struct specular_light arrives = {
        .nodes = lamps ? (const float(*)[4])light->emission : NULL,
        .sky = sky ? (const float(*)[3])technique->sky : NULL,
        .scale = 1,
    };
    if (technique->specular_kind == SPECULAR_INDIRECT)
        arrives = (struct specular_light){.nodes = (const float(*)[4])light->radiance,
                                          .scale = frame->irradiance_scale};
    specular_pass_write(&technique->specular, &technique->links, &arrives);
}

static void light_elements(struct implicit_visibility *technique, const struct frame *frame) {
    int sky = technique->sky ? sky_samples(frame) : 0;
    const struct direct_lights lights = {
        .items = frame->emitters->items,
        .count = frame->emitters->count - sky,
        .lamps_by_links = technique->lamps_by_bins && lamps_shine(frame),
        .casters = &technique->casters,
        .panes = &technique->panes,
        .clearance = geometry_clearance(frame->geometry),
    };
    link_elements(technique, frame, sky > 0);
    if (lights.lamps_by_links) {
        lamps_follow(&technique->lamps, frame->emitters);
        element_light_dim(&technique->light, &technique->elements, &technique->tree,
                          &technique->lamps);
    }
    timer_begin(frame->timers, "direct at elements");
    element_light_direct(&technique->light, &technique->elements, &lights, &technique->links);
    timer_end(frame->timers);
    timer_begin(frame->timers, "bounces");
    element_light_bounce(&technique->light, &technique->elements, &technique->tree,
                         &technique->links, technique->bounces);
    timer_end(frame->timers);
    if (technique->specular_kind != SPECULAR_OFF)
        write_specular(technique, frame, lights.lamps_by_links, sky > 0);
}

static void render_lights(void *state, const struct frame *frame) {
    struct implicit_visibility *technique = state;
    if (technique->elements.count > 0)
        light_elements(technique, frame);
    interpolate_pass_write(&technique->interpolate, &technique->elements, &technique->light,
                           &technique->links, frame->irradiance_scale);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    const struct implicit_visibility *technique = state;
    interpolate_pass_render(&technique->interpolate, frame, gbuffer);
    if (technique->specular_kind != SPECULAR_OFF)
        specular_pass_render(&technique->specular, &technique->interpolate, frame, gbuffer);
}

static struct contribution contribution(const void *state) {
    const struct implicit_visibility *technique = state;
    const struct texture *specular = &technique->specular.radiance.texture;
    return (struct contribution){
        .irradiance = &technique->interpolate.irradiance,
        .radiance = technique->specular_kind == SPECULAR_INDIRECT ? specular : NULL,
        .direct_specular = technique->specular_kind == SPECULAR_DIRECT ? specular : NULL,
    };
}

/* Lamps and skies by rays do not come through bins. */
static bool check(const struct settings *settings) {
    const struct radiosity_settings *own =
        settings_of(struct radiosity_settings, settings, &radiosity_part);
    bool by_bins = own->lamps == BY_BINS && own->sky == BY_BINS;
    return own->specular != SPECULAR_DIRECT || by_bins ||
           error_set("radiosity.specular=direct needs radiosity.lamps=bins and radiosity.sky=bins");
}

static const struct settings_part *const parts[] = {&lights_part, &radiosity_part, NULL};

static const struct preset presets[] = {
    MANY_LIGHTS_FAST,
    {"paper", "links by pairs of nodes, weights of eq. 4.5, lamps and environments by bins",
     "radiosity.links=pairs radiosity.weight=element radiosity.sky=bins radiosity.lamps=bins",
     NULL},
    {NULL}};

extern const struct technique implicit_visibility_technique;
const struct technique implicit_visibility_technique = {
    .name = "implicit-visibility",
    .help = "radiosity of surface elements that know their nearest partners",
    .parts = parts,
    .presets = presets,
    .check = check,
    .init = init,
    .free = free_state,
    .resize = resize,
    .update = update,
    .render_lights = render_lights,
    .render_view = render_view,
    .contribution = contribution,
};
