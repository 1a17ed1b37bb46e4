/* Picks the subcommand. */
#define _POSIX_C_SOURCE 200809L
#include "apps/apps.h"
#include "apps/arguments.h"
#include "base/error.h"
#include "base/file/output_file.h"

#include "version.h"

#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#ifdef MANYLIGHT_NO_VIEWER
static int refuse_view(int argc, char **argv) {
    (void)argc, (void)argv;
    fprintf(stderr, "manylight: view: this build has no viewer; render writes pictures\n");
    return 1;
}
#define VIEW refuse_view
#else
#define VIEW app_view
#endif

static const struct subcommand {
    const char *name, *help;
    int (*run)(int argc, char **argv);
} subcommands[] = {
    {"average", "joins pictures of different passes", app_average},
    {"bench", "measures times, errors and memory", app_bench},
    {"compare", "measures the error between two pictures", app_compare},
    {"export", "writes a scene for other renderers: a pack, Mitsuba 3, pbrt-v4", app_export},
    {"info", "describes a scene, or the renderer of this machine", app_info},
    {"render", "renders pictures without a window", app_render},
    {"report", "writes a page on a scene: each technique's time, error and picture", app_report},
    {"score", "scores a folder of pictures against references, and names their faults", app_score},
    {"tune", "measures the cost of the choices of --max-error and --budget", app_tune},
    {"view", "shows a scene in a window", VIEW},
    {"reference", "path-traces a scene on the CPU", app_reference},
    {NULL, NULL, NULL},
};

static void print_help(FILE *out) {
    fprintf(out, "usage: manylight SUBCOMMAND ...\n\n"
                 "Real-time global illumination by many lights.\n\n");
    for (const struct subcommand *s = subcommands; s->name; s++)
        fprintf(out, "  %-10s %s\n", s->name, s->help);
    fprintf(out, "\nmanylight SUBCOMMAND --help lists options; --version prints the version.\n");
}

/* A picture must not get the number of a standard stream that the caller has closed: what is printed
 * would go there. What cannot be written is an error, never a signal. */
static void guard_streams(void) {
    for (int stream = 0; stream <= 2; stream++)
        if (fcntl(stream, F_GETFD) < 0)
            open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY);
    signal(SIGXFSZ, SIG_IGN);
    /* Of a write that fails when the stream is flushed it is known why, of one in between no more. */
    static char page[1 << 16];
    if (!isatty(STDOUT_FILENO))
        setvbuf(stdout, page, _IOFBF, sizeof page);
}

/* Results that stdout did not take were not told. */
static int close_stdout(int status) {
    if (output_file_close_stdout() || status != 0)
        return status;
    fprintf(stderr, "manylight: %s\n", error_get());
    return 1;
}

static int run(int argc, char **argv) {
    if (argc < 2) {
        print_help(stderr);
        return 2;
    }
    if (arguments_is_help(argv[1])) {
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

int main(int argc, char **argv) {
    guard_streams();
    return close_stdout(run(argc, argv));
}
