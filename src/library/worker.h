/* A thread that does one job at a time for others, who wait. */
#ifndef LIBRARY_WORKER_H
#define LIBRARY_WORKER_H

#include <pthread.h>
#include <stdbool.h>

typedef bool worker_job(void *context);

struct worker {
    pthread_t thread;
    pthread_mutex_t calling; /* held by the thread that waits */
    pthread_mutex_t mutex;   /* of all below */
    pthread_cond_t changed;
    struct work *work; /* NULL: none to do */
    bool ends;
};

/* Error: the system has no thread more. */
bool worker_start(struct worker *worker);
void worker_stop(struct worker *worker);

/* Whether the calling thread is the worker's own. */
bool worker_is_self(const struct worker *worker);

/* Runs the job on the worker's thread, with the log of this one, and returns what it returns. Its error is this thread's. */
bool worker_do(struct worker *worker, worker_job *job, void *context);

#endif
