#include "apps/subcommands.h"

#include "parts.h"

#include <string.h>

const struct subcommand subcommands[] = {
    {"average", "joins pictures of different passes", app_average},
    {"bench", "measures times, errors and memory", IF_LAB(app_bench, NULL)},
    {"compare", "measures the error between two pictures", app_compare},
    {"export", "writes a scene for other renderers: a pack, Mitsuba 3", IF_LAB(app_export, NULL)},
    {"info", "describes a scene, or the renderer of this machine", app_info},
    {"probe", "measures illuminance at points of a scene", app_probe},
    {"render", "renders pictures without a window", app_render},
    {"view", "shows a scene in a window", IF_VIEWER(app_view, NULL)},
    {"reference", "path-traces a scene on the CPU", app_reference},
    {NULL, NULL, NULL},
};

const struct subcommand *subcommand_find(const char *name) {
    for (const struct subcommand *s = subcommands; s->name; s++)
        if (strcmp(s->name, name) == 0)
            return s;
    return NULL;
}
