#include "base/old_names.h"

#include "base/error.h"
#include "base/log.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

static struct old_name {
    const char *old, *now;
    bool told;
} names[] = {
    {"gather.detail", "gather.adaptive", false},
    {"gather.detail-times", "gather.adaptive-factor", false},
    {"gather.further-points", "gather.edge-samples", false},
    {"gather.gloss", "gather.specular", false},
    {"pcss.ways", "pcss.shadow-rays", false},
    {"sky.sky-ways", "sky.shadow-rays", false},
    {"start.directions", "sky.directions", false},
    {"cluster-lights.steps", "clustered.iterations", false},
    {"cluster-lights.begin", "clustered.start", false},
    {"row-column.choice", "lights.seed", false},
};

static const char *const removed[] = {
    "map.near-clip",
    "lookup.bias",
    "lookup.map-bias",
    "lookup.shift",
    "lookup.gain",
    "lookup.sharpen-a",
    "lookup.taps",
    "lookup.filter-jacobian",
    "gather.clamp-value",
    "gather.sphere",
    "gather.near-reach",
    "gather.gloss-interleave",
    "gather.detail-share",
    "direct.shadow-bias",
    "pcss.search-taps",
    "pcss.spread",
    "window.search-parts",
    "window.shadow-parts",
    "prefilter.contact",
    "sky.map-size",
    "sky.sky-size",
    "sky.sun-maps",
    "sky.sky-block",
    "sky.sky-bias",
    "sky.disagree",
    "start.places",
    "start.wide",
    "clustered.importance",
    "cluster-lights.weight-distance",
    "cluster-lights.weight-facing",
    "cluster-lights.weight-hue",
    "cluster-lights.pattern",
    "imperfect-shadow-maps.sets",
    "imperfect-shadow-maps.scale",
    "imperfect-shadow-maps.set-back",
    "instant-radiosity.map-batch",
    "row-column.column-interleave",
};

/* By the full name, with a dot or a dash in its middle, or by the last word. */
static bool is_called(const char *full, const char *name) {
    size_t owner = strcspn(full, ".");
    if (strlen(name) == strlen(full))
        return strncmp(name, full, owner) == 0 && strchr(".-", name[owner]) &&
               strcmp(name + owner + 1, full + owner + 1) == 0;
    return strcmp(name, full + owner + 1) == 0;
}

const char *old_name_follow(const char *name) {
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (is_called(names[i].old, name)) {
            if (!names[i].told)
                log_note("the setting %s is called %s", names[i].old, names[i].now);
            names[i].told = true;
            return names[i].now;
        }
    for (size_t i = 0; i < sizeof removed / sizeof *removed; i++)
        if (is_called(removed[i], name)) {
            error_set("the setting %s was removed: it is constant", removed[i]);
            return NULL;
        }
    error_set("no setting is called '%s' (--help-all lists them)", name);
    return NULL;
}
