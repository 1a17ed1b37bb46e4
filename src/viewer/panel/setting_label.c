#include "viewer/panel/setting_label.h"

#include <stdio.h>
#include <string.h>

static const struct row {
    const char *setting, *label;
} rows[] = {
    {"lights.vpls", "virtual lights"},
    {"lights.seed", "random seed"},
    {"lights.rsm-size", "light map texels"},
    {"lights.bounces", "light bounces"},
    {"lights.paths", "paths of bounces"},
    {"lights.facets", "flat triangles"},
    {"lights.importance", "VPL placement"},
    {"clustered.vals", "shadow groups"},
    {"clustered.bounce-vals", "groups of bounces"},
    {"clustered.iterations", "grouping steps"},
    {"clustered.start", "grouping begins"},
    {"clustered.weight-position", "weight of place"},
    {"clustered.weight-normal", "weight of normal"},
    {"clustered.visibility", "shadow lookup"},
    {"clustered.ray-tests", "test rays a group"},
    {"clustered.visibility-block", "shadow block"},
    {"map.size", "map texels"},
    {"lookup.terms", "Fourier terms"},
    {"caster.error", "simplification"},
    {"caster.long", "bent triangles"},
    {"gather.interleave", "pixel pattern"},
    {"gather.clamp", "near lights"},
    {"gather.near-samples", "near samples"},
    {"gather.specular", "specular light"},
    {"gather.adaptive", "adaptive pattern"},
    {"gather.adaptive-factor", "adaptive factor"},
    {"gather.edge-samples", "edge samples"},
    {"blur.radius", "blur radius"},
    {"blur.separable", "in two steps"},
    {"blur.distance", "distance limit"},
    {"blur.cosine", "normal limit"},
    {"direct.shadow-size", "shadow texels"},
    {"pcss.light-taps", "shadow samples"},
    {"pcss.shadow-rays", "shadow rays"},
    {"samples.points", "light samples"},
    {"prefilter.texels", "map texels"},
    {"cssm.harmonics", "Fourier terms"},
    {"cssm.prefilter", "filter"},
    {"sky.lights", "area lights"},
    {"sky.fit", "fit"},
    {"sky.directions", "directions"},
    {"sky.shadow-rays", "shadow rays"},
    {"surface.materials", "materials"},
    {"medium.scatter", "fog that scatters"},
    {"medium.absorb", "fog that absorbs"},
    {"medium.g", "forward"},
    {"medium.scene", "fog of the file"},
    {"medium.steps", "steps"},
    {"caustics.surface", "on surfaces"},
    {"caustics.medium", "in fog"},
    {"caustics.size", "rays a side"},
    {"caustics.chains", "chains in glass"},
    {"caustics.step", "published step, m"},
    {"caustics.kernel", "published kernel"},
    {"picture.exposure", "exposure, EV"},
    {"picture.samples", "edge samples"},
    {"picture.tone-map", "tone map"},
    {"imperfect-shadow-maps.size", "map texels"},
    {"imperfect-shadow-maps.map-points", "points a map"},
    {"imperfect-shadow-maps.shape", "point shape"},
    {"volume.volume", "kind of light"},
    {"volume.size", "voxels a side"},
    {"volume.order", "harmonics order"},
    {"volume.rays", "rays a voxel"},
    {"volume.voxel-points", "points a voxel"},
    {"volume.ao-distance", "AO distance, m"},
    {"volume.reprojection", "camera's points"},
    {"volume.published", "as published"},
    {"radiosity.elements", "elements"},
    {"radiosity.bins", "bins a side"},
    {"radiosity.links", "links made by"},
    {"radiosity.cover", "bins filled"},
    {"radiosity.weight", "weight"},
    {"radiosity.sky", "environment"},
    {"radiosity.lamps", "lamps"},
    {"radiosity.specular", "specular by bins"},
    {"radiosity.turned", "turned bins"},
    {"instant-radiosity.traced", "traced shadows"},
    {"cluster-lights.area-lights", "area lights"},
    {"cluster-lights.form", "shape"},
    {"cluster-lights.shadows", "shadows"},
    {"cluster-lights.seeds", "first groups"},
    {"cluster-lights.near", "near samples"},
    {"lightcuts.nodes", "nodes of a cut"},
    {"lightcuts.tolerance", "tolerance"},
    {"row-column.rows", "rows (pixels)"},
    {"row-column.columns", "columns (lights)"},
};

bool setting_label(const struct setting *setting, char label[SETTING_LABEL_SIZE]) {
    char name[SETTING_NAME_SIZE];
    setting_name(setting, name);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (strcmp(rows[i].setting, name) == 0)
            return snprintf(label, SETTING_LABEL_SIZE, "%s", rows[i].label) > 0;
    snprintf(label, SETTING_LABEL_SIZE, "%s", setting->option->name);
    for (char *dash = label; (dash = strchr(dash, '-'));)
        *dash = ' ';
    return false;
}
