/* The light as a thing in the picture that can be moved and turned with the mouse. */
#ifndef VIEWER_LIGHT_TOOL_H
#define VIEWER_LIGHT_TOOL_H

#include "scene/camera.h"
#include "scene/mesh/geometry.h"
#include "scene/emitter.h"
#include "inspect/screen.h"
#include "viewer/window/window.h"

enum light_handle { HANDLE_NONE, HANDLE_POSITION, HANDLE_DIRECTION };

struct light_tool {
    bool shown;
    enum light_handle held;
};

/* What the tool works in. */
struct light_stage {
    const struct camera *camera;
    const struct geometry *geometry;
    const struct rectangle *picture;
};

/* Grabs a handle that the mouse is pressed on and drags it. True while it holds one: the mouse is
 * then its own. *moved tells whether the light has changed. */
bool light_tool_update(struct light_tool *tool, const struct light_stage *stage,
                       const struct input *input, struct emitter *light, bool *moved);

void light_tool_draw(const struct light_tool *tool, const struct light_stage *stage,
                     const struct emitter *light);

#endif
