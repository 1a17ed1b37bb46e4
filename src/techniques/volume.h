/* Light in a volume, from surface points to irradiance at the G-buffer: the technique
 * `imperfect-volume`, and ambient occlusion for the frame of any technique.
 *
 *     points -> inject (-> reproject) -> distance -> march -> (reflect -> march)... -> reconstruct
 *
 * For ambient occlusion at a G-buffer call ambient_occlusion_init, _render and _free. The result is
 * ao.light.reconstruct.irradiance: R = G = B is the open fraction in [0, 1], row 0 at the bottom. A
 * is 0 without a surface or a voxel with a value. */
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
    float points;   /* points of a voxel that a surface crosses, on average */
    float distance; /* range of ambient occlusion, metres; 0: by the voxels */
};

extern const struct settings_part volume_part;

/* Returns the range of ambient occlusion, metres, for a path tracer with the same result. */
float volume_ao_distance(const struct settings *settings, const struct geometry *geometry);

struct volume_light_desc {
    /* Read by volume_light_init alone, as the next three members. */
    const struct settings *settings;
    const struct geometry *geometry; /* in its current pose */
    int width, height;
    const struct scene *scene; /* must outlive the light */
    int channels;              /* VOLUME_RADIANCE or VOLUME_VISIBILITY */
    int bounces;               /* bounces of radiance */
    bool medium;               /* frames have a medium or panes */
};

struct volume_light {
    struct volume_light_desc desc;
    struct volume_settings settings;
    struct box box;  /* bounds of the volume */
    int clip_choice; /* clip of the geometry */
    struct volume volume;
    struct volume_points points;
    struct inject_pass inject;
    struct distance_pass distance;
    struct march_pass march;
    struct reflect_pass reflect; /* with more than one bounce */
    struct reconstruct_pass reconstruct;
    struct buffer params;
};

/* Error: out of GPU memory, shader, or a scene without area. */
bool volume_light_init(struct volume_light *light, const struct volume_light_desc *desc);
void volume_light_free(struct volume_light *light);

/* Follows moved geometry. Error: out of GPU memory; the light must then be freed. */
bool volume_light_update(struct volume_light *light, const struct geometry *geometry);

/* Renders all steps except reconstruction. It is independent of the camera unless frame->gbuffer is
 * reprojected. shadow_maps: LIGHT_MAP_KINDS maps of the frame's lights; NULL for visibility. unit:
 * factor of the result. */
void volume_light_render(struct volume_light *light, const struct frame *frame,
                         const struct texture *shadow_maps, float unit);

/* Returns the light that leaves surfaces of the volume in the last march. */
struct march_inputs volume_light_reflected(const struct volume_light *light);

/* Reconstructs irradiance at the G-buffer into light->reconstruct.irradiance. */
void volume_light_render_view(const struct volume_light *light, const struct frame *frame,
                              const struct gbuffer *gbuffer);

/* --- ambient occlusion ------------------------------------------------------------------------ */

struct ambient_occlusion_desc {
    const struct settings *settings; /* settings of volume_part */
    const struct scene *scene;       /* must outlive the ambient occlusion */
    const struct geometry *geometry;
    int width, height;
};

struct ambient_occlusion {
    struct volume_light light;
    unsigned pose; /* pose of the last render; 0: none */
    int pass;
};

/* Error: more memory or points than a volume allows, or a scene without area. */
bool ambient_occlusion_check(const struct ambient_occlusion_desc *desc);

/* Error: that of ambient_occlusion_check, out of GPU memory, or shader. */
bool ambient_occlusion_init(struct ambient_occlusion *ao,
                            const struct ambient_occlusion_desc *desc);
void ambient_occlusion_free(struct ambient_occlusion *ao);

/* Renders ambient occlusion of the geometry's pose; cannot fail. Rays are traced again only in
 * another pose or pass, or with volume.reprojection. */
void ambient_occlusion_render(struct ambient_occlusion *ao, const struct frame *frame,
                              const struct gbuffer *gbuffer);

#endif
