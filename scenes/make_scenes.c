/* make_scenes OUTDIR [NAME...]: writes the scenes named, or all, as OUTDIR/NAME.glb. The folders
 * are there: OUTDIR, and OUTDIR/failures where those are asked for. */
#include "scenes.h"

#include "base/error.h"
#include "base/memory.h"

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
    {"plant", make_plant},
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

static const struct scene_maker *find_maker(const char *name) {
    for (int i = 0; i < MAKER_COUNT; i++)
        if (strcmp(makers[i].name, name) == 0)
            return &makers[i];
    error_set("no scene is called '%s'", name);
    return NULL;
}

static bool write_scenes(const char *folder, char **names, int name_count) {
    for (int i = 0; i < name_count; i++) {
        const struct scene_maker *maker = find_maker(names[i]);
        if (!maker || !write_scene(maker, folder))
            return false;
    }
    for (int i = 0; i < MAKER_COUNT && name_count == 0; i++)
        if (!write_scene(&makers[i], folder))
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
