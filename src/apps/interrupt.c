#define _POSIX_C_SOURCE 200809L
#include "apps/interrupt.h"

#include <pthread.h>
#include <signal.h>
#include <stddef.h>

static const int held[] = {SIGINT, SIGTERM};

enum { HELD = sizeof held / sizeof *held };

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
    return false;
}
