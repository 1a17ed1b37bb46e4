/* The views that passes draw: of a camera, and from the lights (shared/view.h, shared/light.h). */
#ifndef LIGHTS_VIEW_H
#define LIGHTS_VIEW_H

#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"
#include "shared/light.h"

/* aspect = width / height. The near plane lies at a millionth of the scene's size. */
void view_of_camera(struct view *view, const struct camera *camera, const struct geometry *geometry,
                    float aspect);

/* Moves the picture so that what lay at that point of it, ndc in [-1, 1], lies in its middle: for places
 * within a pixel. */
void view_shift(struct view *view, const float ndc[2]);

/* What the maps of lights and the programs that use them must be made for. Lights that move or change
 * keep it, but for one that gets a size. */
struct light_layout {
    int lights;
    int groups; /* of lights that are pieces of one (lights/light_samples.h) */
    int views[LIGHT_MAP_KINDS];
    int maps;   /* of the lights' own: one each, six of a point light */
    bool sized; /* one of them has a size */
    bool sky;   /* some are a sky's */
    /* Most of what they light shows the camera nothing of its light (renderer/light_search.h): of light samples alone. */
    bool unseen;
};

/* Of however many; and whether there is room for them. */
void light_layout_count(struct light_layout *layout, const struct emitters *emitters);
bool light_layout_fits(const struct light_layout *layout);

/* Error: more lights or views than there is room for. */
bool light_layout_of(struct light_layout *layout, const struct emitters *emitters);

bool light_layouts_same(const struct light_layout *a, const struct light_layout *b);

/* Texels a side of a map of that kind, where a single view's has `size`. Six views see the whole
 * sphere with half of that each: the same density. */
int light_map_size(int kind, int size);

/* Texels a side for maps of so many views: `size`, or less where there are more than full_views, so that all
 * take no more than these would. */
int light_map_share(int size, int views, int full_views);

/* The orthographic view along a directional light over the scene's bounds. */
void view_of_directional(struct view *view, const struct emitter *light,
                         const struct geometry *geometry);

/* One perspective view of a spot, six along the world's axes of a point light (and of a spot wider
 * than 2 x 60 degrees), one orthographic view over the scene's bounds of a directional light. */
void views_of_emitters(struct light_block *block, const struct emitters *emitters,
                       const struct geometry *geometry);

#endif
