/* A thread that runs one job at a time for callers, who wait. */
#ifndef LIBRARY_WORKER_H
#define LIBRARY_WORKER_H

#include <pthread.h>
#include <stdbool.h>

typedef bool worker_job(void *context);

struct worker {
    pthread_t thread;
    pthread_mutex_t calling; /* held by the waiting caller */
    pthread_mutex_t mutex;   /* guards the members below */
    pthread_cond_t changed;
    struct work *work; /* NULL: idle */
    bool ends;
};

/* Starts the thread; worker_stop ends and joins it. Error: the system cannot create a thread. */
bool worker_start(struct worker *worker);
void worker_stop(struct worker *worker);

/* True on the worker's own thread. */
bool worker_is_self(const struct worker *worker);

/* Runs the job on the worker's thread with the caller's log, and waits. Returns the job's result;
 * on failure copies its error to the calling thread. */
bool worker_do(struct worker *worker, worker_job *job, void *context);

#endif
