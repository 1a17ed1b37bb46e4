/* Light in a volume, from points of surfaces to irradiance at the G-buffer: what the technique `imperfect-volume` draws,
 * and ambient occlusion for any technique's frame.
 *
 *     points -> inject (-> reproject) -> distance -> march -> (reflect -> march)... -> reconstruct
 *
 * Ambient occlusion at a G-buffer that is there:
 *
 *     ambient_occlusion_init(&ao, &(struct ambient_occlusion_desc){settings, scene, geometry, width, height});
 *     ambient_occlusion_render(&ao, &frame, &gbuffer);
 *     ... ao.light.reconstruct.irradiance: R = G = B, the open share in [0, 1], row 0 at the bottom; A = 0 where there is no
 *         surface, or no voxel knows
 *     ambient_occlusion_free(&ao);
 */
#ifndef TECHNIQUES_VOLUME_H
#define TECHNIQUES_VOLUME_H

#include "passes/volume/distance.h"
#include "passes/volume/inject.h"
#include "passes/volume/march.h"
#include "passes/volume/reconstruct.h"
#include "passes/volume/reflect.h"
#include "passes/volumes.h"
#include "techniques/technique.h"
#include "techniques/volume_box.h"

enum { VOLUME_LIGHT_GI, VOLUME_LIGHT_AO }; /* values of volume.volume */

struct volume_settings {
    int volume; /* VOLUME_LIGHT_... */
    int size, order, rays;
    bool reprojection, published;
    float points;   /* of a voxel that a surface crosses */
    float distance; /* of ambient occlusion, m; 0: by the voxels */
};

extern const struct settings_part volume_part;

/* How far ambient occlusion looks for what hides, metres: of a path tracer that is to find the same. */
float volume_ao_distance(const struct settings *settings, const struct geometry *geometry);

struct volume_light_desc {
    const struct settings *settings; /* of init alone, as are those that follow */
    const struct geometry *geometry; /* in its pose at this time */
    int width, height;
    const struct scene *scene; /* must outlive the light */
    int channels;              /* VOLUME_RADIANCE or VOLUME_VISIBILITY */
    int bounces;               /* of radiance */
    bool medium;               /* frames have one, or panes */
};

struct volume_light {
    struct volume_light_desc desc;
    struct volume_settings settings;
    struct box box;  /* that the volume holds at most */
    int clip_choice; /* of the geometry that it is of */
    struct volume volume;
    struct volume_points points;
    struct inject_pass inject;
    struct distance_pass distance;
    struct march_pass march;
    struct reflect_pass reflect; /* where there are bounces */
    struct reconstruct_pass reconstruct;
    struct buffer params;
};

/* Error: out of GPU memory, shader, or a scene without area. */
bool volume_light_init(struct volume_light *light, const struct volume_light_desc *desc);
void volume_light_free(struct volume_light *light);

/* The geometry has moved. Error: out of GPU memory; the light must then be freed. */
bool volume_light_update(struct volume_light *light, const struct geometry *geometry);

/* All but the last step. It depends on no camera, unless frame->gbuffer is reprojected.
 * shadow_maps: LIGHT_MAP_KINDS of them, of the frame's lights; NULL for visibility. unit: factor of
 * the result. */
void volume_light_render(struct volume_light *light, const struct frame *frame,
                         const struct texture *shadow_maps, float unit);

/* The light that leaves surfaces in the volume, as the last march meets it. */
struct march_inputs volume_light_reflected(const struct volume_light *light);

/* The rest, into light->reconstruct.irradiance. */
void volume_light_render_view(const struct volume_light *light, const struct frame *frame,
                              const struct gbuffer *gbuffer);

/* --- ambient occlusion ------------------------------------------------------------------------ */

struct ambient_occlusion_desc {
    const struct settings *settings; /* volume_part's */
    const struct scene *scene;       /* must outlive it */
    const struct geometry *geometry;
    int width, height;
};

struct ambient_occlusion {
    struct volume_light light;
    unsigned pose; /* that the light is of; 0: none */
    int pass;
};

/* Error: more memory or points than a volume may have, or a scene without area. */
bool ambient_occlusion_check(const struct ambient_occlusion_desc *desc);

/* Error: that of ambient_occlusion_check, out of GPU memory, or shader. */
bool ambient_occlusion_init(struct ambient_occlusion *ao,
                            const struct ambient_occlusion_desc *desc);
void ambient_occlusion_free(struct ambient_occlusion *ao);

/* Of the frame's geometry as it is posed; cannot fail. Rays are traced again only in another pose or pass, or with
 * volume.reprojection. */
void ambient_occlusion_render(struct ambient_occlusion *ao, const struct frame *frame,
                              const struct gbuffer *gbuffer);

#endif
