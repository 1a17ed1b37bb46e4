#define _GNU_SOURCE /* O_TMPFILE */
#include "base/file/output_file.h"

#include "base/error.h"
#include "base/events.h"
#include "base/memory.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool fail(const char *path) {
    return error_set("cannot write %s: %s", path, strerror(errno));
}

/* "." where the path has no slash; to be freed. */
static char *folder_of(const char *path) {
    const char *slash = strrchr(path, '/');
    if (!slash)
        return mem_strdup(".");
    return mem_printf("%.*s", slash == path ? 1 : (int)(slash - path), path);
}

/* --- before ----------------------------------------------------------------------------------- */

/* The folder must take a new name, even where the file is there: it is replaced. */
static bool check_folder(const char *path) {
    char *folder = folder_of(path);
    bool ok = access(folder, W_OK | X_OK) == 0 || fail(path);
    free(folder);
    return ok;
}

bool output_file_is_stdout(const char *path) {
    return strcmp(path, "-") == 0;
}

bool output_file_is_not(const char *path, const char *input) {
    struct stat output, other;
    if (output_file_is_stdout(path) || output_file_is_stdout(input))
        return true;
    bool same = stat(path, &output) == 0 && stat(input, &other) == 0 && S_ISREG(output.st_mode) &&
                output.st_dev == other.st_dev && output.st_ino == other.st_ino;
    return !same || error_set("cannot write %s: it is the input %s", path, input);
}

static bool is_writable(const char *path) {
    struct stat status;
    if (!*path)
        return error_set("cannot write a file without a name");
    if (output_file_is_stdout(path))
        return !isatty(STDOUT_FILENO) ||
               error_set("cannot write a file to standard output: it is a terminal");
    bool exists = stat(path, &status) == 0;
    if (!exists && errno != ENOENT)
        return fail(path);
    if (!exists && lstat(path, &status) == 0)
        return error_set("cannot write %s: it is a link to nothing", path);
    if (exists && S_ISDIR(status.st_mode))
        return error_set("cannot write %s: it is a folder", path);
    if (exists && access(path, W_OK) != 0)
        return fail(path);
    return (exists && !S_ISREG(status.st_mode)) || check_folder(path);
}

bool output_file_check(const char *path, const char *const *inputs, int count) {
    bool ok = is_writable(path);
    for (int i = 0; ok && i < count; i++)
        ok = !inputs[i] || output_file_is_not(path, inputs[i]);
    return ok;
}

/* --- bytes ------------------------------------------------------------------------------------ */

bool output_file_put(int file, const void *bytes, size_t size) {
    const char *rest = bytes;
    while (size > 0) {
        ssize_t written = write(file, rest, size);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        rest += written;
        size -= (size_t)written;
    }
    return true;
}

/* Some file systems cannot sync; none that can is let off. */
static bool sync_all(int file) {
    return fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP;
}

/* Whether the file holds the bytes and no more. */
static bool holds(int file, const char *bytes, size_t size) {
    char chunk[1 << 14];
    size_t at = 0;
    for (ssize_t got; (got = pread(file, chunk, sizeof chunk, (off_t)at)) != 0; at += (size_t)got) {
        if (got < 0)
            return false;
        errno = EIO;
        if ((size_t)got > size - at || memcmp(chunk, bytes + at, (size_t)got) != 0)
            return false;
    }
    errno = EIO;
    return at == size;
}

/* --- the part file ---------------------------------------------------------------------------- */

/* A file on its way to a name. */
struct part {
    int file;
    char *name; /* beside the target, of this process; NULL = it has none yet */
};

/* Calls make(name) with names of this process until one is free; it returns what open does. */
static int with_free_name(struct part *part, const char *path, int (*make)(const struct part *)) {
    char *folder = folder_of(path);
    int result;
    for (int i = 0;; i++) {
        part->name = mem_printf("%s/.manylight-%ld-%d.part", folder, (long)getpid(), i);
        result = make(part);
        if (result >= 0 || errno != EEXIST)
            break;
        free(part->name);
    }
    if (result < 0) {
        free(part->name);
        part->name = NULL;
    }
    free(folder);
    return result;
}

static int open_named(const struct part *part) {
    return open(part->name, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

static int link_to(int file, const char *name) {
    char unnamed[64];
    snprintf(unnamed, sizeof unnamed, "/proc/self/fd/%d", file);
    return linkat(AT_FDCWD, unnamed, AT_FDCWD, name, AT_SYMLINK_FOLLOW);
}

static int link_unnamed(const struct part *part) {
    return link_to(part->file, part->name);
}

/* Whether a file without a name can get one here. */
static bool has_proc(void) {
    return access("/proc/self/fd", X_OK) == 0;
}

static bool part_open(struct part *part, const char *path) {
    char *folder = folder_of(path);
    *part = (struct part){.file = -1};
    if (has_proc())
        part->file = open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
    free(folder);
    if (part->file < 0)
        part->file = with_free_name(part, path, open_named);
    return part->file >= 0;
}

/* The mode of what was there stays. */
static bool keep_mode(int file, const char *path) {
    struct stat old, new;
    return stat(path, &old) != 0 || fstat(file, &new) != 0 || old.st_mode == new.st_mode ||
           fchmod(file, old.st_mode & 0777) == 0;
}

static bool part_fill(const struct part *part, const char *path, const void *bytes, size_t size) {
    return output_file_put(part->file, bytes, size) && sync_all(part->file) &&
           holds(part->file, bytes, size) && keep_mode(part->file, path);
}

/* A file without a name takes the target's, or one beside it where the target is to be replaced: no
 * call does that at once. */
static bool part_link(struct part *part, const char *path) {
    return part->name || link_to(part->file, path) == 0 ||
           (errno == EEXIST && with_free_name(part, path, link_unnamed) == 0);
}

/* Closes the file in any case; only what is good takes the target's name. */
static bool part_finish(struct part *part, const char *path, bool ok) {
    ok = ok && part_link(part, path);
    int reason = errno;
    if (close(part->file) != 0 && ok && part->name) {
        reason = errno;
        ok = false;
    }
    if (ok && part->name && rename(part->name, path) != 0) {
        reason = errno;
        ok = false;
    }
    if (!ok && part->name)
        unlink(part->name);
    free(part->name);
    errno = reason;
    return ok;
}

/* The name in the folder lasts, too. */
static void sync_folder(const char *path) {
    char *name = folder_of(path);
    int folder = open(name, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    free(name);
    if (folder < 0)
        return;
    fsync(folder);
    close(folder);
}

/* --- writing ---------------------------------------------------------------------------------- */

static bool write_regular(const char *path, const void *bytes, size_t size) {
    struct part part;
    if (!part_open(&part, path) || !part_finish(&part, path, part_fill(&part, path, bytes, size)))
        return false;
    sync_folder(path);
    return true;
}

/* A reader that is gone is an error, not a signal that ends the program without a word. */
static bool write_to_reader(int file, const void *bytes, size_t size) {
    struct sigaction ignored = {.sa_handler = SIG_IGN}, before;
    sigaction(SIGPIPE, &ignored, &before);
    bool ok = output_file_put(file, bytes, size);
    int reason = errno;
    sigaction(SIGPIPE, &before, NULL);
    errno = reason;
    return ok;
}

static bool write_stdout(const void *bytes, size_t size) {
    return (fflush(stdout) == 0 && write_to_reader(STDOUT_FILENO, bytes, size) &&
            sync_all(STDOUT_FILENO)) ||
           fail("standard output");
}

static int flush_reason; /* 0: all was flushed */

void output_file_flush_stdout(void) {
    if (fflush(stdout) != 0 && !flush_reason)
        flush_reason = errno;
}

bool output_file_close_stdout(void) {
    bool lost = ferror(stdout);
    errno = 0;
    lost = fclose(stdout) != 0 || lost;
    errno = flush_reason ? flush_reason : errno;
    return !lost || (errno ? fail("standard output") : error_set("cannot write standard output"));
}

static bool write_special(const char *path, const void *bytes, size_t size) {
    int file = open(path, O_WRONLY | O_CLOEXEC);
    if (file < 0)
        return false;
    bool ok = write_to_reader(file, bytes, size);
    int reason = errno;
    bool closed = close(file) == 0;
    errno = ok ? errno : reason;
    return ok && closed;
}

static bool is_special(const char *path) {
    struct stat status;
    return stat(path, &status) == 0 && !S_ISREG(status.st_mode);
}

bool output_file_write(const char *path, const void *bytes, size_t size) {
    if (!is_writable(path))
        return false;
    if (output_file_is_stdout(path))
        return write_stdout(bytes, size);
    /* What a link leads to is replaced, not the link. */
    char *target = realpath(path, NULL);
    const char *name = target ? target : path;
    bool ok =
        (is_special(name) ? write_special(name, bytes, size) : write_regular(name, bytes, size)) ||
        fail(path);
    free(target);
    return ok;
}

bool output_part_begin(struct output_part *part, const char *path) {
    struct part made;
    *part = (struct output_part){0};
    if (!is_writable(path))
        return false;
    if (output_file_is_stdout(path) || is_special(path))
        return error_set("cannot write %s: it is no regular file", path);
    char *target = realpath(path, NULL);
    part->path = target ? target : mem_strdup(path);
    if (part_open(&made, part->path)) {
        part->file = made.file;
        part->name = made.name;
        return true;
    }
    free(part->path);
    part->path = NULL;
    return fail(path);
}

bool output_part_end(struct output_part *part, bool ok) {
    struct part made = {part->file, part->name};
    if (!part->path)
        return false;
    bool filled = ok && sync_all(part->file) && keep_mode(part->file, part->path),
         done = part_finish(&made, part->path, filled) && filled;
    if (done)
        sync_folder(part->path);
    else if (ok)
        fail(part->path);
    free(part->path);
    *part = (struct output_part){0};
    return done;
}

/* --- text ------------------------------------------------------------------------------------- */

void output_text_init(struct output_text *text) {
    *text = (struct output_text){0};
    text->stream = open_memstream(&text->data, &text->size);
    if (!text->stream) {
        event_tell_last("manylight: out of memory");
        _exit(1); /* as base/memory.h does */
    }
}

bool output_text_end(struct output_text *text, const char *path) {
    bool ok = fflush(text->stream) == 0 && !ferror(text->stream);
    ok = ok ? output_file_write(path, text->data, text->size)
            : error_set("cannot write %s: out of memory", path);
    fclose(text->stream);
    free(text->data);
    return ok;
}

/* --- folders ---------------------------------------------------------------------------------- */

static bool fail_folder(const char *path) {
    return error_set("cannot make the folder %s: %s", path, strerror(errno));
}

char *output_folder_begin(const char *path) {
    struct stat there;
    size_t length = strlen(path);
    while (length > 1 && path[length - 1] == '/')
        length--;
    if (lstat(path, &there) == 0) {
        error_set("%s exists: choose the name of a new folder", path);
        return NULL;
    }
    char *folder = mem_printf("%.*s.part-XXXXXX", (int)length, path);
    mode_t mask = umask(0);
    umask(mask);
    if (mkdtemp(folder) && chmod(folder, 0777 & ~mask) == 0)
        return folder;
    fail_folder(path);
    free(folder);
    return NULL;
}

static void remove_folder(const char *folder) {
    DIR *files = opendir(folder);
    for (struct dirent *file; files && (file = readdir(files));) {
        char *path = mem_printf("%s/%s", folder, file->d_name);
        if (strcmp(file->d_name, ".") != 0 && strcmp(file->d_name, "..") != 0)
            unlink(path);
        free(path);
    }
    if (files)
        closedir(files);
    rmdir(folder);
}

bool output_folder_end(char *folder, const char *path, bool ok) {
    ok = ok && (rename(folder, path) == 0 || fail_folder(path));
    if (!ok)
        remove_folder(folder);
    free(folder);
    return ok;
}
