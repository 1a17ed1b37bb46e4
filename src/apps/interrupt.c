#define _POSIX_C_SOURCE 200809L
#include "apps/interrupt.h"

#include <pthread.h>
#include <signal.h>
#include <stddef.h>

static const int held[] = {SIGINT, SIGTERM}, caught[] = {SIGINT, SIGTERM, SIGHUP};

enum { HELD = sizeof held / sizeof *held, CAUGHT = sizeof caught / sizeof *caught };

static volatile sig_atomic_t remembered;

static bool is_ignored(int number) {
    struct sigaction action;
    return sigaction(number, NULL, &action) == 0 && action.sa_handler == SIG_IGN;
}

static void set_mask(int how) {
    sigset_t set;
    sigemptyset(&set);
    for (int i = 0; i < HELD; i++)
        if (!is_ignored(held[i]))
            sigaddset(&set, held[i]);
    pthread_sigmask(how, &set, NULL);
}

void interrupts_hold(void) {
    set_mask(SIG_BLOCK);
}

void interrupts_release(void) {
    set_mask(SIG_UNBLOCK);
}

bool interrupt_came(void) {
    sigset_t pending;
    sigpending(&pending);
    for (int i = 0; i < HELD; i++)
        if (sigismember(&pending, held[i]))
            return true;
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
