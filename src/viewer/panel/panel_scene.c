/* The panel's section of the scene: its file, camera, clips, and what it holds. */
#include "viewer/panel/panel.h"

#include "metrics/colour.h"
#include "scene/animation.h"
#include "scene/clips.h"
#include "scene/node.h"
#include "viewer/files/opening.h"
#include "viewer/scene/placed.h"

#include <math.h>
#include <stdio.h>

enum { NAMES_MAX = 64 };

/* A choice among nodes of the scene, by name. */
static bool draw_node_choice(const struct ui_row *row, const struct scene *scene,
                             enum node_kind kind, int *chosen) {
    const char *names[NAMES_MAX];
    int count = node_count_carrying(scene, kind);
    count = count < NAMES_MAX ? count : NAMES_MAX;
    for (int i = 0; i < count; i++) {
        const char *name = node_name_carrying(scene, kind, i);
        names[i] = *name ? name : "without a name";
    }
    enum ui_result result = ui_choice(row, chosen, names, count);
    if (result == UI_RESET)
        *chosen = *chosen < count ? *chosen : 0;
    return result != UI_NOTHING;
}

/* Which of the rows below is chosen; after the last where several clips were chosen. */
static int chosen_row(const struct scene *scene, int together) {
    if (scene->plays_default && together)
        return 0;
    return scene->playing_count == 1 ? together + scene->playing[0] : together + scene->clip_count;
}

/* Clips are few, and have names. First come all that go together, where there are several. */
static void draw_clip(struct viewer *viewer) {
    const struct scene *scene = &viewer->document.scene;
    const char *names[NAMES_MAX];
    char text[CLIPS_TEXT_SIZE] = "";
    int together = clips_default_count(scene) > 1, count = together;
    names[0] = "all together";
    for (int i = 0; i < scene->clip_count && count < NAMES_MAX - 1; i++)
        names[count++] = *scene->clips[i].name ? scene->clips[i].name : "without a name";
    int before = chosen_row(scene, together), row_number = before;
    if (before >= count)
        names[before = row_number = count++] = "several";
    struct ui_row row = {.name = "clip", .help = "animation of the scene"};
    if (scene->clip_count == 0 || !ui_choice(&row, &row_number, names, count) ||
        row_number == before)
        return;
    if (row_number >= together)
        snprintf(text, sizeof text, "%d", row_number - together);
    viewer_pick_clips(viewer, text);
}

static void draw_animation(struct viewer *viewer) {
    struct playing *play = &viewer->wish.play;
    double duration = scene_duration(&viewer->document.scene);
    draw_clip(viewer);
    if (duration <= 0)
        return;
    struct ui_row speed_row = {.name = "speed",
                               .help = "seconds of the animation a second",
                               .differs = play->speed != 1},
                  loop_row = {.name = "loop", .help = "begin again at the end"};
    if (ui_float(&speed_row, &play->speed, .05F, 4) == UI_RESET)
        play->speed = 1;
    ui_flag(&loop_row, &play->loops);
}

/* --- what it holds --- */

static void draw_counts(const struct scene *scene, const struct geometry *geometry) {
    double texels = 0;
    for (int i = 0; i < scene->texture_count; i++)
        texels += (double)scene->textures[i].bitmap.width * scene->textures[i].bitmap.height;
    ui_value("faces", "%u", geometry_triangle_count(geometry));
    ui_value("nodes, meshes", "%d, %d", scene->node_count, scene->mesh_count);
    ui_value("lights, cameras, clips", "%d, %d, %d", scene->light_count, scene->camera_count,
             scene->clip_count);
    ui_value("textures", "%d, %.1f million texels", scene->texture_count, 1e-6 * texels);
    ui_value("across", "%.3g m", 2 * (double)geometry->radius);
}

/* As a monitor has it. */
static uint32_t color_of(const struct material *material) {
    int rgb[3];
    for (int c = 0; c < 3; c++)
        rgb[c] = (int)lrintf(255 * srgb_encode(material->base_color[c]));
    return UI_RGBA(rgb[0], rgb[1], rgb[2], 255);
}

static void draw_materials(const struct scene *scene, const struct geometry *geometry) {
    int count = scene->material_count < NAMES_MAX ? scene->material_count : NAMES_MAX;
    uint32_t faces[NAMES_MAX] = {0}, all = geometry_triangle_count(geometry);
    for (int i = 0; i < geometry->batch_count; i++)
        if (geometry->batches[i].material < count)
            faces[geometry->batches[i].material] += geometry->batches[i].index_count / 3;
    ui_heading("materials, and their faces");
    for (int i = 0; i < count; i++) {
        const struct material *material = &scene->materials[i];
        char text[16];
        if (faces[i] == 0)
            continue;
        snprintf(text, sizeof text, "%u", faces[i]);
        ui_list_item(color_of(material), *material->name ? material->name : "without a name",
                     material->base_color_texture >= 0 ? "textured" : "", text,
                     all ? (float)faces[i] / (float)all : 0, false);
    }
    if (count < scene->material_count)
        ui_text(UI_DIM, "and %d more", scene->material_count - count);
}

void panel_draw_scene(struct viewer *viewer) {
    struct ui_row open = {.name = "open",
                          .help = "a .gltf or .glb file, a sky, a reference or settings; one may "
                                  "also be dropped on the window"};
    if (ui_text_field(&open, viewer->panel.scene_path, sizeof viewer->panel.scene_path,
                      "path, Enter"))
        viewer_take_file(viewer, viewer->panel.scene_path);
    if (!viewer->has_scene)
        return;
    const struct scene *scene = &viewer->document.scene;
    int camera = viewer->placed.camera_number;
    struct ui_row row = {.name = "camera",
                         .help = "of the scene; R goes back to it",
                         .differs = viewer->placed.camera_moved};
    if (draw_node_choice(&row, scene, NODE_CAMERA, &camera))
        viewer_pick_camera(viewer, camera);
    draw_animation(viewer);
    if (!ui_section("What it holds", false))
        return;
    draw_counts(scene, &viewer->document.geometry);
    draw_materials(scene, &viewer->document.geometry);
}
