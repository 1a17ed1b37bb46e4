#include "scene/darkness.h"

#include "base/halton.h"
#include "base/log.h"
#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/corners.h"
#include "scene/surface_rays.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    GRID = 16,     /* rays a side of the picture */
    BOUNCES = 4,   /* rays from each place for reflected light */
    BRIGHTEST = 2, /* percent of the view; exposures leave as much out */
};

/* A candle of 0.02 W/sr gives white walls 1/1600 at 3 m, and automatic exposure shows them; an LED
 * gives the surfaces about it a millionth. */
static const float least_radiance = 1.F / 4096;

/* Of what the brightest places have, that half of the view has at least: code 13 of 255. An
 * exposure that shows the lamps leaves less than that black. */
static const float least_contrast = 1.F / 256;

static const float reflectance = .5F; /* of surfaces on the way */

struct search {
    struct surface_rays rays;
    struct emitters emitters;
    bool only_stand_ins; /* all emitters approximate surfaces: rays that meet these count */
    float srgb_to_linear[256];
};

/* --- surfaces --------------------------------------------------------------------------------- */

static struct corners corners_at(const struct search *search, const struct surface_hit *place) {
    const struct bvh_triangle *triangle = place->triangle;
    struct corners corners;
    vec3s normal = glms_vec3_cross(triangle->edges[0], triangle->edges[1]);
    vec3s from = glms_vec3_sub(place->position, triangle->corner);
    float area2 = glms_vec3_norm2(normal);
    memcpy(corners.index, &search->rays.geometry->indices[3 * triangle->number],
           sizeof corners.index);
    corners.weight[1] = glms_vec3_dot(glms_vec3_cross(from, triangle->edges[1]), normal) / area2;
    corners.weight[2] = glms_vec3_dot(glms_vec3_cross(triangle->edges[0], from), normal) / area2;
    corners.weight[0] = 1 - corners.weight[1] - corners.weight[2];
    return corners;
}

/* Its brightest channel, W/(sr m2). */
static float emission_at(const struct search *search, const struct surface_hit *place) {
    const struct material *material = place->material;
    vec3s color = {{material->emission[0], material->emission[1], material->emission[2]}};
    if (material->emission_texture >= 0) {
        struct corners corners = corners_at(search, place);
        vec4s texel = corners_texel(
            &corners, search->rays.scene, search->rays.geometry, search->srgb_to_linear,
            &(struct corners_texture){material->emission_texture, material->emission_mapping});
        color = glms_vec3_mul(color, glms_vec3(texel));
    }
    return glms_vec3_max(color);
}

/* Whether it shows little but what it mirrors, by a reflectance at its place. */
static bool is_mirror(const struct reflectance *at) {
    const float smooth = .2F; /* a rougher metal shows the lights without a size */
    return at->roughness < smooth && glm_lerp(glms_vec3_max(at->f0), 1, at->metalness) > .5F;
}

/* Whether it shows the camera the emptiness around the scene, in a mirror. */
static bool mirrors_nothing(const struct search *search, const struct camera *camera,
                            const struct surface_hit *place) {
    struct corners corners = corners_at(search, place);
    struct reflectance at = corners_reflectance(&corners, search->rays.scene, search->rays.geometry,
                                                search->srgb_to_linear, place->material);
    vec3s eye = {{camera->eye[0], camera->eye[1], camera->eye[2]}};
    vec3s forward = {{camera->forward[0], camera->forward[1], camera->forward[2]}};
    vec3s way = camera->orthographic ? forward : vec3s_unit(glms_vec3_sub(place->position, eye));
    vec3s mirrored = glms_vec3_muladds(place->normal, -2 * glms_vec3_dot(way, place->normal), way);
    return is_mirror(&at) && surface_rays_leave(&search->rays, place->position, mirrored);
}

/* --- light ------------------------------------------------------------------------------------ */

/* Of a white surface, by one light without a size; the brightest channel. */
static float reflected(const struct search *search, const struct emitter *piece,
                       const struct surface_hit *place) {
    vec3s at = {{piece->position[0], piece->position[1], piece->position[2]}};
    vec3s axis = {{piece->direction[0], piece->direction[1], piece->direction[2]}};
    vec3s path = glms_vec3_sub(at, place->position);
    float distance = glms_vec3_norm(path);
    if (piece->type == EMITTER_DIRECTIONAL || !(distance > 0))
        return 0; /* one without power, or here itself */
    vec3s to_light = glms_vec3_scale(path, 1 / distance);
    float cosine = glms_vec3_dot(to_light, place->normal);
    float radiance = emitter_cone(piece, -glms_vec3_dot(to_light, axis)) * cosine *
                     emitter_in_range(piece, distance) * glm_vec3_max((float *)piece->intensity) /
                     (GLM_PIf * distance * distance);
    /* Sums of what is as small as this do not count either. */
    if (!(radiance > least_radiance / 256))
        return 0;
    return surface_rays_blocked(&search->rays, place->position, at) ? 0 : radiance;
}

static float direct(const struct search *search, const struct surface_hit *place, uint32_t number) {
    const float point[2] = {(float)radical_inverse(2, number), (float)radical_inverse(3, number)};
    float sum = 0;
    for (int i = 0; i < search->emitters.count; i++) {
        struct emitter piece = emitter_piece(&search->emitters.items[i], point);
        sum += reflected(search, &piece, place);
    }
    return sum;
}

/* What the place emits and reflects: light of the lamps, and what surfaces reflect of it once. */
static float radiance_of(const struct search *search, const struct surface_hit *place,
                         uint32_t number) {
    float sum = emission_at(search, place) + direct(search, place, number);
    for (uint32_t i = 0; sum < 1 && i < BOUNCES; i++) {
        uint32_t point = number * BOUNCES + i;
        const float at[2] = {(float)radical_inverse(5, point), (float)radical_inverse(7, point)};
        vec3s way = surface_ray_direction(place->normal, at);
        struct surface_hit next;
        if (surface_rays_find(&search->rays, place->position, way, &next))
            sum += (reflectance * direct(search, &next, point) +
                    (search->only_stand_ins ? emission_at(search, &next) : 0)) /
                   BOUNCES;
    }
    return sum;
}

/* --- the picture ------------------------------------------------------------------------------ */

static int by_radiance(const void *a, const void *b) {
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* The radiance that so many percent of the places have at least. */
static float reached_by(int percent, const float *sorted, int count) {
    return sorted[count - (count * percent + 99) / 100];
}

/* What the camera sees where a grid of rays meets surfaces; how many they are. */
static int find_seen(const struct search *search, const struct camera *camera,
                     struct surface_hit places[GRID * GRID]) {
    int seen = 0;
    for (int i = 0; i < GRID * GRID; i++) {
        const float point[2] = {((float)(i % GRID) + .5F) / GRID, ((float)(i / GRID) + .5F) / GRID};
        seen += surface_rays_find_seen(&search->rays, camera, point, 1, &places[seen]);
    }
    return seen;
}

static bool picture_is_dark(const struct search *search, const struct camera *camera) {
    struct surface_hit places[GRID * GRID];
    float radiance[GRID * GRID];
    int seen = find_seen(search, camera, places);
    if (seen == 0)
        return false;
    for (int i = 0; i < seen; i++)
        radiance[i] = radiance_of(search, &places[i], 1 + (uint32_t)i);
    qsort(radiance, (size_t)seen, sizeof *radiance, by_radiance);
    float brightest = fminf(reached_by(BRIGHTEST, radiance, seen), 1);
    return reached_by(25, radiance, seen) < least_radiance ||
           reached_by(50, radiance, seen) < least_contrast * brightest;
}

static bool picture_is_of_mirrors(const struct search *search, const struct camera *camera) {
    struct surface_hit places[GRID * GRID];
    int seen = find_seen(search, camera, places), empty = 0;
    for (int i = 0; i < seen; i++)
        empty += mirrors_nothing(search, camera, &places[i]);
    return 2 * empty > seen;
}

static bool ask(struct search *search, const struct scene *scene, const struct geometry *geometry,
                bool (*question)(const struct search *, const struct camera *)) {
    struct camera camera;
    camera_place(&camera, scene, 0, 0);
    texture_decode_table(search->srgb_to_linear);
    surface_rays_init(&search->rays, scene, geometry, NULL);
    bool answer = question(search, &camera);
    surface_rays_free(&search->rays);
    return answer;
}

/* Whether none was placed by hand, and shines. */
static bool has_lamps_alone(const struct emitters *emitters) {
    for (int i = 0; i < emitters->count; i++) {
        const struct emitter *light = &emitters->items[i];
        if (!light->lamp && glm_vec3_max((float *)light->intensity) > 0)
            return false;
    }
    return emitters->count > 0 && !emitters->sky;
}

bool scene_is_dark(const struct scene *scene, const struct geometry *geometry) {
    struct search search = {.emitters = emitters_place(scene, 0), .only_stand_ins = true};
    for (int i = 0; i < search.emitters.count; i++)
        search.only_stand_ins = search.only_stand_ins && search.emitters.items[i].stands_in;
    bool dark = has_lamps_alone(&search.emitters) && ask(&search, scene, geometry, picture_is_dark);
    emitters_free(&search.emitters);
    return dark;
}

/* By the factors, which textures make less. */
static bool may_be_mirror(const struct material *material) {
    struct reflectance at = material_reflectance(material);
    if (material->metal_roughness_texture >= 0)
        at.roughness = 0;
    return is_mirror(&at);
}

void scene_note_mirrors(const struct scene *scene, const struct geometry *geometry) {
    struct search search = {0};
    bool any = false;
    for (int i = 0; i < scene->material_count; i++)
        any = any || may_be_mirror(&scene->materials[i]);
    if (any && !scene->environment && ask(&search, scene, geometry, picture_is_of_mirrors))
        log_note("%s: its smooth metals mirror nothing, so they are nearly black: "
                 "--environment FILE gives them a surrounding",
                 scene->path);
}
