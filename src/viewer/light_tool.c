#include "viewer/light_tool.h"

#include "viewer/window/ui.h"

#include <cglm/cglm.h>

#include <math.h>
#include <string.h>

static const float arrow = .35F; /* length over the scene's radius */

/* Where the handles are: a directional light has no place, so its arrow ends in the scene's centre.
 */
static void place_handles(const struct light_stage *stage, const struct emitter *light,
                          float position[3], float tip[3]) {
    const struct geometry *geometry = stage->geometry;
    float length = arrow * geometry->radius;
    if (light->type == EMITTER_DIRECTIONAL) {
        glm_vec3_copy((float *)geometry->center, position);
        glm_vec3_muladds((float *)light->direction, -length, position);
    } else {
        glm_vec3_copy((float *)light->position, position);
    }
    glm_vec3_copy(position, tip);
    glm_vec3_muladds((float *)light->direction, length, tip);
}

/* In pixels of the window. False: behind the camera. */
static bool project(const struct light_stage *stage, const float point[3], float at[2]) {
    const struct rectangle *picture = stage->picture;
    float place[2];
    if (!camera_project(stage->camera, point, (float)picture->width / (float)picture->height,
                        place))
        return false;
    at[0] = (float)picture->x + place[0] * (float)picture->width;
    at[1] = (float)picture->y + place[1] * (float)picture->height;
    return true;
}

static bool is_under(const struct light_stage *stage, const struct input *input,
                     const float point[3]) {
    float at[2];
    return project(stage, point, at) &&
           hypot(input->press_x - (double)at[0], input->press_y - (double)at[1]) <
               11 * (double)input->scale;
}

/* The point under the mouse at the same depth as another one. */
static void drag_point(const struct light_stage *stage, const struct input *input, float point[3]) {
    const struct rectangle *picture = stage->picture;
    const struct camera *camera = stage->camera;
    vec3 origin, direction, to_point;
    camera_ray(camera, (float)(input->x - picture->x) / (float)picture->width,
               (float)(input->y - picture->y) / (float)picture->height,
               (float)picture->width / (float)picture->height, origin, direction);
    glm_vec3_sub(point, origin, to_point);
    float depth = glm_vec3_dot(to_point, (float *)camera->forward);
    float along = glm_vec3_dot(direction, (float *)camera->forward);
    glm_vec3_copy(origin, point);
    glm_vec3_muladds(direction, depth / along, point);
}

static bool drag(const struct light_tool *tool, const struct light_stage *stage,
                 const struct input *input, struct emitter *light) {
    float position[3], tip[3];
    if (input->dx == 0 && input->dy == 0)
        return false;
    place_handles(stage, light, position, tip);
    if (tool->held == HANDLE_POSITION && light->type != EMITTER_DIRECTIONAL) {
        drag_point(stage, input, light->position);
        return true;
    }
    drag_point(stage, input, tip);
    vec3 direction;
    glm_vec3_sub(tip, position, direction);
    if (glm_vec3_norm(direction) < 1e-3F * stage->geometry->radius)
        return false;
    emitter_aim(light, direction);
    return true;
}

bool light_tool_update(struct light_tool *tool, const struct light_stage *stage,
                       const struct input *input, struct emitter *light, bool *moved) {
    float position[3], tip[3];
    *moved = false;
    if (!tool->shown || !input->held[BUTTON_LEFT])
        tool->held = HANDLE_NONE;
    if (!tool->shown)
        return false;
    place_handles(stage, light, position, tip);
    if (input->pressed[BUTTON_LEFT] && tool->held == HANDLE_NONE) {
        if (light->type != EMITTER_POINT && is_under(stage, input, tip))
            tool->held = HANDLE_DIRECTION;
        else if (is_under(stage, input, position))
            tool->held = HANDLE_POSITION;
    }
    if (tool->held != HANDLE_NONE)
        *moved = drag(tool, stage, input, light);
    return tool->held != HANDLE_NONE;
}

void light_tool_draw(const struct light_tool *tool, const struct light_stage *stage,
                     const struct emitter *light) {
    const uint32_t bright = UI_RGBA(255, 214, 102, 255), dark = UI_RGBA(30, 24, 8, 255);
    const struct rectangle *picture = stage->picture;
    float position[3], tip[3], from[2], to[2];
    if (!tool->shown)
        return;
    place_handles(stage, light, position, tip);
    if (!project(stage, position, from) || !project(stage, tip, to))
        return;
    ui_draw_clip((float)picture->x, (float)picture->y, (float)picture->width,
                 (float)picture->height);
    if (light->type != EMITTER_POINT) {
        ui_draw_line(from[0], from[1], to[0], to[1], dark, 4);
        ui_draw_line(from[0], from[1], to[0], to[1], bright, 2);
        ui_draw_disc(to[0], to[1], 6.5F, dark);
        ui_draw_disc(to[0], to[1], tool->held == HANDLE_DIRECTION ? 6.5F : 5, bright);
    }
    ui_draw_disc(from[0], from[1], 10, dark);
    ui_draw_disc(from[0], from[1], tool->held == HANDLE_POSITION ? 10 : 8, bright);
    ui_draw_ring(from[0], from[1], 13, bright, 1.5F);
    ui_draw_unclip();
}
