/* Shows the lights in the picture, to be moved, turned and sized with the mouse. */
#ifndef VIEWER_LIGHT_TOOL_H
#define VIEWER_LIGHT_TOOL_H

#include "inspect/screen.h"
#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"
#include "viewer/window/window.h"

/* Handles of the chosen light. A round light has a width only, a spot a cone. */
enum light_handle {
    HANDLE_NONE,
    HANDLE_POSITION,
    HANDLE_DIRECTION,
    HANDLE_WIDTH,
    HANDLE_HEIGHT,
    HANDLE_CONE,
    HANDLE_COUNT
};

struct light_tool {
    bool shown;
    enum light_handle held;
};

/* Camera, triangles and place of the picture that the tool works in. */
struct light_stage {
    const struct camera *camera;
    const struct geometry *geometry;
    const struct rectangle *picture;
    float scale; /* of the monitor */
};

/* Drags the handle under the pressed mouse, or chooses another light by its mark. Returns true
 * while it holds one, and the mouse has no other effect. *moved: the chosen light has changed. */
bool light_tool_update(struct light_tool *tool, const struct light_stage *stage,
                       const struct input *input, struct emitters *lights, int *chosen,
                       bool *moved);

/* Returns true if the mouse is on a handle, or holds one. */
bool light_tool_is_under(const struct light_tool *tool, const struct light_stage *stage,
                         const struct input *input, const struct emitters *lights, int chosen);

void light_tool_draw(const struct light_tool *tool, const struct light_stage *stage,
                     const struct emitters *lights, int chosen);

#endif
