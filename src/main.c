/* Picks the subcommand. */
#include "apps/apps.h"

#include "version.h"

#include <stdio.h>
#include <string.h>

static const struct subcommand {
    const char *name, *help;
    int (*run)(int argc, char **argv);
} subcommands[] = {
    {"bench", "times of the passes, speed against accuracy", app_bench},
    {"compare", "error metrics between two pictures", app_compare},
    {"info", "what renders here, and what a scene holds", app_info},
    {"render", "pictures offscreen", app_render},
#ifndef MANYLIGHT_PORTABLE
    {"view", "a scene in a window", app_view},
    {"reference", "path-traced ground truth of a scene", app_reference},
#endif
    {NULL, NULL, NULL},
};

static void print_help(FILE *out) {
    fprintf(out, "usage: manylight SUBCOMMAND ...\n\n"
                 "Real-time global illumination by many lights.\n\n");
    for (const struct subcommand *s = subcommands; s->name; s++)
        fprintf(out, "  %-10s %s\n", s->name, s->help);
    fprintf(out, "\nmanylight SUBCOMMAND --help tells more; --version prints the version.\n");
}

int main(int argc, char **argv) {
    if (argc < 2) {
        print_help(stderr);
        return 2;
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
        print_help(stdout);
        return 0;
    }
    if (strcmp(argv[1], "--version") == 0) {
        printf("manylight %s (%s)\n", MANYLIGHT_VERSION, MANYLIGHT_COMMIT);
        return 0;
    }
    for (const struct subcommand *s = subcommands; s->name; s++)
        if (strcmp(argv[1], s->name) == 0)
            return s->run(argc - 1, argv + 1);
    fprintf(stderr, "manylight: unknown subcommand '%s' (manylight --help lists them)\n", argv[1]);
    return 2;
}
