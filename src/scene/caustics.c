#include "scene/caustics.h"

#include "base/log.h"
#include "scene/material.h"
#include "scene/medium.h"

static const char *const surface_names[] = {"off", "patches", "points", NULL};
static const char *const volume_names[] = {"off", "lines", "paper", NULL};

static const struct option table[] = {
    {"surface", 0, OPTION_CHOICE, offsetof(struct caustics_settings, surface), CAUSTICS_OFF,
     .label = "on surfaces", .choices = surface_names,
     .help = "caustics on surfaces: patches between light rays, or a spot of\n"
             "each; glass shows the scene; off: glass does not refract"},
    {"medium", 0, OPTION_CHOICE, offsetof(struct caustics_settings, volume), 0, .label = "in fog",
     .choices = volume_names,
     .help = "caustics in a medium: light rays of glass and mirrors as lines\n"
             "of the right width, or as published, of constant weight"},
    {"size", 0, OPTION_INT, offsetof(struct caustics_settings, size), 256, 8, 2048,
     .label = "rays a side",
     .help = "light rays per side of each light's view of glass and\n"
             "mirrors; raise for small objects or close views"},
    {"chains", 0, OPTION_INT, offsetof(struct caustics_settings, chains), 3, 1, 8,
     .label = "chains in glass",
     .help = "chains of a light ray and of a pixel at glass: reflected,\n"
             "straight through, reflected within once, twice, ..."},
    {"step", 0, OPTION_FLOAT, offsetof(struct caustics_settings, step), .2, 1e-4, 1e4,
     .label = "published step, m", .help = "caustics.medium=paper: steps of a pixel's ray, metres"},
    {"kernel", 0, OPTION_FLOAT, offsetof(struct caustics_settings, kernel), 1, .05, 2,
     .label = "published kernel",
     .help = "caustics.medium=paper: reach of the Gaussian that brings a line\n"
             "to the steps, in steps; below 1: noise"},
    {NULL},
};

const struct settings_part caustics_part = {"caustics", "caustics", table,
                                            sizeof(struct caustics_settings)};

bool caustics_shown(const struct scene *scene, const struct settings *settings) {
    const struct caustics_settings *own =
        settings_of(struct caustics_settings, settings, &caustics_part);
    const struct material_settings *material =
        settings_of(struct material_settings, settings, &material_part);
    struct medium medium = medium_of(scene, settings, 1);
    if (material->materials != MATERIALS_FULL)
        return false;
    if (own->surface == CAUSTICS_OFF && !(own->volume && medium_exists(&medium)))
        return false;
    for (int m = 0; m < scene->mesh_count; m++)
        for (int i = 0; i < scene->meshes[m].primitive_count; i++)
            if (material_smooth_kind(&scene->materials[scene->meshes[m].primitives[i].material]) !=
                SMOOTH_NONE)
                return true;
    return false;
}

void caustics_note_straight(const struct scene *scene) {
    bool has_solid = false;
    for (int i = 0; i < scene->material_count; i++)
        has_solid |= scene->materials[i].transmission > 0 && !scene->materials[i].thin_walled;
    if (has_solid)
        log_note("%s: shown without: refraction (caustics.surface=patches and reference --smooth "
                 "show it)",
                 scene->path);
}
