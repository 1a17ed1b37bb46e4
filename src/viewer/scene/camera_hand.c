#include "viewer/scene/camera_hand.h"

#include "viewer/picture/look.h"

#include <cglm/cglm.h>

#include <math.h>
#include <string.h>

/* Of flying, scene radii a second: at first, least and most. */
static const float usual_speed = .25F, least_speed = 1e-3F, most_speed = 10;

/* After so many seconds a turn of the wheel seeks anew what is under the mouse. */
static const double grab_lasts = .7;

void camera_hand_touch(struct viewer *viewer) {
    viewer->placed.camera_moved = true;
    viewer_touch(viewer);
}

float camera_hand_speed(const struct viewer *viewer) {
    float speed = viewer->hand.fly_speed > 0 ? viewer->hand.fly_speed : usual_speed;
    return speed * viewer->document.geometry.radius;
}

static void change_speed(struct viewer *viewer, float factor) {
    float speed = viewer->hand.fly_speed > 0 ? viewer->hand.fly_speed : usual_speed;
    viewer->hand.fly_speed = glm_clamp(speed * factor, least_speed, most_speed);
    messages_add(&viewer->host.messages, UI_NORMAL, "flying at %.3g m/s",
                 (double)camera_hand_speed(viewer));
}

static bool is_flying(const struct input *input) {
    static const char keys[] = "WASDQE";
    bool held = input->held[BUTTON_RIGHT];
    for (const char *key = keys; *key; key++)
        held |= input->key_held[(int)*key];
    return held;
}

void camera_hand_fly(struct viewer *viewer, double seconds) {
    const struct input *input = viewer->host.input;
    float pace = input->shift ? 4.F : input->control ? .2F : 1;
    float step =
        pace * camera_hand_speed(viewer) / viewer->document.geometry.radius * (float)seconds;
    float right = (float)(input->key_held['D'] - input->key_held['A']);
    float up = (float)(input->key_held['E'] - input->key_held['Q']);
    float forward = (float)(input->key_held['W'] - input->key_held['S']);
    if (right == 0 && up == 0 && forward == 0)
        return;
    orbit_fly(&viewer->placed.orbit, right * step, up * step, forward * step);
    camera_hand_touch(viewer);
}

/* --- what is under the mouse --- */

/* False: nothing, or no picture of the scene is shown. */
static bool point_under(struct viewer *viewer, float point[3]) {
    float x, y;
    return !viewer->shown.choice.output && viewer->shown.frame_count > 0 &&
           look_at_mouse(viewer, &x, &y) && probe_point(&viewer->shown.renderer, x, y, point);
}

/* Where there is nothing, as far away as what was circled last. */
static void grab(struct viewer *viewer) {
    const struct rectangle *picture = &viewer->shown.picture;
    struct orbit *orbit = &viewer->placed.orbit;
    vec3 point, origin, direction;
    float x, y;
    if (!point_under(viewer, point)) {
        look_at_mouse(viewer, &x, &y);
        camera_ray(&orbit->camera, x, y, (float)picture->width / (float)picture->height, origin,
                   direction);
        float along = glm_vec3_dot(direction, orbit->camera.forward);
        glm_vec3_copy(origin, point);
        glm_vec3_muladds(direction, orbit->distance / along, point);
    }
    orbit_grab(orbit, point);
}

/* --- the mouse --- */

static bool is_pan(const struct input *input) {
    return input->held[BUTTON_MIDDLE] || (input->held[BUTTON_LEFT] && input->shift);
}

void camera_hand_drag(struct viewer *viewer) {
    const struct input *input = viewer->host.input;
    struct orbit *orbit = &viewer->placed.orbit;
    float height = (float)viewer->shown.picture.height;
    float right = (float)input->dx / height, down = (float)input->dy / height;
    if (input->pressed[BUTTON_LEFT] || input->pressed[BUTTON_MIDDLE])
        grab(viewer);
    if (right == 0 && down == 0)
        return;
    if (is_pan(input))
        orbit_pan(orbit, right, down);
    else if (input->held[BUTTON_LEFT])
        orbit_turn(orbit, right, down);
    else if (input->held[BUTTON_RIGHT])
        orbit_look(orbit, right, down);
    else
        return;
    camera_hand_touch(viewer);
}

/* A lens: what is circled keeps its place, and gets larger or smaller. */
static void change_field(struct viewer *viewer, float steps) {
    struct camera *camera = &viewer->placed.orbit.camera;
    float height = tanf(camera->fov_y / 2) * powf(.95F, steps);
    if (!camera->orthographic)
        camera->fov_y =
            glm_clamp(2 * atanf(height), glm_rad(CAMERA_FIELD_LEAST), glm_rad(CAMERA_FIELD_MOST));
    camera_hand_touch(viewer);
}

void camera_hand_scroll(struct viewer *viewer) {
    const struct input *input = viewer->host.input;
    struct hand *hand = &viewer->hand;
    double now = window_time();
    if (input->shift) {
        change_field(viewer, (float)input->scroll);
        return;
    }
    if (is_flying(input)) {
        change_speed(viewer, powf(1.25F, (float)input->scroll));
        return;
    }
    if (now - hand->last_grab > grab_lasts ||
        hypot(input->x - hand->grab_x, input->y - hand->grab_y) > 2)
        grab(viewer);
    hand->last_grab = now;
    hand->grab_x = input->x;
    hand->grab_y = input->y;
    orbit_zoom(&viewer->placed.orbit, (float)input->scroll);
    camera_hand_touch(viewer);
}

/* --- framing --- */

/* The smallest thing whose box the point is in; NULL = none. */
static const struct geometry_part *part_at(const struct geometry *geometry, const float point[3]) {
    const struct geometry_part *found = NULL;
    float reach = 1e-3F * geometry->radius, smallest = INFINITY;
    for (int i = 0; i < geometry->part_count; i++) {
        const struct geometry_part *part = &geometry->parts[i];
        bool inside = true;
        for (int axis = 0; axis < 3; axis++)
            inside &= point[axis] > part->bounds_min[axis] - reach &&
                      point[axis] < part->bounds_max[axis] + reach;
        float size = glm_vec3_distance2((float *)part->bounds_min, (float *)part->bounds_max);
        if (inside && size < smallest) {
            smallest = size;
            found = part;
        }
    }
    return found;
}

void camera_hand_frame(struct viewer *viewer) {
    const struct geometry *geometry = &viewer->document.geometry;
    const struct rectangle *picture = &viewer->shown.picture;
    float point[3], radius = geometry->radius;
    vec3 center;
    if (!viewer->has_scene || picture->width == 0)
        return;
    const struct geometry_part *part = point_under(viewer, point) ? part_at(geometry, point) : NULL;
    glm_vec3_copy((float *)geometry->center, center);
    if (part) {
        glm_vec3_center((float *)part->bounds_min, (float *)part->bounds_max, center);
        radius = glm_vec3_distance((float *)part->bounds_min, (float *)part->bounds_max) / 2;
    }
    orbit_frame(&viewer->placed.orbit, center, fmaxf(radius, 1e-3F * geometry->radius),
                (float)picture->width / (float)picture->height);
    camera_hand_touch(viewer);
}
