/* What all many-light techniques share: reflective shadow map, VPLs, gather and blur. They differ
 * in the visibility between. */
#ifndef TECHNIQUES_MANY_LIGHTS_H
#define TECHNIQUES_MANY_LIGHTS_H

#include "passes/blur.h"
#include "passes/gather.h"
#include "passes/geometry.h"
#include "passes/near_field.h"
#include "passes/vpl.h"
#include "techniques/technique.h"

struct many_lights {
    struct gbuffer rsm;
    struct geometry_pass geometry;
    struct vpl_pass vpl;
    struct vpl_buffer vpls;
    struct gather_pass gather;
    bool has_near_field; /* clamp=near */
    struct near_field_pass near_field;
    struct blur_pass blur;
};

/* How the gather asks for visibility. */
struct many_lights_visibility {
    enum visibility_lookup lookup;
    int map_count;
    bool map_per_vpl, share; /* as in struct gather_desc */
};

/* The settings of a lookup. */
struct visibility_desc many_lights_lookup(const struct settings *settings,
                                          enum visibility_lookup lookup, int map_count);

bool many_lights_init(struct many_lights *lights, const struct technique_desc *desc,
                      const struct many_lights_visibility *visibility);
void many_lights_free(struct many_lights *lights);

/* As technique->resize. */
bool many_lights_resize(struct many_lights *lights, int width, int height);

/* RSM and VPLs, into lights->vpls. */
void many_lights_render_vpls(struct many_lights *lights, const struct frame *frame);

/* The share of map depth that the scene may take, so that the series, of period 2, stays clear of
 * the falls at |t| = 1: 1 - 1 / (2 K). */
float many_lights_depth_range(const struct settings *settings);

/* The near field, where it is not the VPLs', and the blur: after the gather. */
void many_lights_finish(const struct many_lights *lights, const struct frame *frame,
                        const struct gbuffer *gbuffer);

void many_lights_outputs(const struct many_lights *lights, struct technique_outputs *outputs);

#endif
