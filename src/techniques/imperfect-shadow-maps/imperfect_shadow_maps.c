/* Imperfect shadow maps [Ritschel et al. 2008]: each VPL has a map of its own, small and made of a
 * few points of surfaces, of which each map has others: its faults are averaged over all VPLs. The
 * peer of clustered visibility, which has a few good maps. */
#include "base/memory.h"
#include "shared/maps.h"
#include "shared/splat.h"
#include "techniques/imperfect-shadow-maps/fill.h"
#include "techniques/imperfect-shadow-maps/splat.h"
#include "techniques/vpl_maps.h"

struct imperfect_settings {
    int size, points, shape;
};

#define ROW(name) offsetof(struct imperfect_settings, name)

enum shape { SHAPE_DISK, SHAPE_SQUARE, SHAPE_FILLED };

static const char *const shape_names[] = {"disk", "square", "filled", NULL};

static const struct option table[] = {
    {"size", 0, OPTION_INT, ROW(size), 64, 8, 1024, .label = "map texels",
     .help = "texels along each side of a VPL's map"},
    {"map-points", 0, OPTION_INT, ROW(points), 4096, 16, 262144, .label = "points a map",
     .help = "number of surface points per map; raise\n"
             "for contact shadows and thin casters"},
    {"shape", 0, OPTION_CHOICE, ROW(shape), SHAPE_DISK, .label = "point shape",
     .choices = shape_names,
     .help = "shape of a point in a map: a disk in its true orientation,\n"
             "a square at one depth, or squares half as large whose\n"
             "holes pull and push fill, as published"},
    {NULL},
};

static const struct settings_part own_part = {"imperfect-shadow-maps", "maps of points", table,
                                              sizeof(struct imperfect_settings)};

/* Sets of points, which VPLs use in rotation. */
enum { POINT_SETS = 64 };

struct imperfect {
    struct many_lights lights;
    struct splat_pass splat;
    bool filled;
    struct fill_pass fill;
    struct vpl_maps maps;
};

static void free_state(void *state) {
    struct imperfect *technique = state;
    if (technique) {
        many_lights_free(&technique->lights);
        splat_pass_free(&technique->splat);
        fill_pass_free(&technique->fill);
        vpl_maps_free(&technique->maps);
    }
    free(technique);
}

static void render_maps(void *state, const struct frame *frame, const struct map_views *views,
                        int first) {
    struct imperfect *technique = state;
    splat_pass_render(&technique->splat, frame, views, first);
    if (technique->filled)
        fill_pass_render(&technique->fill, frame, &technique->splat.maps, views,
                         technique->splat.points.radius);
}

static const struct depth_maps *final_maps(const struct imperfect *technique) {
    return technique->filled ? &technique->fill.maps : &technique->splat.maps;
}

static bool init(void **state, const struct technique_desc *desc) {
    const struct imperfect_settings *own =
        settings_of(struct imperfect_settings, desc->settings, &own_part);
    const struct lights_settings *lights =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    struct imperfect *technique = *state = mem_alloc(1, sizeof *technique);
    int batch = lights->vpls < MAP_VIEWS_MAX ? lights->vpls : MAP_VIEWS_MAX;
    enum visibility_lookup lookup =
        own->shape == SHAPE_DISK ? VISIBILITY_LOOKUP_PLANE : VISIBILITY_LOOKUP_HARD;
    struct many_lights_visibility visibility = {lookup, .map_per_vpl = true, .map_count = batch,
                                                .map_size = own->size};
    struct splat_desc splat = {
        .points = {desc->scene, desc->geometry, own->points, POINT_SETS},
        .size = own->size,
        .count = batch,
        .scale = own->shape == SHAPE_FILLED ? .5F : 1, /* holes between small squares are filled */
        .shape = own->shape == SHAPE_DISK ? SPLAT_DISK : SPLAT_SQUARE,
    };
    technique->filled = own->shape == SHAPE_FILLED;
    return many_lights_init(&technique->lights, desc, &visibility) &&
           splat_pass_init(&technique->splat, &splat) &&
           (!technique->filled || fill_pass_init(&technique->fill, own->size, batch)) &&
           vpl_maps_init(&technique->maps,
                         &(struct vpl_maps_desc){final_maps(technique), render_maps, technique});
}

static void render_lights(void *state, const struct frame *frame) {
    struct imperfect *technique = state;
    vpl_maps_render_lights(&technique->maps, &technique->lights, frame);
}

static void render_view(void *state, const struct frame *frame, const struct gbuffer *gbuffer) {
    struct imperfect *technique = state;
    vpl_maps_render_view(&technique->maps, &technique->lights, frame, gbuffer);
}

static void outputs(const void *state, struct output_list *outputs) {
    const struct imperfect *technique = state;
    many_lights_outputs(&technique->lights, &technique->lights.vpls, outputs);
    output_add(outputs, &(struct output){"vpl-depth", "imperfect depth maps of the last VPLs",
                                         OUTPUT_MAP_DEPTH, final_maps(technique)});
}

static const struct settings_part *const parts[] = {&lights_part, &own_part, &gather_part,
                                                    &blur_part, NULL};

static const struct preset presets[] = {
    MANY_LIGHTS_FAST,
    {"paper", "holes filled; gather and blur as published",
     MANY_LIGHTS_AS_PUBLISHED " imperfect-shadow-maps.shape=filled", NULL},
    {NULL}};

extern const struct technique imperfect_shadow_maps_technique;
const struct technique imperfect_shadow_maps_technique = {
    .name = "imperfect-shadow-maps",
    .help = "a small map of surface points per VPL",
    MANY_LIGHTS_TECHNIQUE,
    .seeks_lights = true,
    .refinement = &many_lights_refinement,
    .check = many_lights_check,
    .resize = many_lights_resize,
};
