/* Videos through ffmpeg, which gets frames by a pipe: H.264 in 4:2:0 where ffmpeg has it, else the format's usual codec.
 * As other files, a video appears whole or not at all.
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
    int width, height;   /* of the frames */
    unsigned char *even; /* a frame of even sides, where those of the frames are not; else NULL */
};

/* Whether the extension is that of a video: mp4, mov, mkv, webm. */
bool video_file_is(const char *path);

/* Call it before long work. Error: ffmpeg is missing. */
bool video_file_check(const char *path);

/* rate: frames per second as ffmpeg reads them, "24000/1001". Error: names the path and the reason. Call video_file_end in any case. */
bool video_file_begin(struct video_file *video, const char *path, int width, int height,
                      const char *rate);

/* Adds a frame, without its alpha. Error: ffmpeg has ended, and how. */
bool video_file_add(struct video_file *video, const struct bitmap *frame);

/* Waits for ffmpeg. There is no video where ok is false or ffmpeg has ended before; neither is a new error. Accepts a
 * zeroed one. */
bool video_file_end(struct video_file *video, bool ok);

#endif
