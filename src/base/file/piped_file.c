#define _GNU_SOURCE /* memfd_create */
#include "base/file/piped_file.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/file/output_file.h"
#include "base/memory.h"
#include "base/text.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

/* Both are called "-". */
static bool is_standard_input(const char *path) {
    return output_file_is_stdout(path);
}

bool piped_file_is(const char *path) {
    struct stat status;
    return is_standard_input(path) || (stat(path, &status) == 0 && S_ISFIFO(status.st_mode));
}

/* --- reading to the end ----------------------------------------------------------------------- */

static bool fail(const char *path) {
    return error_set("cannot read %s: %s", path, strerror(errno));
}

/* A pipe may have no end. What is read of it lies in memory twice, here and where it is used. */
static bool copy(int kept, int pipe, const char *path) {
    uint64_t most = mem_free_bytes() / 2, size = 0;
    if (most > UINT32_MAX - 1)
        most = UINT32_MAX - 1;
    for (char chunk[1 << 16];;) {
        ssize_t got = read(pipe, chunk, sizeof chunk);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return fail(path);
        if (got == 0)
            return true;
        size += (uint64_t)got;
        if (size > most)
            return error_set("cannot read %s: it has more than %.0f MiB", path,
                             (double)most / (1 << 20));
        if (!output_file_put(kept, chunk, (size_t)got))
            return fail(path);
    }
}

static int open_pipe(const char *path) {
    if (!is_standard_input(path))
        return open(path, O_RDONLY | O_CLOEXEC);
    if (isatty(STDIN_FILENO)) {
        error_set("-: standard input is a terminal, not a file or a pipe");
        return -1;
    }
    return fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3);
}

/* The path of what was read, to be freed; NULL and an error. The file lives as long as
 * the program. */
static char *read_whole(const char *path) {
    error_set("%s", "");
    int pipe = open_pipe(path);
    int kept = pipe >= 0 ? memfd_create("manylight", MFD_CLOEXEC) : -1;
    if (kept < 0 && !*error_get())
        fail(path);
    bool ok = kept >= 0 && copy(kept, pipe, path);
    if (pipe >= 0)
        close(pipe);
    if (ok)
        return mem_printf("/proc/self/fd/%d", kept);
    if (kept >= 0)
        close(kept);
    return NULL;
}

/* --- what was read ---------------------------------------------------------------------------- */

/* Never freed: its paths are given away. */
static struct kept {
    char *path, *opens;
    struct kept *next;
} * all_kept;

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

static struct kept *find_or_read(const char *path) {
    struct kept *kept = all_kept;
    while (kept && strcmp(kept->path, path) != 0)
        kept = kept->next;
    if (kept)
        return kept;
    char *opens = read_whole(path);
    if (!opens)
        return NULL;
    kept = mem_alloc(1, sizeof *kept);
    *kept = (struct kept){mem_strdup(path), opens, all_kept};
    return all_kept = kept;
}

/* The path that opens the bytes as a regular file: the path itself where it is no pipe. The text
 * lives as long as the program. NULL and an error: a terminal, 4 GiB or more, or more than half of
 * the memory that is free. */
static const char *open_bytes(const char *path) {
    if (!piped_file_is(path))
        return path;
    pthread_mutex_lock(&lock);
    const struct kept *kept = find_or_read(path);
    pthread_mutex_unlock(&lock);
    return kept ? kept->opens : NULL;
}

/* Messages name what the user named. */
static bool blame(const char *path, const char *opened) {
    char *message = mem_strdup(error_get());
    struct text named = {0};
    const char *rest = message;
    for (const char *at; opened != path && (at = strstr(rest, opened)); rest = at + strlen(opened))
        text_print(&named, "%.*s%s", (int)(at - rest), rest, path);
    text_print(&named, "%s", rest);
    error_set("%s", named.data);
    mem_free(named.data, message);
    return false;
}

bool piped_file_read(struct file_bytes *bytes, const char *path) {
    *bytes = (struct file_bytes){0};
    const char *opens = open_bytes(path);
    return opens && (file_read(bytes, opens) || blame(path, opens));
}

bool piped_image_read_layer(struct image *image, const char *path, const char *layer,
                            int channels[3]) {
    *image = (struct image){0};
    const char *opens = open_bytes(path);
    return opens && (image_read_layer(image, opens, layer, channels) || blame(path, opens));
}

bool piped_image_read(struct image *image, const char *path) {
    *image = (struct image){0};
    const char *opens = open_bytes(path);
    return opens && (image_read(image, opens) || blame(path, opens));
}
