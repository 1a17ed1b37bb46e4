#define _POSIX_C_SOURCE 200809L
#include "base/memory.h"

#include "base/error.h"
#include "base/events.h"

#include <inttypes.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

static const double gib = 1 << 30;

/* The number behind the word in a file of /proc or /sys; "" = the first. UINT64_MAX where there is
 * none. */
static uint64_t number_in(const char *path, const char *word) {
    char line[256];
    uint64_t number = UINT64_MAX;
    FILE *file = fopen(path, "r");
    while (file && fgets(line, sizeof line, file))
        if (strncmp(line, word, strlen(word)) == 0 &&
            sscanf(line + strlen(word), "%" SCNu64, &number) == 1)
            break;
    if (file)
        fclose(file);
    return number;
}

static uint64_t least(uint64_t a, uint64_t b) {
    return a < b ? a : b;
}

/* Of `ulimit -v` or `-d`, less what is mapped or of that kind: the words in /proc/self/status. */
static uint64_t left_of_limit(int resource, const char *used) {
    struct rlimit limit;
    if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return UINT64_MAX;
    uint64_t kib = number_in("/proc/self/status", used), bytes = kib == UINT64_MAX ? 0 : kib * 1024;
    return bytes < limit.rlim_cur ? limit.rlim_cur - bytes : 0;
}

bool mem_is_limited(void) {
    struct rlimit limit;
    return getrlimit(RLIMIT_DATA, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

bool mem_is_scarce(void) {
    const uint64_t enough = (uint64_t)2 << 30;
    return left_of_limit(RLIMIT_AS, "VmSize:") < enough ||
           left_of_limit(RLIMIT_DATA, "VmData:") < enough;
}

static bool check_left(uint64_t left, const char *option, const char *what, double least_gib) {
    return (double)left >= least_gib * gib ||
           error_set_memory("too little memory: ulimit %s leaves %.2f GiB of %s, and an OpenGL "
                            "driver takes about %g GiB",
                            option, (double)left / gib, what, least_gib);
}

/* Drivers that lack memory end the process in ways of their own. */
bool mem_check_driver(void) {
    return check_left(left_of_limit(RLIMIT_AS, "VmSize:"), "-v", "address space", .9) &&
           check_left(left_of_limit(RLIMIT_DATA, "VmData:"), "-d", "data", .2);
}

uint64_t mem_free_bytes(void) {
    uint64_t free_kib = number_in("/proc/meminfo", "MemAvailable:");
    uint64_t there = free_kib == UINT64_MAX ? free_kib : free_kib * 1024;
    there = least(there, number_in("/sys/fs/cgroup/memory.max", ""));
    return least(there,
                 least(left_of_limit(RLIMIT_AS, "VmSize:"), left_of_limit(RLIMIT_DATA, "VmData:")));
}

bool mem_check(uint64_t bytes) {
    uint64_t there = mem_free_bytes();
    return bytes <= there ||
           error_set_memory("%.2f GiB of memory are wanted, and %.2f GiB are free",
                            (double)bytes / gib, (double)there / gib);
}

static double status_mib(const char *word) {
    uint64_t kib = number_in("/proc/self/status", word);
    return kib == UINT64_MAX ? 0 : (double)kib / 1024;
}

double mem_resident(void) {
    return status_mib("VmRSS:");
}

double mem_most_resident(void) {
    return status_mib("VmHWM:");
}

static void *checked(void *pointer, size_t count, size_t size) {
    if (pointer)
        return pointer;
    char text[96];
    snprintf(text, sizeof text, "manylight: out of memory (%zu x %zu bytes)", count, size);
    event_tell_last(text);
    _exit(1); /* other threads may be at work, so nothing is torn down */
}

void mem_keep_freed(void) {
#ifdef __GLIBC__
    mallopt(M_TRIM_THRESHOLD, 256 << 20);
    /* To where it would have grown, had the other been left alone. */
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
#endif
}

void *mem_alloc(size_t count, size_t size) {
    if (count == 0 || size == 0)
        count = size = 1;
    return checked(calloc(count, size), count, size);
}

void *mem_resize(void *pointer, size_t count, size_t size) {
    if (count == 0 || size == 0)
        count = size = 1;
    void *resized = count > SIZE_MAX / size ? NULL : realloc(pointer, count * size);
    return checked(resized, count, size);
}

void *mem_copy(const void *elements, size_t count, size_t size) {
    void *to = elements ? mem_resize(NULL, count, size) : NULL;
    return to ? memcpy(to, elements, count * size) : NULL;
}

char *mem_strdup(const char *text) {
    size_t size = strlen(text) + 1;
    return memcpy(mem_alloc(size, 1), text, size);
}

char *mem_printf(const char *format, ...) {
    va_list args;
    va_start(args, format);
    int length = vsnprintf(NULL, 0, format, args);
    va_end(args);
    size_t size = length < 0 ? 1 : (size_t)length + 1;
    char *text = mem_alloc(size, 1);
    va_start(args, format);
    vsnprintf(text, size, format, args);
    va_end(args);
    return text;
}
