#define _GNU_SOURCE /* sched_getaffinity */
#include "base/parallel.h"

#include "base/log.h"

#include <math.h>
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>

enum { MAX_THREADS = 256, WATCHED = 4 /* calls of a thread from one question to the next */ };

struct loop {
    size_t count;
    atomic_size_t next;
    void (*body)(void *context, size_t i);
    void *context;
    const struct log_sink *sink; /* of the thread that calls parallel_for */
};

static int most = MAX_THREADS, granted = MAX_THREADS;
static pthread_once_t asked = PTHREAD_ONCE_INIT;

int parallel_granted(const char *path) {
    FILE *file = fopen(path, "r");
    double quota = 0, period = 0;
    int count = file ? fscanf(file, "%lf %lf", &quota, &period) : 0;
    if (file)
        fclose(file);
    bool bounded = count == 2 && quota > 0 && period > 0 && quota < period * MAX_THREADS;
    return bounded ? (int)ceil(quota / period) : MAX_THREADS;
}

static void ask(void) {
    granted = parallel_granted("/sys/fs/cgroup/cpu.max");
}

void parallel_set_most(int threads) {
    most = threads;
}

int parallel_core_count(void) {
    cpu_set_t set;
    pthread_once(&asked, ask);
    if (sched_getaffinity(0, sizeof set, &set) != 0)
        return 1;
    int count = CPU_COUNT(&set);
    count = count < granted ? count : granted;
    count = count < most ? count : most;
    return count < 1 ? 1 : count;
}

static void *run(void *argument) {
    struct loop *loop = argument;
    log_set_sink(loop->sink);
    for (size_t i; (i = atomic_fetch_add(&loop->next, 1)) < loop->count;)
        loop->body(loop->context, i);
    return NULL;
}

static _Thread_local bool (*is_wanted)(void);

void parallel_watch(bool (*wanted)(void)) {
    is_wanted = wanted;
}

static void run_all(struct loop *loop, int threads) {
    pthread_t helpers[MAX_THREADS];
    int started = 0;
    /* The calling thread works too; a helper that cannot start only costs time. */
    while (started < threads - 1 && pthread_create(&helpers[started], NULL, run, loop) == 0)
        started++;
    run(loop);
    for (int i = 0; i < started; i++)
        pthread_join(helpers[i], NULL);
}

void parallel_for(size_t count, int threads, void (*body)(void *context, size_t i), void *context) {
    struct loop loop = {.body = body, .context = context, .sink = log_get_sink()};
    if (threads <= 0)
        threads = parallel_core_count();
    if (threads > MAX_THREADS)
        threads = MAX_THREADS;
    while (loop.count < count && (!is_wanted || is_wanted())) {
        size_t left = count - loop.count, part = is_wanted ? WATCHED * (size_t)threads : left;
        atomic_store(&loop.next, loop.count);
        loop.count += part < left ? part : left;
        run_all(&loop, threads);
    }
}
