/* What a renderer has for a medium and for panes: their block, shadow maps from all light samples, the airlight pass, and
 * the pass that shows panes. */
#ifndef RENDERER_AIRLIGHT_H
#define RENDERER_AIRLIGHT_H

#include "passes/picture/airlight.h"
#include "passes/picture/show_panes.h"
#include "passes/visibility/shadow_map.h"
#include "scene/mesh/geometry.h"

struct airlight_part_desc {
    int width, height, steps;   /* steps 0: nothing scatters, as of panes alone */
    bool slides;                /* lights may have some */
    bool sky, irradiance;       /* there is one; the technique has some */
    bool reflects, specular;    /* as in struct show_panes_desc */
    struct caster_pool *panes;  /* NULL: there are none */
    struct light_layout lights; /* light samples */
};

/* All zero: no medium. */
struct airlight {
    struct buffer medium; /* for BLOCK_MEDIUM */
    struct shadow_map_pass maps;
    int maps_pass; /* whose light samples the maps are of */
    struct airlight_pass pass;
    struct show_panes_pass panes;
};

bool airlight_init(struct airlight *airlight, const struct airlight_part_desc *desc);
void airlight_free(struct airlight *airlight);
bool airlight_resize(struct airlight *airlight, int width, int height);

/* The medium of the next frames, in the geometry's bounding sphere. */
void airlight_set_medium(const struct airlight *airlight, const struct medium *medium,
                         const struct geometry *geometry);

#endif
