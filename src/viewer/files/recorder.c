#define _XOPEN_SOURCE 700
#include "viewer/files/recorder.h"

#include "base/error.h"
#include "base/file/folder.h"
#include "base/shell.h"
#include "scene/animation.h"
#include "viewer/files/screenshot.h"
#include "viewer/scene/animation.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* --- where it goes ---------------------------------------------------------------------------- */

bool recorder_has_video(void) {
    return shell_has("ffmpeg");
}

/* Makes the folder, or the video's lock; false where another viewer has done so. */
static bool take_name(const struct recorder *recorder) {
    if (recorder->kind == RECORD_PICTURES)
        return mkdir(recorder->name, 0777) == 0;
    int file = open(recorder->lock, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    return file >= 0 && close(file) == 0;
}

/* A video has its name when it is whole. */
static enum name_state take_number(void *user, int number) {
    struct recorder *recorder = user;
    const char *ending = recorder->kind == RECORD_VIDEO ? ".mp4" : "";
    snprintf(recorder->name, sizeof recorder->name, "%s/manylight-clip-%04d%s", recorder->folder,
             number, ending);
    snprintf(recorder->lock, sizeof recorder->lock, "%s/.manylight-clip-%04d%s", recorder->folder,
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

/* A video of the frames so far, unless ffmpeg has ended, which is told already. */
static bool end_video(struct recorder *recorder) {
    bool has_failed = recorder->video.path && recorder->video.encoder == 0;
    bool ok = video_file_end(&recorder->video, !has_failed) || has_failed;
    remove(recorder->lock);
    return ok;
}

void recorder_stop(struct viewer *viewer) {
    struct recorder *recorder = &viewer->recorder;
    bool ok = !*recorder->lock || recorder->kind == RECORD_PICTURES || end_video(recorder);
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
    char rate[16];
    snprintf(rate, sizeof rate, "%d", TIMELINE_FPS);
    viewer_read_shown(viewer, &shown);
    bool ok = recorder->video.path ||
              video_file_begin(&recorder->video, recorder->name, shown.width, shown.height, rate);
    ok = ok && video_file_add(&recorder->video, &shown);
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
