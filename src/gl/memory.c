#include "gl/memory.h"

#include "base/memory.h"

#include <pthread.h>
#include <string.h>

struct entry {
    char label[40];
    size_t bytes;
    int count;
};

/* One GPU per process in all but tests, so one ledger per process, whichever thread has
 * a context. */
static struct {
    struct entry *entries;
    int count;
} ledger;
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;

static struct entry *find(const char *label) {
    for (int i = 0; i < ledger.count; i++)
        if (strcmp(ledger.entries[i].label, label) == 0)
            return &ledger.entries[i];
    ledger.entries = mem_resize(ledger.entries, (size_t)ledger.count + 1, sizeof *ledger.entries);
    struct entry *entry = &ledger.entries[ledger.count++];
    *entry = (struct entry){0};
    snprintf(entry->label, sizeof entry->label, "%s", label);
    return entry;
}

void gpu_memory_add(const char *label, ptrdiff_t bytes) {
    char short_label[sizeof((struct entry *)0)->label];
    snprintf(short_label, sizeof short_label, "%s", label);
    pthread_mutex_lock(&mutex);
    struct entry *entry = find(short_label);
    entry->bytes += (size_t)bytes;
    entry->count += bytes < 0 ? -1 : 1;
    pthread_mutex_unlock(&mutex);
}

/* The sums over all labels. */
static struct entry sum(void) {
    struct entry all = {0};
    pthread_mutex_lock(&mutex);
    for (int i = 0; i < ledger.count; i++) {
        all.bytes += ledger.entries[i].bytes;
        all.count += ledger.entries[i].count;
    }
    pthread_mutex_unlock(&mutex);
    return all;
}

size_t gpu_memory_total(void) {
    return sum().bytes;
}

int gpu_memory_object_count(void) {
    return sum().count;
}

static int larger_first(const void *a, const void *b) {
    const struct entry *x = a, *y = b;
    return (x->bytes < y->bytes) - (x->bytes > y->bytes);
}

static void print_bytes(FILE *out, const char *label, size_t bytes) {
    fprintf(out, "  %-28s %9.2f MiB\n", label, (double)bytes / (1 << 20));
}

void gpu_memory_print(FILE *out) {
    enum { LARGEST = 8 };
    int shown = 0, others = 0;
    size_t rest = 0;
    char label[32];
    pthread_mutex_lock(&mutex);
    qsort(ledger.entries, (size_t)ledger.count, sizeof *ledger.entries, larger_first);
    for (int i = 0; i < ledger.count; i++)
        if (ledger.entries[i].count > 0 && shown < LARGEST) {
            print_bytes(out, ledger.entries[i].label, ledger.entries[i].bytes);
            shown++;
        } else if (ledger.entries[i].count > 0) {
            rest += ledger.entries[i].bytes;
            others++;
        }
    pthread_mutex_unlock(&mutex);
    snprintf(label, sizeof label, "%d others", others);
    print_bytes(out, label, rest);
    print_bytes(out, "all GPU memory", gpu_memory_total());
}
