#include "reference/rows.h"

#include "base/error.h"
#include "base/parallel.h"

#include <pthread.h>
#include <stdatomic.h>

struct work {
    const struct rows *rows;
    pthread_mutex_t lock; /* held while reporting */
    int done;
    atomic_bool cancelled;
};

static void render_row(void *context, size_t row) {
    struct work *work = context;
    const struct rows *rows = work->rows;
    if (atomic_load(&work->cancelled))
        return;
    rows->render(rows->context, (int)row);
    pthread_mutex_lock(&work->lock);
    work->done++;
    if (rows->report && !rows->report(rows->context, (double)work->done / rows->count))
        atomic_store(&work->cancelled, true);
    pthread_mutex_unlock(&work->lock);
}

bool rows_render(const struct rows *rows) {
    struct work work = {.rows = rows, .lock = PTHREAD_MUTEX_INITIALIZER};
    parallel_for((size_t)rows->count, rows->threads, render_row, &work);
    pthread_mutex_destroy(&work.lock);
    return !atomic_load(&work.cancelled) || error_set("cancelled");
}
