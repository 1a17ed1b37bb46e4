#include "scene/darkness.h"

#include "base/halton.h"
#include "base/memory.h"
#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/corners.h"
#include "scene/surface_rays.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    GRID = 16,   /* rays a side of the picture */
    BOUNCES = 4, /* rays from each place for reflected light */
};

/* A candle of 0.02 W/sr gives white walls 1/1600 at 3 m, and automatic exposure shows them; an LED gives the
 * surfaces about it a millionth. */
static const float least_radiance = 1.F / 4096;
static const int least_share = 4; /* one place in so many */

static const float reflectance = .5F; /* of surfaces on the way */

struct search {
    struct surface_rays rays;
    struct emitters emitters;
    float srgb_to_linear[256];
};

/* --- surfaces --------------------------------------------------------------------------------- */

/* Its brightest channel, W/(sr m2). */
static float emission_at(const struct search *search, const struct surface_hit *place) {
    const struct bvh_triangle *triangle = place->triangle;
    const struct material *material = place->material;
    const struct geometry *geometry = search->rays.geometry;
    vec3s color = {{material->emission[0], material->emission[1], material->emission[2]}};
    if (material->emission_texture >= 0) {
        struct corners corners;
        vec3s normal = glms_vec3_cross(triangle->edges[0], triangle->edges[1]);
        vec3s from = glms_vec3_sub(place->position, triangle->corner);
        float area2 = glms_vec3_norm2(normal);
        memcpy(corners.index, &geometry->indices[3 * triangle->number], sizeof corners.index);
        corners.weight[1] =
            glms_vec3_dot(glms_vec3_cross(from, triangle->edges[1]), normal) / area2;
        corners.weight[2] =
            glms_vec3_dot(glms_vec3_cross(triangle->edges[0], from), normal) / area2;
        corners.weight[0] = 1 - corners.weight[1] - corners.weight[2];
        vec4s texel = corners_texel(
            &corners, search->rays.scene, geometry, search->srgb_to_linear,
            &(struct corners_texture){material->emission_texture, material->emission_mapping});
        color = glms_vec3_mul(color, glms_vec3(texel));
    }
    return glms_vec3_max(color);
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
    for (uint32_t i = 0; sum < least_radiance && i < BOUNCES; i++) {
        uint32_t point = number * BOUNCES + i;
        const float at[2] = {(float)radical_inverse(5, point), (float)radical_inverse(7, point)};
        vec3s way = surface_ray_direction(place->normal, at);
        struct surface_hit next;
        if (surface_rays_find(&search->rays, place->position, way, &next))
            sum += reflectance * direct(search, &next, point) / BOUNCES;
    }
    return sum;
}

/* --- the picture ------------------------------------------------------------------------------ */

static bool picture_is_dark(const struct search *search) {
    struct camera camera;
    int seen = 0, lit = 0;
    camera_place(&camera, search->rays.scene, 0, 0);
    for (uint32_t i = 0; i < GRID * GRID; i++) {
        const float point[2] = {((float)(i % GRID) + .5F) / GRID, ((float)(i / GRID) + .5F) / GRID};
        struct surface_hit place;
        if (!surface_rays_find_seen(&search->rays, &camera, point, 1, &place))
            continue;
        seen++;
        lit += radiance_of(search, &place, 1 + i) >= least_radiance;
    }
    return lit * least_share < seen;
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
    struct search search = {.emitters = emitters_place(scene, 0)};
    bool dark = false;
    if (has_lamps_alone(&search.emitters)) {
        texture_decode_table(search.srgb_to_linear);
        surface_rays_init(&search.rays, scene, geometry);
        dark = picture_is_dark(&search);
        surface_rays_free(&search.rays);
    }
    emitters_free(&search.emitters);
    return dark;
}
