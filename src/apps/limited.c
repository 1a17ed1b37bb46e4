#define _GNU_SOURCE
#include "apps/limited.h"

#include "base/error.h"
#include "base/events.h"
#include "base/file/output_file.h"
#include "base/memory.h"
#include "base/text.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { HELD_MOST = 1 << 16 }; /* bytes of others' messages that are kept until the end */

/* What the child writes to its standard error. Lines of ours pass at once; those of libraries wait, as a driver
 * that ends the process has said something, too. */
struct relay {
    struct text line, held;
    const char *subcommand;
    bool has_error; /* a line of ours that is an error, not a note, a warning or a detail */
};

static bool begins(const struct text *text, const char *with) {
    return text->length >= strlen(with) && memcmp(text->data, with, strlen(with)) == 0;
}

/* "manylight render: ..." of arguments_fail, or the last words of base/memory.h. */
static bool is_error(const struct relay *relay, const struct text *line) {
    size_t name = strlen("manylight ");
    return begins(line, "{\"event\": \"error\"") || begins(line, "manylight: out of memory") ||
           begins(line, "manylight: cannot write") ||
           (begins(line, "manylight ") && line->length > name + strlen(relay->subcommand) &&
            memcmp(line->data + name, relay->subcommand, strlen(relay->subcommand)) == 0);
}

static void pass_line(struct relay *relay) {
    struct text *line = &relay->line;
    if (begins(line, "manylight") || begins(line, "{\"event\": ")) {
        relay->has_error |= is_error(relay, line);
        output_file_put(STDERR_FILENO, line->data, line->length);
    } else if (relay->held.length + line->length < HELD_MOST) {
        text_append(&relay->held, line->data, line->length);
    }
    line->length = 0;
}

static void relay_all(struct relay *relay, int from) {
    char bytes[4096];
    for (;;) {
        ssize_t count = read(from, bytes, sizeof bytes);
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            break;
        for (ssize_t i = 0; i < count; i++) {
            text_append(&relay->line, &bytes[i], 1);
            if (bytes[i] == '\n')
                pass_line(relay);
        }
    }
    if (relay->line.length)
        pass_line(relay);
}

/* --- the parent ------------------------------------------------------------------------------- */

static const int asked_to_end[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

enum { ASKED_COUNT = sizeof asked_to_end / sizeof *asked_to_end };

static volatile pid_t child;

static void forward(int number) {
    kill(child, number);
}

static void forward_signals(void) {
    struct sigaction action = {.sa_handler = forward}, before;
    for (int i = 0; i < ASKED_COUNT; i++)
        if (sigaction(asked_to_end[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN)
            sigaction(asked_to_end[i], &action, NULL);
}

/* How a process ends that lacks memory, by its own hand or by the system's. */
static bool is_lack_of_memory(int number) {
    return number == SIGSEGV || number == SIGABRT || number == SIGBUS || number == SIGILL ||
           number == SIGTRAP || number == SIGKILL;
}

/* As the child ended, so that whoever waits for this process sees the same. */
static void end_by(int number) {
    signal(number, SIG_DFL);
    raise(number);
}

static int wait_for_child(void) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        ;
    return status;
}

static _Noreturn void be_parent(const char *subcommand, double gib, int from) {
    struct relay relay = {.subcommand = subcommand};
    forward_signals();
    relay_all(&relay, from);
    int status = wait_for_child();
    if (WIFSIGNALED(status) && !is_lack_of_memory(WTERMSIG(status)))
        end_by(WTERMSIG(status));
    int code = WIFEXITED(status) ? WEXITSTATUS(status) : 1;
    if (code != 0 && !relay.has_error) {
        char bound[32] = "ulimit";
        if (gib > 0)
            snprintf(bound, sizeof bound, "--max-memory %g", gib);
        char *text = mem_printf("manylight %s: %s: too little memory for the work and the OpenGL "
                                "driver",
                                subcommand, bound);
        event_tell_last(text);
        free(text);
        code = 1; /* some libraries end the process by other numbers */
    } else if (relay.held.length) {
        output_file_put(STDERR_FILENO, relay.held.data, relay.held.length);
    }
    free(relay.line.data);
    free(relay.held.data);
    _exit(code);
}

/* --- the child -------------------------------------------------------------------------------- */

/* Says to the child that it is one. */
static const char mark[] = "MANYLIGHT_LIMITED";

/* The program begins anew, as libraries have started threads, which a copy of the process lacks. */
static _Noreturn void be_child(int argc, char **argv, int to) {
    char **arguments = mem_alloc((size_t)argc + 3, sizeof *arguments), *rest = argv[0];
    int count = 0;
    arguments[count++] = "manylight";
    while (rest) /* "bench times" are two */
        arguments[count++] = strsep(&rest, " ");
    for (int i = 1; i < argc; i++)
        arguments[count++] = argv[i];
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    dup2(to, STDERR_FILENO);
    setenv(mark, "1", 1);
    execv("/proc/self/exe", arguments);
    _exit(1);
}

bool limited_begin(int argc, char **argv, double gib) {
    int ends[2];
    bool has_proc = access("/proc/self/exe", X_OK) == 0;
    if (getenv(mark) || !has_proc) {
        unsetenv(mark);
        return gib == 0 || mem_limit((uint64_t)(gib * (1 << 30)));
    }
    if (pipe2(ends, O_CLOEXEC) != 0)
        return error_set("no pipe: %s", strerror(errno));
    fflush(NULL);
    child = fork();
    if (child < 0)
        return error_set("no process: %s", strerror(errno));
    if (child == 0)
        be_child(argc, argv, ends[1]);
    close(ends[1]);
    be_parent(argv[0], gib, ends[0]);
}
