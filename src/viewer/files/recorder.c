#define _XOPEN_SOURCE 700
#include "viewer/files/recorder.h"

#include "base/error.h"
#include "base/file/folder.h"
#include "base/file/output_file.h"
#include "base/memory.h"
#include "base/shell.h"
#include "scene/animation.h"
#include "viewer/files/screenshot.h"
#include "viewer/scene/animation.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* --- where it goes ---------------------------------------------------------------------------- */

bool recorder_has_video(void) {
    return shell_has("ffmpeg");
}

/* Makes the folder, or the file that ffmpeg writes; false where another viewer has done so. */
static bool take_name(const struct recorder *recorder) {
    if (recorder->kind == RECORD_PICTURES)
        return mkdir(recorder->name, 0777) == 0;
    int file = open(recorder->part, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    return file >= 0 && close(file) == 0;
}

/* A video has its name when it is whole. */
static enum name_state take_number(void *user, int number) {
    struct recorder *recorder = user;
    const char *ending = recorder->kind == RECORD_VIDEO ? ".mp4" : "";
    snprintf(recorder->name, sizeof recorder->name, "%s/manylight-clip-%04d%s", recorder->folder,
             number, ending);
    snprintf(recorder->part, sizeof recorder->part, "%s/.manylight-clip-%04d%s", recorder->folder,
             number, ending);
    if (access(recorder->name, F_OK) == 0)
        return NAME_IS_TAKEN;
    if (take_name(recorder))
        return NAME_IS_FREE;
    if (errno == EEXIST)
        return NAME_IS_TAKEN;
    error_set("cannot make %s: %s", recorder->name, strerror(errno));
    return NAME_IS_REFUSED;
}

/* The video's sides are even, as most players want them. */
static bool open_pipe(struct recorder *recorder) {
    char *part = shell_quote(recorder->part);
    char *command = mem_printf(
        "ffmpeg -loglevel error -y -f rawvideo -pix_fmt rgba -s %dx%d -r %d -i - -an -vf "
        "'crop=trunc(iw/2)*2:trunc(ih/2)*2' -pix_fmt yuv420p %s",
        recorder->width, recorder->height, TIMELINE_FPS, part);
    signal(SIGPIPE, SIG_IGN); /* an ffmpeg that fails is noticed by fwrite */
    recorder->pipe = popen(command, "w");
    free(command);
    free(part);
    return recorder->pipe || error_set("ffmpeg cannot be started: %s", strerror(errno));
}

/* --- a clip ----------------------------------------------------------------------------------- */

static void set_folder(struct recorder *recorder, const char *folder) {
    char *whole = path_of_user(folder);
    snprintf(recorder->folder, sizeof recorder->folder, "%s", whole);
    free(whole);
}

void recorder_start(struct viewer *viewer) {
    struct recorder *recorder = &viewer->recorder;
    const struct record_request *request = &viewer->record;
    int last = (int)lround((double)fmaxf(request->from, request->to) * TIMELINE_FPS);
    *recorder = (struct recorder){.kind = request->kind,
                                  .first = (int)lround((double)request->from * TIMELINE_FPS)};
    set_folder(recorder, request->folder);
    if (!free_number(take_number, recorder)) {
        *recorder = (struct recorder){0};
        viewer_tell_error(viewer);
        return;
    }
    recorder->on = true;
    recorder->count = last > recorder->first ? last - recorder->first : 1;
    recorder->started = window_time();
    viewer->wish.play.on = false;
}

void recorder_tell(const struct viewer *viewer, char *text, size_t size) {
    const struct recorder *recorder = &viewer->recorder;
    double seconds = window_time() - recorder->started;
    double left =
        recorder->frame > 0 ? seconds / recorder->frame * (recorder->count - recorder->frame) : 0;
    int at = snprintf(text, size, "recording %d of %d", recorder->frame, recorder->count);
    if (recorder->frame > 0 && at > 0 && (size_t)at < size && left < 90)
        snprintf(text + at, size - (size_t)at, ", %.0f seconds left", left);
    else if (recorder->frame > 0 && at > 0 && (size_t)at < size)
        snprintf(text + at, size - (size_t)at, ", %.0f minutes left", left / 60);
}

static void tell_written(struct viewer *viewer) {
    const struct recorder *recorder = &viewer->recorder;
    char *path = realpath(recorder->name, NULL);
    messages_add_result(&viewer->host.messages, "written: %s, %d frames",
                        path ? path : recorder->name, recorder->frame);
    free(path);
}

/* Of a video that was begun. */
static bool end_video(const struct recorder *recorder) {
    bool ok = recorder->pipe && (pclose(recorder->pipe) == 0 ||
                                 error_set("ffmpeg failed: there is no %s", recorder->name));
    if (ok)
        return output_file_take(recorder->part, recorder->name);
    remove(recorder->part);
    return !recorder->pipe;
}

void recorder_stop(struct viewer *viewer) {
    struct recorder *recorder = &viewer->recorder;
    bool ok = !*recorder->part || recorder->kind == RECORD_PICTURES || end_video(recorder);
    if (!ok)
        viewer_tell_error(viewer);
    else if (recorder->on && recorder->frame > 0)
        tell_written(viewer);
    *recorder = (struct recorder){0};
}

void recorder_pose(struct viewer *viewer) {
    if (viewer->recorder.on)
        viewer_go_to(viewer,
                     (double)(viewer->recorder.first + viewer->recorder.frame) / TIMELINE_FPS);
}

static bool write_picture(struct viewer *viewer) {
    char path[640];
    snprintf(path, sizeof path, "%s/%04d.png", viewer->recorder.name,
             viewer->recorder.first + viewer->recorder.frame);
    return viewer_write_picture(viewer, path);
}

static bool write_video(struct viewer *viewer) {
    struct recorder *recorder = &viewer->recorder;
    struct bitmap shown;
    viewer_read_shown(viewer, &shown);
    if (!recorder->pipe) {
        recorder->width = shown.width;
        recorder->height = shown.height;
    }
    bool ok = shown.width == recorder->width && shown.height == recorder->height;
    size_t size = (size_t)shown.width * (size_t)shown.height * 4;
    if (!ok)
        error_set("%s: the picture's size has changed", recorder->name);
    ok = ok && (recorder->pipe || open_pipe(recorder));
    if (ok && fwrite(shown.rgba, 1, size, recorder->pipe) != size)
        ok = error_set("%s: %s", recorder->name, strerror(errno));
    bitmap_free(&shown);
    return ok;
}

void recorder_write(struct viewer *viewer) {
    struct recorder *recorder = &viewer->recorder;
    if (!recorder->on || viewer->shown.dirty || !viewer->shown.left)
        return;
    bool ok = recorder->kind == RECORD_VIDEO ? write_video(viewer) : write_picture(viewer);
    recorder->frame++;
    if (!ok) {
        viewer_tell_error(viewer);
        recorder->on = false;
    }
    if (!ok || recorder->frame == recorder->count)
        recorder_stop(viewer);
}
