#include "techniques/volume.h"

#include "base/error.h"
#include "passes/frame.h"
#include "scene/caustics.h"

#include <math.h>
#include <string.h>

#define ROW(name) offsetof(struct volume_settings, name)

static const char *const volume_names[] = {"gi", "ao", NULL};

/* The least that leaves voxels between the margins. */
enum { LEAST_SIZE = 8, MOST_SIZE = 4096 };

static const struct option table[] = {
    {"volume", 0, OPTION_CHOICE, ROW(volume), VOLUME_LIGHT_GI, .label = "kind of light",
     .choices = volume_names,
     .help = "gi: indirect light; ao: a constant ambient light, darker where\n"
             "surfaces hide its directions (ambient occlusion)"},
    {"size", 0, OPTION_INT, ROW(size), 64, LEAST_SIZE, MOST_SIZE, .label = "voxels a side",
     .help = "voxels along the longest side of the scene; more: finer contact\n"
             "shadows, memory and time by the third power"},
    {"order", 0, OPTION_INT, ROW(order), 3, 2, 3, .label = "harmonics order",
     .help = "order of the spherical harmonics of a voxel: 2 (4 coefficients) blurs\n"
             "directions more, 3 (9 coefficients) takes twice the memory"},
    {"rays", 0, OPTION_INT, ROW(rays), 100, 1, 4096, .label = "rays a voxel",
     .help = "rays from each empty voxel near a surface; more: less noise, slower"},
    {"voxel-points", 0, OPTION_FLOAT, ROW(points), 5, .01, 100, .label = "points a voxel",
     .help = "mean number of points in a voxel that a surface crosses, k: a part of\n"
             "at most e^-k of these voxels stays empty; with volume.published=on\n"
             "the number of points of each triangle"},
    {"ao-distance", 0, OPTION_FLOAT, ROW(distance), 0, 0, 1e9, .label = "AO distance, m",
     .help = "distance within which surfaces hide ambient light, also of the layer ao, m;\n"
             "0: 16 voxels",
     .needs = "volume.volume=ao"},
    {"reprojection", 0, OPTION_FLAG, ROW(reprojection), 0, .label = "camera's points",
     .help = "adds points at the camera's pixels: fewer holes in visible surfaces,\n"
             "but light depends on the camera"},
    {"published", 0, OPTION_FLAG, ROW(published), 0, .label = "as published",
     .help = "as published: random points and rays, as many points in each triangle,\n"
             "emission by spherical harmonics, six voxels for each pixel"},
    {NULL},
};

const struct settings_part volume_part = {"volume", "voxels of points", table,
                                          sizeof(struct volume_settings)};

/* --- sizes ------------------------------------------------------------------------------------ */

static const double most_bytes = 2147483648.;

static const float default_ao_voxels = 16;

static struct volume_settings own_of(const struct settings *settings) {
    return *settings_of(struct volume_settings, settings, &volume_part);
}

static bool check_memory(const struct volume_desc *volume) {
    const double mebibyte = 1048576;
    double bytes = volume_bytes(volume);
    return bytes <= most_bytes ||
           error_set_memory(
               "volume.size %d: up to %.0f MiB of GPU memory; at most %.0f MiB: take fewer "
               "voxels, for example 200",
               volume->size, bytes / mebibyte, most_bytes / mebibyte);
}

/* box NULL: all of the scene. */
static void set_box(struct volume_desc *volume, const struct geometry *geometry,
                    const struct box *box) {
    memcpy(volume->low, geometry->bounds_min, sizeof volume->low);
    memcpy(volume->high, geometry->bounds_max, sizeof volume->high);
    for (int c = 0; c < 3 && box; c++) {
        volume->low[c] = fmaxf(volume->low[c], box->low[c]);
        volume->high[c] = fminf(volume->high[c], box->high[c]);
    }
}

static struct volume_desc volume_of(const struct volume_light_desc *desc,
                                    const struct volume_settings *own, const struct box *box) {
    struct volume_desc volume = {
        .size = own->size,
        .channels = desc->channels,
        .order = own->order,
        .bounces = desc->bounces > 1,
        .medium = desc->medium,
        .published = own->published,
    };
    set_box(&volume, desc->geometry, box);
    for (int m = 0; m < desc->scene->material_count; m++)
        volume.both_sides |= desc->scene->materials[m].double_sided;
    return volume;
}

static const struct box endless = {{-INFINITY, -INFINITY, -INFINITY},
                                   {INFINITY, INFINITY, INFINITY}};

/* Ambient light is the same beyond: its volume holds all. */
static struct box box_of(const struct volume_light_desc *desc) {
    struct box box = endless;
    if (desc->channels == VOLUME_RADIANCE)
        volume_box_fit(&box, desc->scene, desc->geometry);
    return box;
}

static float ao_distance(const struct volume_settings *own, float voxel) {
    return own->distance > 0 ? own->distance : default_ao_voxels * voxel;
}

float volume_ao_distance(const struct settings *settings, const struct geometry *geometry) {
    struct volume_settings own = own_of(settings);
    struct volume_desc desc = {.size = own.size};
    struct volume_grid grid;
    set_box(&desc, geometry, NULL);
    volume_grid_fit(&grid, &desc);
    return ao_distance(&own, grid.voxel);
}

/* --- passes ----------------------------------------------------------------------------------- */

static enum materials materials_of(const struct settings *settings) {
    return (enum materials)settings_of(struct material_settings, settings, &material_part)
        ->materials;
}

static int points_per_triangle(const struct volume_settings *own) {
    return own->published ? (int)ceilf(own->points) : 0;
}

/* Where points lie: in all voxels, margins too, of a volume that leaves some of the scene out. */
static struct box points_box(const struct volume_grid *grid, const struct box *of_volume) {
    struct box box;
    for (int c = 0; c < 3; c++) {
        box.low[c] = grid->corner[c];
        box.high[c] = grid->corner[c] + (float)grid->cells[c] * grid->voxel;
    }
    return box_ends(of_volume) ? box : endless;
}

static bool init_points(struct volume_light *light, const struct volume_light_desc *desc,
                        const struct box *box, double area) {
    const struct volume_settings *own = &light->settings;
    float voxel = light->volume.grid.voxel;
    return volume_points_init(
        &light->points,
        &(struct volume_points_desc){.scene = desc->scene,
                                     .geometry = desc->geometry,
                                     .materials = materials_of(desc->settings),
                                     .smooth_black = caustics_shown(desc->scene, desc->settings),
                                     .count = volume_points_count(area, voxel, own->points),
                                     .per_triangle = points_per_triangle(own),
                                     .box = *box});
}

/* area: volume_points_area's. */
static bool check(const struct volume_light_desc *desc, const struct volume_desc *volume,
                  double area) {
    struct volume_settings own = own_of(desc->settings);
    return check_memory(volume) &&
           volume_points_check(desc->geometry, area, points_per_triangle(&own));
}

bool volume_light_init(struct volume_light *light, const struct volume_light_desc *desc) {
    *light = (struct volume_light){.desc = *desc, .settings = own_of(desc->settings)};
    light->box = box_of(desc);
    light->clip_choice = desc->geometry->span.clip_choice;
    struct volume_desc volume = volume_of(desc, &light->settings, &light->box);
    struct volume_grid grid;
    volume_grid_fit(&grid, &volume);
    struct box box = points_box(&grid, &light->box);
    double area = volume_points_area(desc->geometry, &box);
    if (check(desc, &volume, area) && volume_init(&light->volume, &volume) &&
        init_points(light, desc, &box, area) &&
        inject_pass_init(&light->inject, &light->volume, light->settings.reprojection,
                         desc->scene->slide_count > 0) &&
        distance_pass_init(&light->distance, &light->volume) &&
        march_pass_init(&light->march, &light->volume) &&
        (!volume.bounces || reflect_pass_init(&light->reflect, &light->volume)) &&
        reconstruct_pass_init(&light->reconstruct, &light->volume, desc->width, desc->height) &&
        buffer_init(&light->params, "volume parameters", sizeof(struct volume_params), NULL))
        return true;
    volume_light_free(light);
    return false;
}

void volume_light_free(struct volume_light *light) {
    volume_free(&light->volume);
    volume_points_free(&light->points);
    inject_pass_free(&light->inject);
    distance_pass_free(&light->distance);
    march_pass_free(&light->march);
    reflect_pass_free(&light->reflect);
    reconstruct_pass_free(&light->reconstruct);
    buffer_free(&light->params);
}

/* Voxels of another size, or other triangles, need another number of points. */
static bool renew_points(struct volume_light *light, const struct geometry *geometry) {
    struct volume_points_desc desc = light->points.desc;
    desc.geometry = geometry;
    desc.box = points_box(&light->volume.grid, &light->box);
    desc.count = volume_points_count(volume_points_area(geometry, &desc.box),
                                     light->volume.grid.voxel, light->settings.points);
    volume_points_free(&light->points);
    return volume_points_init(&light->points, &desc);
}

/* The bounds are those of the whole clip: another clip plays, or a pose reaches beyond. */
bool volume_light_update(struct volume_light *light, const struct geometry *geometry) {
    struct volume_desc desc = light->volume.desc;
    struct volume fresh;
    light->desc.geometry = geometry;
    if (light->clip_choice != geometry->span.clip_choice)
        light->box = box_of(&light->desc);
    light->clip_choice = geometry->span.clip_choice;
    set_box(&desc, geometry, &light->box);
    if (memcmp(&desc, &light->volume.desc, sizeof desc) == 0)
        return volume_points_fit(&light->points, geometry) || renew_points(light, geometry);
    if (!volume_init(&fresh, &desc))
        return false;
    volume_free(&light->volume);
    light->volume = fresh;
    reflect_pass_free(&light->reflect);
    return renew_points(light, geometry) &&
           (!desc.bounces || reflect_pass_init(&light->reflect, &light->volume));
}

/* Rays of marches whose light is reflected once more, as a fraction of the last march's: their
 * noise is smoothed again. */
static const float early_rays = .25F;

/* Surfaces read voxels 1.5 voxels above them, so that a mean ray, of cosine 2/3, begins a voxel
 * nearer to what it meets; and a voxel reaches half a voxel beyond the surface in it. */
static const float nearer = 1.5F;

static float ray_voxels(const struct volume_light *light, float voxel) {
    float distance = ao_distance(&light->settings, voxel) / voxel;
    return light->settings.published ? distance : fmaxf(distance - nearer, 1);
}

static void write_params(const struct volume_light *light, int pass, bool last, float unit) {
    struct volume_params params = volume_params_of(&light->volume);
    bool visibility = light->volume.desc.channels == VOLUME_VISIBILITY;
    params.rays = last || light->settings.published
                      ? light->settings.rays
                      : (int)ceilf(early_rays * (float)light->settings.rays);
    params.distance = visibility ? ray_voxels(light, params.voxel) : 1e9F;
    params.irradiance_scale = unit;
    params.turn[0] = (float)fmod(pass * .7548776662466927, 1);
    params.turn[1] = (float)fmod(pass * .5698402909980532, 1);
    buffer_write(&light->params, 0, sizeof params, &params);
}

static struct march_inputs direct_of(const struct volume *volume) {
    return (struct march_inputs){&volume->radiosity, &volume->back, &volume->turned_radiosity};
}

struct march_inputs volume_light_reflected(const struct volume_light *light) {
    const struct volume *volume = &light->volume;
    const struct reflect_pass *reflect = &light->reflect;
    if (volume->desc.bounces)
        return (struct march_inputs){&reflect->radiosity, &reflect->back, &reflect->turned};
    return direct_of(volume);
}

void volume_light_render(struct volume_light *light, const struct frame *frame,
                         const struct texture *shadow_maps, float unit) {
    const struct volume *volume = &light->volume;
    const struct buffer *params = &light->params;
    const int bounces = light->desc.bounces;
    struct march_inputs inputs = direct_of(volume);
    write_params(light, frame->pass, bounces == 1, unit);
    volume_points_place(&light->points, frame->geometry);
    inject_pass_render(&light->inject, frame, volume, params, &light->points, shadow_maps);
    if (light->settings.reprojection && frame->gbuffer)
        inject_pass_add_pixels(&light->inject, frame, frame->gbuffer, volume, params, shadow_maps);
    distance_pass_render(&light->distance, frame, volume, params);
    march_pass_render(&light->march, frame, volume, params, &inputs);
    inputs = volume_light_reflected(light);
    for (int bounce = 2; bounce <= bounces; bounce++) {
        reflect_pass_render(&light->reflect, frame, volume, params);
        write_params(light, frame->pass, bounce == bounces, unit);
        march_pass_render(&light->march, frame, volume, params, &inputs);
    }
}

void volume_light_render_view(const struct volume_light *light, const struct frame *frame,
                              const struct gbuffer *gbuffer) {
    reconstruct_pass_render(&light->reconstruct, frame, gbuffer, &light->volume, &light->params);
}

/* --- ambient occlusion ------------------------------------------------------------------------ */

static struct volume_light_desc visibility_of(const struct ambient_occlusion_desc *desc) {
    return (struct volume_light_desc){.settings = desc->settings,
                                      .scene = desc->scene,
                                      .geometry = desc->geometry,
                                      .width = desc->width,
                                      .height = desc->height,
                                      .channels = VOLUME_VISIBILITY,
                                      .bounces = 1,
                                      .medium = geometry_has_panes(desc->geometry)};
}

bool ambient_occlusion_check(const struct ambient_occlusion_desc *desc) {
    struct volume_light_desc light = visibility_of(desc);
    struct volume_settings own = own_of(desc->settings);
    struct volume_desc volume = volume_of(&light, &own, NULL);
    return check(&light, &volume, volume_points_area(desc->geometry, &endless));
}

bool ambient_occlusion_init(struct ambient_occlusion *ao,
                            const struct ambient_occlusion_desc *desc) {
    struct volume_light_desc light = visibility_of(desc);
    *ao = (struct ambient_occlusion){0};
    return volume_light_init(&ao->light, &light);
}

void ambient_occlusion_free(struct ambient_occlusion *ao) {
    volume_light_free(&ao->light);
}

void ambient_occlusion_render(struct ambient_occlusion *ao, const struct frame *frame,
                              const struct gbuffer *gbuffer) {
    const struct geometry *geometry = frame->geometry;
    if (ao->pose != geometry->pose_count || ao->pass != frame->pass ||
        ao->light.settings.reprojection) {
        struct frame seen = *frame;
        seen.gbuffer = gbuffer;
        volume_light_render(&ao->light, &seen, NULL, 1);
        ao->pose = geometry->pose_count;
        ao->pass = frame->pass;
    }
    volume_light_render_view(&ao->light, frame, gbuffer);
}
