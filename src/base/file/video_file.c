#define _GNU_SOURCE /* pipe2 */
#include "base/file/video_file.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/shell.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

static const struct container {
    const char *extension, *name; /* as ffmpeg calls it */
} containers[] = {{"mp4", "mp4"}, {"mov", "mov"}, {"mkv", "matroska"}, {"webm", "webm"}};

static const struct container *find_container(const char *path) {
    const char *dot = strrchr(path, '.');
    for (size_t i = 0; dot && i < sizeof containers / sizeof *containers; i++)
        if (strcasecmp(dot + 1, containers[i].extension) == 0)
            return containers + i;
    return NULL;
}

bool video_file_is(const char *path) {
    return find_container(path) != NULL;
}

bool video_file_check(const char *path) {
    return shell_has("ffmpeg") ||
           error_set("%s: videos need ffmpeg, which is not installed; without it write numbered "
                     "pictures: -o frame.####.png",
                     path);
}

/* --- the encoder ------------------------------------------------------------------------------ */

/* The descriptor of the output in ffmpeg's process, where it has no name. */
enum { PART_FILE = 3 };

/* Its own process group, so that Ctrl-C reaches it through this program alone. */
static int spawn(struct video_file *video, char *const *arguments, int from) {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    sigset_t none, pipes;
    sigemptyset(&none);
    sigemptyset(&pipes);
    sigaddset(&pipes, SIGPIPE);
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, from, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, video->part.file, PART_FILE);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK |
                                              POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &pipes);
    int reason =
        posix_spawnp(&video->encoder, arguments[0], &files, &attributes, arguments, environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return reason;
}

/* Frames are sRGB of full range. The video's colours are those of BT.709, and say so: players else
 * guess. Without -xerror ffmpeg ends well although the disk is full. */
static bool start(struct video_file *video, const char *fps, int from) {
    static char filter[] = "scale=out_color_matrix=bt709:out_range=limited,format=yuv420p";
    char size[32], rate[40], output[32], container[16];
    snprintf(size, sizeof size, "%dx%d", video->width + video->width % 2,
             video->height + video->height % 2);
    snprintf(rate, sizeof rate, "%s", fps);
    snprintf(output, sizeof output, "/proc/self/fd/%d", PART_FILE);
    snprintf(container, sizeof container, "%s", find_container(video->path)->name);
    char *arguments[] = {"ffmpeg",       "-loglevel",  "error",
                         "-xerror",      "-y",         "-f",
                         "rawvideo",     "-pix_fmt",   "rgb0",
                         "-s",           size,         "-r",
                         rate,           "-i",         "pipe:0",
                         "-an",          "-vf",        filter,
                         "-colorspace",  "bt709",      "-color_primaries",
                         "bt709",        "-color_trc", "iec61966-2-1",
                         "-color_range", "tv",         "-f",
                         container,      output,       NULL};
    int reason = spawn(video, arguments, from);
    if (reason != 0)
        video->encoder = 0;
    return reason == 0 ||
           error_set("%s: ffmpeg cannot be started: %s", video->path, strerror(reason));
}

/* Says why a video is not there. */
static bool tell_end(const struct video_file *video, int status) {
    if (WIFSIGNALED(status))
        return error_set("%s: ffmpeg was ended by signal %d (%s)", video->path, WTERMSIG(status),
                         strsignal(WTERMSIG(status)));
    if (WEXITSTATUS(status) == 0)
        return error_set("%s: ffmpeg ended before the last frame", video->path);
    return error_set("%s: ffmpeg failed with exit status %d", video->path, WEXITSTATUS(status));
}

static int wait_for(struct video_file *video) {
    int status = 0;
    if (video->pipe >= 0)
        close(video->pipe);
    video->pipe = -1;
    while (waitpid(video->encoder, &status, 0) < 0 && errno == EINTR)
        ;
    video->encoder = 0;
    return status;
}

/* --- a video ---------------------------------------------------------------------------------- */

bool video_file_begin(struct video_file *video, const char *path, int width, int height,
                      const char *rate) {
    int ends[2];
    *video = (struct video_file){.path = path, .pipe = -1, .width = width, .height = height};
    if (!video_file_check(path) || !output_part_begin(&video->part, path))
        return false;
    if (pipe2(ends, O_CLOEXEC) != 0)
        return error_set("%s: no pipe: %s", path, strerror(errno));
    video->pipe = ends[1];
    signal(SIGPIPE, SIG_IGN); /* an ffmpeg that has ended is noticed by its pipe */
    bool ok = start(video, rate, ends[0]);
    close(ends[0]);
    if (ok && (width % 2 || height % 2))
        video->even = mem_alloc((size_t)(width + 1) * (size_t)(height + 1), 4);
    return ok;
}

/* Colours of 4:2:0 are those of 2 x 2 pixels: the last column and row come twice where the sides
 * are odd. */
static void make_even(struct video_file *video, const struct bitmap *frame) {
    size_t width = (size_t)frame->width, height = (size_t)frame->height,
           even_width = width + width % 2, even_height = height + height % 2;
    for (size_t y = 0; y < even_height; y++) {
        const unsigned char *from = frame->rgba + 4 * width * (y < height ? y : height - 1);
        unsigned char *to = video->even + 4 * even_width * y;
        memcpy(to, from, 4 * width);
        memcpy(to + 4 * (even_width - 1), from + 4 * (width - 1), 4);
    }
}

bool video_file_add(struct video_file *video, const struct bitmap *frame) {
    size_t width = (size_t)(video->width + video->width % 2),
           height = (size_t)(video->height + video->height % 2);
    if (frame->width != video->width || frame->height != video->height)
        return error_set("%s: a frame of %dx%d, not %dx%d", video->path, frame->width,
                         frame->height, video->width, video->height);
    if (video->even)
        make_even(video, frame);
    if (output_file_put(video->pipe, video->even ? video->even : frame->rgba, 4 * width * height))
        return true;
    if (errno != EPIPE)
        return error_set("%s: %s", video->path, strerror(errno));
    return tell_end(video, wait_for(video));
}

bool video_file_end(struct video_file *video, bool ok) {
    if (!video->path)
        return ok;
    if (video->encoder > 0) {
        if (!ok)
            kill(video->encoder, SIGKILL);
        int status = wait_for(video);
        if (ok && status != 0)
            ok = tell_end(video, status);
    } else {
        if (video->pipe >= 0)
            close(video->pipe);
        ok = false;
    }
    ok = output_part_end(&video->part, ok) && ok;
    free(video->even);
    *video = (struct video_file){0};
    return ok;
}
