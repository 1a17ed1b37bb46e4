/* The panel's section of lights: which there are, and all that one of them is. */
#include "viewer/panel/panel.h"

#include "scene/lights/environment.h"
#include "scene/node.h"
#include "viewer/scene/lights.h"
#include "viewer/scene/sky.h"

#include <cglm/cglm.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Of more lights than have a list the number alone chooses one. */
enum { NAME_SIZE = SCENE_NAME_SIZE + 16, NAMES_MAX = 64 };

/* Which of those that shine, by the numbers of --light and info. */
static void draw_choice(struct viewer *viewer) {
    const struct scene *scene = &viewer->document.scene;
    struct placed *placed = &viewer->placed;
    char texts[NAMES_MAX][NAME_SIZE];
    const char *names[NAMES_MAX];
    int all = placed->emitters.count, count = all <= NAMES_MAX ? all : 0, added = 0;
    for (int i = 0; i < count; i++) {
        const struct emitter *light = &placed->emitters.items[i];
        if (light->number < 0) {
            snprintf(texts[i], NAME_SIZE, "added %d", ++added);
        } else {
            const char *name = node_name_carrying(scene, NODE_LIGHT, light->number);
            snprintf(texts[i], NAME_SIZE, "%d  %s", light->number, *name ? name : "without a name");
        }
        names[i] = texts[i];
    }
    bool moved = viewer_light(viewer)->moved;
    struct ui_row row = {.name = "light",
                         .help = "of those that shine, the one that is shown here",
                         .differs = moved && viewer_light(viewer)->number >= 0};
    if ((count > 0 ? ui_choice(&row, &placed->chosen_light, names, count)
                   : ui_int(&row, &placed->chosen_light, 0, all - 1)) == UI_RESET)
        viewer_reset_light(viewer);
}

static void draw_type(struct viewer *viewer) {
    int type = viewer_light(viewer)->type;
    struct ui_row row = {.name = "type", .help = "its power stays"};
    if (ui_choice(&row, &type, emitter_type_names, 4))
        viewer_retype_light(viewer, (enum emitter_type)type);
}

static bool draw_place(struct viewer *viewer, struct emitter *light) {
    float direction[3];
    struct ui_row position_row = {.name = "position", .help = "metres"},
                  direction_row = {.name = "direction", .help = "where it shines"};
    memcpy(direction, light->direction, sizeof direction);
    bool changed =
        light->type != EMITTER_DIRECTIONAL &&
        ui_vector(&position_row, light->position, .005F * viewer->document.geometry.radius);
    if (light->type != EMITTER_POINT && ui_vector(&direction_row, direction, .01F) &&
        glm_vec3_norm2(direction) > 0) {
        emitter_aim(light, direction);
        changed = true;
    }
    return changed;
}

/* The brightest of the three is 1; the power stays. */
static bool draw_color(struct viewer *viewer, struct emitter *light) {
    float brightest = glm_vec3_max(light->intensity), color[3];
    double power = viewer_light_power(viewer, light);
    if (brightest <= 0)
        return false;
    glm_vec3_scale(light->intensity, 1 / brightest, color);
    if (!ui_color(&(struct ui_row){.name = "colour", .help = "linear; its power stays"}, color) ||
        glm_vec3_max(color) <= 0)
        return false;
    memcpy(light->intensity, color, sizeof color);
    viewer_set_light_power(viewer, light, power);
    return true;
}

static bool draw_power(struct viewer *viewer, struct emitter *light) {
    bool sun = light->type == EMITTER_DIRECTIONAL;
    double across = GLM_PI * pow((double)viewer->document.geometry.radius, 2);
    double unit = sun ? across : 1;
    float power = (float)(viewer_light_power(viewer, light) / unit);
    struct ui_row row = {.name = sun ? "W/m\xc2\xb2" : "power, W",
                         .help = sun ? "on what faces it, the mean of its colours"
                                     : "in all, the mean of its colours"};
    if (!ui_float(&row, &power, 0, 1e5F))
        return false;
    viewer_set_light_power(viewer, light, (double)power * unit);
    return true;
}

static bool draw_size(struct viewer *viewer, struct emitter *light) {
    float most = viewer->document.geometry.radius, angle = glm_deg(light->size[0]);
    struct ui_row across = {.name = "width, m", .help = "of the lamp, across; 0: a point"},
                  up = {.name = "length, m",
                        .help = "of a rectangle, its other side; 0: it is round"},
                  sun = {.name = "disc, \xc2\xb0",
                         .help = "how wide it is in the sky, degrees; the sun's is 0.53"};
    if (light->type == EMITTER_DIRECTIONAL) {
        bool changed = ui_float(&sun, &angle, 0, 60);
        if (changed)
            light->size[0] = glm_rad(angle);
        return changed;
    }
    bool changed = ui_float(&across, &light->size[0], 0, most);
    if (light->type != EMITTER_POINT && light->size[0] > 0)
        changed |= ui_float(&up, &light->size[1], 0, most) != UI_NOTHING;
    return changed;
}

/* A sun's light has no end. */
static bool draw_range(struct viewer *viewer, struct emitter *light) {
    struct ui_row row = {.name = "range, m",
                         .help = "where its light ends (glTF: range); 0: it has no end",
                         .least = "none"};
    return light->type != EMITTER_DIRECTIONAL &&
           ui_float(&row, &light->range, 0, 10 * viewer->document.geometry.radius);
}

/* Half angles, of which the first stays the smaller one. */
static bool draw_cone(struct emitter *light) {
    float inner = glm_deg(acosf(light->cos_inner)), outer = glm_deg(acosf(light->cos_outer));
    struct ui_row bright = {.name = "inner angle, \xc2\xb0",
                            .help = "half angle of the cone up to which it is as bright as on its "
                                    "axis",
                            .even = true},
                  dark = {.name = "outer angle, \xc2\xb0",
                          .help = "half angle from which on there is no light",
                          .even = true};
    if (ui_float(&bright, &inner, 0, 89)) {
        light->cos_inner = cosf(glm_rad(inner));
        light->cos_outer = fminf(light->cos_outer, light->cos_inner);
        return true;
    }
    if (ui_float(&dark, &outer, 1, 90)) {
        light->cos_outer = fmaxf(cosf(glm_rad(outer)), 0);
        light->cos_inner = fmaxf(light->cos_outer, light->cos_inner);
        return true;
    }
    return false;
}

static void draw_additions(struct viewer *viewer) {
    static const char *const names[] = {"+ spot", "+ point", "+ sun", "+ area"};
    for (int type = EMITTER_SPOT; type <= EMITTER_AREA; type++) {
        if (type > EMITTER_SPOT)
            ui_same_line();
        if (ui_button(names[type], "a new light before the camera, as strong as the chosen one"))
            viewer_add_light(viewer, (enum emitter_type)type);
    }
}

static void draw_light(struct viewer *viewer) {
    draw_choice(viewer);
    struct emitter *light = viewer_light(viewer);
    if (light->stands_in) {
        ui_text(UI_DIM, "part of a surface that emits");
        return;
    }
    draw_type(viewer);
    ui_flag(&(struct ui_row){.name = "handles",
                             .help =
                                 "move, turn and size it in the picture (L); a click on another "
                                 "light's mark chooses that"},
            &viewer->hand.light_tool.shown);
    bool changed = draw_place(viewer, light);
    changed |= draw_color(viewer, light);
    changed |= draw_power(viewer, light);
    changed |= draw_size(viewer, light);
    changed |= draw_range(viewer, light);
    if (light->type == EMITTER_SPOT)
        changed |= draw_cone(light);
    if (changed)
        viewer_touch_light(viewer);
    if (emitter_has_slide(light) && light->slide->is_profile)
        panel_draw_profile(light);
}

/* --- the sky --- */

static void draw_sky_file(struct viewer *viewer) {
    char *path = viewer->panel.sky_path;
    struct ui_row row = {.name = "sky",
                         .help = "a panorama, .hdr or .exr, twice as wide as high; it may also be "
                                 "dropped on the window"};
    if (!ui_text_field(&row, path, sizeof viewer->panel.sky_path, "path, Enter"))
        return;
    if (*path)
        viewer_open_sky(viewer, path);
    else if (viewer_can_remove_sky(viewer))
        viewer_remove_sky(viewer);
    else
        viewer_tell_sky(viewer);
}

static void draw_sky(struct viewer *viewer) {
    draw_sky_file(viewer); /* may free the environment */
    struct environment *sky = viewer->document.scene.environment;
    if (!sky)
        return;
    bool needed = !viewer_can_do_without_sky(viewer), shines = viewer_sky_shines(viewer);
    struct ui_row turn = {.name = "turn, \xc2\xb0",
                          .help = "about the vertical, from +Z towards +X",
                          .differs = sky->turn != 0},
                  strength = {.name = "strength",
                              .help = "a factor of its radiance",
                              .differs = sky->strength != 1};
    enum ui_result turned = ui_float(&turn, &sky->turn, -180, 180);
    if (turned == UI_RESET)
        sky->turn = 0;
    enum ui_result changed = ui_float(&strength, &sky->strength, .01F, 100);
    if (changed == UI_RESET)
        sky->strength = 1;
    if (turned || changed)
        viewer_touch_sky(viewer);
    ui_disabled_begin(needed);
    if (ui_flag(&(struct ui_row){.name = "sky shines", .help = "off: the ground is black, too"},
                &shines))
        viewer_let_sky_shine(viewer, shines);
    ui_disabled_end();
    ui_disabled_begin(!viewer_can_remove_sky(viewer));
    if (ui_wide_button("Remove the sky", "where the scene has a light"))
        viewer_remove_sky(viewer);
    ui_disabled_end();
}

void panel_draw_light(struct viewer *viewer) {
    draw_sky(viewer);
    ui_space();
    if (viewer_has_light(viewer))
        draw_light(viewer);
    ui_space();
    draw_additions(viewer);
    if (!viewer_has_light(viewer))
        return;
    ui_disabled_begin(!viewer_can_remove_light(viewer));
    if (ui_wide_button("Remove this light", "another must shine"))
        viewer_remove_light(viewer);
    ui_disabled_end();
}
