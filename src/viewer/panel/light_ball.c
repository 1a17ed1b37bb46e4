#include "viewer/panel/light_ball.h"

#include "metrics/colour.h"
#include "viewer/window/ui.h"

#include <math.h>

enum { CELLS = 48 }; /* across a half of the ball */

static uint32_t color_of(const struct voxel_light *light, const float direction[3],
                         float exposure) {
    float rgb[3];
    int color[3];
    voxel_light_radiance(light, direction, rgb);
    for (int c = 0; c < 3; c++)
        color[c] = (int)lrintf(255 * srgb_encode(exposure * rgb[c]));
    return UI_RGBA(color[0], color[1], color[2], 255);
}

/* A half of the ball, as it would be seen from its side: that towards the camera, side = -1, or away from it, 1. */
static void draw_half(const struct viewer *viewer, float x, float y, float radius, float side) {
    const struct camera *camera = &viewer->placed.orbit.camera;
    float exposure = exp2f(renderer_exposure(&viewer->shown.renderer));
    float cell = 2 * radius / CELLS;
    for (int i = 0; i < CELLS * CELLS; i++) {
        float across = (2 * (float)(i % CELLS) + 1) / CELLS - 1;
        float up = 1 - (2 * (float)(i / CELLS) + 1) / CELLS, out = 1 - across * across - up * up;
        float direction[3];
        if (out < 0)
            continue;
        for (int c = 0; c < 3; c++)
            direction[c] = -side * across * camera->right[c] + up * camera->up[c] +
                           side * sqrtf(out) * camera->forward[c];
        ui_draw_rectangle(x + (across - 1 / (float)CELLS) * radius,
                          y - (up + 1 / (float)CELLS) * radius, cell, cell,
                          color_of(&viewer->shown.voxel_light, direction, exposure));
    }
}

void light_ball_draw(const struct viewer *viewer) {
    const struct voxel_light *light = &viewer->shown.voxel_light;
    float line = ui_line_height();
    struct ui_canvas canvas;
    if (light->order == 0)
        return;
    ui_space();
    ui_fact("light at the voxel before it",
            "radiance by direction, as the volume keeps it: the half of a ball that faces the "
            "camera, and the other half as it is seen from behind",
            "order %d", light->order);
    ui_numbers("middle, m", light->middle);
    ui_canvas_begin("light ball", 8 * line, &canvas);
    float radius = fminf(.23F * canvas.width, 3.2F * line), y = canvas.y + .3F * line + radius;
    for (int half = 0; half < 2; half++) {
        float x = canvas.x + (half ? .75F : .25F) * canvas.width;
        draw_half(viewer, x, y, radius, half ? 1 : -1);
        ui_draw_text(x, y + radius + .2F * line, .5F, UI_DIM,
                     half ? "from beyond" : "from the camera's side");
    }
    ui_canvas_end();
}
