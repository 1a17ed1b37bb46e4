/* The renderer's part for a medium and panes: their block, shadow maps of all light samples, the
 * airlight pass, and the pass that renders panes. */
#ifndef RENDERER_AIRLIGHT_H
#define RENDERER_AIRLIGHT_H

#include "passes/picture/airlight.h"
#include "passes/picture/show_panes.h"
#include "passes/visibility/shadow_map.h"
#include "scene/mesh/geometry.h"

struct airlight_part_desc {
    int width, height, steps;   /* steps 0: nothing scatters, as with panes alone */
    bool slides;                /* lights may have slides */
    bool sky, irradiance;       /* the scene has an environment; the technique has irradiance */
    bool reflects, specular;    /* as in struct show_panes_desc */
    struct caster_pool *panes;  /* NULL: no panes */
    struct light_layout lights; /* layout of the light samples */
};

/* All zero: no medium. */
struct airlight {
    struct buffer medium; /* block BLOCK_MEDIUM */
    struct shadow_map_pass maps;
    int maps_pass; /* index of the pass whose light samples the maps show */
    struct airlight_pass pass;
    struct show_panes_pass panes;
};

bool airlight_init(struct airlight *airlight, const struct airlight_part_desc *desc);
void airlight_free(struct airlight *airlight);
bool airlight_resize(struct airlight *airlight, int width, int height);

/* Sets the medium of the next frames, within the geometry's bounding sphere. */
void airlight_set_medium(const struct airlight *airlight, const struct medium *medium,
                         const struct geometry *geometry);

#endif
