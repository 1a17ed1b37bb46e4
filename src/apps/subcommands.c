#include "apps/subcommands.h"

#include "apps/apps.h"

#include <stdio.h>
#include <string.h>

#ifdef MANYLIGHT_NO_VIEWER
static int refuse_view(int argc, char **argv) {
    (void)argc, (void)argv;
    fprintf(stderr, "manylight: view: this build has no viewer; render writes pictures\n");
    return 1;
}
#define VIEW refuse_view
#define MISSING refuse_view
#else
#define VIEW app_view
#define MISSING NULL
#endif

const struct subcommand subcommands[] = {
    {"average", "joins pictures of different passes", app_average},
    {"bench", "measures times, errors and memory", app_bench},
    {"compare", "measures the error between two pictures", app_compare},
    {"export", "writes a scene for other renderers: a pack, Mitsuba 3", app_export},
    {"info", "describes a scene, or the renderer of this machine", app_info},
    {"manual", "writes man pages, and completions for bash", app_manual},
    {"render", "renders pictures without a window", app_render},
    {"score", "scores a folder of pictures against references, and names their faults", app_score},
    {"view", "shows a scene in a window", VIEW},
    {"reference", "path-traces a scene on the CPU", app_reference},
    {NULL, NULL, NULL},
};

bool subcommand_is_missing(const struct subcommand *subcommand) {
    return subcommand->run == MISSING;
}

const struct subcommand *subcommand_find(const char *name) {
    for (const struct subcommand *s = subcommands; s->name; s++)
        if (strcmp(s->name, name) == 0)
            return s;
    return NULL;
}
