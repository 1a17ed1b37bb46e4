/* Picks the subcommand. */
#define _POSIX_C_SOURCE 200809L
#include "apps/arguments.h"
#include "apps/subcommands.h"
#include "base/clock.h"
#include "base/error.h"
#include "base/events.h"
#include "base/file/output_file.h"

#include "version.h"

#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static double start_ms;

static void print_help(FILE *out) {
    fprintf(out, "usage: manylight SUBCOMMAND ...\n\n"
                 "Real-time global illumination by many lights.\n\n");
    for (const struct subcommand *s = subcommands; s->name; s++)
        if (s->run)
            fprintf(out, "  %-10s %s\n", s->name, s->help);
    fprintf(out, "\nmanylight SUBCOMMAND --help lists options; --version prints the version.\n");
}

/* A picture must not get the number of a standard stream that the caller has closed: what is
 * printed would go there. What cannot be written is an error, never a signal. */
static void guard_streams(void) {
    for (int stream = 0; stream <= 2; stream++)
        if (fcntl(stream, F_GETFD) < 0)
            open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY);
    signal(SIGXFSZ, SIG_IGN);
    /* Of a write that fails when the stream is flushed it is known why, of one in between
     * no more. */
    static char page[1 << 16];
    if (!isatty(STDOUT_FILENO))
        setvbuf(stdout, page, _IOFBF, sizeof page);
}

/* The last event. */
static void tell_end(void) {
    struct event event;
    event_begin(&event, "done");
    json_number(&event.json, "done", 1);
    json_number(&event.json, "seconds", (clock_ms() - start_ms) / 1e3);
    event_send(&event);
}

/* Results that stdout did not take were not told. */
static int close_stdout(int status) {
    bool ok = output_file_close_stdout();
    if (ok && status == 0 && events_are_json())
        tell_end();
    if (ok || status != 0)
        return status;
    if (events_are_json())
        event_tell("error", error_get());
    else
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
    const struct subcommand *named = subcommand_find(argv[1]);
    if (named && named->run)
        return named->run(argc - 1, argv + 1);
    if (named) {
        fprintf(stderr, "manylight: %s: this build is without it\n", named->name);
        return 1;
    }
    fprintf(stderr, "manylight: unknown subcommand '%s' (manylight --help lists them)\n", argv[1]);
    return 2;
}

int main(int argc, char **argv) {
    start_ms = clock_ms();
    guard_streams();
    return close_stdout(run(argc, argv));
}
