/* Views that passes draw, of a camera and from lights (shared/view.h, shared/light.h). */
#ifndef LIGHTS_VIEW_H
#define LIGHTS_VIEW_H

#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"
#include "shared/light.h"

/* Makes the view of a camera. aspect: width / height. The near plane is at a millionth of the
 * scene's radius. */
void view_of_camera(struct view *view, const struct camera *camera, const struct geometry *geometry,
                    float aspect);

/* Shifts the picture: the point ndc in [-1, 1]^2 moves to its middle. For positions within a
 * pixel. */
void view_shift(struct view *view, const float ndc[2]);

/* Writes the axis along which depth is counted (glsl/lib/view.glsl). */
void view_axis(const struct view *view, float axis[3]);

/* Numbers of lights and maps for which maps and programs are made. Lights that move or change keep
 * their layout unless one gets a size. */
struct light_layout {
    int lights;
    int groups; /* groups of samples of one light (lights/light_samples.h) */
    int views[LIGHT_MAP_KINDS];
    int maps;   /* maps that lights own: one each, six of a point light */
    bool sized; /* a light has a size */
    bool sky;   /* some lights are a sky's */
    bool many;  /* one light is all sampled lights (passes/sampled_lights.h) */
    /* For light samples only: most of their light falls on places that no visible surface faces
     * (renderer/light_search.h). */
    bool unseen;
};

/* Count any number of lights; return whether a layout is within the limits. */
void light_layout_count(struct light_layout *layout, const struct emitters *emitters);
bool light_layout_fits(const struct light_layout *layout);

/* Counts the lights of the emitters. Error: too many lights or views. */
bool light_layout_of(struct light_layout *layout, const struct emitters *emitters);

bool light_layouts_same(const struct light_layout *a, const struct light_layout *b);

/* Returns the texels per side of a map of that kind; a single view's map has `size`. Each of six
 * views of the sphere has half of that, for the same density. */
int light_map_size(int kind, int size);

/* Returns the texels per side for maps of `views` views: `size`, or less above full_views, so that
 * the memory does not grow further. */
int light_map_share(int size, int views, int full_views);

/* Makes the orthographic view along a directional light over the scene's bounds. */
void view_of_directional(struct view *view, const struct emitter *light,
                         const struct geometry *geometry);

/* Makes the views of all lights. Spot: one perspective view. Point light, and spot wider than 2 x
 * 60 degrees: six along the world's axes. Directional light: one orthographic view over the scene's
 * bounds. */
void views_of_emitters(struct light_block *block, const struct emitters *emitters,
                       const struct geometry *geometry);

#endif
