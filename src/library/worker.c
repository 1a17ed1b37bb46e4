#define _XOPEN_SOURCE 700
#include "library/worker.h"

#include "base/error.h"
#include "base/log.h"
#include "library/door.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>

struct work {
    worker_job *job;
    void *context;
    const struct log_sink *sink;
    bool done, ok;
    char error[2048];
    enum error_kind kind;
    enum manylight_status blamed;
};

static void run(struct work *work) {
    struct door door;
    door_enter(&door);
    log_set_sink(work->sink);
    work->ok = work->job(work->context);
    work->kind = error_get_kind();
    work->blamed = door_blamed();
    snprintf(work->error, sizeof work->error, "%s", error_get());
    door_leave(&door, true, MANYLIGHT_OK);
}

static void *live(void *argument) {
    struct worker *worker = argument;
    pthread_mutex_lock(&worker->mutex);
    for (;;) {
        while (!worker->ends && (!worker->work || worker->work->done))
            pthread_cond_wait(&worker->changed, &worker->mutex);
        if (worker->ends)
            break;
        struct work *work = worker->work;
        pthread_mutex_unlock(&worker->mutex);
        run(work);
        pthread_mutex_lock(&worker->mutex);
        work->done = true;
        pthread_cond_broadcast(&worker->changed);
    }
    pthread_mutex_unlock(&worker->mutex);
    return NULL;
}

/* Signals of the process are for threads that know of them; faults and profilers are the thread's
 * own. */
static int start_without_signals(struct worker *worker) {
    static const int own[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGPROF};
    sigset_t all, before;
    sigfillset(&all);
    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        sigdelset(&all, own[i]);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    int failed = pthread_create(&worker->thread, NULL, live, worker);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return failed;
}

bool worker_start(struct worker *worker) {
    *worker = (struct worker){.work = NULL};
    pthread_mutex_init(&worker->calling, NULL);
    pthread_mutex_init(&worker->mutex, NULL);
    pthread_cond_init(&worker->changed, NULL);
    int failed = start_without_signals(worker);
    return !failed || error_set("no thread for a device: %s", strerror(failed));
}

void worker_stop(struct worker *worker) {
    pthread_mutex_lock(&worker->mutex);
    worker->ends = true;
    pthread_cond_broadcast(&worker->changed);
    pthread_mutex_unlock(&worker->mutex);
    pthread_join(worker->thread, NULL);
    pthread_mutex_destroy(&worker->calling);
    pthread_mutex_destroy(&worker->mutex);
    pthread_cond_destroy(&worker->changed);
}

bool worker_is_self(const struct worker *worker) {
    return pthread_equal(pthread_self(), worker->thread);
}

/* Errors that are set again keep their kind. */
static void take_error(const struct work *work) {
    (work->kind == ERROR_OF_MEMORY ? error_set_memory : error_set)("%s", work->error);
    if (work->blamed)
        door_blame(work->blamed);
}

bool worker_do(struct worker *worker, worker_job *job, void *context) {
    struct work work = {.job = job, .context = context, .sink = log_get_sink()};
    pthread_mutex_lock(&worker->calling);
    pthread_mutex_lock(&worker->mutex);
    worker->work = &work;
    pthread_cond_broadcast(&worker->changed);
    while (!work.done)
        pthread_cond_wait(&worker->changed, &worker->mutex);
    worker->work = NULL;
    pthread_mutex_unlock(&worker->mutex);
    pthread_mutex_unlock(&worker->calling);
    if (!work.ok)
        take_error(&work);
    return work.ok;
}
