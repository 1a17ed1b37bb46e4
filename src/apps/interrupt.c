#define _POSIX_C_SOURCE 200809L
#include "apps/interrupt.h"

#include <pthread.h>
#include <signal.h>
#include <stddef.h>
#include <time.h>
#include <unistd.h>

static const int held[] = {SIGINT, SIGTERM}, caught[] = {SIGINT, SIGTERM, SIGHUP};

enum { HELD = sizeof held / sizeof *held, CAUGHT = sizeof caught / sizeof *caught };

static volatile sig_atomic_t remembered;

static bool is_ignored(int number) {
    struct sigaction action;
    return sigaction(number, NULL, &action) == 0 && action.sa_handler == SIG_IGN;
}

static sigset_t held_set(void) {
    sigset_t set;
    sigemptyset(&set);
    for (int i = 0; i < HELD; i++)
        if (!is_ignored(held[i]))
            sigaddset(&set, held[i]);
    return set;
}

/* Whatever the process is at: opening, a driver's compiler, a loop that asks nothing. */
static void *wait_for_end(void *unused) {
    static const char text[] = "manylight render: stopped within a frame\n";
    const struct timespec grace = {.tv_sec = 1};
    const sigset_t set = held_set();
    int number;
    (void)unused;
    if (sigwait(&set, &number) != 0)
        return NULL;
    remembered = number;
    sigtimedwait(&set, NULL, &grace);
    if (write(STDERR_FILENO, text, sizeof text - 1) < 0)
        _exit(128 + number);
    interrupts_release();
    return NULL;
}

void interrupts_hold(void) {
    const sigset_t set = held_set();
    pthread_t thread;
    pthread_sigmask(SIG_BLOCK, &set, NULL);
    if (pthread_create(&thread, NULL, wait_for_end, NULL) == 0)
        pthread_detach(thread);
    else
        pthread_sigmask(SIG_UNBLOCK, &set, NULL);
}

void interrupts_release(void) {
    const sigset_t set = held_set();
    pthread_sigmask(SIG_UNBLOCK, &set, NULL);
    interrupts_obey();
}

bool interrupt_came(void) {
    return remembered != 0;
}

bool interrupt_asked(void *user) {
    (void)user;
    return interrupt_came();
}

static void remember(int number) {
    remembered = number;
}

void interrupts_catch(void) {
    struct sigaction action = {.sa_handler = remember, .sa_flags = SA_RESTART};
    for (int i = 0; i < CAUGHT; i++)
        if (!is_ignored(caught[i]))
            sigaction(caught[i], &action, NULL);
}

void interrupts_obey(void) {
    for (int i = 0; i < CAUGHT; i++)
        if (!is_ignored(caught[i]))
            signal(caught[i], SIG_DFL);
    if (remembered)
        raise(remembered);
}
