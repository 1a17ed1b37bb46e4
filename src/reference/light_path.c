#include "reference/light_path.h"

#include "reference/smooth.h"
#include "reference/vector.h"

#include "base/memory.h"

#include <math.h>

/* Points of a segment: one for so many pixels of its length in the picture. */
enum { PIXELS_PER_POINT = 6, POINTS_MOST = 24 };

struct walk {
    const struct light_path_scene *scene;
    struct emitter piece;
    struct smooth_ray ray;
    vec3s flux;      /* W, without the light's range */
    float travelled; /* metres */
    int smooth;      /* so many interfaces so far */
    struct light_deposits *deposits;
};

static double mean(vec3s light) {
    return (double)glms_vec3_hadd(light) / 3;
}

static void leave(struct light_deposits *deposits, const struct light_deposit *deposit) {
    if (deposits->count == deposits->room) {
        deposits->room = deposits->room ? 2 * deposits->room : 1024;
        deposits->items =
            mem_resize(deposits->items, (size_t)deposits->room, sizeof *deposits->items);
    }
    deposits->items[deposits->count++] = *deposit;
}

/* The flux so far along the ray, within the light's range. */
static vec3s flux_at(const struct walk *walk, float along) {
    return glms_vec3_scale(walk->flux, emitter_in_range(&walk->piece, walk->travelled + along));
}

/* The share of what leaves a point that comes to the eye. */
static vec3s passes_to_eye(const struct walk *walk, vec3s point, const struct camera_view *view) {
    return medium_transmittance(&walk->scene->emission->medium, point, view->to_eye,
                                view->distance);
}

/* --- on a surface ----------------------------------------------------------------------------- */

/* What the diffuse part reflects to the eye. Light by the shading normal's cosine is counted, as a
 * path tracer counts it, and rays come by the triangle's. */
static float reflected_share(const struct hit *hit, vec3s to_eye) {
    float cosine = glms_vec3_dot(hit->normal, hit->towards);
    float of_triangle = glms_vec3_dot(hit->geometric_normal, hit->towards);
    float to_camera = glms_vec3_dot(hit->geometric_normal, to_eye);
    if (cosine <= 0 || of_triangle <= 0 || to_camera <= 0)
        return 0;
    float share = to_camera * cosine / of_triangle;
    return hit->brdf.diffuse
               ? share
               : share * brdf_eval(&hit->brdf, hit->normal, to_eye, hit->towards).diffuse;
}

static void leave_on_surface(const struct walk *walk, const struct hit *hit) {
    const struct camera_link *link = &walk->scene->link;
    vec3s above = ray_scene_departure(walk->scene->rays, hit);
    struct camera_view view;
    if (hit_is_black(hit) || !camera_link_view(link, hit->position, &view) || !view.in_range)
        return;
    float share = reflected_share(hit, view.to_eye) * view.weight * GLM_1_PIf;
    if (!(share > 0))
        return;
    vec3s seen = camera_link_sees(link, &view, above);
    if (glms_vec3_max(seen) <= 0)
        return;
    leave(walk->deposits,
          &(struct light_deposit){
              .pixel = view.pixel,
              .light = glms_vec3_scale(flux_at(walk, 0), share),
              .albedo = hit->brdf.albedo,
              .passes = glms_vec3_mul(seen, passes_to_eye(walk, hit->position, &view)),
          });
}

/* --- in a medium ------------------------------------------------------------------------------ */

/* A piece of the ray, and how it lies to the camera: angles as seen from it, or metres where it is
 * orthographic. */
struct piece {
    float from, to; /* metres along the ray */
    float foot, h;  /* of the camera: how far along, and how far aside */
    bool by_angle;
    int points;
};

static vec3s point_at(const struct walk *walk, float along) {
    return glms_vec3_muladds(walk->ray.direction, along, walk->ray.origin);
}

/* In the picture, pixels. */
static float length_seen(const struct walk *walk, const struct piece *piece) {
    const struct primary_rays *primary = &walk->scene->link.primary;
    float width = (float)primary->width, height = (float)primary->height, places[2][2];
    float margin = 1e-3F * (piece->to - piece->from);
    for (int end = 0; end < 2; end++) {
        vec3s point = point_at(walk, end ? piece->to - margin : piece->from + margin);
        if (!camera_project(primary->camera, point.raw, width / height, places[end]))
            return width;
    }
    return hypotf((places[1][0] - places[0][0]) * width, (places[1][1] - places[0][1]) * height);
}

static bool find_piece(const struct walk *walk, float length, struct piece *piece) {
    const struct camera *camera = walk->scene->link.primary.camera;
    const struct medium_ball *medium = &walk->scene->emission->medium;
    float ends[2];
    if (!medium_segment(medium, walk->ray.origin, walk->ray.direction, length, ends) ||
        !camera_link_cut(&walk->scene->link, walk->ray.origin, walk->ray.direction, ends))
        return false;
    vec3s to_eye = glms_vec3_sub(vector_of(camera->eye), walk->ray.origin);
    float foot = glms_vec3_dot(to_eye, walk->ray.direction);
    vec3s aside = glms_vec3_muladds(walk->ray.direction, -foot, to_eye);
    *piece = (struct piece){ends[0],
                            ends[1],
                            foot,
                            fmaxf(glms_vec3_norm(aside), 1e-6F * medium->radius),
                            !camera->orthographic,
                            0};
    float more = fminf(length_seen(walk, piece) / PIXELS_PER_POINT, POINTS_MOST - 1);
    piece->points = 1 + (int)more;
    return true;
}

/* The i-th point, metres along the ray, and how many metres it stands for. */
static float place_of(const struct piece *piece, float i, float *stands_for) {
    float share = i / (float)piece->points;
    if (!piece->by_angle) {
        *stands_for = (piece->to - piece->from) / (float)piece->points;
        return glm_lerp(piece->from, piece->to, share);
    }
    float from = atan2f(piece->from - piece->foot, piece->h);
    float to = atan2f(piece->to - piece->foot, piece->h);
    float off = piece->h * tanf(glm_lerp(from, to, share));
    *stands_for = (to - from) / (float)piece->points * (piece->h * piece->h + off * off) / piece->h;
    return piece->foot + off;
}

static void leave_at(const struct walk *walk, float along, float stands_for) {
    const struct camera_link *link = &walk->scene->link;
    const struct medium_ball *medium = &walk->scene->emission->medium;
    vec3s point = point_at(walk, along);
    struct camera_view view;
    if (!camera_link_view(link, point, &view))
        return;
    float phase = medium_phase(medium->g, glms_vec3_dot(walk->ray.direction, view.to_eye));
    float share = phase * stands_for * view.weight;
    if (!(share > 0 && isfinite(share)))
        return;
    vec3s seen = camera_link_sees(link, &view, point);
    if (glms_vec3_max(seen) <= 0)
        return;
    vec3s light = glms_vec3_mul(flux_at(walk, along), medium->scattering);
    vec3s comes = medium_transmittance(medium, walk->ray.origin, walk->ray.direction, along);
    vec3s passes = glms_vec3_mul(glms_vec3_mul(comes, seen), passes_to_eye(walk, point, &view));
    leave(walk->deposits,
          &(struct light_deposit){.pixel = view.pixel,
                                  .is_volume = true,
                                  .light = glms_vec3_scale(glms_vec3_mul(light, passes), share)});
}

static void leave_in_medium(const struct walk *walk, float length, struct sampler *sampler) {
    struct piece piece;
    if (!find_piece(walk, length, &piece))
        return;
    float jitter = sampler_next(sampler).x;
    for (int i = 0; i < piece.points; i++) {
        float stands_for, along = place_of(&piece, (float)i + jitter, &stands_for);
        leave_at(walk, along, stands_for);
    }
}

/* --- the path --------------------------------------------------------------------------------- */

/* Through glass, or through the medium. */
static void travel(struct walk *walk, float length) {
    vec3s passes = walk->ray.inside
                       ? smooth_passes(walk->ray.inside, length)
                       : medium_transmittance(&walk->scene->emission->medium, walk->ray.origin,
                                              walk->ray.direction, length);
    walk->flux = glms_vec3_mul(walk->flux, passes);
    walk->travelled += length;
}

/* To the next surface; false: the ray has ended there. */
static bool go_on(struct walk *walk, struct sampler *sampler, struct light_balance *balance) {
    const struct light_path_scene *scene = walk->scene;
    bool counts = walk->smooth > 0 || scene->straight;
    struct hit hit;
    bool hits = ray_scene_hit(scene->rays, walk->ray.origin, walk->ray.direction, &hit);
    float length = hits ? glms_vec3_distance(walk->ray.origin, hit.position) : INFINITY;
    double before = mean(walk->flux);
    if (hits)
        walk->ray.inside = smooth_inside(&hit, walk->ray.inside);
    if (counts && !walk->ray.inside && scene->emission->medium.exists)
        leave_in_medium(walk, length, sampler);
    if (!hits) {
        balance->escaped += before;
        return false;
    }
    travel(walk, length);
    walk->flux = glms_vec3_mul(walk->flux, hit.share);
    balance->absorbed += before - mean(walk->flux);
    if (!hit.smooth) {
        *(walk->smooth > 0 ? &balance->landed : &balance->missed) += mean(walk->flux);
        if (counts)
            leave_on_surface(walk, &hit);
        return false;
    }
    if (++walk->smooth > SMOOTH_MOST) {
        balance->cut += mean(walk->flux);
        return false;
    }
    before = mean(walk->flux);
    walk->ray = smooth_leave(scene->rays, &hit, sampler_next(sampler).x);
    walk->flux = glms_vec3_mul(walk->flux, walk->ray.share);
    balance->absorbed += before - mean(walk->flux);
    return glms_vec3_max(walk->flux) > 0;
}

void light_path_trace(const struct light_path_scene *scene, const struct light_ray *ray,
                      struct sampler *sampler, struct light_deposits *deposits,
                      struct light_balance *balance) {
    struct walk walk = {.scene = scene,
                        .piece = ray->piece,
                        .ray = {.origin = ray->origin, .direction = ray->direction},
                        .flux = ray->flux,
                        .deposits = deposits};
    /* Each step takes two pairs of its own. */
    uint32_t first = sampler->pair;
    balance->emitted += mean(walk.flux);
    do
        sampler->pair = first + 2 * (uint32_t)walk.smooth;
    while (go_on(&walk, sampler, balance));
}
