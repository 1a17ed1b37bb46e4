/* Makes, resizes and frees the passes that the techniques share, by the settings. */
#include "techniques/adaptive_pixels.h"
#include "techniques/many_lights.h"

#include "base/error.h"
#include "scene/animation.h"
#include "scene/caustics.h"
#include "scene/material.h"
#include "shared/bounce.h"
#include "shared/gather.h"
#include "shared/vpl.h"

enum {
    SPECULAR_RAY_COUNT = 4,  /* specular rays of a pixel */
    SPECULAR_INTERLEAVE = 2, /* of the VPLs in specular reflection; 1 is sharper, 4 is cheaper */
    SPECULAR_RAYS_INTERLEAVE = 4, /* the same beside rays */
    SPECULAR_TOGETHER = 16,       /* VPLs of which two test visibility */
    FILTER_TAPS = 16, /* texels of a percentage-closer filter; a blocker search takes half */
};

/* Receiver offset along its normal, in texels of the map at its distance; a ray uses 40 % of it.
 * And depth bias, over the receiver's distance. */
static const float lookup_bias = .25F, lookup_map_bias = .005F;

/* Ringing suppression [Dong 2011, Fig. 5.2]: shift of the receiver's depth in units of 1/(2K), and
 * scale of the blocked fraction about one half. */
static const float ringing_shift = .25F, ringing_gain = 2;

/* Radius of the near field in VPL spacings: less for flat triangles, whose pictures are the mean of
 * many passes. */
static const float near_reach = 5, near_reach_of_facets = 4;

/* Radius of virtual spherical lights, over the distance within which 10 VPLs lie. */
static const float sphere_radius = .25F;

struct visibility_desc many_lights_lookup(const struct settings *settings,
                                          enum visibility_lookup lookup, int map_count) {
    const struct map_settings *map = settings_of(struct map_settings, settings, &map_part);
    const struct lookup_settings *own = settings_of(struct lookup_settings, settings, &lookup_part);
    return (struct visibility_desc){
        .lookup = lookup,
        .map_size = map->size,
        .map_count = map_count,
        .basis_terms = own->terms,
        .bias = lookup_bias,
        .map_bias = lookup_map_bias,
        .shift = ringing_shift,
        .gain = ringing_gain,
        .taps = FILTER_TAPS,
    };
}

struct caster_desc many_lights_caster(const struct settings *settings) {
    const struct caster_settings *own = settings_of(struct caster_settings, settings, &caster_part);
    return (struct caster_desc){.error = own->error, .long_count = own->long_count};
}

static struct visibility_desc lookup_of(const struct settings *settings,
                                        enum visibility_lookup lookup,
                                        const struct many_lights_visibility *visibility) {
    struct visibility_desc desc = many_lights_lookup(settings, lookup, visibility->map_count);
    if (visibility->map_size)
        desc.map_size = visibility->map_size;
    return desc;
}

int many_lights_blur_radius(const struct settings *settings) {
    const struct gather_settings *gather =
        settings_of(struct gather_settings, settings, &gather_part);
    const struct blur_settings *blur = settings_of(struct blur_settings, settings, &blur_part);
    return blur->radius < 0 ? gather->interleave / 2 : blur->radius;
}

/* --- passes --- */

static bool init_gathers(struct many_lights *lights, const struct technique_desc *desc) {
    const struct many_lights_visibility *visibility = &lights->visibility;
    const struct gather_settings *own =
        settings_of(struct gather_settings, desc->settings, &gather_part);
    struct gather_desc gather_desc = {
        .width = desc->width,
        .height = desc->height,
        .interleave = own->interleave,
        .map_per_vpl = visibility->map_per_vpl,
        .share = visibility->block > 0,
        .cuts = visibility->cuts,
        .visibility = lookup_of(desc->settings, visibility->lookup, visibility),
        .clamp = own->clamp,
        .clamp_value = many_lights_clamp_value,
        .sphere = sphere_radius,
        .lobes = lights->specular != SPECULAR_NONE,
        .medium = lights->medium,
        .later = lights->bounces > 1,
    };
    if (!adaptive_pixels_init(lights, desc, &gather_desc))
        return false;
    if (visibility->together && gather_desc.receivers == RECEIVERS_ALL)
        gather_desc.together = vpls_together(&gather_desc);
    return gather_pass_init(&lights->gather, &gather_desc);
}

/* Tests visibility of VPLs by rays. Specular rays find the light of narrow lobes. */
static void take_rays(struct gather_desc *gather) {
    gather->later = gather->share = gather->map_per_vpl = false;
    if (gather->visibility.lookup == VISIBILITY_LOOKUP_NONE)
        return;
    gather->visibility.lookup = VISIBILITY_LOOKUP_TRACED;
    gather->together = SPECULAR_TOGETHER;
}

/* Specular reflection is sharper than diffuse, so each pixel takes more VPLs and a smaller blur. It
 * has no near field: near VPLs are bounded as disks. */
static bool init_specular(struct many_lights *lights, const struct technique_desc *desc) {
    const struct gather_settings *own =
        settings_of(struct gather_settings, desc->settings, &gather_part);
    const struct blur_settings *blur =
        settings_of(struct blur_settings, desc->settings, &blur_part);
    struct gather_desc gather = lights->gather.desc;
    bool rays = lights->specular == SPECULAR_RAYS;
    int wanted = rays ? SPECULAR_RAYS_INTERLEAVE : SPECULAR_INTERLEAVE;
    int n = wanted < own->interleave ? wanted : own->interleave;
    int radius = rays && n > 1 ? n : n / 2;
    gather.interleave = n;
    gather.receivers = RECEIVERS_ALL;
    gather.cuts = gather.lobes = false;
    gather.specular = lights->specular;
    gather.specular_rays = SPECULAR_RAY_COUNT;
    if (rays)
        take_rays(&gather);
    struct blur_desc of_blur =
        blur_desc_specular(desc->width, desc->height, radius, blur->distance);
    of_blur.specular = rays;
    of_blur.square = !rays;
    of_blur.lender = lights->blur.half.texture.id ? &lights->blur : NULL;
    return lights->specular == SPECULAR_NONE ||
           (gather_pass_init(&lights->specular_gather, &gather) &&
            blur_pass_init(&lights->specular_blur, &of_blur));
}

static bool init_specular_rays(struct many_lights *lights, const struct technique_desc *desc) {
    return lights->specular != SPECULAR_RAYS ||
           specular_rays_pass_init(&lights->specular_rays,
                                   &(struct specular_rays_desc){
                                       .rays = SPECULAR_RAY_COUNT,
                                       .later = lights->bounces > 1,
                                       .by_importance = many_lights_follow_camera(lights),
                                       .medium = lights->medium,
                                       .slides = lights->slides,
                                       .lights = *desc->lights,
                                   });
}

/* Returns the texels along a side of a view. Many views share the texels of a few, so that a dozen
 * directions of a sky do not cost as much as the picture. */
static int rsm_size(const struct technique_desc *desc) {
    static const int full_views[LIGHT_MAP_KINDS] = {4, 128};
    const struct lights_settings *own =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    int size = own->rsm_size;
    for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++) {
        int shared = light_map_share(own->rsm_size, desc->lights->views[kind], full_views[kind]);
        size = shared < size ? shared : size;
    }
    return size > RSM_SIZE_MIN ? size : RSM_SIZE_MIN;
}

/* False with specular rays, which need the smooth normals of the surfaces that they meet. */
static bool sends_as_facets(const struct technique_desc *desc) {
    const struct lights_settings *own =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    return own->facets && !desc->specular;
}

/* True if a sky or a wide lamp has several light samples. */
static bool has_light_samples(const struct light_layout *layout) {
    return layout->lights > layout->groups;
}

/* VPLs placed by importance are far apart where the camera sees little of their light. Without rays
 * their near light would shine through walls. */
static bool asks_by_rays(const struct many_lights *lights) {
    return lights->visibility.lookup == VISIBILITY_LOOKUP_TRACED ||
           many_lights_follow_camera(lights);
}

/* Tests near light as VPLs are tested. */
static int near_occlusion(const struct many_lights *lights) {
    return asks_by_rays(lights)                                  ? NEAR_BY_RAYS
           : lights->visibility.lookup == VISIBILITY_LOOKUP_NONE ? NEAR_UNOCCLUDED
                                                                 : NEAR_BY_VIEWS;
}

static bool init_near_sampled(struct many_lights *lights, const struct near_field_desc *others) {
    struct near_sampled_desc desc = {.adaptive = others->adaptive,
                                     .by_importance = others->by_importance,
                                     .medium = lights->medium,
                                     .slides = lights->slides};
    memcpy(desc.list_slots, others->list_slots, sizeof desc.list_slots);
    return !lights->sampled || near_sampled_pass_init(&lights->near_sampled, &desc);
}

static bool init_near_field(struct many_lights *lights, const struct technique_desc *desc) {
    const struct gather_settings *own =
        settings_of(struct gather_settings, desc->settings, &gather_part);
    bool wanted = own->clamp == GATHER_CLAMP_NEAR || own->clamp == GATHER_CLAMP_RECTANGLE_NEAR;
    int occlusion = near_occlusion(lights);
    struct near_field_desc near_field = {
        .samples = own->near_samples,
        .facets = sends_as_facets(desc),
        .normal_maps = desc->specular && materials_have_normal_maps(desc->scene),
        .occlusion = occlusion,
        .casters = occlusion == NEAR_BY_RAYS ? desc->casters : NULL,
        .by_importance = many_lights_follow_camera(lights),
        .medium = lights->medium,
        .slides = lights->slides,
        .rsm_size = rsm_size(desc),
        .lights = *desc->lights,
    };
    adaptive_pixels_fit_near_field(lights, &near_field);
    return !wanted || (near_field_pass_init(&lights->near_field, &near_field) &&
                       init_near_sampled(lights, &near_field));
}

static bool init_blur(struct many_lights *lights, const struct technique_desc *desc) {
    const struct blur_settings *own = settings_of(struct blur_settings, desc->settings, &blur_part);
    int radius = many_lights_blur_radius(desc->settings), n = lights->gather.desc.interleave;
    struct blur_desc blur = {
        .width = desc->width,
        .height = desc->height,
        .radius = radius,
        .distance = own->distance,
        .cosine = own->cosine,
        .square = !own->separable || radius == 0,
    };
    adaptive_pixels_fit_blur(lights, &blur);
    return (n == 1 && radius == 0 && !blur.adaptive) || blur_pass_init(&lights->blur, &blur);
}

/* Makes the passes of the picture's size. */
static bool init_sized(struct many_lights *lights, const struct technique_desc *desc) {
    return init_gathers(lights, desc) && init_blur(lights, desc) && init_specular(lights, desc);
}

static bool init_bounces(struct many_lights *lights, const struct technique_desc *desc) {
    const struct lights_settings *own =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    lights->bounces = own->bounces;
    return lights->bounces == 1 ||
           bounce_pass_init(&lights->bounce, &(struct bounce_desc){
                                                 .casters = desc->casters,
                                                 .bounces = own->bounces,
                                                 .medium = lights->medium,
                                                 .seen = many_lights_follow_camera(lights),
                                                 .count = own->paths,
                                                 .seed = own->seed,
                                             });
}

bool many_lights_may_trace(const struct scene *scene, const struct geometry *geometry) {
    static const uint32_t most_that_move = 20000, most = 1 << 20;
    bool moves = scene_duration(scene) > 0;
    return geometry_triangle_count(geometry) <= (moves ? most_that_move : most);
}

bool many_lights_check(const struct settings *settings) {
    const struct lights_settings *lights =
        settings_of(struct lights_settings, settings, &lights_part);
    const struct gather_settings *gather =
        settings_of(struct gather_settings, settings, &gather_part);
    int places = gather->interleave * gather->interleave;
    return lights->vpls >= places || error_set("interleave=%d needs at least %d VPLs, and vpls=%d",
                                               gather->interleave, places, lights->vpls);
}

/* Without a BVH for rays, VPLs are balls. */
static int specular_of(const struct technique_desc *desc) {
    const struct gather_settings *gather =
        settings_of(struct gather_settings, desc->settings, &gather_part);
    int wanted = desc->specular ? gather->specular + 1 : SPECULAR_NONE;
    bool can_trace = many_lights_may_trace(desc->scene, desc->geometry);
    return wanted == SPECULAR_RAYS && !can_trace ? SPECULAR_SPHERE : wanted;
}

static bool init_tree(struct many_lights *lights) {
    bool asks = lights->visibility.lookup == VISIBILITY_LOOKUP_TRACED ||
                lights->specular == SPECULAR_RAYS || lights->sampled;
    return !asks || caster_pool_acquire_tree(lights->casters, &lights->tree);
}

/* Samplers must have textures, even if no light has a map. */
static bool init_blank_rsm(struct gbuffer *rsm, bool has_specular) {
    bool ok = gbuffer_init(rsm, &(struct gbuffer_desc){"rsm", 1, 1, 1, false, has_specular, false});
    rsm->layers = 0;
    return ok;
}

static bool init_rsm(struct many_lights *lights, const struct technique_desc *desc, int size) {
    const struct light_layout *layout = desc->lights;
    bool ok = true, has_specular = lights->specular != SPECULAR_NONE;
    bool facets = sends_as_facets(desc);
    for (int kind = 0; ok && kind < LIGHT_MAP_KINDS; kind++) {
        int texels = light_map_size(kind, size), layers = layout->views[kind];
        ok = layers == 0 ||
             gbuffer_init(&lights->rsm[kind], &(struct gbuffer_desc){"rsm", texels, texels, layers,
                                                                     false, has_specular, facets});
    }
    if (layout->views[LIGHT_MAP_SINGLE] + layout->views[LIGHT_MAP_FACE] == 0)
        ok = init_blank_rsm(&lights->rsm[LIGHT_MAP_SINGLE], has_specular);
    return ok;
}

/* True if VPLs are placed by importance. With many light samples, or where the camera sees little
 * of the lit surfaces, most VPLs by flux lie where the camera sees nothing of their light. */
static bool wants_importance(const struct many_lights *lights, const struct technique_desc *desc) {
    const struct lights_settings *own =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    const struct light_layout *layout = desc->lights;
    bool gains = (has_light_samples(layout) || layout->unseen || layout->many) &&
                 lights->visibility.lookup != VISIBILITY_LOOKUP_NONE;
    return layout->lights > 0 && (own->importance == IMPORTANCE_ON ||
                                  (own->importance == IMPORTANCE_AUTO && gains &&
                                   many_lights_may_trace(desc->scene, desc->geometry)));
}

/* True if each VPL of a sky has its own direction, not that of a light sample. */
static bool has_sky_rays(const struct many_lights *lights, const struct technique_desc *desc) {
    return desc->lights->sky && many_lights_follow_camera(lights);
}

/* Returns the number of starts: several for each path, at most VPLS_MAX in all. */
static int starts_of(int vpls) {
    int paths = vpls * BOUNCE_ROWS, tries = VPLS_MAX / paths;
    return paths * (tries < BOUNCE_TRIES ? tries : BOUNCE_TRIES);
}

/* Later bounces have an importance map of their own: that of the first says little of them. */
static bool init_path_starts(struct many_lights *lights, const struct technique_desc *desc) {
    const struct lights_settings *own =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    return own->bounces == 1 || !many_lights_follow_camera(lights) ||
           path_starts_init(&lights->path_starts,
                            &(struct path_starts_desc){.casters = desc->casters,
                                                       .lights = desc->lights->lights,
                                                       .count = starts_of(own->paths),
                                                       .bounces = own->bounces,
                                                       .seed = own->seed,
                                                       .medium = lights->medium,
                                                       .slides = lights->slides,
                                                       .sampled = lights->sampled,
                                                       .sky_rays = has_sky_rays(lights, desc)});
}

static bool init_albedos(struct many_lights *lights, const struct technique_desc *desc) {
    bool has_rays =
        has_sky_rays(lights, desc) || lights->specular == SPECULAR_RAYS || lights->sampled;
    return (lights->bounces == 1 && !has_rays) ||
           albedos_init(&lights->albedos,
                        &(struct albedos_desc){
                            .scene = desc->scene,
                            .materials = desc->specular ? MATERIALS_FULL : MATERIALS_DIFFUSE,
                            .smooth_black = caustics_shown(desc->scene, desc->settings)},
                        desc->geometry);
}

static bool init_importance(struct many_lights *lights, const struct technique_desc *desc) {
    const struct lights_settings *own =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    return !wants_importance(lights, desc) ||
           importance_map_pass_init(&lights->importance,
                                    &(struct importance_map_desc){.casters = desc->casters,
                                                                  .lights = desc->lights->lights,
                                                                  .vpls = own->vpls,
                                                                  .sampled = lights->sampled,
                                                                  .sky_rays = desc->lights->sky});
}

bool many_lights_init(struct many_lights *lights, const struct technique_desc *desc,
                      const struct many_lights_visibility *visibility) {
    const struct lights_settings *own =
        settings_of(struct lights_settings, desc->settings, &lights_part);
    const float reach = own->facets ? near_reach_of_facets : near_reach;
    *lights = (struct many_lights){.settings = *desc->settings,
                                   .visibility = *visibility,
                                   .casters = desc->casters,
                                   .specular = specular_of(desc),
                                   .medium = desc->medium,
                                   .sampled = desc->lights->many,
                                   .slides = desc->scene->slide_count > 0};
    if (init_tree(lights) && init_rsm(lights, desc, rsm_size(desc)) &&
        geometry_pass_init(
            &lights->geometry,
            &(struct geometry_desc){.has_specular = desc->specular,
                                    .has_mappings = materials_have_mappings(desc->scene),
                                    .facets = sends_as_facets(desc)}) &&
        init_importance(lights, desc) &&
        vpl_pass_init(&lights->vpl,
                      &(struct vpl_desc){.count = own->vpls,
                                         .seed = own->seed,
                                         .reach = reach,
                                         .by_importance = many_lights_follow_camera(lights),
                                         .sky_rays = has_sky_rays(lights, desc),
                                         .sampled = lights->sampled,
                                         .lobes = lights->specular != SPECULAR_NONE,
                                         .medium = lights->medium,
                                         .slides = lights->slides}) &&
        vpl_buffer_init(&lights->vpls, "VPLs", own->vpls) && init_bounces(lights, desc) &&
        init_path_starts(lights, desc) && init_albedos(lights, desc) && init_sized(lights, desc) &&
        init_specular_rays(lights, desc) && init_near_field(lights, desc))
        return true;
    many_lights_free(lights);
    return false;
}

static void free_sized(struct many_lights *lights) {
    gather_pass_free(&lights->gather);
    adaptive_pass_free(&lights->adaptive);
    gather_pass_free(&lights->adaptive_gather);
    gather_pass_free(&lights->specular_gather);
    blur_pass_free(&lights->specular_blur);
    blur_pass_free(&lights->blur);
}

void many_lights_free(struct many_lights *lights) {
    for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++)
        gbuffer_free(&lights->rsm[kind]);
    geometry_pass_free(&lights->geometry);
    importance_map_pass_free(&lights->importance);
    vpl_pass_free(&lights->vpl);
    vpl_buffer_free(&lights->vpls);
    bounce_pass_free(&lights->bounce);
    albedos_free(&lights->albedos);
    path_starts_free(&lights->path_starts);
    near_field_pass_free(&lights->near_field);
    near_sampled_pass_free(&lights->near_sampled);
    specular_rays_pass_free(&lights->specular_rays);
    caster_pool_release_tree(lights->casters, &lights->tree);
    free_sized(lights);
}

bool many_lights_resize(void *state, int width, int height) {
    struct many_lights *lights = state, fresh = *lights;
    const struct technique_desc desc = {
        .settings = &lights->settings, .width = width, .height = height};
    fresh.gather = fresh.adaptive_gather = fresh.specular_gather = (struct gather_pass){0};
    fresh.specular_blur = fresh.blur = (struct blur_pass){0};
    fresh.adaptive = (struct adaptive_pass){0};
    bool ok = init_sized(&fresh, &desc);
    free_sized(ok ? lights : &fresh);
    if (ok)
        *lights = fresh;
    adaptive_pixels_fit_near_field(lights, &lights->near_field.desc);
    return ok;
}
