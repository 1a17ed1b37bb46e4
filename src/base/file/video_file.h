/* Writes videos by ffmpeg, which receives frames through a pipe: H.264 in 4:2:0 if ffmpeg has it,
 * else the usual codec of the format. A video appears whole or not at all.
 *
 *     struct video_file video;
 *     bool ok = video_file_begin(&video, "clip.mp4", 320, 200, "25");
 *     for (...)
 *         ok = ok && video_file_add(&video, &bitmap);
 *     ok = video_file_end(&video, ok) && ok;
 */
#ifndef BASE_FILE_VIDEO_FILE_H
#define BASE_FILE_VIDEO_FILE_H

#include "base/file/output_file.h"
#include "base/image.h"

#include <sys/types.h>

/* Zeroed: none. */
struct video_file {
    const char *path; /* not owned */
    struct output_part part;
    pid_t encoder;
    int pipe;
    int width, height;   /* frame size in pixels */
    unsigned char *even; /* frame padded to even sides if needed; else NULL */
};

/* True for the extensions mp4, mov, mkv and webm. */
bool video_file_is(const char *path);

/* Checks that ffmpeg exists. Call it before long work. Error: ffmpeg is missing. */
bool video_file_check(const char *path);

/* Starts ffmpeg. rate: frames per second as ffmpeg reads them, "24000/1001". Call video_file_end in
 * any case. Error: names path and reason. */
bool video_file_begin(struct video_file *video, const char *path, int width, int height,
                      const char *rate);

/* Adds a frame without its alpha. Error: ffmpeg has ended, and how. */
bool video_file_add(struct video_file *video, const struct bitmap *frame);

/* Waits for ffmpeg and gives the video its path. If ok is false, kills ffmpeg and leaves no video,
 * without a new error. Error: ffmpeg or the file failed. Accepts a zeroed one. */
bool video_file_end(struct video_file *video, bool ok);

#endif
