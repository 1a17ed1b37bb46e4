/* make_scenes OUTDIR [NAME...]: writes the scenes named, or all, as OUTDIR/NAME.glb, and the skies
 * as OUTDIR/NAME.hdr. The folders are there: OUTDIR, and OUTDIR/failures where those are
 * asked for. */
#include "scenes.h"
#include "skies/skies.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/memory.h"
#include "scene/lights/environment.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct scene_maker {
    const char *name;
    void (*make)(struct glb *glb);
} makers[] = {
    {"cornell-box", make_cornell_box},
    {"three-lights", make_three_lights},
    {"cornell-animal", make_cornell_animal},
    {"atrium", make_atrium},
    {"sphere", make_sphere},
    {"metaballs", make_metaballs},
    {"moving-spot", make_moving_spot},
    {"door", make_door},
    {"creatures", make_creatures},
    {"character", make_character},
    {"table", make_table},
    {"gloss", make_gloss},
    {"materials", make_materials},
    {"roughness", make_roughness},
    {"plant", make_plant},
    {"courtyard", make_courtyard},
    {"hall", make_hall},
    {"ring", make_ring},
    {"pawns", make_pawns},
    {"gem", make_gem},
    {"window", make_window},
    {"vase", make_vase},
    {"failures/room", make_room},
    {"failures/table-legs", make_table_legs},
    {"failures/contact", make_contact},
    {"failures/wide-light", make_wide_light},
    {"failures/grazing-receivers", make_grazing_receivers},
    {"failures/val-plane", make_val_plane},
    {"failures/center-inside", make_center_inside},
    {"failures/thin-wall", make_thin_wall},
    {"failures/closed-door", make_closed_door},
    {"failures/grazing-light", make_grazing_light},
    {"failures/empty-map", make_empty_map},
    {"failures/needle", make_needle},
    {"failures/corner", make_corner},
    {"failures/black", make_black},
    {"failures/white", make_white},
    {"failures/giant-triangle", make_giant_triangle},
    {"failures/plain", make_plain},
    {"failures/tiny-triangles", make_tiny_triangles},
    {"failures/millimetre", make_millimetre},
    {"failures/kilometre", make_kilometre},
    {"failures/far-away", make_far_away},
    {"failures/ball-lamp", make_ball_lamp},
};
enum { MAKER_COUNT = sizeof makers / sizeof makers[0] };

static const struct sky_maker {
    const char *name;
    sky_painter paint;
} sky_makers[] = {
    {"day", paint_day},
    {"overcast", paint_overcast},
};
enum { SKY_MAKER_COUNT = sizeof sky_makers / sizeof sky_makers[0] };

static bool write_sky(const struct sky_maker *maker, const char *folder) {
    struct environment sky = {.width = 256, .height = 128, .strength = 1};
    struct image image;
    image_init(&image, sky.width, sky.height, "R G B");
    for (int y = 0; y < sky.height; y++)
        for (int x = 0; x < sky.width; x++) {
            float direction[3];
            environment_direction(&sky, x + .5, y + .5, direction);
            maker->paint(direction, image_at(&image, x, y));
        }
    char *path = mem_printf("%s/%s.hdr", folder, maker->name);
    bool ok = image_write(&image, path);
    free(path);
    image_free(&image);
    return ok;
}

static bool write_scene(const struct scene_maker *maker, const char *folder) {
    struct glb glb;
    glb_init(&glb, maker->name);
    maker->make(&glb);
    char *path = mem_printf("%s/%s.glb", folder, maker->name);
    bool ok = glb_write(&glb, path);
    free(path);
    glb_free(&glb);
    return ok;
}

static bool write_named(const char *name, const char *folder) {
    for (int i = 0; i < MAKER_COUNT; i++)
        if (strcmp(makers[i].name, name) == 0)
            return write_scene(&makers[i], folder);
    for (int i = 0; i < SKY_MAKER_COUNT; i++)
        if (strcmp(sky_makers[i].name, name) == 0)
            return write_sky(&sky_makers[i], folder);
    return error_set("no scene is called '%s'", name);
}

static bool write_all(const char *folder) {
    for (int i = 0; i < MAKER_COUNT; i++)
        if (!write_scene(&makers[i], folder))
            return false;
    for (int i = 0; i < SKY_MAKER_COUNT; i++)
        if (!write_sky(&sky_makers[i], folder))
            return false;
    return true;
}

static bool write_scenes(const char *folder, char **names, int name_count) {
    if (name_count == 0)
        return write_all(folder);
    for (int i = 0; i < name_count; i++)
        if (!write_named(names[i], folder))
            return false;
    return true;
}

int main(int argc, char **argv) {
    if (argc < 2) {
        fprintf(stderr, "usage: make_scenes OUTDIR [NAME...]\n");
        return 2;
    }
    if (!write_scenes(argv[1], argv + 2, argc - 2)) {
        fprintf(stderr, "make_scenes: %s\n", error_get());
        return 1;
    }
    return 0;
}
