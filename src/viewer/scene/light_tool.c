#include "viewer/scene/light_tool.h"

#include "viewer/window/ui.h"

#include <cglm/cglm.h>

#include <math.h>
#include <string.h>

static const float arrow = .35F; /* length over the scene's radius */

/* How near the mouse must be to a handle; how far the handles of sizes are from the shape, so that
 * those of a light without a size can be reached. Pixels of a monitor of scale 1. */
enum { REACH = 11, GAP = 26 };

/* --- where the handles are -------------------------------------------------------------------- */

/* A directional light has no place, so its arrow ends in the scene's centre. */
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

/* A direction from the light's place in the picture: unit, and pixels that a metre takes there. */
struct ray {
    float from[2], along[2], pixels;
};

static bool project_ray(const struct light_stage *stage, const float position[3],
                        const float axis[3], struct ray *ray) {
    const float step = 1e-2F * stage->geometry->radius;
    float to[2];
    vec3 point;
    glm_vec3_copy((float *)position, point);
    glm_vec3_muladds((float *)axis, step, point);
    if (!project(stage, position, ray->from) || !project(stage, point, to))
        return false;
    glm_vec2_sub(to, ray->from, ray->along);
    float length = glm_vec2_norm(ray->along);
    ray->pixels = length / step;
    glm_vec2_scale(ray->along, 1 / length, ray->along);
    return length > 0;
}

/* Along which a size is measured. A sphere has the same in all directions, and what is seen from
 * the side has none that can be grabbed: the picture's own then. */
static bool size_ray(const struct light_stage *stage, const struct emitter *light,
                     enum light_handle handle, struct ray *ray) {
    bool up = handle == HANDLE_HEIGHT;
    const float *axis = up ? light->up : light->right;
    const float *own = up ? stage->camera->up : stage->camera->right;
    struct ray flat;
    if (!project_ray(stage, light->position, own, &flat))
        return false;
    bool sphere = light->type == EMITTER_POINT;
    if (sphere || !project_ray(stage, light->position, axis, ray) ||
        ray->pixels < .15F * flat.pixels)
        *ray = flat;
    return true;
}

static void cone_point(const struct light_stage *stage, const struct emitter *light,
                       float point[3]) {
    float length = arrow * stage->geometry->radius, outer = light->cos_outer;
    glm_vec3_copy((float *)light->position, point);
    glm_vec3_muladds((float *)light->direction, length * outer, point);
    glm_vec3_muladds((float *)light->right, length * sqrtf(fmaxf(0, 1 - outer * outer)), point);
}

/* Along right, or up: a sphere has one, as has what is round, until its other handle is used. */
static bool has_size(const struct emitter *light, int axis) {
    bool flat = light->type == EMITTER_SPOT || light->type == EMITTER_AREA;
    return axis == 0 ? flat || light->type == EMITTER_POINT : flat && light->size[0] > 0;
}

/* In pixels. False: the light has no such handle, or it is not in sight. */
static bool locate(const struct light_stage *stage, const struct emitter *light,
                   enum light_handle handle, float at[2]) {
    float position[3], tip[3], cone[3];
    struct ray ray;
    int axis = handle == HANDLE_HEIGHT;
    place_handles(stage, light, position, tip);
    switch (handle) {
    case HANDLE_POSITION:
        return project(stage, position, at);
    case HANDLE_DIRECTION:
        return light->type != EMITTER_POINT && project(stage, tip, at);
    case HANDLE_WIDTH:
    case HANDLE_HEIGHT:
        if (!has_size(light, axis) || !size_ray(stage, light, handle, &ray))
            return false;
        glm_vec2_copy(ray.from, at);
        glm_vec2_muladds(ray.along, ray.pixels * light->size[axis] / 2 + GAP * stage->scale, at);
        return true;
    case HANDLE_CONE:
        cone_point(stage, light, cone);
        return light->type == EMITTER_SPOT && project(stage, cone, at);
    case HANDLE_NONE:
    case HANDLE_COUNT:
        break;
    }
    return false;
}

/* --- dragging --------------------------------------------------------------------------------- */

static bool is_near(const struct light_stage *stage, double x, double y, const float at[2]) {
    return hypot(x - (double)at[0], y - (double)at[1]) < REACH * (double)stage->scale;
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

static bool drag_direction(const struct light_stage *stage, const struct input *input,
                           struct emitter *light) {
    float position[3], tip[3];
    vec3 direction;
    place_handles(stage, light, position, tip);
    drag_point(stage, input, tip);
    glm_vec3_sub(tip, position, direction);
    if (glm_vec3_norm(direction) < 1e-3F * stage->geometry->radius)
        return false;
    emitter_aim(light, direction);
    return true;
}

static bool drag_size(const struct light_stage *stage, const struct input *input,
                      enum light_handle handle, struct emitter *light) {
    struct ray ray;
    if (!size_ray(stage, light, handle, &ray))
        return false;
    float from[2] = {(float)input->x - ray.from[0], (float)input->y - ray.from[1]};
    float half = (glm_vec2_dot(from, ray.along) - GAP * stage->scale) / ray.pixels;
    light->size[handle == HANDLE_HEIGHT] = glm_clamp(2 * half, 0, stage->geometry->radius);
    return true;
}

/* The dark edge goes with the mouse, the bright one in proportion. */
static bool drag_cone(const struct light_stage *stage, const struct input *input,
                      struct emitter *light) {
    float point[3];
    vec3 to_point;
    cone_point(stage, light, point);
    drag_point(stage, input, point);
    glm_vec3_sub(point, light->position, to_point);
    float angle = glm_vec3_angle(to_point, light->direction);
    angle = glm_clamp(angle, glm_rad(1), GLM_PI_2f);
    float before = acosf(light->cos_outer), share = acosf(light->cos_inner) / fmaxf(before, 1e-3F);
    light->cos_outer = fmaxf(cosf(angle), 0);
    light->cos_inner = fmaxf(cosf(angle * share), light->cos_outer);
    return true;
}

static bool drag(const struct light_tool *tool, const struct light_stage *stage,
                 const struct input *input, struct emitter *light) {
    if (input->dx == 0 && input->dy == 0)
        return false;
    switch (tool->held) {
    case HANDLE_POSITION:
        if (light->type == EMITTER_DIRECTIONAL)
            return drag_direction(stage, input, light);
        drag_point(stage, input, light->position);
        return true;
    case HANDLE_DIRECTION:
        return drag_direction(stage, input, light);
    case HANDLE_WIDTH:
    case HANDLE_HEIGHT:
        return drag_size(stage, input, tool->held, light);
    case HANDLE_CONE:
        return drag_cone(stage, input, light);
    case HANDLE_NONE:
    case HANDLE_COUNT:
        break;
    }
    return false;
}

/* The smaller handles lie on the larger one. */
static enum light_handle handle_at(const struct light_stage *stage, double x, double y,
                                   const struct emitter *light) {
    float at[2];
    if (light->stands_in) /* for a surface, which its material lights */
        return HANDLE_NONE;
    for (enum light_handle handle = HANDLE_COUNT - 1; handle > HANDLE_NONE; handle--)
        if (locate(stage, light, handle, at) && is_near(stage, x, y, at))
            return handle;
    return HANDLE_NONE;
}

/* Another light whose mark is there; -1 = none. */
static int light_at(const struct light_stage *stage, double x, double y,
                    const struct emitters *lights) {
    float at[2];
    for (int i = 0; i < lights->count; i++)
        if (locate(stage, &lights->items[i], HANDLE_POSITION, at) && is_near(stage, x, y, at))
            return i;
    return -1;
}

bool light_tool_is_under(const struct light_tool *tool, const struct light_stage *stage,
                         const struct input *input, const struct emitters *lights, int chosen) {
    return tool->shown &&
           (tool->held != HANDLE_NONE ||
            handle_at(stage, input->x, input->y, &lights->items[chosen]) != HANDLE_NONE ||
            light_at(stage, input->x, input->y, lights) >= 0);
}

bool light_tool_update(struct light_tool *tool, const struct light_stage *stage,
                       const struct input *input, struct emitters *lights, int *chosen,
                       bool *moved) {
    *moved = false;
    if (!tool->shown || !input->held[BUTTON_LEFT])
        tool->held = HANDLE_NONE;
    if (!tool->shown)
        return false;
    if (input->pressed[BUTTON_LEFT] && tool->held == HANDLE_NONE) {
        double x = input->press_x, y = input->press_y;
        tool->held = handle_at(stage, x, y, &lights->items[*chosen]);
        int other = tool->held == HANDLE_NONE ? light_at(stage, x, y, lights) : -1;
        if (other >= 0) {
            *chosen = other;
            tool->held = HANDLE_POSITION;
        }
    }
    if (tool->held != HANDLE_NONE)
        *moved = drag(tool, stage, input, &lights->items[*chosen]);
    return tool->held != HANDLE_NONE;
}

/* --- drawing ---------------------------------------------------------------------------------- */

static const uint32_t bright = UI_RGBA(255, 214, 102, 255), dark = UI_RGBA(30, 24, 8, 255);

static void draw_line(const float from[2], const float to[2]) {
    ui_draw_line(from[0], from[1], to[0], to[1], dark, 4);
    ui_draw_line(from[0], from[1], to[0], to[1], bright, 1.6F);
}

static void draw_knob(const float at[2], float radius, bool held) {
    ui_draw_disc(at[0], at[1], radius + 1.5F, dark);
    ui_draw_disc(at[0], at[1], held ? radius + 1.5F : radius, bright);
}

/* A closed line of points about a middle, each by what it has of two vectors. */
static void draw_outline(const struct light_stage *stage, const float middle[3],
                         const float right[3], const float up[3], bool round) {
    enum { POINTS = 32 };
    const int step = round ? 1 : POINTS / 4;
    float before[2] = {0}, at[2];
    bool was = false;
    for (int i = 0; i <= POINTS; i += step) {
        float turn = 2 * GLM_PIf * ((float)i + (round ? 0 : .5F * (float)step)) / POINTS;
        float reach = round ? 1 : GLM_SQRT2f; /* of corners */
        vec3 point;
        glm_vec3_copy((float *)middle, point);
        glm_vec3_muladds((float *)right, reach * cosf(turn), point);
        glm_vec3_muladds((float *)up, reach * sinf(turn), point);
        bool is = project(stage, point, at);
        if (is && was)
            draw_line(before, at);
        glm_vec2_copy(at, before);
        was = is;
    }
}

static void draw_shape(const struct light_stage *stage, const struct emitter *light) {
    enum emitter_shape shape = emitter_shape(light);
    bool sphere = shape == EMITTER_IS_SPHERE, rectangle = shape == EMITTER_IS_RECTANGLE;
    vec3 right, up;
    if (shape == EMITTER_IS_POINT || shape == EMITTER_IS_CAP)
        return;
    glm_vec3_scale((float *)(sphere ? stage->camera->right : light->right), light->size[0] / 2,
                   right);
    glm_vec3_scale((float *)(sphere ? stage->camera->up : light->up), light->size[rectangle] / 2,
                   up);
    draw_outline(stage, light->position, right, up, !rectangle);
}

static void draw_cone(const struct light_stage *stage, const struct emitter *light) {
    float length = arrow * stage->geometry->radius, outer = light->cos_outer;
    float radius = length * sqrtf(fmaxf(0, 1 - outer * outer)), from[2], to[2], point[3];
    vec3 middle, right, up;
    glm_vec3_copy((float *)light->position, middle);
    glm_vec3_muladds((float *)light->direction, length * outer, middle);
    glm_vec3_scale((float *)light->right, radius, right);
    glm_vec3_scale((float *)light->up, radius, up);
    draw_outline(stage, middle, right, up, true);
    cone_point(stage, light, point);
    if (project(stage, light->position, from) && project(stage, point, to))
        draw_line(from, to);
}

static void draw_chosen(const struct light_tool *tool, const struct light_stage *stage,
                        const struct emitter *light) {
    float from[2], to[2];
    if (light->type == EMITTER_SPOT)
        draw_cone(stage, light);
    draw_shape(stage, light);
    if (!locate(stage, light, HANDLE_POSITION, from))
        return;
    if (locate(stage, light, HANDLE_DIRECTION, to))
        draw_line(from, to);
    for (enum light_handle handle = HANDLE_DIRECTION; handle < HANDLE_COUNT; handle++)
        if (locate(stage, light, handle, to))
            draw_knob(to, handle == HANDLE_DIRECTION ? 5 : 4, tool->held == handle);
    ui_draw_disc(from[0], from[1], 10, dark);
    ui_draw_disc(from[0], from[1], tool->held == HANDLE_POSITION ? 10 : 8, bright);
    ui_draw_ring(from[0], from[1], 13, bright, 1.5F);
}

void light_tool_draw(const struct light_tool *tool, const struct light_stage *stage,
                     const struct emitters *lights, int chosen) {
    const struct rectangle *picture = stage->picture;
    float at[2];
    if (!tool->shown)
        return;
    ui_draw_clip((float)picture->x, (float)picture->y, (float)picture->width,
                 (float)picture->height);
    for (int i = 0; i < lights->count; i++)
        if (i != chosen && locate(stage, &lights->items[i], HANDLE_POSITION, at)) {
            ui_draw_disc(at[0], at[1], 6, dark);
            ui_draw_ring(at[0], at[1], 6, bright, 1.5F);
        }
    draw_chosen(tool, stage, &lights->items[chosen]);
    ui_draw_unclip();
}
